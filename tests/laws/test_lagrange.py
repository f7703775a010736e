"""Small mechanisms against Lagrange's equations derived by SymPy from poses alone."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from laws.lagrange import Lagrangian, Rigid, rates, turn
from mechanisms import ZOO
from spread import some

SEED = 3
STATES = 10
DOWN = (0, 0, -9.81)


def vector(*entries: object) -> sp.Matrix:
    return sp.Matrix(entries)


def rod_inertia(mass: float, length: float) -> sp.Matrix:
    """A thin rod along z."""
    return sp.diag(mass * length**2 / 12, mass * length**2 / 12, 0)


def pendulum() -> tuple:
    q = sp.symbols("pivot")
    r = turn("y", q)
    rod = Rigid(1.2, rod_inertia(1.2, 0.8), r, r * vector(0, 0, -0.4))
    return [q], [rod], DOWN


def double_pendulum() -> tuple:
    a, b = sp.symbols("shoulder elbow")
    ra, rb = turn("y", a), turn("y", a + b)
    upper = Rigid(1.0, rod_inertia(1.0, 0.6), ra, ra * vector(0, 0, -0.3))
    hip = ra * vector(0, 0, -0.6)
    lower = Rigid(0.4, rod_inertia(0.4, 0.5), rb, hip + rb * vector(0, 0, -0.25))
    return [a, b], [upper, lower], DOWN


def cart_pole() -> tuple:
    x, a = sp.symbols("track hinge")
    r = turn("y", a)
    cart = Rigid(2.0, sp.diag(0.1, 0.2, 0.3), sp.eye(3), vector(x, 0, 0))
    place = vector(x + 0.1, 0, 0.2) + r * vector(0, 0.02, -0.4)
    pole = Rigid(0.5, sp.diag(0.03, 0.03, 0.001), r, place)
    return [x, a], [cart, pole], DOWN


def cylindrical() -> tuple:
    a, d, b = sp.symbols("angle displacement hinge")
    r = turn((3, 0, 4), a)
    origin = vector(sp.Rational(3, 5), 0, sp.Rational(4, 5)) * d
    inertia = sp.diag(0.02, 0.03, 0.025)
    collar = Rigid(1.5, inertia, r, origin + r * vector(0.1, 0, 0.05))
    rb = r * turn("y", b)
    place = origin + r * vector(0.2, 0, 0) + rb * vector(0, 0, -0.3)
    bob = Rigid(0.7, sp.diag(0.01, 0.01, 0.002), rb, place)
    return [a, d, b], [collar, bob], DOWN


def screw() -> tuple:
    a, b = sp.symbols("thread hinge")
    # the pitch is the advance per radian
    r, origin = turn("z", a), vector(0, 0, 0.08 * a)
    nut = Rigid(2.0, sp.diag(0.05, 0.04, 0.06), r, origin + r * vector(0.15, 0, 0))
    rb = r * turn("y", b)
    place = origin + r * vector(0.2, 0, 0) + rb * vector(0.3, 0, 0)
    arm = Rigid(0.5, sp.diag(0.001, 0.02, 0.02), rb, place)
    return [a, b], [nut, arm], (0, 1.5, -9.81)


def universal() -> tuple:
    a, b, c = sp.symbols("bearing first second")
    r = turn("z", a)
    shaft = Rigid(3.0, sp.diag(0.02, 0.02, 0.04), r, vector(0, 0, 0))
    rb = r * turn("x", b) * turn("y", c)
    place = r * vector(0, 0, -0.1) + rb * vector(0.02, 0, -0.3)
    rotor = Rigid(2.0, sp.diag(0.05, 0.05, 0.01), rb, place)
    return [a, b, c], [shaft, rotor], DOWN


def planar() -> tuple:
    x, y, a, b = sp.symbols("x y angle hinge")
    r, origin = turn("z", a), vector(x, y, 0)
    puck = Rigid(1.0, sp.diag(0.01, 0.01, 0.02), r, origin + r * vector(0.05, 0.02, 0))
    rb = r * turn((1, 0, 1), b)
    place = origin + r * vector(0, 0.1, -0.1) + rb * vector(0.1, 0, -0.2)
    flag = Rigid(0.3, sp.diag(0.004, 0.005, 0.002), rb, place)
    return [x, y, a, b], [puck, flag], (0.8, 0, -9.81)


def parabola() -> tuple:
    x, b = sp.symbols("x hinge")
    r, origin = turn("y", -sp.atan(x)), vector(x, 0, x**2 / 2)
    sledge = Rigid(1.0, sp.diag(0.02, 0.03, 0.04), r, origin + r * vector(0, 0, 0.1))
    rb = r * turn("y", b)
    bob = Rigid(0.4, sp.diag(0.004, 0.004, 0.001), rb, origin + rb * vector(0, 0, -0.3))
    return [x, b], [sledge, bob], DOWN


SMALL: dict[str, Callable[[], tuple]] = {
    f.__name__: f
    for f in (
        pendulum, double_pendulum, cart_pole, cylindrical, screw, universal, planar, parabola,
    )
}  # fmt: skip


@pytest.mark.parametrize("name", some(SMALL, 2))
def test_joints_whose_speeds_are_rates(name: str) -> None:
    q, bodies, gravity = SMALL[name]()
    lagrangian = Lagrangian(q, bodies, gravity)
    model = cd.compile(ZOO[name].build())
    rng = np.random.default_rng(SEED)
    for _ in range(STATES):
        place, speed = rng.uniform(-1.2, 1.2, (2, len(q)))
        expected = lagrangian.accelerations(place, speed)
        mass = lagrangian.mass(place, speed)
        # both solve with M: its condition is what either may lose
        allowed = 100 * np.finfo(float).eps * np.linalg.cond(mass)
        computed = model.forward_dynamics(place, speed)
        assert np.abs(computed - expected).max() <= allowed * np.abs(expected).max()
        np.testing.assert_allclose(model.mass_matrix(place), mass, rtol=0, atol=1e-14 * mass.max())
        kinetic, potential = lagrangian.energy(place, speed)
        energy = model.energy(place, speed)
        assert energy.kinetic == pytest.approx(kinetic, rel=1e-13)
        assert energy.potential == pytest.approx(potential, rel=1e-13, abs=1e-13)


@pytest.mark.parametrize("rotation", some(["XYZ", "ZXZ", "zyx"], 3))
def test_ball_joint_in_euler_angles(rotation: str) -> None:
    angles = sp.symbols("a b c")
    letters = list(zip(rotation.lower(), angles, strict=True))
    # space-fixed turns are applied in reverse order
    first, second, third = letters if rotation.isupper() else letters[::-1]
    r = turn(*first) * turn(*second) * turn(*third)
    scene = cd.Scene("top", gravity=DOWN)
    com, diagonal = (0.1, -0.2, 0.4), (0.06, 0.05, 0.07)
    body = scene.body("top", mass=1.5, com=com, inertia=diagonal)
    scene.joint("ball", cd.Spherical(rotation=rotation), scene.ground, body)
    model = cd.compile(scene)
    top = Rigid(1.5, sp.diag(*diagonal), r, r * vector(*com))
    lagrangian = Lagrangian(angles, [top], DOWN)
    # omega = B qdot, its derivative = B qddot + Bdot qdot
    q, qdot = sp.Matrix(angles), sp.Matrix(sp.symbols("da db dc"))
    omega = rates([top], q, qdot)[0][1]
    to_speeds = sp.lambdify([angles, list(qdot)], (omega.jacobian(qdot), omega.jacobian(q)))
    rng = np.random.default_rng(SEED)
    for _ in range(STATES):
        place, rate = rng.uniform(0.4, 1.1, 3), rng.uniform(-2, 2, 3)
        turning, change = to_speeds(place, rate)
        expected = turning @ lagrangian.accelerations(place, rate) + change @ rate
        computed = model.forward_dynamics(place, turning @ rate)
        # the angles lose what B loses, at most 1/sin(0.4) squared
        allowed = 1e3 * np.finfo(float).eps * np.linalg.cond(lagrangian.mass(place, rate))
        assert np.abs(computed - expected).max() <= allowed * np.abs(expected).max()
        np.testing.assert_allclose(model.qdot(place, turning @ rate), rate, rtol=0, atol=1e-13)
