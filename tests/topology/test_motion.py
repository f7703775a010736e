"""Prescribed and coupled coordinates, rotors of drives."""

from __future__ import annotations

import math

import numpy as np
import pytest
import sympy

from cardan.api.scene import Scene
from cardan.elements.forces import Drive, Force
from cardan.elements.joints import Prismatic, Revolute, Spherical
from cardan.errors import ModelError
from cardan.scene import t
from cardan.topology import build
from topology.numbers_of import body_mass, body_poses, values


def arm(**options):
    scene = Scene("arm")
    a, b = scene.body("a", mass=1.0), scene.body("b", mass=1.0)
    scene.joint("base", Revolute("z"), scene.ground, a)
    scene.joint("elbow", Revolute("y"), a.at(1, 0, 0), b, **options)
    return scene


def test_motion_in_time():
    scene = arm()
    c = scene.body("c", mass=1.0)
    amplitude = scene.parameter("amplitude", 0.2)
    motion = amplitude * sympy.sin(3 * t)
    scene.joint("drive", Prismatic("x"), scene.bodies["b"], c, prescribed=motion)
    system = build(scene)
    joint = system.joints[2]
    assert (joint.q, joint.u) == (-1, -1)
    assert system.nq == 2
    found = values(
        system, [joint.motion.value, joint.motion.rate, joint.motion.acceleration], t=[0.7]
    )
    s, c = math.sin(2.1), math.cos(2.1)
    np.testing.assert_allclose(found, [0.2 * s, 0.6 * c, -1.8 * s], rtol=1e-15)


def test_motion_by_an_input_takes_value_rate_and_acceleration():
    scene = arm()
    x = scene.input("x", default=0.1, unit="deg")
    other = scene.input("other")
    scene.output("o", other)
    tip = scene.body("tip", mass=1.0)
    scene.joint("j", Revolute("x"), scene.bodies["b"], tip, prescribed=x**2)
    system = build(scene)
    assert [r.name for r in system.inputs] == ["x", "x.rate", "x.acceleration", "other"]
    motion = system.joints[2].motion
    x0, x1, x2 = 0.3, 0.4, 0.5
    found = values(system, [motion.value, motion.rate, motion.acceleration], r=[x0, x1, x2, 9.0])
    np.testing.assert_allclose(found, [x0**2, 2 * x0 * x1, 2 * x1**2 + 2 * x0 * x2], rtol=1e-15)


def test_what_a_motion_may_depend_on():
    scene = arm()
    tip = scene.body("tip", mass=1.0)
    scene.joint("j", Revolute("x"), scene.bodies["b"], tip, prescribed=scene.q("elbow"))
    with pytest.raises(ModelError, match=r"'j' \(revolute\).*'elbow'"):
        build(scene)
    scene = arm()
    ball = scene.body("ball", mass=1.0)
    scene.joint("s", Spherical(), scene.bodies["b"], ball, prescribed=t)
    with pytest.raises(ModelError, match=r"one coordinate.*give a value for each"):
        build(scene)


def test_coupled_joint():
    scene = arm(couple=("base", -2.0, 0.1))
    scene.output("angle", scene.q("elbow"))
    system = build(scene)
    assert (system.nq, system.nu) == (1, 1)
    coupling = system.joints[1].coupling
    assert coupling.leader == 0
    np.testing.assert_allclose(values(system, [coupling.ratio, coupling.offset]), [-2, 0.1])
    # coordinates without slots are placeholders
    assert system.atoms["elbow"].quantity == "q"
    assert system.atoms["elbow"].frame == 1
    # elbow turns by -2 * 0.3 + 0.1 = -0.5 about y after 0.3 about z
    pose = body_poses(system, [0.3])[1]
    assert pose[2, 0] == pytest.approx(-math.sin(-0.5))


def test_what_follows_a_prescribed_joint_is_prescribed():
    scene = Scene("m")
    a, b, c = (scene.body(name, mass=1.0) for name in "abc")
    scene.joint("one", Revolute("z"), scene.ground, a, prescribed=t**2)
    scene.joint("two", Revolute("z"), a, b, couple=("one", 2.0, 0.5))
    scene.joint("three", Revolute("z"), b, c, couple=("two", -1.0))
    motion = build(scene).joints[2].motion
    nodes = [motion.value, motion.rate, motion.acceleration]
    np.testing.assert_allclose(values(build(scene), nodes, t=[3.0]), [-18.5, -12, -4])
    assert build(scene).nq == 0


def test_couplings_to_nothing_and_in_rings():
    with pytest.raises(ModelError, match="Did you mean 'base'"):
        build(arm(couple=("bse", 1.0)))
    scene = arm(couple=("third", 1.0))
    tip = scene.body("tip", mass=1.0)
    scene.joint("third", Revolute("x"), scene.bodies["b"], tip, couple=("elbow", 1.0))
    with pytest.raises(ModelError, match="ring"):
        build(scene)


def test_rigid_drive_needs_no_body():
    scene = arm()
    scene.force("motor", Drive("elbow", inertia=1e-4, ratio=100.0, torque=0.1))
    system = build(scene)
    assert len(system.bodies) == 2
    assert system.forces[0].joints == {"joint": 1}


def test_gyroscopic_drive_adds_a_coupled_rotor_in_the_parent():
    scene = arm()
    scene.force("motor", Drive("elbow", inertia=1e-4, ratio=100.0, gyroscopic=True))
    system = build(scene)
    assert [b.name for b in system.bodies] == ["a", "b", "motor.rotor"]
    assert (system.nq, system.joints[2].coupling.leader) == (1 + 1, 1)
    assert system.bodies[2].parent == 0
    mass, first, moment = body_mass(system, 2)
    assert mass == 0
    np.testing.assert_array_equal(first, 0)
    np.testing.assert_allclose(moment, np.diag([0, 1e-4, 0]))
    # one number of the user is one parameter
    names = [p.name for p in system.parameters if "motor" in p.name]
    assert sorted(names) == ["motor.inertia", "motor.ratio"]
    assert system.forces[0].joints == {"joint": 1, "rotor": 2}
    # the scene itself is as it was
    assert list(scene.bodies) == ["a", "b"]


def test_elastic_drive_has_a_coordinate_of_its_own():
    scene = Scene("m")
    a = scene.body("a", mass=1.0)
    scene.joint("j", Revolute((0, 3, 4)), scene.ground, a)
    scene.force("motor", Drive("j", inertia=2.0, ratio=50.0, stiffness=1e3))
    system = build(scene)
    assert system.nq == 2
    assert system.joints[1].name == "motor.rotor"
    _, _, moment = body_mass(system, 1)
    axis = np.array([0, 0.6, 0.8])
    np.testing.assert_allclose(moment, 2 * np.outer(axis, axis), rtol=0, atol=1e-15)


def test_an_input_with_the_name_of_a_rate():
    scene = arm(prescribed=Scene("other").input("x"))
    scene.input("x")
    scene.input("x.rate")
    with pytest.raises(ModelError, match=r"input 'x.rate': input 'x' prescribes a motion"):
        build(scene)


def test_a_joint_follows_a_motion_or_a_joint():
    with pytest.raises(ModelError, match="cannot follow prescribed= and another joint"):
        arm(prescribed=t, couple=("base", 2))


def test_a_rotor_and_a_force_on_a_frame_in_one_scene():
    """The rotor is added to a copy of the scene; frames and names of the scene stay valid."""
    scene = arm()
    scene.force("motor", Drive("elbow", 1e-3, ratio=10, gyroscopic=True))
    scene.force("push", Force(scene.bodies["b"].at(0.5, 0, 0), (1, 0, 0)))
    scene.force("pull", Force("a", (0, 1, 0)))
    system = build(scene)
    pushed = system.frames[system.forces[1].frames["frame"]]
    assert system.bodies[pushed.body].name == "b"
    assert system.frames[system.forces[2].frames["frame"]].name == "a"


def test_a_drive_takes_the_joint_or_its_name():
    systems = []
    for given in (lambda s: s.joints["elbow"], lambda s: "elbow"):
        scene = arm()
        scene.force("motor", Drive(given(scene), 1e-3, ratio=10, gyroscopic=True))
        systems.append(build(scene))
    assert [b.name for b in systems[0].bodies] == ["a", "b", "motor.rotor"]
    assert repr(systems[0]) == repr(systems[1])
