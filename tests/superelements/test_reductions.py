"""Reductions against values of 34 digits, against impedances, and coupled to each other."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.linalg import block_diag, eigh
from scipy.sparse import csc_matrix

import cardan as cd
from cardan.superelements import component
from cardan.superelements.methods import METHODS
from superelements.components import (
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

SHORT = {"cb": "craig_bampton", "rubin": "rubin", "macneal": "macneal"}
LOCKED = {"free_free": [], "clamped_free": ["root"], "clamped_clamped": ["root", "tip"]}
BEAM = reference("se_beam_16")["reference"]
MODES = (0, 1, 2, 3, 4, 8)


def beam_rows() -> list[tuple[int, str, str]]:
    return [
        (n, method, case)
        for n in MODES
        for method in SHORT
        for case in LOCKED
        if f"{method}_{case}_omega" in BEAM[f"modes_{n}"]
    ]


@each("n, method, case", beam_rows())
def test_a_beam_has_the_frequencies_of_34_digits(n: int, method: str, case: str) -> None:
    """Rubin and MacNeal lose no digits to the residual flexibility, which is not inverted."""
    row = BEAM[f"modes_{n}"]
    modes = beam(method=SHORT[method], modes=n).modes(LOCKED[case])
    expected = row[f"{method}_{case}_omega"]
    np.testing.assert_allclose(modes.frequencies[: len(expected)], expected, rtol=5e-12)
    count = row.get(f"{method}_{case}_finite_count", len(modes.frequencies))
    assert len(modes.frequencies) == count
    assert modes.n_rigid == (3 if case == "free_free" else 0)


# log10 of relative errors of the frequencies of the beam on one clamp, modes 1, 2, ...
ERRORS = {
    (0, "craig_bampton"): (-2.3, -0.2),
    (2, "craig_bampton"): (-4.2, -3.0, -2.4),
    (4, "craig_bampton"): (-5.3, -3.9, -3.2, -2.8, -2.6),
    (8, "craig_bampton"): (-6.3, -4.8, -4.0, -3.5, -3.2),
    (0, "rubin"): (-5.8, -2.3, -1.6),
    (2, "rubin"): (-8.6, -5.8, -4.4, -1.3),
    (4, "rubin"): (-10.3, -7.3, -5.8, -4.9, -4.4),
    (8, "rubin"): (-12.0, -9.0, -7.3, -6.3, -5.7),
    (0, "macneal"): (-2.3, -0.2),
    (2, "macneal"): (-4.2, -3.0, -2.4),
    (4, "macneal"): (-5.3, -3.9, -3.2, -2.8, -2.6),
    (8, "macneal"): (-6.3, -4.8, -4.0, -3.5, -3.2),
}


@each("key", ERRORS)
def test_errors_fall_with_the_modes_as_in_the_table(key: tuple[int, str]) -> None:
    n, method = key
    exact = np.array(BEAM["full_clamped_free_omega"])[: len(ERRORS[key])]
    # modes of bending and stretch in one order
    errors = beam(method=method, modes=n).modes(["root"]).frequencies[: len(exact)] / exact - 1
    np.testing.assert_allclose(np.log10(errors), ERRORS[key], atol=0.16)


def test_modes_that_are_chosen_and_left_out_are_those_of_all_rows() -> None:
    rubin, fixed = beam(method="rubin", modes=5), beam(modes=4)
    for record, name in ((rubin, "full_free_free_omega"), (fixed, "full_clamped_clamped_omega")):
        omega = np.concatenate([record.frequencies, record.dropped])
        count = min(len(omega), len(BEAM[name]))
        np.testing.assert_allclose(omega[:count], BEAM[name][:count], rtol=1e-11)


def test_guyan_is_craig_bampton_without_modes() -> None:
    guyan, none = beam(method="guyan"), beam(modes=0)
    np.testing.assert_array_equal(guyan.K, none.K)
    np.testing.assert_allclose(guyan.M, none.M, rtol=1e-14, atol=1e-16)
    assert len(guyan.frequencies) == 0
    np.testing.assert_allclose(
        guyan.dropped[:2], BEAM["full_clamped_clamped_omega"][:2], rtol=1e-12
    )


def test_coordinates_of_interfaces_are_the_static_shapes_of_any_method() -> None:
    guyan = beam(method="guyan")
    for method in ("craig_bampton", "rubin"):
        record = beam(method=method, modes=4)
        np.testing.assert_allclose(record.M[:6, :6], guyan.M, rtol=1e-9, atol=1e-11)
        np.testing.assert_allclose(record.K[:6, :6], guyan.K, rtol=1e-9, atol=1e-3)
        np.testing.assert_allclose(record.basis[:, :6], guyan.basis, atol=1e-9)
        assert not record.K[:6, 6:].any()
        np.testing.assert_allclose(record.M[6:, 6:], np.eye(record.n - 6), atol=1e-12)


def parts() -> tuple[np.ndarray, ...]:
    """M, K of the beam split at its six interface rows: bb, bi, ii of each."""
    data = beam_16()
    b = data["interface"]
    i = np.setdiff1d(np.arange(len(data["K"])), b)
    return tuple(data[name][np.ix_(r, c)] for name in "MK" for r, c in ((b, b), (b, i), (i, i)))


OMEGA = np.array([30.0, 300.0, 1000.0, 2000.0])


def test_impedance_of_craig_bampton_by_its_series() -> None:
    """Z = K0 - l M0 - l^2 g^T (w^2 - l)^-1 g, without any projection."""
    Mbb, Mbi, Mii, Kbb, Kbi, Kii = parts()
    static = -np.linalg.solve(Kii, Kbi.T)
    K0 = Kbb + Kbi @ static
    M0 = Mbb + Mbi @ static + static.T @ Mbi.T + static.T @ Mii @ static
    squares, modes = eigh(Kii, Mii)
    g = (modes.T @ (Mbi.T + Mii @ static))[:4]
    Z = beam(modes=4).impedance(OMEGA)
    for k, omega in enumerate(OMEGA):
        l = omega**2
        expected = K0 - l * M0 - l**2 * g.T @ (g / (squares[:4] - l)[:, None])
        scale = np.sqrt(np.outer(K0.diagonal(), K0.diagonal()))
        assert (abs(Z[k] - expected) / scale).max() < 1e-9


@each("method", ["rubin", "macneal"])
def test_admittance_of_free_modes_by_its_series(method: str) -> None:
    """Y = -R R^T/l + sum phi phi^T/(w^2 - l) + the residual part, with its mass or without."""
    data = beam_16()
    M, K, b = data["M"], data["K"], data["interface"]
    squares, shapes = eigh(K, M)
    rigid, chosen, last = shapes[:, :3], shapes[:, 3:7], shapes[:, 7:]
    A = np.eye(len(M)) - M @ rigid @ rigid.T
    flexible = A.T @ np.linalg.pinv(K, rcond=1e-13, hermitian=True) @ A
    residual = (flexible - chosen / squares[3:7] @ chosen.T)[:, b]
    G, H = residual[b], residual.T @ M @ residual
    np.testing.assert_allclose(residual, (last / squares[7:]) @ last[b].T, atol=1e-12)
    Y = beam(method=method, modes=4).admittance(OMEGA)
    for k, omega in enumerate(OMEGA):
        l = omega**2
        tail = G if method == "macneal" else G @ np.linalg.solve(G - l * H, G)
        modal = (chosen[b] / (squares[3:7] - l)) @ chosen[b].T
        expected = -rigid[b] @ rigid[b].T / l + modal + tail
        scale = np.sqrt(np.outer(abs(expected.diagonal()), abs(expected.diagonal())))
        assert (abs(Y[k] - expected) / scale).max() < 1e-6


@each("method", METHODS)
def test_admittance_is_the_inverse_of_impedance(method: str) -> None:
    record = beam(method=method, modes=None if method == "guyan" else 3, damping=0.01)
    product = record.impedance(OMEGA) @ record.admittance(OMEGA)
    np.testing.assert_allclose(product, np.broadcast_to(np.eye(6), (4, 6, 6)), atol=1e-7)


BRICK = reference("se_brick_A")["reference"]


@each("n", [0, 2, 6, 12])
def test_a_brick_between_spiders(n: int) -> None:
    record = brick(modes=n)
    for case in ("free_free", "clamped_free"):
        expected = BRICK[f"cb_{n}_{case}_omega"]
        omega = record.modes(LOCKED[case]).frequencies[: len(expected)]
        np.testing.assert_allclose(omega, expected, rtol=1e-11)


def test_a_soft_brick_on_one_face() -> None:
    """The local frequencies of the component of a pendulum, and those of all rows."""
    data = reference("se_spherical_joint_A")
    M, K, nodes = brick_matrices()
    soft = K * data["parameters"]["K_scale"]
    n = data["parameters"]["cb_modes"]
    record = cd.superelement.reduce(M, soft, nodes, faces(), modes=n)
    expected = data["reference"]["local_omega_node0_clamped"]
    np.testing.assert_allclose(record.modes(["root"]).frequencies, expected, rtol=1e-11)
    many = brick(method="rubin", modes=100).modes(["root"]).frequencies
    np.testing.assert_allclose(many[:6], BRICK["spider_full_clamped_free_omega"], rtol=1e-8)


def test_free_modes_of_the_brick_are_those_of_all_rows() -> None:
    record = brick(method="rubin", modes=8)
    expected = BRICK["spider_full_free_free_omega"]
    np.testing.assert_allclose(record.frequencies, expected, rtol=1e-11)
    np.testing.assert_allclose(record.modes().frequencies[:8], expected, rtol=1e-11)
    # the mean motion of a face leaves it elastic: free, nothing is reduced away
    soft = brick(method="rubin", modes=8, rigid="rbe3")
    np.testing.assert_allclose(soft.frequencies, BRICK["full_free_free_omega"], rtol=1e-11)


def test_the_sparse_way_gives_what_the_dense_one_does(monkeypatch: pytest.MonkeyPatch) -> None:
    dense = [brick(modes=6), brick(method="rubin", modes=6)]
    monkeypatch.setattr(component, "DENSE", 0)
    for other in dense:
        sparse = brick(method=other.method, modes=6)
        np.testing.assert_allclose(sparse.frequencies, other.frequencies, rtol=1e-11)
        np.testing.assert_allclose(sparse.dropped, other.dropped, rtol=1e-9)
        expected = other.modes(["root"]).frequencies
        np.testing.assert_allclose(sparse.modes(["root"]).frequencies, expected, rtol=1e-9)


def test_a_hub_with_a_brick() -> None:
    data = reference("hub_brick_A")
    x, y, z = data["parameters"]["hub_com_from_node0"]
    mass, J = data["parameters"]["hub_mass"], np.diag(data["parameters"]["hub_inertia"])
    arm = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    hub = np.block([[mass * np.eye(3), -mass * arm], [mass * arm, J - mass * arm @ arm]])
    for n in (0, 4, 10):
        record = brick(modes=n)
        M = record.M.copy()
        M[:6, :6] += hub
        omega = np.sqrt(abs(eigh(record.K, M, eigvals_only=True)[6:12]))
        np.testing.assert_allclose(omega, data["reference"][f"cb_{n}_omega"], rtol=1e-11)


@each("n_A, n_B", [(2, 2), (4, 3), (6, 6)])
@each("method", SHORT)
def test_two_beams_at_a_right_angle(method: str, n_A: int, n_B: int) -> None:
    data = reference("coupled_L_frame_A")
    records = []
    for name, n in (("A", n_A), ("B", n_B)):
        p = data["parameters"][name]
        M, K, nodes = planar_beam(p["L"], p["elements"], p["EA"], p["EI"], p["rhoA"])
        ends = {"start": 0, "end": p["elements"]}
        records.append(
            cd.superelement.reduce(
                M, K, nodes, ends, node_dofs="x y rz", method=SHORT[method], modes=n
            )
        )
    first, second = records
    # the motions of the start of B are those of the end of A, turned by a quarter
    n, m = first.n, second.n
    T = np.zeros((n + m, n - 3 + m - 3))
    T[3:n, : n - 3] = np.eye(n - 3)
    T[n : n + 3, :3] = [[0, 1, 0], [-1, 0, 0], [0, 0, 1]]
    T[n + 3 :, n - 3 :] = np.eye(m - 3)
    M, K = (T.T @ block_diag(a, b) @ T for a, b in ((first.M, second.M), (first.K, second.K)))
    expected = data["reference"][f"{method}_{n_A}_{n_B}_omega"]
    np.testing.assert_allclose(frequencies(M, K)[: len(expected)], expected, rtol=1e-9)


def test_a_satellite_of_hub_and_two_beams() -> None:
    """The exact frequencies of the continuum to 1e-5, by 64 elements and 12 modes each."""
    data = reference("satellite_two_beams_A")
    p, exact = data["parameters"], data["reference"]
    M, K, nodes = planar_beam(p["L"], 64, 1e4 * p["EI"], p["EI"], p["rhoA"])
    record = cd.superelement.reduce(
        M, K, nodes, {"root": 0}, node_dofs="x y rz", modes=12, frame_dofs="x y rz"
    )
    np.testing.assert_allclose(record.frequencies[:3], exact["clamped_beam"], rtol=1e-6)
    # one beam with half of the hub: it turns (root moves by a theta), or moves across
    for kind, row, hub in (
        ("still_antisymmetric", [0, p["a"], 1], p["J_hub"] / 2),
        ("still_symmetric", [0, 1, 0], p["m_hub"] / 2),
    ):
        T = np.zeros((record.n, record.n - 2))
        T[:3, 0] = row
        T[3:, 1:] = np.eye(record.n - 3)
        reduced = T.T @ record.M @ T
        reduced[0, 0] += hub
        omega = frequencies(reduced, T.T @ record.K @ T, zeros=1)
        lateral = omega[: len(exact[kind])]
        np.testing.assert_allclose(lateral, exact[kind], rtol=1e-5)


@each("n", [2, 4, 8])
def test_bounds_hold_and_estimates_are_near(n: int) -> None:
    """Within the bound lies an exact frequency; the estimate is within a factor of the error."""
    data = beam_16()
    for method in METHODS:
        record = beam(method=method, modes=None if method == "guyan" else n)
        for locked, rows, zeros in (
            ([], np.arange(51), 3),
            (["root"], np.arange(3, 51), 0),
            (["root", "tip"], np.arange(3, 48), 0),
        ):
            free = np.ix_(rows, rows)
            exact = frequencies(data["M"][free], data["K"][free], zeros=zeros)
            modes = record.modes(locked)
            distance = abs(modes.frequencies[:, None] / exact - 1).min(axis=1)
            assert (distance <= modes.bounds + 1e-9).all()
            # of the first half, whose neighbors are known
            for error, estimate in zip(distance[: n // 2], modes.estimates, strict=False):
                if 1e-9 < error < 1e-2 and method != "macneal":
                    assert error / 30 < estimate < 30 * error


@each("method", ["craig_bampton", "rubin"])
def test_rows_may_have_no_mass(method: str) -> None:
    """Lumped masses without inertia of rotation: those rows follow the others in statics."""
    _, K, nodes = planar_beam(2.0, 10, 3e6, 500.0, 4.0)
    lumped = np.diag(np.where(np.arange(33) % 3 < 2, 0.8, 0.0))
    lumped[[0, 1, 30, 31], [0, 1, 30, 31]] = 0.4
    ends = {"root": 0, "tip": 10}
    record = cd.superelement.reduce(
        lumped, K, nodes, ends, node_dofs="x y rz", method=method, modes=8
    )
    exact = frequencies(lumped[3:, 3:], K[3:, 3:])[:3]
    np.testing.assert_allclose(record.modes(["root"]).frequencies[:3], exact, rtol=2e-4)
    assert record.modes().n_rigid == 3
    assert record.properties.mass == pytest.approx(8.0)


def test_pins_at_both_ends_are_interfaces() -> None:
    """Frames without rotation: simply supported when fixed, in closed form."""
    M, K, nodes = planar_beam(1.0, 32, 1e8, 100.0, 2.0)
    ends = {"root": 0, "tip": 32}
    record = cd.superelement.reduce(
        M, K, nodes, ends, node_dofs="x y rz", frame_dofs="x y", modes=3
    )
    expected = (np.arange(1, 4) * np.pi) ** 2 * np.sqrt(100.0 / 2.0)
    np.testing.assert_allclose(record.frequencies, expected, rtol=1e-5)
    assert record.n == 7


@each("method", METHODS)
def test_a_component_without_anything_behind_its_interfaces(method: str) -> None:
    """One element: there is nothing to reduce."""
    M, K, nodes = planar_beam(1.0, 1, 1e6, 100.0, 2.0)
    ends = {"root": 0, "tip": 1}
    record = cd.superelement.reduce(M, K, nodes, ends, node_dofs="x y rz", method=method)
    np.testing.assert_allclose(record.K, K, rtol=1e-9, atol=1e-6)
    if method != "macneal":
        np.testing.assert_allclose(record.M, M, rtol=1e-9, atol=1e-12)
    exact = frequencies(M, K, zeros=3)
    if method != "macneal":
        np.testing.assert_allclose(record.modes().frequencies, exact, rtol=1e-9)


def test_a_long_beam_is_not_taken_for_singular() -> None:
    """1000 elements: its softest shape has 5e-13 of the stiffness of its rows."""
    M, K, nodes = planar_beam(1.0, 1000, 1e6, 100.0, 2.0)
    record = cd.superelement.reduce(
        csc_matrix(M), csc_matrix(K), nodes, {"root": 0}, node_dofs="x y rz", modes=2
    )
    expected = 1.8751040687119611**2 * np.sqrt(100.0 / 2.0)
    assert record.frequencies[0] == pytest.approx(expected, rel=1e-3)


def test_faces_share_no_node() -> None:
    both = {**faces(), "third": 0}
    with pytest.raises(cd.ModelError, match="node 0 belongs to interface 'root' too"):
        cd.superelement.reduce(*brick_matrices(), both)
