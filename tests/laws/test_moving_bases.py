"""Bodies on bases that move as prescribed: what is free moves as if there were no base."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from laws.cases import call

TIGHT = {"rtol": 1e-11, "atol": 1e-13}


def test_puck_on_a_turning_platform() -> None:
    """A straight line seen from the platform: Coriolis and centrifugal force in closed form."""
    turn, start, speed = 1.7, np.array([0.6, 0.0]), np.array([-0.3, 0.4])
    scene = cd.Scene("platform", gravity=(0, 0, 0))
    platform, puck = scene.body("platform"), scene.body("puck", mass=0.2, inertia=(1, 1, 1))
    scene.joint("turn", cd.Revolute("z"), scene.ground, platform, prescribed=turn * cd.t)
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
    scene = cd.Scene("foucault", gravity=(0, 0, 0))
    earth, bob = scene.body("earth"), scene.body("bob", mass=2.0, com=(0, 0, -length))
    scene.joint("day", cd.Revolute("z"), scene.ground, earth, prescribed=turn * cd.t)
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
    scene = cd.Scene("ship", gravity=(0, 0, -9.81))
    ship, half = scene.body("ship"), sp.Rational(1, 2)
    moves = (half * sp.sin(cd.t / 3), sp.sin(2 * cd.t) / 10, sp.sin(3 * cd.t + 1) / 4)
    places = (2 * cd.t + half * sp.sin(cd.t), sp.cos(cd.t / 2), scene.input("heave"))
    scene.joint("sea", cd.Free("ZYX"), scene.ground, ship, prescribed=(*moves, *places))
    ball = scene.body("ball", mass=0.4, inertia=(0.01, 0.02, 0.03))
    scene.joint("flight", cd.Free(), ship.at(1, 2, 3), ball)
    model = cd.compile(scene)
    times = np.linspace(0, 2, 81)
    motion = model.simulate(2.0, inputs={"heave": (times, 0.3 * np.sin(1.5 * times))}, **TIGHT)
    found = motion.pose("ball")[:, :3, 3]
    # less the fall the path is straight, and run at constant speed
    straight = found - np.outer(motion.t**2, [0, 0, -9.81 / 2])
    wanted = straight[0] + np.outer(motion.t / motion.t[-1], straight[-1] - straight[0])
    np.testing.assert_allclose(straight, wanted, atol=1e-8)
    assert np.ptp(found, axis=0).min() > 0.1


KINDS = {
    "free": (cd.Free("zxy"), 6),
    "free, turning along": (cd.Free("YXZ"), 6),
    "spherical": (cd.Spherical("ZXZ"), 3),
    "universal": (cd.Universal((1, 2, 0), (0, 1, -1)), 2),
    "cylindrical": (cd.Cylindrical((1, 1, 1)), 2),
    "planar": (cd.Planar("y"), 3),
    "translation": (cd.Translation(), 3),
    "planar, from behind": (cd.Planar("-x"), 3),
}


@pytest.mark.parametrize("name", KINDS)
def test_a_joint_is_its_steps(name: str, tmp_path: Path) -> None:
    """Prescribed one by one, in Python and from a file, or free: the same pose."""
    kind, count = KINDS[name]
    q = [0.3, -0.5, 0.8, 0.2, 0.7, -0.4][:count]
    motion: list[float | None] = [*q[:-1], None]
    scenes = [cd.Scene("moved"), cd.Scene("free")]
    for scene, given in zip(scenes, (motion, None), strict=True):
        body = scene.body("body", mass=1.0, inertia=(1, 1, 1))
        scene.joint("way", kind, scene.ground.at(0.1, 0, 0), body.at(0, 0.2, 0), prescribed=given)
    scenes[0].save(tmp_path / "scene.yaml")
    (free,) = call(cd.derive(scenes[1]), "pose", "body", q=np.array(q)).values()
    for scene in (scenes[0], cd.load(tmp_path / "scene.yaml")):
        (found,) = call(cd.derive(scene), "pose", "body", q=np.array(q[-1:])).values()
        np.testing.assert_allclose(found, free, atol=1e-15)


@pytest.mark.parametrize(
    ("kind", "more", "message"),
    [
        (
            cd.Free(),
            {"prescribed": [0] * 7},
            r"free\): prescribed= moves the coordinates .*cd.Free\(\"ZYX\"\)",
        ),
        (
            cd.Free("ZYX"),
            {"prescribed": [0] * 5},
            "prescribed= has 5 values; give 6, for angle1, .*, pz",
        ),
        (
            cd.Universal(),
            {"prescribed": [0, 0], "q0": [0, 0]},
            "q0= does not go with prescribed= for",
        ),
    ],
)
def test_bad_motions_leave_nothing(kind: Any, more: dict[str, Any], message: str) -> None:
    scene = cd.Scene("bad")
    body = scene.body("body", mass=1.0, inertia=(1, 1, 1))
    with pytest.raises(cd.ModelError, match=message):
        scene.joint("way", kind, scene.ground, body, **more)
    assert list(scene.bodies) == ["body"]
    assert not scene.joints
