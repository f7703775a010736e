"""Solutions against closed forms, and the order in which they converge."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.linalg import eigh
from scipy.optimize import brentq
from scipy.sparse.linalg import spsolve

import cardan as cd
from cardan import solids as fem
from solids.meshes import KINDS, bent, block

E, RHO = 70e9, 2700.0
SLIM = cd.material(E=E, nu=0.0, rho=RHO)
METAL = cd.material(E=E, nu=0.3, rho=RHO, expansion=2e-5)


def solid(mesh, material=METAL) -> fem.Solid:
    return fem.solid(mesh, material)


def free(mesh, *fixed):
    """Degrees of freedom that are left, when those of conditions on positions are fixed."""
    mask = np.ones((len(mesh.points), 3), bool)
    for condition, axes in fixed:
        mask[np.ix_(condition(mesh.points.T), axes)] = False
    return np.flatnonzero(mask.ravel())


def solved(K, f, dofs):
    u = np.zeros(len(f))
    u[dofs] = spsolve(K[dofs][:, dofs].tocsc(), f[dofs])
    return u


def orders(errors, sizes):
    return np.diff(np.log(errors)) / np.diff(np.log(sizes))


@pytest.mark.parametrize(("kind", "order"), [("tet4", 2), ("hex8", 2), ("tet10", 4), ("hex20", 4)])
def test_axial_frequency_of_a_bar(kind: str, order: int) -> None:
    """Fixed at one end, moving along alone: w = pi/2 c/l, errors of the order of the square."""
    exact = (np.pi / 2) ** 2 * E / RHO
    errors, counts = [], (2, 4, 8)
    for count in counts:
        mesh = block(kind, (count, 1, 1), (1.0, 0.2, 0.2))
        dofs = free(mesh, (lambda x: x[0] > -1, [1, 2]), (lambda x: x[0] < 1e-9, [0]))
        body = solid(mesh, SLIM)
        K, M = (A[dofs][:, dofs].toarray() for A in (body.stiffness(), body.mass()))
        errors.append(eigh(K, M, eigvals_only=True)[0] / exact - 1)
    assert min(errors) > 0
    assert orders(errors, 1 / np.array(counts))[-1] == pytest.approx(order, abs=0.25)


def tube(count, kind="hex20"):
    """A quarter of a thick tube, nodes on circles; radii 1 and 2, height 0.5."""
    mesh = block(kind, (count, 2 * count, 1), (1.0, np.pi / 2, 0.5))
    return bent(
        mesh, lambda x: np.array([(1 + x[0]) * np.cos(x[1]), (1 + x[0]) * np.sin(x[1]), x[2]])
    )


def radius(x):
    return np.hypot(x[0], x[1])


def test_thick_tube_under_pressure() -> None:
    """Lame's solution in plane strain: displacement and stress, with orders at least 3 and 2."""
    p, a, b, nu = 1e6, 1.0, 2.0, 0.3
    A, B = p * a * a / (b * b - a * a), p * a * a * b * b / (b * b - a * a)
    inner = (1 + nu) / E * ((1 - 2 * nu) * A * a + B / a)
    errors, stresses, counts = [], [], (1, 2, 4)
    for count in counts:
        mesh = tube(count)
        body = solid(mesh)
        nodes = np.flatnonzero(abs(radius(mesh.points.T) - a) < 1e-9)
        f = fem.pressure(body, nodes, p)
        dofs = free(
            mesh,
            (lambda x: x[2] > -1, [2]),
            (lambda x: abs(x[1]) < 1e-9, [1]),
            (lambda x: abs(x[0]) < 1e-9, [0]),
        )
        u = solved(body.stiffness(), f, dofs)
        r = radius(mesh.points.T)
        moved = (u.reshape(-1, 3)[nodes, :2] * mesh.points[nodes, :2]).sum(axis=1) / a
        errors.append(abs(moved - inner).max() / inner)
        # along the x axis the hoop stress is yy
        line = np.flatnonzero(abs(mesh.points[:, 1]) < 1e-9)
        stress = (fem.stress_operator(body, line) @ u).reshape(-1, 6)
        stresses.append(abs(stress[:, 1] - (A + B / r[line] ** 2)).max() / (A + B))
        # plane strain: zz = nu (rr + tt), the same everywhere
        assert abs(stress[:, 2] - 2 * nu * A).max() < stresses[-1] * (A + B)
    assert errors[-1] < 2e-4
    assert orders(errors, 1 / np.array(counts))[-1] > 2.8
    assert stresses[-1] < 0.02
    assert orders(stresses, 1 / np.array(counts))[-1] > 1.5


def test_bending_frequency_of_a_cantilever() -> None:
    """Timoshenko's beam for a square section with nu = 0: clamped at its root, 1 to 20 slender."""
    length, h = 1.0, 0.05
    mesh = block("hex20", (20, 1, 1), (length, h, h))
    body = solid(mesh, SLIM)
    dofs = free(mesh, (lambda x: x[0] < 1e-9, [0, 1, 2]), (lambda x: x[0] > -1, [2]))
    K, M = (A[dofs][:, dofs].toarray() for A in (body.stiffness(), body.mass()))
    values = np.sqrt(eigh(K, M, eigvals_only=True, subset_by_index=(0, 1)))
    exact = timoshenko(length, h, E, E / 2, RHO)
    # one cell across has no cubic warping: the shear coefficient differs a little from 5/6
    assert values[0] == pytest.approx(exact[0], rel=4e-4)
    assert values[1] == pytest.approx(exact[1], rel=3e-3)


def timoshenko(length, h, E, G, rho):
    """The first two frequencies, by the determinant of the clamped and free ends."""
    A, I, k = h * h, h**4 / 12, 5 / 6

    def determinant(w):
        # y' = B y for deflection, rotation, shear force, moment, at the frequency w
        B = np.array(
            [
                [0, 1, 1 / (k * G * A), 0],
                [0, 0, 0, 1 / (E * I)],
                [-rho * A * w**2, 0, 0, 0],
                [0, -rho * I * w**2, -1, 0],
            ]
        )
        values, vectors = np.linalg.eig(B.astype(complex))
        T = (vectors * np.exp(values * length)) @ np.linalg.inv(vectors)
        return np.linalg.det(T[2:, 2:].real)

    thin = np.array([1.8751041, 4.6940911]) ** 2 * np.sqrt(E * I / (rho * A)) / length**2
    return [brentq(determinant, 0.8 * w, 1.05 * w) for w in thin]


@pytest.mark.parametrize("kind", KINDS)
def test_loads_have_the_resultants_of_mechanics(kind: str) -> None:
    size = (0.4, 0.2, 0.3)
    mesh = bent(block(kind, size=size), lambda x: x + 0.02 * np.sin(7 * x[[1, 2, 0]]))
    body = solid(mesh)
    M = body.nodal_mass()
    mass, center = M.sum(), (M @ mesh.points).sum(axis=0) / M.sum()
    weight = fem.gravity(body, (1.0, -2.0, 9.81)).reshape(-1, 3)
    assert weight.sum(axis=0) == pytest.approx(mass * np.array([1.0, -2.0, 9.81]))
    assert np.cross(mesh.points, weight).sum(axis=0) == pytest.approx(
        mass * np.cross(center, [1.0, -2.0, 9.81])
    )
    omega, axis = np.array([10.0, 20.0, -5.0]), np.array([0.1, 0.2, 0.0])
    pull = fem.centrifugal(body, omega, axis).reshape(-1, 3).sum(axis=0)
    assert pull == pytest.approx(-mass * np.cross(omega, np.cross(omega, center - axis)))
    # a closed surface under pressure, and thermal loads, are in balance; work is p times volume
    every = np.arange(len(mesh.points))
    f = fem.pressure(body, every, 2.0).reshape(-1, 3)
    assert abs(f.sum(axis=0)).max() < 1e-13
    assert abs(np.cross(mesh.points, f).sum(axis=0)).max() < 1e-14
    assert -(f * mesh.points).sum() / 3 == pytest.approx(2.0 * mass / RHO, rel=2e-4)
    rise = np.cos(mesh.points @ [3.0, 1.0, 2.0])
    heat = fem.thermal(body, rise).reshape(-1, 3)
    assert abs(heat.sum(axis=0)).max() < 1e-9 * abs(heat).max()
    assert abs(np.cross(mesh.points, heat).sum(axis=0)).max() < 1e-9 * abs(heat).max()


def test_spinning_bar_and_its_stress() -> None:
    """Linear extension of a bar that spins about its end: u = rho w^2 (l^2 x/2 - x^3/6) / E."""
    length, w = 1.0, 100.0
    mesh = block("hex20", (8, 1, 1), (length, 0.1, 0.1))
    body = solid(mesh, SLIM)
    dofs = free(mesh, (lambda x: x[0] < 1e-9, [0]), (lambda x: x[0] > -1, [1, 2]))
    u = solved(body.stiffness(), fem.centrifugal(body, (0, 0, w)), dofs)
    x = mesh.points[:, 0]
    exact = RHO * w**2 / E * (length**2 * x / 2 - x**3 / 6)
    assert abs(u[::3] - exact).max() < 1e-5 * exact.max()
    stress = (fem.stress_operator(body) @ u).reshape(-1, 6)
    pull = RHO * w**2 * (length**2 - x**2) / 2
    # a parabola, extrapolated linearly from two points in each of 8 cells
    step = RHO * w**2 * (length / 8) ** 2 / 12
    assert abs(stress[:, 0] - pull).max() == pytest.approx(step, rel=1e-6)
    # K_G for a slope across: half the energy of tension in a string
    K_G = body.geometric_stiffness(u)
    slope = np.zeros((len(x), 3))
    slope[:, 1] = x
    tension = RHO * w**2 * length**3 / 3 * 0.01
    assert slope.ravel() @ K_G @ slope.ravel() == pytest.approx(tension, rel=1e-6)


def test_geometric_stiffness_of_rotations_is_that_of_the_stress() -> None:
    """A uniform stress S in a block: K_G of a linear field with gradient H is tr(H S H^T) V."""
    mesh = block("tet10", distortion=0.2)
    body = solid(mesh)
    rng = np.random.default_rng(4)
    A, H = 1e-3 * rng.normal(size=(3, 3)), rng.normal(size=(3, 3))
    K_G = body.geometric_stiffness(mesh.points @ A.T)
    assert abs(K_G - K_G.T).max() == 0
    strain = (A + A.T) / 2
    lame, shear = E * 0.3 / 1.3 / 0.4, E / 2.6
    stress = lame * np.trace(strain) * np.eye(3) + 2 * shear * strain
    field = (mesh.points @ H.T).ravel()
    assert field @ K_G @ field == pytest.approx(np.trace(H @ stress @ H.T), rel=1e-12)


@pytest.mark.parametrize(("kind", "rel"), [("hex20", 2e-3), ("tet10", 6e-3)])
def test_buckling_of_a_column(kind: str, rel: float) -> None:
    """Clamped and free, nu = 0: Euler's load with Engesser's share of shear."""
    length, h = 1.0, 0.05
    mesh = block(kind, (10, 1, 1), (length, h, h))
    body = solid(mesh, SLIM)
    top = np.flatnonzero(mesh.points[:, 0] > length - 1e-9)
    f = fem.pressure(body, top, 1.0)
    dofs = free(mesh, (lambda x: x[0] < 1e-9, [0, 1, 2]))
    K = body.stiffness()
    u = solved(K, f, dofs)
    K_G = body.geometric_stiffness(u)
    values = eigh(-K_G[dofs][:, dofs].toarray(), K[dofs][:, dofs].toarray(), eigvals_only=True)
    euler = np.pi**2 * E * h**4 / 12 / (4 * length**2)
    exact = euler / (1 + euler / (5 / 6 * E / 2 * h * h))
    assert h * h / values[-1] == pytest.approx(exact, rel=rel)


def test_heated_block_between_walls() -> None:
    """Walls on all sides: stress is -E alpha T / (1 - 2 nu), and von Mises stress is 0."""
    mesh = block("hex8", distortion=0.2)
    body = solid(mesh)
    rise = np.full(len(mesh.points), 50.0)
    stress = fem.thermal_stresses(body, rise).reshape(-1, 6)
    assert stress[:, :3] == pytest.approx(-E * 2e-5 * 50 / 0.4)
    assert abs(stress[:, 3:]).max() < 1e-6
    assert abs(fem.von_mises(stress)).max() < 1e-6
    # K_G is that of the pressure, with no displacement at all
    K_G = body.geometric_stiffness(np.zeros(mesh.dofs), rise)
    field = np.zeros((len(mesh.points), 3))
    field[:, 0] = mesh.points[:, 1]
    assert field.ravel() @ K_G @ field.ravel() == pytest.approx(stress[0, 0])


def test_von_mises_of_known_states() -> None:
    assert fem.von_mises([[3.0, 0, 0, 0, 0, 0], [5, 5, 5, 0, 0, 0], [0, 0, 0, 0, 0, 2]]) == (
        pytest.approx([3.0, 0.0, 2 * 3**0.5])
    )
