"""Bodies on bases that move as prescribed: what is free moves as if there were no base."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

import cardan as cd

TIGHT = {"rtol": 1e-11, "atol": 1e-13}


def test_puck_on_a_turning_platform() -> None:
    """A straight line seen from the platform: Coriolis and centrifugal force in closed form."""
    turn, start, speed = 1.7, np.array([0.6, 0.0]), np.array([-0.3, 0.4])
    scene = cd.Model("platform", gravity=(0, 0, 0))
    platform, puck = scene.body("platform"), scene.body("puck", mass=0.2, inertia=(1, 1, 1))
    scene.joint("turn", cd.Revolute("z"), scene.ground, platform, motion=turn * cd.t)
    scene.joint("slide", cd.Planar("z"), platform, puck)
    # at rest against the ground it moves backward against the platform
    seen = speed - turn * np.array([-start[1], start[0]])
    motion = cd.compile(scene).simulate(
        5.0, q={"slide": [*start, 0]}, u={"slide": [*seen, 0]}, **TIGHT
    )
    straight = start[:, None] + speed[:, None] * motion.t
    c, s = np.cos(turn * motion.t), np.sin(turn * motion.t)
    wanted = np.array([c * straight[0] + s * straight[1], c * straight[1] - s * straight[0]])
    np.testing.assert_allclose(motion.q[:, :2].T, wanted, atol=1e-9)


@pytest.mark.parametrize("latitude", [0.9, -0.4])
def test_pendulum_of_foucault(latitude: float) -> None:
    """Its plane turns by -Omega sin(latitude), less Omega^2 / omega^2 and squares of its swing."""
    turn, length, swing, end = 0.01, 1.0, 5e-3, 60.0
    scene = cd.Model("foucault", gravity=(0, 0, 0))
    earth, bob = scene.body("earth"), scene.body("bob", mass=2.0, com=(0, 0, -length))
    scene.joint("day", cd.Revolute("z"), scene.ground, earth, motion=turn * cd.t)
    # x to the south, y to the east, z up
    site = earth.at(rotation=("XYZ", 0, np.pi / 2 - latitude, 0))
    scene.joint("pivot", cd.Universal("x", "y"), site, bob)
    tip = bob.at(0, 0, -length)
    scene.force("weight", cd.Force(tip, (0, 0, -9.81 * 2.0), in_=site))
    path = tip.position(in_=site)
    scene.output("south", path[0])
    scene.output("east", path[1])
    period = 2 * np.pi / np.sqrt(9.81 / length)
    times = end + np.linspace(0, period, 41)[:-1]
    motion = cd.compile(scene).simulate([0, *times], q={"pivot": [0, -swing]}, **TIGHT)
    # about where it would hang at rest, which the turning of the base moves a little
    south, east = (x[1:] - x[1:].mean() for x in (motion["south"], motion["east"]))
    # turned back by the closed form it swings to the south as it began
    back = (south + 1j * east) * np.exp(1j * turn * np.sin(latitude) * motion.t[1:])
    plane = np.arctan2(2 * back.real @ back.imag, back.real @ back.real - back.imag @ back.imag) / 2
    assert abs(plane) < 2e-4 * turn * end


def test_free_body_on_a_ship() -> None:
    """Whatever the six coordinates of the base do, by expressions and an input."""
    scene = cd.Model("ship", gravity=(0, 0, -9.81))
    heave = scene.input("heave")
    moves = {
        "surge": (cd.Prismatic("x"), 2 * cd.t + sp.Rational(1, 5) * sp.sin(cd.t)),
        "sway": (cd.Prismatic("y"), sp.cos(cd.t / 2)),
        "heave_slide": (cd.Prismatic("z"), heave),
        "yaw": (cd.Revolute("z"), sp.Rational(1, 3) * cd.t),
        "pitch": (cd.Revolute("y"), sp.sin(2 * cd.t) / 10),
        "roll": (cd.Revolute("x"), sp.sin(3 * cd.t + 1) / 4),
    }
    place = scene.ground
    for name, (kind, path) in moves.items():
        carried = scene.body(f"on_{name}")
        scene.joint(name, kind, place, carried, motion=path)
        place = carried
    ball = scene.body("ball", mass=0.4, inertia=(0.01, 0.02, 0.03))
    scene.joint("flight", cd.Free(), place.at(1, 2, 3), ball)
    model = cd.compile(scene)
    times = np.linspace(0, 2, 81)
    motion = model.simulate(2.0, inputs={"heave": (times, 0.3 * np.sin(1.5 * times))}, **TIGHT)
    found = motion.pose("ball")[:, :3, 3]
    # less the fall the path is straight, and run at constant speed
    straight = found - np.outer(motion.t**2, [0, 0, -9.81 / 2])
    wanted = straight[0] + np.outer(motion.t / motion.t[-1], straight[-1] - straight[0])
    np.testing.assert_allclose(straight, wanted, atol=1e-8)
    assert np.ptp(found, axis=0).min() > 0.1
