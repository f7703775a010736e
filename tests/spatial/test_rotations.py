"""Every parametrization: SciPy's rotations, and rates against differences in many digits."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest
from scipy.spatial.transform import Rotation as SciPy

from cardan.ir.graph import Graph
from cardan.ir.matrix import Matrix
from cardan.spatial.rotations import ROTATIONS, SEQUENCES, Rotation, parametrization
from spatial.numbers_of import block, close, difference, moving, numbers, unskew
from table import each

EPS = np.finfo(float).eps
# largest angle that has coordinates
REACH = {"linear": pi / 2, "rodrigues": pi, "euler_rodrigues": pi}
ANGLES = (0.0, 1e-9, 1e-4, 0.3, 0.6, 0.9)  # of the reach, half a turn for the others


def coordinates(name: str, rotation: SciPy) -> np.ndarray:
    """Coordinates of a rotation by SciPy, or by the definition of the parametrization."""
    v = rotation.as_rotvec()
    angle = np.linalg.norm(v)
    n = v / angle if angle else v
    if name in SEQUENCES:
        return rotation.as_euler(name)
    return {
        "quaternion": lambda: rotation.as_quat(canonical=True, scalar_first=True),
        "rodrigues": lambda: np.tan(angle / 2) * n,
        "mrp": rotation.as_mrp,
        "conformal": lambda: 4 * rotation.as_mrp(),
        "euler_rodrigues": lambda: 2 * np.sin(angle / 2) * n,
        "rotation_vector": lambda: v,
        "linear": lambda: np.sin(angle) * n,
        "dcm": lambda: rotation.as_matrix()[:, :2].T.ravel(),
    }[name]()


def some(name: str, seed: int = 1) -> list[SciPy]:
    """Rotations inside the domain, small ones too where they are inside."""
    rng = np.random.default_rng(seed)
    proper = name in SEQUENCES and ROTATIONS[name].proper
    angles = [a * REACH.get(name, pi) for a in ANGLES if a > 0.1 or not proper]
    directions = rng.normal(size=(len(angles), 3))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    return [SciPy.from_rotvec(a * n) for a, n in zip(angles, directions, strict=True)]


@pytest.fixture(params=ROTATIONS)
def rotation(request: pytest.FixtureRequest) -> Rotation:
    return ROTATIONS[request.param]


def start(rotation: Rotation, angle: float, seed: int) -> list:
    """Coordinates in many digits, on the constraint of those that have one."""
    rng = np.random.default_rng(seed)
    v = rng.normal(size=3)
    graph = Graph()
    identity = Matrix.vector(graph, list(rotation.defaults))
    q = rotation.integrate(identity, block(graph, "du", 3))
    return list(numbers(q, "mp", du=v * (angle / np.linalg.norm(v))))


def test_matrix_is_that_of_scipy(rotation: Rotation) -> None:
    graph = Graph()
    R = rotation.matrix(block(graph, "q", len(rotation.components)))
    for wanted in some(rotation.name):
        found = numbers(R, q=coordinates(rotation.name, wanted))
        # linear parameters: 1 - sin² loses digits towards the quarter turn
        np.testing.assert_allclose(found, wanted.as_matrix(), atol=50 * EPS)


def test_coordinates_of_a_matrix_are_those_of_scipy(rotation: Rotation) -> None:
    graph = Graph()
    given = block(graph, "R", 9)
    q = rotation.from_matrix(Matrix(graph, 3, 3, given.nodes))
    for given_rotation in some(rotation.name):
        found = numbers(q, R=given_rotation.as_matrix().ravel())
        wanted = coordinates(rotation.name, given_rotation)
        size = 1 + np.abs(wanted).max()
        # tan(phi/2) near the half turn magnifies rounding by its square
        np.testing.assert_allclose(found, wanted, atol=30 * EPS * size**2)


def test_identity_has_the_default_coordinates(rotation: Rotation) -> None:
    graph = Graph()
    R = rotation.matrix(Matrix.vector(graph, list(rotation.defaults)))
    assert R.nodes == Matrix.identity(graph, 3).nodes or np.array_equal(numbers(R), np.eye(3))
    assert len(rotation.defaults) == len(rotation.components) == len(rotation.units)
    assert rotation.domain
    assert rotation.source


@pytest.mark.parametrize("angle", [0.01, 0.8, 1.4])
def test_rates_move_the_matrix_with_the_angular_velocity(rotation: Rotation, angle: float) -> None:
    graph = Graph()
    n = len(rotation.components)
    q, w, rate = (block(graph, name, k) for name, k in (("q", n), ("w", 3), ("rate", n)))
    at = start(rotation, angle, seed=n)
    omega = np.array([0.7, -1.3, 0.4])
    rates = numbers(rotation.rates(q, w), "mp", q=at, w=omega)
    # R^T Rdot is the skew matrix of omega
    path, R = moving(at, rates), rotation.matrix(q)
    turning = numbers(R, "mp", q=at).T @ difference(lambda t: numbers(R, "mp", q=path(t)))
    assert close(turning, -turning.T, 35)
    assert close(unskew(turning), omega, 35)
    assert close(numbers(rotation.omega(q, rate), "mp", q=at, rate=rates), omega, 35)


# rates of the others are not free; omega of rates is tested above
@each("name", [name for name, r in ROTATIONS.items() if len(r.components) == 3])
def test_rates_of_an_angular_velocity_of_rates(name: str) -> None:
    rotation, graph = ROTATIONS[name], Graph()
    q, rate = block(graph, "q", 3), block(graph, "rate", 3)
    again = rotation.rates(q, rotation.omega(q, rate))
    at, rates = start(rotation, 1.1, seed=5), [0.3, 2.0, -0.6]
    assert close(numbers(again, "mp", q=at, rate=rates), rates, 60)


@pytest.mark.parametrize("angle", [1e-9, 1e-3, 0.05, 0.7])
def test_integrate_and_difference_are_inverse(rotation: Rotation, angle: float) -> None:
    graph = Graph()
    n = len(rotation.components)
    q, du = block(graph, "q", n), block(graph, "du", 3)
    q0 = np.array(start(rotation, 0.6, seed=3), float)
    step = np.array([2.0, -1.0, 2.0]) / 3 * angle
    q1 = numbers(rotation.integrate(q, du), q=q0, du=step)
    end = block(graph, "end", n)
    back = numbers(rotation.difference(q, end), q=q0, end=q1)
    np.testing.assert_allclose(back, step, atol=40 * EPS)
    # the step is a rotation in the turned axes
    found = numbers(rotation.matrix(q), q=q1)
    wanted = numbers(rotation.matrix(q), q=q0) @ SciPy.from_rotvec(step).as_matrix()
    np.testing.assert_allclose(found, wanted, atol=40 * EPS)


@each("name", SEQUENCES)
@each("turns", [0.0, 4.0])
def test_angles_go_on_through_half_a_turn(name: str, turns: float) -> None:
    graph, sequence = Graph(), ROTATIONS[name]
    q, du = block(graph, "q", 3), block(graph, "du", 3)
    middle = 0.7 if sequence.proper else 0.4
    q0 = np.array([pi * (1 + turns) - 1e-3, middle, -pi * (1 + turns) + 1e-3])
    for sign in (1, -1):
        q1 = numbers(sequence.integrate(q, du), q=q0, du=[0.01 * sign, 0.02, -0.01 * sign])
        assert np.abs(q1 - q0).max() < 0.1


HUGE = 1e9
SINGULAR = {
    "quaternion": [(0.0, 0.0, 0.0, 0.0)],
    "dcm": [(0.6, 0.8, 0.0, -0.6, -0.8, 0.0)],
    "rodrigues": [(HUGE, 0.0, HUGE)],
    "mrp": [(0.0, HUGE, 0.0)],
    "conformal": [(0.0, 0.0, 4 * HUGE)],
    "euler_rodrigues": [(1.2, 0.0, 1.6), (0.0, -2.0, 0.0)],
    "rotation_vector": [(0.0, 2 * pi, 0.0)],
    "linear": [(0.6, 0.0, 0.8), (-1.0, 0.0, 0.0)],
} | {
    name: [(0.3, b, -0.8) for b in ((0.0, pi) if ROTATIONS[name].proper else (pi / 2, -pi / 2))]
    for name in SEQUENCES
}


def test_margin_is_zero_where_the_coordinates_fail(rotation: Rotation) -> None:
    graph = Graph()
    margin = rotation.margin(block(graph, "q", len(rotation.components)))
    for q in SINGULAR[rotation.name]:
        assert 0 <= numbers(margin, q=q) < 2e-8  # a root of a rounding, or 1/HUGE


def test_margin_is_one_where_the_coordinates_are_best(rotation: Rotation) -> None:
    graph = Graph()
    margin = rotation.margin(block(graph, "q", len(rotation.components)))
    best = rotation.defaults if rotation.name not in SEQUENCES else (0.4, 0.0, 2.0)
    if rotation.name in SEQUENCES and rotation.proper:
        best = (0.4, pi / 2, 2.0)
    assert numbers(margin, q=best) == pytest.approx(1.0, rel=1e-15)


def test_an_unknown_parametrization_is_told_the_near_one() -> None:
    with pytest.raises(ValueError, match=r"'quaternions' does not.*Did you mean 'quaternion'"):
        parametrization("quaternions")
    with pytest.raises(ValueError, match="free joint: parametrization 3 does not exist"):
        parametrization(3, "free joint")
