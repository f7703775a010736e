"""Elements that need a joint with one coordinate are refused where they are written."""

from __future__ import annotations

import pytest

import cardan as cd


def test_a_stop_on_a_joint_of_three_coordinates_fails_at_once() -> None:
    """It failed when the scene was compiled, with a cure that does not exist for stops."""
    scene = cd.Scene("crane", gravity=(0, 0, -9.81))
    load = scene.body("load", mass=1.0)
    scene.joint("gantry", cd.Translation(), scene.ground, load)
    said = "force 'end': joint 'gantry' has 3 coordinates; stop needs a joint with one.*Prismatic"
    with pytest.raises(cd.ModelError, match=said):
        scene.force("end", cd.Stop("gantry", lower=0.0))
    for element in (cd.JointSpring("gantry", 1.0), cd.Friction("gantry", 1.0)):
        with pytest.raises(cd.ModelError, match="needs a joint with one"):
            scene.force("other", element)


def test_the_cure_holds() -> None:
    """Three slides with bodies of mass 0 between them; the last one falls on its stop."""
    scene = cd.Scene("crane", gravity=(0, 0, -9.81))
    along, across = scene.body("along", mass=0.0), scene.body("across", mass=0.0)
    load = scene.body("load", mass=1.0)
    scene.joint("x", cd.Prismatic("x"), scene.ground, along)
    scene.joint("y", cd.Prismatic("y"), along, across)
    scene.joint("z", cd.Prismatic("z"), across, load)
    scene.force("end", cd.Stop("z", lower=-0.5))
    motion = cd.compile(scene).simulate(1.0, u={"x": 1.0})
    assert motion["z"].min() == pytest.approx(-0.5, abs=1e-9)
    assert motion["x"][-1] == pytest.approx(1.0)
