"""Generalized speeds at will, and more coordinates than degrees of freedom."""

from __future__ import annotations

import math

import numpy as np
import pytest
import sympy

import cardan as cd
from cardan.equations.formalisms import FORMALISMS
from laws.cases import call
from mechanisms.rolling import COIN, coin
from table import each

CHOOSING = [name for name, formalism in FORMALISMS.items() if formalism.chooses]
EXACT = ("multipliers", "elimination", "null_space")
L, G = 0.8, 9.81


def bob() -> cd.Scene:
    """A pendulum as a point in x and z on a circle: two coordinates, one degree of freedom."""
    scene = cd.Scene("bob", gravity=(0, 0, -G))
    slider, point = scene.body("slider", mass=0), scene.body("bob", mass=1.3)
    scene.joint("x", cd.Prismatic("x"), scene.ground, slider)
    scene.joint("z", cd.Prismatic("z"), slider, point)
    scene.constraint("rod", scene.q("x") ** 2 + scene.q("z") ** 2 - L**2, unit="m^2")
    return scene


@each(
    ("method", "way"),
    [(m, EXACT[n % 3]) for n, m in enumerate(CHOOSING)] + [("kane", "null_space")],
)
def test_pendulum_in_cartesian_coordinates(method: str, way: str) -> None:
    """By speeds along and across the rod: L theta'' = -g sin(theta), and none along it."""
    scene = bob()
    x, z, ux, uz = scene.q("x"), scene.q("z"), scene.u("x"), scene.u("z")
    speeds = {"across": (x * uz - z * ux) / L, "along": (x * ux + z * uz) / L}
    e = cd.derive(scene, method=method, constraints=way, speeds=speeds)
    theta, rate = 0.7, 1.4
    q, w = np.array([L * math.sin(theta), -L * math.cos(theta)]), np.array([L * rate, 0.0])
    found = call(e, "forward_dynamics", q=q, u=w)["udot"]
    np.testing.assert_allclose(found, [-G * math.sin(theta), 0], rtol=0, atol=1e-13)
    qdot = [L * rate * math.cos(theta), L * rate * math.sin(theta)]
    np.testing.assert_allclose(call(e, "qdot", q=q, u=w)["qdot"], qdot, rtol=0, atol=1e-15)


@pytest.mark.parametrize("method", ["kane", "lagrange"])
def test_a_dependent_pendulum_runs(method: str) -> None:
    """As the pendulum of one angle does, by speeds of which one depends on the other."""
    scene = bob()
    x, z, ux, uz = scene.q("x"), scene.q("z"), scene.u("x"), scene.u("z")
    model = cd.compile(
        scene,
        method=method,
        constraints="null_space",
        speeds={"across": (x * uz - z * ux) / L, "along": (x * ux + z * uz) / L},
    )
    start = {"x": L * math.sin(0.7), "z": -L * math.cos(0.7)}
    motion = model.simulate(2.0, q=start, rtol=1e-10, atol=1e-12)
    single = cd.Scene("single", gravity=(0, 0, -G))
    rod = single.body("rod", mass=1.3, com=(0, 0, -L))
    single.joint("theta", cd.Revolute("y"), single.ground, rod)
    wanted = cd.compile(single).simulate(2.0, q={"theta": -0.7}, rtol=1e-11, atol=1e-13)
    # both runs to their tolerance, over a time of two swings
    assert motion["x"][-1] == pytest.approx(-L * math.sin(wanted["theta"][-1]), abs=1e-8)


@pytest.mark.parametrize("method", CHOOSING)
def test_rolling_disk_in_axes_of_its_contact(method: str) -> None:
    """Angular velocities in axes that lean but do not spin with the disk.

    Source: SymPy, documentation of sympy.physics.mechanics, "A rolling disc": udot of lean, spin
    and yaw of a thin uniform disk that rolls.
    """
    scene, r, g = coin(), COIN["r"], COIN["g"]
    lean = scene.q("rolls.lean")
    yaw_rate, lean_rate, spin_rate = (scene.u(f"rolls.{n}") for n in ("yaw", "lean", "spin"))
    speeds = {
        "w1": lean_rate,
        "w2": spin_rate + yaw_rate * sympy.sin(lean),
        "w3": yaw_rate * sympy.cos(lean),
        # of these rolling leaves none free
        "vx": scene.u("rolls.x"),
        "vy": scene.u("rolls.y"),
    }
    e = cd.derive(scene, method=method, speeds=speeds)
    yaw, angle, w = 0.4, 0.3, np.array([0.5, -2.0, 1.2])
    q = np.array([0.0, 0.0, yaw, angle, 0.2])
    # the contact moves along the heading as far as the edge turns
    v = r * (w[1] - w[2] * math.tan(angle))
    u = np.array([*w, v * math.cos(yaw), v * math.sin(yaw)])
    assert np.abs(call(e, "constraint_rates", q=q, u=u)["rates"]).max() < 1e-14
    found = call(e, "forward_dynamics", q=q, u=u)["udot"][:3]
    tan = math.tan(angle)
    expected = [
        (4 * g * math.sin(angle) + 6 * r * w[1] * w[2] - r * w[2] ** 2 * tan) / (5 * r),
        -2 * w[0] * w[2] / 3,
        (-2 * w[1] + w[2] * tan) * w[0],
    ]
    np.testing.assert_allclose(found, expected, rtol=1e-12)


def test_velocities_of_frames_are_speeds() -> None:
    """A point's velocity as generalized speed: the mass belongs to it alone."""
    scene = cd.Scene("point", gravity=(0, 0, -G))
    arm, hand = scene.body("arm", mass=0), scene.body("hand", mass=2.0, com=(0.3, 0, 0))
    scene.joint("shoulder", cd.Revolute("y"), scene.ground, arm)
    scene.joint("elbow", cd.Revolute("y"), arm.at(0.5, 0, 0), hand)
    tip = hand.at(0.3, 0, 0).velocity()
    model = cd.compile(scene, speeds={"vx": tip[0], "vz": tip[2]})
    q = [0.3, 0.9]
    np.testing.assert_allclose(model.mass_matrix(q), 2.0 * np.eye(2), rtol=0, atol=1e-14)
    np.testing.assert_allclose(model.forward_dynamics(q, [0.4, -0.7]), [0, -G], atol=1e-12)
    with pytest.raises(cd.ModelError, match=r"'speed vx': symbol 'hand.acceleration.x'"):
        cd.derive(scene, speeds={"vx": hand.acceleration()[0], "vz": tip[2]})
