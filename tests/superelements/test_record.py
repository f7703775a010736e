"""The record: inertia, loads, damping, stress, checks of what it was made of, and its file."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.linalg import eig, null_space
from scipy.sparse import csc_matrix

import cardan as cd
from superelements.components import (
    BAR,
    beam,
    beam_16,
    brick,
    brick_matrices,
    faces,
    frequencies,
    planar_beam,
    reference,
)
from table import each


def bar(**options: Any) -> Any:
    """A small brick of 60 rows, from the files of CalculiX."""
    ends = {"root": [11, 12, 13, 14], "tip": [51, 52, 53, 54]}
    return cd.superelement.read(BAR).reduce(ends, **options)


def test_mass_properties_of_the_brick() -> None:
    expected = reference("se_brick_A")["reference"]
    record = brick(modes=2)
    assert record.properties.mass == pytest.approx(expected["mass"], rel=1e-12)
    inertia = np.array(record.properties.inertia)
    np.testing.assert_allclose(inertia, np.diag(expected["inertia_exact_box"]), atol=1e-11)
    np.testing.assert_allclose(record.properties.center, (0.5, 0.15, 0.05), rtol=1e-12)
    assert max(record.check.residual) < 1e-14
    # a bar in aluminium has 5090 m/s
    assert 4000 < record.sound < 8000
    assert record.density == pytest.approx(2700)


@each("rigid", ["rbe2", "rbe3"])
@each("method", ["craig_bampton", "rubin"])
def test_rigid_motions_have_no_strain_and_the_right_energy(rigid: str, method: str) -> None:
    record = brick(modes=4, rigid=rigid, method=method)
    motions = record.rigid_motions(record.properties.center)
    assert abs(record.K @ motions).max() < 1e-11 * abs(record.K).max()
    mass = np.diag([81.0] * 3 + [0.675, 6.8175, 7.3575])
    np.testing.assert_allclose(motions.T @ record.M @ motions, mass, atol=1e-10)
    nodes = record.displacements(motions.T).reshape(6, -1, 3)
    arms = record.dofs.positions - record.properties.center
    for k, axis in enumerate(np.eye(3)):
        np.testing.assert_allclose(nodes[k], np.tile(axis, (len(arms), 1)), atol=1e-11)
        np.testing.assert_allclose(nodes[3 + k], np.cross(axis, arms), atol=1e-11)


def test_a_mean_frame_moves_as_its_nodes_do_on_average() -> None:
    """By least squares of the displacements of the face over rigid motions."""
    record = brick(modes=4, rigid="rbe3")
    nodes = faces()["tip"]
    arms = record.dofs.positions[nodes] - record.interface("tip").position
    rigid = np.vstack([np.hstack([np.eye(3), np.cross(np.eye(3), a).T]) for a in arms])
    for z in np.random.default_rng(1).standard_normal((3, record.n)):
        moved = record.displacements(z).reshape(-1, 3)[nodes].ravel()
        mean = np.linalg.lstsq(rigid, moved, rcond=None)[0]
        np.testing.assert_allclose(mean, z[6:12], atol=1e-11)


def test_all_modes_reduce_nothing() -> None:
    """Mean frames and all modes span all motions: the response of all rows, loaded at a face."""
    matrices = cd.superelement.read(BAR)
    M, K = matrices.M.toarray(), matrices.K.toarray()
    record = bar(modes=48, rigid="rbe3")
    nodes = [matrices.node_ids.index(k) for k in (51, 52, 53, 54)]
    arms = matrices.nodes[nodes] - record.interface("tip").position
    rows = (3 * np.array(nodes)[:, None] + np.arange(3)).ravel()
    rigid = np.vstack([np.hstack([np.eye(3), np.cross(np.eye(3), a).T]) for a in arms])
    mean = np.zeros((6, len(M)))
    mean[:, rows] = np.linalg.pinv(rigid)
    for omega in (1000.0, 6500.0):
        expected = mean @ np.linalg.solve(K - omega**2 * M, mean.T)
        tip = record.admittance([omega])[0][6:, 6:]
        np.testing.assert_allclose(tip, expected, rtol=1e-8, atol=1e-9 * abs(expected).max())


def energy_rows(record: Any) -> np.ndarray:
    """Velocities of the rows of the nodes by (v, w, w_x z, w_y z, w_z z, z'), node by node."""
    columns = 6 + 4 * record.n
    B = np.zeros((len(record.dofs), columns))
    for row in range(len(record.dofs)):
        node, component = record.dofs.node[row], record.dofs.component[row]
        X = record.dofs.positions[node]
        rows = {c: r for r, c in enumerate(record.dofs.component) if record.dofs.node[r] == node}
        U = [record.basis[rows[a]] if a in rows else np.zeros(record.n) for a in range(3)]
        B[row, 6 + 3 * record.n :] = record.basis[row]
        for k, axis in enumerate(np.eye(3)):
            if component >= 3:
                B[row, 3 + k] = component - 3 == k
                continue
            B[row, k] = component == k
            B[row, 3 + k] = np.cross(axis, X)[component]
            spun = np.cross(axis, np.array(U).T)[:, component]
            B[row, 6 + k * record.n : 6 + (k + 1) * record.n] = spun
    return B


@each("kind", ["solid", "beam"])
def test_projected_inertia_is_that_of_all_nodes(kind: str) -> None:
    """B^T M B by the velocities of single nodes; beams have rotations and no z."""
    if kind == "solid":
        record, M = bar(modes=2), cd.superelement.read(BAR).M.toarray()
    else:
        record, M = beam(modes=3), beam_16()["M"]
    B = energy_rows(record)
    expected = B.T @ M @ B
    np.testing.assert_allclose(record.inertia.matrix(), expected, atol=1e-12 * abs(expected).max())
    np.testing.assert_allclose(record.inertia.modal, record.M, atol=1e-10)
    np.testing.assert_allclose(record.gravity, record.inertia.momentum.T)


def test_masses_of_solids_do_not_depend_on_directions() -> None:
    assert bar(modes=1).anisotropy < 1e-12
    assert beam(modes=1).anisotropy > 0.01
    assert "approximate" in repr(beam(modes=1))
    assert "approximate" not in repr(bar(modes=1))


def test_a_spinning_beam_is_longer_by_what_its_inertia_says() -> None:
    """K z = w^2 (j + P z) with the constants for a spin about the center."""
    data, expected = beam_16(), reference("se_spin_translate_16")
    spin = expected["parameters"]["spin"]
    nodes = data["nodes"] - [0.5, 0.0, 0.0]
    for n in (0, 3, 8):
        record = cd.superelement.reduce(
            data["M"], data["K"], nodes, {"a": 0, "b": 16}, node_dofs="x y rz", modes=n
        )
        j, P = record.inertia.spin_angular[2][2], record.inertia.spin_spin[2, 2]
        z = np.linalg.solve(record.K - spin**2 * P, spin**2 * j)
        longer = expected["reference"][f"elongation_cb_{n}"]
        assert z[3] - z[0] == pytest.approx(longer, rel=1e-9)
        assert abs(z[[1, 2, 4, 5]]).max() < 1e-12


def test_a_spinning_bar_is_longer_by_the_closed_form() -> None:
    """Masses that do not depend on directions: the difference equation of the bar."""
    data = reference("spinning_bar_A")
    p, n = data["parameters"], 10
    h, E, rho = p["half_length"] / n, p["E"], p["rho"]
    stiff = np.diag([1.0] + [2.0] * (n - 1) + [1.0]) - np.eye(n + 1, k=1) - np.eye(n + 1, k=-1)
    heavy = np.diag([2.0] + [4.0] * (n - 1) + [2.0]) + np.eye(n + 1, k=1) + np.eye(n + 1, k=-1)
    # as stiff across as along: the spin is about the root, nothing moves across
    M, K = np.kron(rho * h / 6 * heavy, np.eye(2)), np.kron(E / h * stiff, np.eye(2))
    nodes = np.zeros((n + 1, 3))
    nodes[:, 0] = np.linspace(0, p["half_length"], n + 1)
    ends = {"root": 0, "tip": n}
    record = cd.superelement.reduce(
        M, K, nodes, ends, node_dofs="x y", modes=2 * (n - 1), supported=True
    )
    j, P = record.inertia.spin_angular[2][2], record.inertia.spin_spin[2, 2]
    A = record.K - p["Omega"] ** 2 * P
    z = np.linalg.solve(A[2:, 2:], p["Omega"] ** 2 * j[2:])
    assert z[0] == pytest.approx(data["reference"]["u_tip_fe"], abs=1e-12)


def test_static_loads_move_interfaces_as_they_do_all_rows() -> None:
    """Weight and heat: what the static shapes of the interfaces carry is exact."""
    M, K, nodes = planar_beam(2.0, 8, 3e6, 500.0, 4.0)
    heat = np.zeros(27)
    heat[0], heat[24] = -60.0, 60.0
    ends = {"root": 0, "tip": 8}
    record = cd.superelement.reduce(
        M, K, nodes, ends, node_dofs="x y rz", modes=2, loads={"heat": heat}
    )
    weight = M @ np.tile([0.0, -9.81, 0.0], 9)
    for force, reduced in ((heat, record.loads["heat"]), (weight, record.gravity @ [0, -9.81, 0])):
        exact = np.linalg.solve(K[3:, 3:], force[3:])
        moved = np.linalg.solve(record.K[3:, 3:], reduced[3:])
        np.testing.assert_allclose(moved[:3], exact[-3:], rtol=1e-10, atol=1e-15)


@each("method", ["craig_bampton", "rubin", "guyan"])
def test_static_shapes_make_all_displacements_exact(method: str) -> None:
    """Heat and weight in a beam on one clamp: every row moves as without a reduction."""
    M, K, nodes = planar_beam(2.0, 8, 3e6, 500.0, 4.0)
    heat = np.zeros(27)
    heat[9], heat[14], heat[24] = -60.0, 5.0, 60.0
    options = {"node_dofs": "x y rz", "loads": {"heat": heat}, "method": method}
    options["modes"] = None if method == "guyan" else 2
    ends = {"root": 0, "tip": 8}
    weight = M @ np.tile([0.0, -9.81, 0.0], 9)
    for shapes, is_exact in (((), False), (("heat", "gravity"), True)):
        record = cd.superelement.reduce(M, K, nodes, ends, static_shapes=shapes, **options)
        for force, reduced in (
            (heat, record.loads["heat"]),
            (weight, record.gravity @ [0, -9.81, 0]),
        ):
            z = np.zeros(record.n)
            z[3:] = np.linalg.solve(record.K[3:, 3:], reduced[3:])
            moved = record.displacements(z)
            exact = np.linalg.solve(K[3:, 3:], force[3:])
            error = abs(moved[3:] - exact).max() / abs(exact).max()
            # attachment modes of a free body span its response to weight
            spanned = is_exact or (method == "rubin" and force is weight)
            assert error < 1e-10 if spanned else error > 1e-5
    # frequencies can only become better
    plain = cd.superelement.reduce(M, K, nodes, ends, **options).modes(["root"]).frequencies
    assert (record.modes(["root"]).frequencies[: len(plain)] <= plain * (1 + 1e-10)).all()
    with pytest.raises(cd.ModelError, match=r"there is no load 'heet'.*Did you mean 'heat'"):
        cd.superelement.reduce(M, K, nodes, ends, static_shapes=["heet"], **options)
    options |= {"method": "macneal", "modes": 1}
    with pytest.raises(cd.ModelError, match="take method='rubin'"):
        cd.superelement.reduce(M, K, nodes, ends, static_shapes=["heat"], **options)


def test_damping_ratios_are_those_of_the_free_modes() -> None:
    record = beam(modes=4, damping=[0.01, 0.02, 0.03], method="rubin")
    values = eig(
        np.block([[np.zeros((13, 13)), np.eye(13)], [-record.K, -record.C]]),
        np.block([[record.M * 0 + np.eye(13), np.zeros((13, 13))], [np.zeros((13, 13)), record.M]]),
        right=False,
    )
    oscillating = sorted(values[values.imag > 1.0], key=abs)
    ratios = [-value.real / abs(value) for value in oscillating]
    np.testing.assert_allclose(ratios, [0.01, 0.02, *[0.03] * 8], rtol=1e-6)
    np.testing.assert_allclose(np.abs(oscillating), record.modes().frequencies, rtol=1e-9)
    assert abs(record.C @ record.rigid_motions()).max() < 1e-9
    both = beam(modes=4, rayleigh=(0.5, 1e-4))
    np.testing.assert_allclose(both.C, 0.5 * both.M + 1e-4 * both.K)


def test_stress_and_geometric_stiffness_are_projected() -> None:
    M = brick_matrices()[0]
    rows = csc_matrix(np.random.default_rng(2).standard_normal((3, 396)))
    record = brick(modes=3, stress=rows, stress_names=["a", "b", "c"], geometric={"pull": M})
    z = np.random.default_rng(3).standard_normal((2, record.n))
    expected = record.displacements(z) @ rows.toarray().T
    np.testing.assert_allclose(record.stresses(z), expected, rtol=1e-10, atol=1e-12)
    np.testing.assert_allclose(record.geometric["pull"], record.M, atol=1e-11)
    with pytest.raises(cd.ModelError, match="give stress= to the reduction"):
        brick(modes=3).stresses(z)


def test_rounded_stiffness_is_made_free() -> None:
    """Seven digits of a text leave forces by rigid motions, which make_free takes out."""
    M, K, nodes = brick_matrices()
    rounded = K.copy()
    rounded.data = np.array([float(f"{x:.6e}") for x in K.data])
    rounded = (rounded + rounded.T) / 2
    plain = cd.superelement.reduce(M, rounded, nodes, faces(), modes=3)
    freed = cd.superelement.reduce(M, rounded, nodes, faces(), modes=3, make_free=True)
    motions = plain.rigid_motions()
    assert 1e-9 < max(plain.check.residual) < 1e-6
    assert max(plain.check.self_stress) > 1.0
    assert abs(plain.K @ motions).max() > 1e3 * abs(freed.K @ motions).max()
    # 1e-7 of a stiffness whose bending part is a hundredth
    np.testing.assert_allclose(
        freed.modes().frequencies[:4], brick(modes=3).modes().frequencies[:4], rtol=2e-4
    )


def test_a_component_with_supports_has_no_rigid_motions() -> None:
    M, K, nodes = planar_beam(1.0, 6, 1e6, 100.0, 2.0)
    K[0, 0] += 1e7
    K[1, 1] += 1e7
    options = {"node_dofs": "x y rz", "modes": 3, "supported": True}
    for method in ("craig_bampton", "rubin"):
        # it still turns about its pivot
        record = cd.superelement.reduce(M, K, nodes, {"tip": 6}, method=method, **options)
        assert record.rigid.shape[1] == 1
        exact = frequencies(M, K, zeros=1)
        assert record.modes().frequencies[0] == pytest.approx(exact[0], rel=1e-3)
    K[2, 2] += 1e5
    record = cd.superelement.reduce(M, K, nodes, {"tip": 6}, method="rubin", **options)
    assert record.rigid.shape[1] == 0
    exact = frequencies(M, K)
    np.testing.assert_allclose(record.modes().frequencies[:3], exact[:3], rtol=1e-9)


@each("order, dofs", [("node", None), ("component", None), ("node", "listed"), ("node", "turned")])
def test_rows_may_stand_in_any_order(order: str, dofs: str | None) -> None:
    data, expected = beam_16(), beam(modes=3).modes(["root"]).frequencies
    names, options = ("x", "y", "rz"), {}
    place = np.arange(51)
    if order == "component":
        place = np.arange(51).reshape(17, 3).T.ravel()
    if dofs == "listed":
        place = np.random.default_rng(5).permutation(51)
        options["dofs"] = [(int(k) // 3 + 100, names[k % 3]) for k in place]
        options["node_ids"] = range(100, 117)
    elif dofs == "turned":
        place = np.arange(51).reshape(17, 3)[:, [2, 0, 1]].ravel()
        options["node_dofs"] = "rz x y"
    else:
        options["node_dofs"] = "x y rz"
    first = 100 if dofs == "listed" else 0
    M, K = (data[name][np.ix_(place, place)] for name in "MK")
    record = cd.superelement.reduce(
        M, K, data["nodes"], {"root": first, "tip": first + 16}, order=order, modes=3, **options
    )
    np.testing.assert_allclose(record.modes(["root"]).frequencies, expected, rtol=1e-10)


def test_what_the_record_says() -> None:
    text = repr(brick(modes=3, method="rubin"))
    for part in ("'root' (6 motions, rbe2)", "left out", "81 kg", "free mode 1", "K R relative"):
        assert part in text
    assert "6 coordinates: M has no inverse" in repr(beam(modes=2, method="macneal"))
    assert "0 rigid" in repr(beam(modes=2).modes(["root"]))
    record = beam(modes=2)
    assert record.labels[2:8] == ("root.rz", "tip.x", "tip.y", "tip.rz", "mode 1", "mode 2")
    assert record.modes("root.x").locked == ("root.x",)
    with pytest.raises(cd.ModelError, match="Did you mean 'root'"):
        record.modes("rot")


def test_a_frequency_without_response_is_refused() -> None:
    record = beam(modes=3)
    with pytest.raises(cd.SolveError, match=r"139\.7.* all interfaces fixed"):
        record.impedance([record.frequencies[0]])
    with pytest.raises(cd.SolveError, match="all interfaces free"):
        record.admittance([0.0])
    assert abs(beam(modes=3, damping=0.01).impedance([record.frequencies[0]])).max() < 1e12


def test_null_space_of_a_free_component_is_that_of_its_nodes() -> None:
    """Rigid motions span what K does not resist."""
    record = brick(modes=2)
    full = null_space(record.K, rcond=1e-9)
    assert full.shape[1] == 6
    motions = record.rigid_motions()
    remainder = motions - full @ (full.T @ motions)
    assert abs(remainder).max() < 1e-7
