"""Models as parts of models."""

from __future__ import annotations

import numpy as np
import pytest
import sympy

from cardan.api.scene import Scene
from cardan.elements.forces import Force, JointForce, SpringDamper
from cardan.elements.joints import Custom, Prismatic, Revolute
from cardan.errors import ModelError
from cardan.scene import t
from cardan.topology import build
from topology.numbers_of import body_poses, frame_pose, values


def arm():
    scene = Scene("arm")
    m = scene.parameter("m", 2.0, unit="kg")
    k = scene.parameter("k", 5.0)
    drive = scene.input("drive")
    upper = scene.body("upper", mass=m, pose=(0, 0, 1))
    lower = scene.body("lower", mass=m / 2)
    scene.joint("shoulder", Revolute("y"), scene.ground, upper, at=(0, 0, 1))
    scene.joint("elbow", Revolute("y"), upper.at(0, 0, -0.5, name="tip"), lower)
    scene.force("motor", JointForce("shoulder", drive - k * scene.q("shoulder")))
    scene.force("spring", SpringDamper(scene.ground, lower, 10.0))
    scene.output("height", lower.position()[2] + t)
    return scene


def test_two_arms_on_a_torso():
    scene = Scene("robot")
    torso = scene.body("torso", mass=10.0)
    scene.joint("waist", Revolute("z"), scene.ground, torso)
    left = scene.include(arm(), "left", at=torso.at(0, 0.3, 1))
    scene.include(arm(), "right", at=torso.at(0, -0.3, 1))
    scene.joint("stick", Revolute("x"), left.bodies["lower"], scene.body("stick", mass=1.0))
    system = build(scene)
    assert {j.name for j in system.joints} == {
        "waist",
        "left.shoulder",
        "left.elbow",
        "right.shoulder",
        "right.elbow",
        "stick",
    }
    assert {p.name for p in system.parameters if p.declared} == {
        "left.m",
        "left.k",
        "right.m",
        "right.k",
    }
    # the pose of the arm is that in the ground of the arm
    np.testing.assert_allclose(frame_pose(system, "left.upper")[:3, 3], [0, 0.3, 2])
    np.testing.assert_allclose(frame_pose(system, "right.lower")[:3, 3], [0, -0.3, 1.5])
    motor = next(f for f in system.forces if f.name == "right.motor")
    k = next(k for k, j in enumerate(system.joints) if j.name == "right.shoulder")
    assert motor.joints == {"joint": k}
    ((_, _, (node,)),) = motor.data.values()
    q = np.zeros(system.nq)
    q[system.joints[k].q] = 0.2
    assert values(system, [node], q=q, r=[0, 3.0])[0] == pytest.approx(3.0 - 5 * 0.2)
    spring = next(f for f in system.forces if f.name == "left.spring")
    names = {role: system.frames[frame].name for role, frame in spring.frames.items()}
    assert set(names.values()) == {"left.ground", "left.lower"}
    assert "left.lower.position.z" in system.atoms
    assert left.symbols["m"] == sympy.Symbol("left.m")


def test_own_symbols_of_a_custom_joint_keep_their_names():
    s = sympy.Symbol("s")
    part = Scene("part")
    k = part.parameter("k", 2.0)
    body = part.body("b", mass=1.0)
    part.joint("curve", Custom([s], position=(s, k * s**2, 0)), part.ground, body)
    scene = Scene("whole")
    scene.parameter("s", 9.0, unit="kg")
    scene.include(part, "left")
    system = build(scene)
    np.testing.assert_allclose(body_poses(system, [0.5])[0][:3, 3], [0.5, 2 * 0.25, 0])


def test_nested_and_repeated():
    inner = Scene("inner")
    inner.include(arm(), "a_")
    scene = Scene("outer")
    scene.include(inner, "b")
    assert list(scene.bodies) == ["b.ground", "b.a_ground", "b.a_upper", "b.a_lower"]
    assert build(scene).nq == 2
    with pytest.raises(ModelError, match="taken"):
        scene.include(inner, "b")


def test_the_original_is_as_it_was():
    original = arm()
    before = build(original)
    Scene("m").include(original, "x")
    assert build(original).graph.nodes == before.graph.nodes


def test_frames_named_by_text_are_those_of_the_part():
    part = Scene("part")
    body = part.body("arm", mass=1.0)
    part.joint("j", Prismatic("z"), "ground", "arm")
    body.at(1, 0, 0, name="tip")
    part.force("push", Force("tip", (0, 0, 7)))
    part.force("spring", SpringDamper("ground", "arm", 10.0))
    whole = Scene("whole")
    arm_of_whole = whole.body("arm", mass=3.0)
    arm_of_whole.at(1, 0, 0, name="tip")
    whole.joint("j", Prismatic("z"), "ground", "arm")
    whole.include(part, "left")
    push, spring = (build(whole).forces[k].frames for k in (0, 1))
    frames = build(whole).frames
    assert frames[push["frame"]].name == "left.tip"
    assert [frames[spring[end]].name for end in "ab"] == ["left.ground", "left.arm"]


def test_nothing_is_replaced_by_a_part():
    part = Scene("part")
    part.joint("j", Prismatic("z"), "ground", part.body("arm", mass=1.0))
    part.output("height", part.q("j"))
    for taken in ("joint", "output"):
        whole = Scene("whole")
        box = whole.body("box", mass=1.0)
        if taken == "joint":
            whole.joint("left.j", Prismatic("x"), "ground", box)
        else:
            whole.output("left.height", box.position()[2])
        with pytest.raises(ModelError, match=f"{taken} 'left.*the name is taken"):
            whole.include(part, "left")


def test_a_model_is_no_part_of_itself():
    scene = arm()
    with pytest.raises(ModelError, match="cannot be a part of itself"):
        scene.include(scene, "copy")


def test_a_clash_halfway_leaves_the_outer_model_as_it_was() -> None:
    outer, inner = Scene("outer"), Scene("inner")
    first, second = inner.body("first", mass=1.0), inner.body("second", mass=1.0)
    inner.joint("hinge", Revolute("y"), inner.ground, first)
    inner.joint("slide", Prismatic("x"), first, second)
    outer.body("part.second", mass=2.0)
    before = {name: dict(getattr(outer, name)) for name in ("bodies", "joints", "frames")}
    with pytest.raises(ModelError, match=r"part\.second"):
        outer.include(inner, prefix="part")
    assert {name: dict(getattr(outer, name)) for name in before} == before
    outer.include(inner, prefix="other")
    assert "other.slide" in outer.joints
