"""Reactions under wrenches of a call are those of forces in the scene, in all coordinates."""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd

WRENCHES = {"tip": np.array([1.0, 2, 3, 4, 5, 6]), "upper": np.array([0.1, 0.2, 0.3, -4, 5, -6])}
START = {"q": {"shoulder": [0.3, 0.2], "elbow": 0.5}, "u": {"shoulder": [0.3, -0.2], "elbow": 0.5}}
JOINTS = ("shoulder", "elbow")


def arm(kind: str, pushed: bool = False, driven: bool = False) -> cd.CompiledModel:
    """Two links, in joint or absolute coordinates, or beside a beam."""
    scene = cd.Scene("arm")
    upper = scene.body("upper", mass=1, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.01))
    lower = scene.body("lower", mass=1, com=(0, 0.1, -0.4), inertia=(0.1, 0.1, 0.02))
    tip = lower.at(0, 0.2, -1, name="tip")
    prescribed = {"prescribed": 0.3 * cd.t} if driven else {}
    scene.joint("shoulder", cd.Universal("x", "y"), scene.ground, upper)
    scene.joint("elbow", cd.Revolute("y"), upper.at(0, 0, -1), lower.at(0, 0.1, 0), **prescribed)
    if pushed:
        for name, frame in (("tip", tip), ("upper", upper)):
            moment, force = np.split(WRENCHES[name], 2)
            scene.force(f"{name} force", cd.Force(frame, tuple(force)))
            scene.force(f"{name} torque", cd.Torque(frame, tuple(moment)))
    if kind != "elements":
        return cd.compile(scene, coordinates=kind)
    section, steel = cd.section.tube(0.05, 0.04), cd.material(E=2e11, nu=0.3, rho=7800)
    scene.beam("beam", scene.ground.at(0, 3, 0), (1.0, 3.0, 0), section, steel, elements=1)
    return cd.compile(scene)


def state(model: cd.CompiledModel) -> tuple[np.ndarray, np.ndarray]:
    """The same in all coordinates."""
    motion = model.simulate(1e-9, **START)
    return motion.q[0], motion.u[0]


@pytest.fixture(scope="module")
def expected() -> dict[str, np.ndarray]:
    model = arm("relative", pushed=True)
    return {joint: model.reaction(joint, *state(model)) for joint in JOINTS}


@pytest.mark.parametrize("kind", ["relative", "absolute", "elements"])
def test_wrenches_act_as_forces_of_the_scene(kind: str, expected: dict[str, np.ndarray]) -> None:
    model = arm(kind)
    q, u = state(model)
    for joint in JOINTS:
        found = model.reaction(joint, q, u, wrenches=WRENCHES)
        np.testing.assert_allclose(found, expected[joint], atol=1e-11)
        # as many at once
        many = {name: np.array([0 * w, w]) for name, w in WRENCHES.items()}
        none, again = model.reaction(joint, q, u, wrenches=many)
        np.testing.assert_allclose(none, model.reaction(joint, q, u), atol=1e-12)
        np.testing.assert_allclose(again, found, atol=1e-12)


def test_a_joint_of_a_tree_that_tells_nothing_of_what_it_carries() -> None:
    model = arm("elements", driven=True)
    motion = model.simulate(1e-9, q={"shoulder": [0.3, 0.2]})
    with pytest.raises(cd.ModelError, match="Put them into the scene as a Force and a Torque"):
        model.reaction("elbow", motion.q[0], motion.u[0], wrenches=WRENCHES)


def test_reactions_of_more_speeds_than_a_full_mass_matrix_has() -> None:
    """A long beam between hinges with a link: rows of constraints are few."""
    scene = cd.Scene("long")
    section, steel = cd.section.rectangle(0.1, 0.01), cd.material(E=7e10, nu=0.3, rho=2700)
    left, right, bob = (
        scene.body(name, mass=1.0, inertia=(1, 1, 1), pose=place)
        for name, place in (("a", (0, 0, 0)), ("b", (1, 0, 0)), ("c", (1, 0, -1)))
    )
    scene.joint("left", cd.Revolute("y"), scene.ground, left)
    scene.beam("beam", left, right, section, steel, elements=130)
    scene.joint("right", cd.Revolute("y"), scene.ground.at(1, 0, 0), right)
    scene.joint("link", cd.Distance(length=1.0), right, bob)
    model = cd.compile(scene)
    assert model.nu > 600
    q, u = model.split(model.initial())
    # the bob hangs at rest
    assert abs(model.reaction("link", q, u)[3:]).max() == pytest.approx(9.81, rel=1e-6)
