"""Superelements of meshes against the solids that they are made of."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.linalg import eigh

import cardan as cd
from cardan import solids as fem
from solids.meshes import block, grid

LUG = Path(__file__).with_name("files") / "lug.inp"
ALUMINIUM = cd.material(E=70e9, nu=0.3, rho=2700, expansion=2.3e-5)


def test_a_link_from_its_file() -> None:
    """Frequencies with the root fixed, static stiffness, stress under a load at the hole."""
    link = cd.superelement.from_mesh(
        LUG, ALUMINIUM, {"base": "root", "pin": "hole"}, modes=12, stress="root", scale=1e-3
    )
    mesh = fem.read(LUG, scale=1e-3)
    body = fem.solid(mesh, ALUMINIUM)
    K, M = body.stiffness(), body.mass()
    assert link.properties.mass == pytest.approx(M.sum() / 3, rel=1e-10)
    # the pin is rigid: displacements of its nodes are six motions about their mean position
    pin, root = mesh.nodes("hole"), mesh.nodes("root")
    arm = mesh.points[pin] - mesh.points[pin].mean(axis=0)
    free = np.setdiff1d(np.arange(len(mesh.points)), np.union1d(pin, root))
    T = np.zeros((mesh.dofs, 3 * len(free) + 6))
    rows = (3 * free[:, None] + np.arange(3)).ravel()
    T[rows, np.arange(len(rows))] = 1
    for k, axis in enumerate(np.eye(3)):
        T[3 * pin + k, len(rows) + k] = 1
        T[(3 * pin[:, None] + np.arange(3)).ravel(), len(rows) + 3 + k] = np.cross(
            axis, arm
        ).ravel()
    reduced_K, reduced_M = T.T @ (K @ T), T.T @ (M @ T)
    omega = np.sqrt(eigh(reduced_K, reduced_M, eigvals_only=True, subset_by_index=(0, 1)))
    modes = link.modes(locked="base")
    # from above, as all Ritz values
    assert modes.frequencies[:2] == pytest.approx(omega, rel=1e-3)
    assert (modes.frequencies[:2] >= omega).all()
    # a pull of 1 kN: displacement of the pin, and mean stress at the root
    force = np.zeros(len(link.K))
    labels = [label for frame in link.interfaces for label in frame.labels]
    moving = [k for k in range(len(link.K)) if k >= len(labels) or labels[k].startswith("pin")]
    force[labels.index("pin.x")] = 1e3
    z = np.zeros(len(force))
    z[moving] = np.linalg.solve(link.K[np.ix_(moving, moving)], force[moving])
    exact = np.linalg.solve(reduced_K, np.eye(len(reduced_K))[len(rows)] * 1e3)
    assert z[labels.index("pin.x")] == pytest.approx(exact[len(rows)], rel=1e-9)
    stress = link.stresses(z).reshape(-1, 6)
    by_solid = (fem.stress_operator(body, "root") @ (T @ exact)).reshape(-1, 6)
    assert abs(stress - by_solid).max() < 1e-8 * abs(by_solid).max()
    assert link.stress_names[:2] == (f"{root[0]} xx", f"{root[0]} yy")


def test_heat_of_a_free_body_is_free_of_stress() -> None:
    mesh = block("hex20", (3, 1, 1), (0.3, 0.1, 0.1))
    ends = [np.flatnonzero(abs(mesh.points[:, 0] - x) < 1e-9) for x in (0, 0.3)]
    link = cd.superelement.from_mesh(
        mesh,
        cd.material(E=70e9, nu=0.3, rho=2700, expansion=2e-5),
        {"a": ends[0], "b": ends[1]},
        rigid="rbe3",
        method="rubin",
        modes=6,
    )
    # one end fixed, 100 K: the mean of the other end moves by alpha T l
    n = len(link.K)
    moving = np.arange(6, n)
    z = np.linalg.lstsq(link.K[np.ix_(moving, moving)], 100 * link.loads["temperature"][moving])[0]
    assert z[0] == pytest.approx(2e-5 * 100 * 0.3, rel=1e-6)


def test_frequencies_of_a_beam_of_solids() -> None:
    """Free, and against the eigenvalues of the solid."""
    mesh = block("hex20", (8, 2, 2), (1.0, 0.1, 0.08))
    body = fem.solid(mesh, ALUMINIUM)
    ends = {
        name: np.flatnonzero(abs(mesh.points[:, 0] - x) < 1e-9) for name, x in (("a", 0), ("b", 1))
    }
    link = cd.superelement.from_mesh(mesh, ALUMINIUM, ends, method="rubin", rigid="rbe3", modes=10)
    K, M = body.stiffness().toarray(), body.mass().toarray()
    exact = np.sqrt(eigh(K, M, eigvals_only=True, subset_by_index=(6, 9)))
    assert link.frequencies[:4] == pytest.approx(exact, rel=1e-7)


def test_damping_of_materials() -> None:
    """C is the sum of the stiffnesses of materials times their damping."""
    points, cells = grid((4, 1, 1), kind="hex20", size=(0.4, 0.05, 0.05))
    regions = {"stiff": {"hex20": [0, 1]}, "soft": {"hex20": [2, 3]}}
    mesh = fem.from_arrays(points, cells, regions=regions)
    x = mesh.points[:, 0]
    ends = {"a": np.flatnonzero(x < 1e-9), "b": np.flatnonzero(x > 0.4 - 1e-9)}

    def reduced(E: float, soft: float, *damping: float) -> Any:
        pairs = zip((E, soft), damping or (0.0, 0.0), strict=True)
        materials = [cd.material(E=E, nu=0.3, rho=2700, damping=d) for E, d in pairs]
        by_region = dict(zip(("stiff", "soft"), materials, strict=True))
        return cd.superelement.from_mesh(mesh, by_region, ends, modes=6)

    alike = reduced(70e9, 70e9, 2e-6, 2e-6)
    assert abs(alike.C - 2e-6 * alike.K).max() < 1e-12 * abs(alike.C).max()
    mixed = reduced(70e9, 2e9, 2e-6, 3e-4)
    plain = reduced(70e9, 2e9)
    assert not plain.C.any()
    # the stiffness of a region is what its modulus adds
    body = fem.solid(mesh, {"stiff": ALUMINIUM, "soft": cd.material(E=2e9, nu=0.3)})
    twice = fem.solid(mesh, {"stiff": ALUMINIUM, "soft": cd.material(E=4e9, nu=0.3)})
    soft = (twice.stiffness() - body.stiffness()).toarray()
    C = 2e-6 * (body.stiffness().toarray() - soft) + 3e-4 * soft
    expected = plain.basis.T @ C @ plain.basis
    assert abs(mixed.C - expected).max() < 1e-9 * abs(expected).max()


def test_faults_are_named() -> None:
    mesh = block("hex8", (1, 1, 1))
    for interfaces, says in (
        ({}, r"interfaces=\{\}: give surfaces, sets or nodes by name"),
        ({"a": "hole"}, r"no surface, set or region 'hole'"),
        ({"a": [99]}, r"there is no node 99"),
    ):
        with pytest.raises(cd.ModelError, match=says):
            cd.superelement.from_mesh(mesh, ALUMINIUM, interfaces)
    with pytest.raises(cd.ModelError, match=r"scale=0.001: the mesh is one already"):
        cd.superelement.from_mesh(mesh, ALUMINIUM, {"a": [0]}, scale=1e-3)


# first flap frequency of a rotating blade by w (rho A l^4 / E I)^(1/2), both over the same unit:
# A. D. Wright, C. E. Smith, R. W. Thresher, J. L. C. Wang, J. Appl. Mech. 49 (1982), 197-202
BLADE = {0: 3.5160, 3: 4.7973, 6: 7.3604}


def test_a_spinning_blade_by_its_geometric_stiffness() -> None:
    """One superelement with K_G against the exact table, flapping along the axis of rotation."""
    length, h, E, rho = 1.0, 0.02, 70e9, 2700.0
    mesh = block("hex20", (16, 1, 1), (length, h, h))
    metal = cd.material(E=E, nu=0.0, rho=rho)
    ends = {
        name: np.flatnonzero(abs(mesh.points[:, 0] - x) < 1e-9)
        for name, x in (("root", 0), ("tip", length))
    }
    blade = cd.superelement.from_mesh(mesh, metal, ends, modes=8, stiffening="root")
    assert set(blade.geometric) == {"xx", "yy", "zz", "yz", "zx", "xy"}
    unit = np.sqrt(E * h * h / 12 / rho) / length**2
    moving = slice(6, None)
    M, K = blade.M[moving, moving], blade.K[moving, moving]
    for ratio, exact in BLADE.items():
        stiff = K + (ratio * unit) ** 2 * blade.geometric["zz"][moving, moving]
        # spin takes from the plane of rotation what it gives across: the flap is the softest with z
        omega, shapes = eigh(stiff, M)
        motion = blade.basis[:, moving] @ shapes
        flapping = np.abs(motion[2::3]).max(axis=0) > 0.5 * np.abs(motion).max(axis=0)
        first = np.sqrt(omega[np.flatnonzero(flapping)[0]])
        assert first / unit == pytest.approx(exact, rel=2e-3)


def test_a_body_spins_about_the_origin_of_its_frame() -> None:
    """Beside the nodes of the interface, as on a hub: the tension is that of the longer arms."""
    mesh = block("hex20", (4, 1, 1), (1.0, 0.1, 0.1))
    root = np.flatnonzero(mesh.points[:, 0] < 1e-9)
    center = (-0.3, 0.05, 0.05)
    options = {"modes": 2, "stiffening": "root"}
    metal = cd.material(E=70e9, nu=0.0, rho=2700)
    record = cd.superelement.from_mesh(mesh, metal, {"root": root}, at={"root": center}, **options)
    K_G = fem.spin_stiffness(fem.solid(mesh, metal), root, center)["zz"]
    expected = record.basis.T @ (K_G @ record.basis)
    scale = abs(expected).max()
    np.testing.assert_allclose(record.geometric["zz"], expected, atol=1e-9 * scale)
    plain = cd.superelement.from_mesh(mesh, metal, {"root": root}, **options)
    assert record.geometric["zz"][-1, -1] > 1.3 * plain.geometric["zz"][-1, -1] > 0


def test_products_of_angular_velocities() -> None:
    mesh = block("tet10", (1, 1, 1), (0.3, 0.2, 0.1))
    body = fem.solid(mesh, ALUMINIUM)
    w, center = np.array([3.0, -2.0, 5.0]), (0.1, 0.2, 0.3)
    products = fem.centrifugal_products(body, center)
    total = sum(w["xyz".index(a)] * w["xyz".index(b)] * load for (a, b), load in products.items())
    assert total == pytest.approx(fem.centrifugal(body, w, center), rel=1e-12, abs=1e-12)


def test_nodes_on_a_line_hold_nothing() -> None:
    mesh = block("hex8", (1, 1, 1))
    body = fem.solid(mesh, ALUMINIUM)
    edge = np.flatnonzero((mesh.points[:, :2] == 0).all(axis=1))
    with pytest.raises(cd.ModelError, match=r"body that spins is singular.*do not lie on a line"):
        fem.spin_stiffness(body, edge)
    with pytest.raises(cd.ModelError, match=r"stiffening='rot': .*Did you mean 'root'"):
        cd.superelement.from_mesh(mesh, ALUMINIUM, {"root": edge}, stiffening="rot")
