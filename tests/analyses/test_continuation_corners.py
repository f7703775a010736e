"""Paths through stops, latches and dry friction, against closed forms."""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd

POINT = {"mass": 1.0, "inertia": (1.0, 1.0, 1.0)}
RISE, FLOOR = 0.5, -0.4
COORDINATES = pytest.mark.parametrize("coordinates", ["relative", "absolute"])


def truss(coordinates: str) -> cd.CompiledModel:
    """An apex between two bars of EA = 1 that snaps down onto a stop."""
    scene = cd.Scene("truss", gravity=(0, 0, 0))
    load, length = scene.parameter("P", 0.0), float(np.hypot(1.0, RISE))
    apex = scene.body("apex", **POINT)
    scene.joint("up", cd.Prismatic("z"), scene.ground.at(0, 0, RISE), apex)
    for name, x in (("left", -1.0), ("right", 1.0)):
        bar = cd.SpringDamper(
            scene.ground.at(x, 0, 0), apex, stiffness=1 / length, rest_length=length
        )
        scene.force(name, bar)
    scene.force("load", cd.Force(apex, (0, 0, -1 * load)))
    scene.force("floor", cd.Stop("up", lower=FLOOR, restitution=0.0))
    return cd.compile(scene, coordinates=coordinates)


def borne(up: float) -> float:
    """The load that the bars bear."""
    height = RISE + up
    return 2 * height * (1 / np.hypot(1.0, height) - 1 / np.hypot(1.0, RISE))


@COORDINATES
def test_a_stop_turns_the_load_back(coordinates: str) -> None:
    """Past the limit load less and less is borne, until the stop bears what is added."""
    model = truss(coordinates)
    path = model.continuation(P=(0, 1))
    assert [point.kind for point in path.points] == ["fold", "event", "event"]
    corner = path.point("floor.lower")
    assert corner["P"] == pytest.approx(borne(FLOOR), abs=1e-10)
    assert corner["up"] == pytest.approx(FLOOR, abs=1e-10)
    assert path.success
    assert path["up"][-1] == pytest.approx(FLOOR, abs=1e-10)
    # the stop bears the rest
    assert np.abs(path.main.lam[-1]).max() == pytest.approx(1 - borne(FLOOR), abs=1e-10)
    assert path[-1].modes == {"floor": "at the lower stop"}


@COORDINATES
def test_what_leaves_a_stop_goes_its_own_way(coordinates: str) -> None:
    model = truss(coordinates)
    pressed = model.equilibrium(q={"up": FLOOR + 1e-12}, parameters={"P": 0.5})
    assert pressed.modes == {"floor": "at the lower stop"}
    path = model.continuation(P=(0.5, -0.2), q=pressed.q, until={"up": -0.2})
    corner = next(point for point in path.points if point.kind == "event")
    assert corner["P"] == pytest.approx(borne(FLOOR), abs=1e-10)
    for up, load in zip(path["up"], path["P"], strict=True):
        if up > FLOOR + 1e-6:
            assert load == pytest.approx(borne(up), abs=1e-10)
    assert path["up"][-1] == pytest.approx(-0.2)


@COORDINATES
def test_friction_sticks_before_it_slides(coordinates: str) -> None:
    """A slide with a spring of 10 and friction of 3: x = (P - 3) / 10 from P = 3 on."""
    scene = cd.Scene("slide", gravity=(0, 0, 0))
    body = scene.body("body", **POINT)
    scene.joint("x", cd.Prismatic("x"), scene.ground, body)
    scene.force("spring", cd.JointSpring("x", stiffness=10.0))
    scene.force("rail", cd.Friction("x", coulomb=3.0))
    scene.force("load", cd.JointForce("x", scene.parameter("P", 0.0)))
    path = cd.compile(scene, coordinates=coordinates).continuation(P=(0, 10))
    corner = next(point for point in path.points if point.kind == "event")
    assert corner["P"] == pytest.approx(3.0, abs=1e-10)
    wanted = np.maximum(path["P"] - 3, 0) / 10
    np.testing.assert_allclose(path["x"], wanted, atol=1e-9)
    assert path["x"][-1] == pytest.approx(0.7, abs=1e-9)
