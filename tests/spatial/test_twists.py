"""Twists, wrenches and inertias: what must not depend on reference points and axes."""

from __future__ import annotations

import numpy as np
import pytest

from cardan.errors import ModelError
from cardan.ir.graph import Graph
from cardan.spatial.axis import rotation_about, unit
from cardan.spatial.dyadics import Dyadic
from cardan.spatial.frames import Frame
from cardan.spatial.inertia import RigidInertia, composite, parallel_axes, principal
from cardan.spatial.twists import Twist, Wrench
from cardan.spatial.vectors import Vector
from spatial.numbers_of import block, numbers

RNG = np.random.default_rng(7)
VALUES = {name: RNG.normal(size=3) for name in ("w", "v", "m", "f", "r", "n", "q", "c")}


class Bench:
    """Two frames and vectors that are input blocks."""

    def __init__(self) -> None:
        self.graph = Graph()
        self.root = Frame(self.graph, "root")
        axis, q = block(self.graph, "n", 3), block(self.graph, "q", 3)
        self.other = self.root.turned("other", rotation_about(unit(axis), q[0]))
        self.twist = Twist(self.vector("w"), self.vector("v"), "O")
        self.wrench = Wrench(self.vector("m"), self.vector("f"), "O")

    def vector(self, name: str) -> Vector:
        return Vector(self.root, block(self.graph, name, 3))

    def scalar(self, name: str) -> object:
        return block(self.graph, name, 1)[0]

    def body(self, n: str, point: str = "O") -> RigidInertia:
        """Mass m, center c, inertia of three point masses along the axes of the root."""
        frame = self.root
        x, y, z = block(self.graph, f"arms{n}", 3)
        arms = ([x, 0, 0], [0, y, 0], [x, y, z])
        masses = [parallel_axes(self.scalar(f"mass{n}"), Vector.of(frame, arm)) for arm in arms]
        central = masses[0] + masses[1] + masses[2]
        return RigidInertia(self.scalar(f"mass{n}"), self.vector(f"com{n}"), central, point)


BODIES = {
    "mass1": [2.0], "mass2": [0.7], "arms1": [0.5, 0.2, 0.9], "arms2": [0.3, 0.3, -0.4],
    "com1": [1.0, -2.0, 0.3], "com2": [0.2, 0.1, -1.0],
}  # fmt: skip


def value(x: object, **values: object) -> object:
    return numbers(x, **(VALUES | BODIES | values))


@pytest.fixture
def bench() -> Bench:
    return Bench()


def test_power_depends_on_neither_point_nor_axes(bench: Bench) -> None:
    power = value(bench.wrench.power(bench.twist))
    assert power == pytest.approx(VALUES["m"] @ VALUES["w"] + VALUES["f"] @ VALUES["v"], rel=1e-14)
    r = bench.vector("r")
    moved = bench.wrench.moved("P", r).power(bench.twist.moved("P", r))
    assert value(moved) == pytest.approx(power, rel=1e-13)
    turned = bench.wrench.express(bench.other).power(bench.twist.express(bench.other))
    assert value(turned) == pytest.approx(power, rel=1e-13)


def test_moving_there_and_back(bench: Bench) -> None:
    r = bench.vector("r")
    for screw in (bench.twist, bench.wrench):
        back = screw.moved("P", r).moved("O", -r)
        np.testing.assert_allclose(value((back - screw).column), 0, atol=1e-15)
        np.testing.assert_allclose(value((back + screw).column), 2 * value(screw.column))


@pytest.mark.parametrize("name", ["twist", "wrench"])
def test_on_the_screw_axis_both_vectors_are_parallel(bench: Bench, name: str) -> None:
    motion = getattr(bench, name)
    screw = motion.screw()
    local = motion.moved("axis", screw.position).column
    whole = VALUES["w"] if name == "twist" else VALUES["f"]
    column = value(local)
    own = column[3:] if name == "twist" else column[:3]
    np.testing.assert_allclose(own, value(screw.pitch) * whole, atol=1e-14)
    np.testing.assert_allclose(value(screw.direction.components) * value(screw.around), whole)
    assert value(screw.position.dot(screw.direction)) == pytest.approx(0, abs=1e-15)
    assert value(screw.along) == pytest.approx(value(screw.pitch) * value(screw.around), rel=1e-14)


def test_a_screw_of_known_axis_and_pitch(bench: Bench) -> None:
    """Turning at 3 rad/s about the line through (1, 2, 0) along z, 0.5 m per radian."""
    screw = bench.twist.screw()
    at = {"w": [0, 0, 3.0], "v": [6.0, -3.0, 1.5]}
    assert np.array_equal(value(screw.position.components, **at), [1, 2, 0])
    assert np.array_equal(value(screw.direction.components, **at), [0, 0, 1])
    assert value(screw.pitch, **at) == 0.5
    assert value(screw.around, **at) == 3.0


@pytest.mark.parametrize("name", ["twist", "wrench"])
def test_without_turning_the_axis_is_along_the_other_vector(bench: Bench, name: str) -> None:
    """A pure translation, or a pure torque; then nothing at all."""
    screw = getattr(bench, name).screw()
    whole, local = ("w", "v") if name == "twist" else ("f", "m")
    at = {whole: np.zeros(3), local: [0.0, 3.0, -4.0]}
    np.testing.assert_allclose(value(screw.direction.components, **at), [0, 0.6, -0.8])
    assert np.array_equal(value(screw.position.components, **at), np.zeros(3))
    assert value(screw.along, **at) == pytest.approx(5.0, rel=1e-15)
    assert value(screw.around, **at) == 0
    assert value(screw.pitch, **at) == np.inf
    nothing = {whole: np.zeros(3), local: np.zeros(3)}
    assert np.array_equal(value(screw.direction.components, **nothing), np.zeros(3))
    assert value(screw.along, **nothing) == 0


def test_mixed_points_and_frames_name_both(bench: Bench) -> None:
    r = bench.vector("r")
    for operation in (
        lambda: bench.twist + bench.twist.moved("P", r),
        lambda: bench.wrench - bench.wrench.moved("P", r),
        lambda: bench.wrench.power(bench.twist.moved("P", r)),
        lambda: bench.body("1") + bench.body("2", "P"),
    ):
        with pytest.raises(ModelError, match=r"points 'O' and 'P' cannot be combined.*moved"):
            operation()
    with pytest.raises(ModelError, match="'root' and 'other' cannot be combined"):
        Twist(bench.vector("w"), bench.vector("v").express(bench.other), "O")
    with pytest.raises(ModelError, match="'root' and 'other' cannot be combined"):
        bench.wrench.power(bench.twist.express(bench.other))


# inertia


def points(n: str) -> tuple[np.ndarray, np.ndarray]:
    """Six point masses with the mass, center and inertia of a body of the bench.

    Each of its three masses m at an arm becomes m/6 at + and - sqrt(3) times the arm.
    """
    x, y, z = BODIES[f"arms{n}"]
    arms = np.sqrt(3) * np.array([[x, 0, 0], [0, y, 0], [x, y, z]])
    return BODIES[f"mass{n}"][0] / 6 * np.ones(6), np.vstack([arms, -arms]) + BODIES[f"com{n}"]


def inertia_of(masses: np.ndarray, at: np.ndarray) -> np.ndarray:
    return sum(m * (p @ p * np.eye(3) - np.outer(p, p)) for m, p in zip(masses, at, strict=True))


def test_inertia_about_the_reference_point(bench: Bench) -> None:
    """Parallel axes, against the sum over points."""
    body = bench.body("1")
    np.testing.assert_allclose(
        value(body.about_point().components), inertia_of(*points("1")), rtol=1e-13, atol=1e-14
    )
    masses, at = points("1")
    moved = body.moved("P", bench.vector("r")).about_point()
    np.testing.assert_allclose(
        value(moved.components), inertia_of(masses, at - VALUES["r"]), rtol=1e-13, atol=1e-14
    )
    turned, R = body.express(bench.other), value(bench.root.rotation_in(bench.other))
    np.testing.assert_allclose(
        value(turned.about_point().components), inertia_of(masses, at @ R.T), rtol=1e-13, atol=1e-14
    )


def test_a_composite_is_the_sum_over_its_points(bench: Bench) -> None:
    both = composite(bench.body("1"), bench.body("2"))
    masses, at = (np.concatenate(x) for x in zip(points("1"), points("2"), strict=True))
    assert value(both.mass) == pytest.approx(masses.sum(), rel=1e-15)
    np.testing.assert_allclose(value(both.com.components), masses @ at / masses.sum(), rtol=1e-14)
    np.testing.assert_allclose(
        value(both.about_point().components), inertia_of(masses, at), rtol=1e-13, atol=1e-14
    )
    with pytest.raises(ModelError, match="composite: no bodies"):
        composite()


def test_momentum_and_energy_are_the_sums_over_points(bench: Bench) -> None:
    body = bench.body("1")
    masses, at = points("1")
    velocities = VALUES["v"] + np.cross(VALUES["w"], at)
    angular = (masses[:, None] * np.cross(at, velocities)).sum(axis=0)
    found = value(body.momentum(bench.twist).column)
    np.testing.assert_allclose(found, [*angular, *(masses @ velocities)], rtol=1e-12)
    energy = 0.5 * masses @ (velocities**2).sum(axis=1)
    assert value(body.kinetic_energy(bench.twist)) == pytest.approx(energy, rel=1e-13)
    # the same at another reference point
    r = bench.vector("r")
    elsewhere = body.moved("P", r).kinetic_energy(bench.twist.moved("P", r))
    assert value(elsewhere) == pytest.approx(energy, rel=1e-13)


def test_principal_moments_and_axes() -> None:
    matrix = inertia_of(*points("1"))
    moments, axes = principal(matrix)
    assert moments[0] <= moments[1] <= moments[2] <= moments[0] + moments[1]
    np.testing.assert_allclose(axes @ np.diag(moments) @ axes.T, matrix, atol=1e-14)
    np.testing.assert_allclose(axes.T @ axes, np.eye(3), atol=1e-15)
    assert np.linalg.det(axes) == pytest.approx(1.0, rel=1e-14)
    moments, axes = principal(np.diag([1.0, 2.0, 3.0]))
    assert np.array_equal(moments, [1, 2, 3])
    assert np.array_equal(axes, np.eye(3))


@pytest.mark.parametrize(
    ("matrix", "message"),
    [
        (np.zeros((2, 2)), r"shape \(2, 2\); give 3 x 3"),
        (np.full((3, 3), np.nan), "finite numbers"),
        ([[1, 0.1, 0], [0, 1, 0], [0, 0, 1]], "not symmetric"),
    ],
)
def test_what_has_no_principal_axes(matrix: object, message: str) -> None:
    with pytest.raises(ModelError, match=message):
        principal(matrix)


def test_a_sphere_turns_into_itself(bench: Bench) -> None:
    ball = Dyadic.identity(bench.root) * 0.4
    np.testing.assert_allclose(
        value(ball.express(bench.other).components), 0.4 * np.eye(3), atol=1e-15
    )
