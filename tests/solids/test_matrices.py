"""Matrices of cells against other routes, laws of rigid motion, patch tests."""

from __future__ import annotations

import numpy as np
import pytest
import sympy

import cardan as cd
from cardan import solids as fem
from cardan.solids.cells import SOLIDS
from solids import routes
from solids.meshes import KINDS, bent, block

E, NU, RHO = 210e9, 0.3, 7850.0
STEEL = cd.material(E=E, nu=NU, rho=RHO)
EPS = np.finfo(float).eps


def solid(mesh, material=STEEL) -> fem.Solid:
    return fem.solid(mesh, material)


def wavy(x):
    """Curved edges, all volumes positive."""
    return x + 0.04 * np.array([np.sin(3 * x[1]), np.sin(4 * x[2] + 1), np.cos(3 * x[0])])


def rigid(points):
    """Rigid motions (dofs, 6)."""
    modes = np.zeros((len(points), 3, 6))
    for k, axis in enumerate(np.eye(3)):
        modes[:, k, k] = 1
        modes[:, :, 3 + k] = np.cross(axis, points)
    return modes.reshape(-1, 6)


def single(kind, seed=3):
    """A distorted cell with straight edges; hexahedra are parallelepipeds."""
    cell = SOLIDS[kind]
    rng = np.random.default_rng(seed)
    A = np.eye(3) + 0.3 * rng.normal(size=(3, 3))
    x = np.array(cell.nodes, float) @ A.T
    return fem.from_arrays(x, {kind: [list(range(len(x)))]}, scale=1.0)


@pytest.mark.parametrize("kind", KINDS)
def test_single_cells_by_another_route(kind: str) -> None:
    mesh = single(kind)
    if kind.startswith("tet"):
        K, M = routes.simplex_matrices(mesh.points, E, NU, RHO)
    else:
        K, M = routes.hex_matrices(mesh.points, SOLIDS[kind].nodes, E, NU, RHO, 5)
    M = np.kron(M, np.eye(3))
    ours = solid(mesh)
    assert abs(ours.stiffness() - K).max() < 1e3 * EPS * abs(K).max()
    assert abs(ours.mass() - M).max() < 1e3 * EPS * abs(M).max()


@pytest.mark.parametrize("kind", ["hex8", "hex20"])
def test_curved_cells_have_the_points_that_are_said(kind: str) -> None:
    """Where no rule is exact, the result is that of the same rule by other formulas."""
    mesh = bent(single(kind), lambda x: x + 0.05 * np.sin(x[[1, 2, 0]]))
    counts = {"hex8": (2, 3), "hex20": (3, 3)}[kind]
    args = (mesh.points, SOLIDS[kind].nodes, E, NU, RHO)
    K, M = routes.hex_matrices(*args, counts[0])[0], routes.hex_matrices(*args, counts[1])[1]
    ours = solid(mesh)
    assert abs(ours.stiffness() - K).max() < 1e3 * EPS * abs(K).max()
    assert abs(ours.mass() - np.kron(M, np.eye(3))).max() < 1e3 * EPS * abs(M).max()


@pytest.mark.parametrize("kind", KINDS)
def test_six_rigid_motions_and_no_more(kind: str) -> None:
    mesh = bent(block(kind, (2, 1, 2), distortion=0.2), wavy)
    K, modes = solid(mesh).stiffness(), rigid(mesh.points)
    assert abs(K - K.T).max() == 0
    assert abs(K @ modes).max() < 1e3 * EPS * abs(K).max()
    values = np.linalg.eigvalsh(K.toarray())
    assert (abs(values[:6]) < 1e4 * EPS * values[-1]).all()
    assert values[6] > 1e-5 * values[-1]


@pytest.mark.parametrize("kind", KINDS)
def test_patch_of_constant_strain(kind: str) -> None:
    """Nodes inside find their places, stresses are those of the strain everywhere."""
    mesh = block(kind, distortion=0.25)
    body = solid(mesh)
    A = 1e-3 * np.random.default_rng(0).normal(size=(3, 3))
    exact = (mesh.points @ A.T).ravel()
    outside = np.unique(np.concatenate([x.ravel() for x in mesh.boundary.faces.values()]))
    fixed = np.zeros(len(exact), bool)
    fixed[(3 * outside[:, None] + np.arange(3)).ravel()] = True
    K = body.stiffness().toarray()
    inside = np.linalg.solve(K[~fixed][:, ~fixed], -K[~fixed][:, fixed] @ exact[fixed])
    assert len(inside)
    assert abs(inside - exact[~fixed]).max() < 1e4 * EPS * abs(exact).max()
    stress = np.einsum("ijkl,kl->ij", routes.tensor(E, NU), (A + A.T) / 2)
    voigt = stress[[0, 1, 2, 1, 2, 0], [0, 1, 2, 2, 0, 1]]
    nodal = (fem.stress_operator(body) @ exact).reshape(-1, 6)
    assert abs(nodal - voigt).max() < 1e4 * EPS * abs(voigt).max()
    # energy is that of the volume 1
    assert exact @ K @ exact == pytest.approx((stress * A).sum(), rel=1e-12)


def test_quadratic_displacements_have_exact_energy_and_stress() -> None:
    """Straight tet10 and hex20 contain all quadratic fields, and linear stress at nodes."""
    C = routes.tensor(E, NU)
    Q = 1e-3 * np.random.default_rng(2).normal(size=(3, 3, 3))
    Q = Q + Q.transpose(0, 2, 1)
    x, w = np.polynomial.legendre.leggauss(3)
    x, w = (x + 1) / 2, w / 2
    energy = 0.0
    for i, j, k in np.ndindex(3, 3, 3):
        strain = 2 * np.einsum("imn,n->im", Q, np.array([x[i], x[j], x[k]]))
        energy += w[i] * w[j] * w[k] * np.einsum("ij,ijkl,kl->", strain, C, strain)
    for kind in ("tet10", "hex20"):
        mesh = block(kind, (2, 1, 2))
        body = solid(mesh)
        u = np.einsum("imn,am,an->ai", Q, mesh.points, mesh.points).ravel()
        assert u @ body.stiffness() @ u == pytest.approx(energy, rel=1e-12)
        strain = 2 * np.einsum("imn,an->aim", Q, mesh.points)
        stress = np.einsum("ijkl,akl->aij", C, strain)
        voigt = stress[:, [0, 1, 2, 1, 2, 0], [0, 1, 2, 2, 0, 1]]
        chosen = np.arange(3, len(mesh.points), 5)
        nodal = (fem.stress_operator(body, chosen) @ u).reshape(-1, 6)
        assert abs(nodal - voigt[chosen]).max() < 1e-11 * abs(voigt).max()


@pytest.mark.parametrize("kind", KINDS)
def test_mass_and_inertia_of_a_block(kind: str) -> None:
    a, b, c = size = (0.3, 0.2, 0.5)
    mesh = block(kind, size=size, distortion=0.25)
    body, modes = solid(mesh), rigid(mesh.points)
    m = RHO * a * b * c
    inertia = modes.T @ body.mass() @ modes
    assert inertia[:3, :3] == pytest.approx(m * np.eye(3), rel=1e-13, abs=1e-12 * m)
    # about a corner
    moments = m / 3 * np.array([b * b + c * c, c * c + a * a, a * a + b * b])
    assert np.diag(inertia)[3:] == pytest.approx(moments, rel=1e-12)
    assert inertia[3, 4] == pytest.approx(-m * a * b / 4, rel=1e-12)
    lumped = body.mass(lumped=True)
    assert lumped.nnz == mesh.dofs
    assert lumped.diagonal().min() > 0
    assert lumped.diagonal()[::3].sum() == pytest.approx(m, rel=1e-13)


def test_orthotropic_with_isotropic_numbers_is_isotropic() -> None:
    mesh = block("hex20", (1, 1, 2), distortion=0.2)
    G = E / 2 / (1 + NU)
    angle = 0.7
    axes = np.array(
        [[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]]
    )
    material = fem.orthotropic((E, E, E), (NU, NU, NU), (G, G, G), RHO, axes=axes)
    K, same = solid(mesh).stiffness(), solid(mesh, material).stiffness()
    assert abs(K - same).max() < 1e-13 * abs(K).max()
    by_shear = solid(mesh, cd.material(E=E, G=G, rho=RHO)).stiffness()
    assert abs(K - by_shear).max() < 1e-13 * abs(K).max()


def test_orthotropic_material_follows_its_axes() -> None:
    """A stretched bar of wood: modulus and contraction along its axes, which are rotated."""
    moduli, ratios, shear = (12e9, 0.8e9, 0.5e9), (0.4, 0.45, 0.3), (0.7e9, 0.65e9, 0.04e9)
    rng = np.random.default_rng(5)
    axes = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    axes[:, 0] *= np.linalg.det(axes)
    mesh = block("hex20", (1, 1, 1))
    wood = fem.orthotropic(moduli, ratios, shear, expansion=(1e-6, 2e-6, 3e-6), axes=axes)
    body = solid(mesh, wood)
    # strain of a unit stress along axis 1, as a tensor
    strain = axes @ np.diag([1, -ratios[0], -ratios[1]]) @ axes.T / moduli[0]
    u = (mesh.points @ strain.T).ravel()
    nodal = (fem.stress_operator(body) @ u).reshape(-1, 6)
    stress = np.outer(axes[:, 0], axes[:, 0])[[0, 1, 2, 1, 2, 0], [0, 1, 2, 2, 0, 1]]
    assert abs(nodal - stress).max() < 1e-12
    # shear in the plane of axes 1 and 2
    strain = (np.outer(axes[:, 0], axes[:, 1]) + np.outer(axes[:, 1], axes[:, 0])) / (2 * shear[0])
    u = (mesh.points @ strain.T).ravel()
    nodal = (fem.stress_operator(body) @ u).reshape(-1, 6)
    stress = strain * 2 * shear[0]
    assert abs(nodal - stress[[0, 1, 2, 1, 2, 0], [0, 1, 2, 2, 0, 1]]).max() < 1e-12
    # free expansion is free of stress
    growth = axes @ np.diag([1e-6, 2e-6, 3e-6]) @ axes.T
    u = (mesh.points @ growth.T).ravel()
    rise = np.ones(len(mesh.points))
    assert abs(body.stiffness() @ u - fem.thermal(body, 1.0)).max() < 1e-9
    nodal = fem.stress_operator(body) @ u + fem.thermal_stresses(body, rise)
    assert abs(nodal).max() < 1e-9


def test_two_materials_by_region() -> None:
    plain = block("hex8", (2, 1, 1))
    regions = {"left": {"hex8": [0]}, "right": {"hex8": [1]}}
    mesh = fem.from_arrays(plain.points, dict(plain.cells), regions=regions, scale=1.0)
    soft = cd.material(E=1e9, nu=0.2, rho=1000)
    body = solid(mesh, {"left": STEEL, "right": soft})
    assert repr(body) == "Solid(36 degrees of freedom, 1 hex8, 1 hex8)"
    assert body.mass().sum() / 3 == pytest.approx((RHO + 1000) / 2)
    K = np.zeros((mesh.dofs, mesh.dofs))
    for nodes, (modulus, ratio) in zip(mesh.cells["hex8"], ((E, NU), (1e9, 0.2)), strict=True):
        dofs = (3 * nodes[:, None] + np.arange(3)).ravel()
        args = (mesh.points[nodes], SOLIDS["hex8"].nodes, modulus, ratio, 1.0, 2)
        K[np.ix_(dofs, dofs)] += routes.hex_matrices(*args)[0]
    assert abs(body.stiffness() - K).max() < 1e3 * EPS * abs(K).max()
    with pytest.raises(cd.ModelError, match=r"cell 1 of hex8 has no material"):
        solid(mesh, {"left": STEEL})
    with pytest.raises(cd.ModelError, match=r"no region 'lift'.*Did you mean 'left'"):
        solid(mesh, {"lift": STEEL})


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ({"E": (1e9, 1e9, -1.0)}, r"E3 is -1; give a modulus above 0"),
        ({"nu": (0.9, 0.9, 0.9)}, r"a strain would set energy free"),
        ({"nu": (0.3, 0.3)}, r"nu=.*give 3 numbers"),
        ({"rho": -1.0}, r"rho is -1"),
        ({"damping": -1.0}, r"damping is -1; give 0 or more \[s\]"),
        ({"axes": np.ones((3, 3))}, r"three orthonormal directions"),
        ({"G": ("x", 1e9, 1e9)}, r"G\[0\]='x': matrices of a mesh are numbers"),
    ],
)
def test_impossible_materials(arguments: dict, says: str) -> None:
    usual = {"E": (1e9,) * 3, "nu": (0.3,) * 3, "G": (4e8,) * 3}
    with pytest.raises(cd.ModelError, match=says):
        fem.orthotropic(**{**usual, **arguments})


def test_materials_that_give_no_matrices() -> None:
    mesh = block("hex8", (1, 1, 1))
    for material, says in (
        (cd.material(E=1e9, nu=0.5), r"nu is 0.5: with 1/2 the volume cannot change"),
        (cd.material(rho=1000), r"the material has no E with nu or G"),
        (cd.material(E=sympy.Symbol("E"), nu=0.3), r"E=.*matrices of a mesh are numbers"),
    ):
        with pytest.raises(cd.ModelError, match=says):
            solid(mesh, material)
    for material, says in (
        (cd.material(E=210e3, nu=0.3, rho=7.85e-9), r"faster than in any material.*MPa by 1e6"),
        (cd.material(E=210e3, nu=0.3, rho=7850), r"slower than in rubber"),
    ):
        with pytest.warns(cd.ModelWarning, match=says):
            solid(mesh, material)
