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


@pytest.mark.parametrize("coordinates", ["relative", "absolute"])
def test_the_driving_force_of_a_prescribed_joint_is_not_its_reaction(coordinates: str) -> None:
    scene = cd.Scene("lift", gravity=(0, 0, -9.81))
    cage = scene.body("cage", mass=3.0, com=(0.2, 0, 0), inertia=(1, 1, 1))
    scene.joint("shaft", cd.Prismatic("z"), scene.ground, cage, prescribed=0.5 * cd.t**2)
    model = cd.compile(cd.derive(scene, coordinates=coordinates))
    motion = model.simulate(0.1)
    # weight, and an acceleration of 1 m/s^2
    expected = np.full(len(motion.t), 3.0 * (9.81 + 1.0))
    assert motion["shaft.driving_force"] == pytest.approx(expected, rel=1e-8)
    assert motion["shaft.force"].shape == (len(motion.t), 3)
    assert [row.name for row in model.manifest.outputs] == ["shaft.driving_force"]
    assert [row.unit for row in model.manifest.outputs] == ["N"]


@pytest.mark.parametrize("coordinates", ["relative", "absolute"])
def test_outputs_of_accelerations_are_those_of_the_motion(coordinates: str) -> None:
    scene = cd.Scene("pendulum")
    rod = scene.body("rod", mass=1.0, com=(0, 0, -1.0))
    scene.joint("pin", cd.Revolute("y"), scene.ground, rod)
    scene.output("along", rod.at(0, 0, -1).acceleration(in_=rod)[0])
    motion = cd.compile(cd.derive(scene, coordinates=coordinates)).simulate(0.3, q={"pin": 0.5})
    # a point mass on a massless rod: r phi'' = -g sin(phi), and x of the tip is -r phi
    assert motion["along"] == pytest.approx(9.81 * np.sin(motion["pin"]), rel=1e-9)


def test_outputs_of_an_equilibrium_that_is_held() -> None:
    rest = cd.compile(hanging()).equilibrium(locked={"hinge": 0.3})
    assert rest["height"] == pytest.approx(-np.sin(0.3), abs=1e-12)
    assert rest["spring.force"] == pytest.approx(-100.0 * 0.3)
