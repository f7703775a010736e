"""Reactions and outputs by name in motions, equilibria and load paths."""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd


def hanging() -> cd.Scene:
    """A weight that a spring holds, on a rod that is hinged to the ground."""
    scene = cd.Scene("hanging", gravity=(0, 0, -9.81))
    load = scene.parameter("load", 2.0)
    rod = scene.body("rod", mass=load, com=(1.0, 0, 0), inertia=(0.01, 0.02, 0.02))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, rod)
    scene.force("spring", cd.JointSpring("hinge", stiffness=100.0))
    scene.output("height", rod.at(1, 0, 0).position()[2])
    return scene


def test_equilibria_and_paths_have_outputs_and_reactions_by_name() -> None:
    model = cd.compile(hanging())
    rest = model.equilibrium()
    angle = rest["hinge"]
    assert rest["height"] == pytest.approx(-np.sin(angle), abs=1e-12)
    # the weight, in axes of the rod
    weight = 2.0 * 9.81
    expected = weight * np.array([-np.sin(angle), 0.0, np.cos(angle)])
    assert rest["hinge.force"] == pytest.approx(expected, abs=1e-9)
    assert rest["hinge.moment"] == pytest.approx(rest.reaction("hinge")[:3], abs=1e-12)
    path = model.statics(load=np.linspace(0.5, 2.0, 4))
    assert path["height"][-1] == pytest.approx(rest["height"], abs=1e-9)
    assert np.linalg.norm(path["hinge.force"], axis=1) == pytest.approx(9.81 * path["load"])
    for result in (rest, path):
        with pytest.raises(cd.ModelError, match=r"'heigth'.*Did you mean 'height'"):
            result["heigth"]


def test_reactions_at_a_stop_are_those_of_rest() -> None:
    scene = cd.Scene("leaning", gravity=(0, 0, -9.81))
    rod = scene.body("rod", mass=1.5, com=(0, 0, -1.0), inertia=(0.1, 0.1, 0.1))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, rod)
    scene.force("stop", cd.Stop("hinge", lower=0.2))
    rest = cd.compile(scene).equilibrium(q={"hinge": 0.3})
    assert rest.modes == {"stop": "at the lower stop"}
    # the hinge carries the weight, in axes of the rod
    weight = 1.5 * 9.81 * np.array([-np.sin(0.2), 0.0, np.cos(0.2)])
    assert rest["hinge.force"] == pytest.approx(weight, abs=1e-9)


def test_a_motion_has_reactions_by_name() -> None:
    motion = cd.compile(hanging()).simulate(0.5, q={"hinge": 0.3})
    wrenches = motion.reaction("hinge")
    assert np.array_equal(motion["hinge.moment"], wrenches[:, :3])
    assert np.array_equal(motion["hinge.force"], wrenches[:, 3:])
    with pytest.raises(cd.ModelError, match=r"motion\['hing.force'\]: there is no such history"):
        motion["hing.force"]
