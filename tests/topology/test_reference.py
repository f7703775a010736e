"""pose= of bodies and at=/axis= of joints, in ground axes at the reference configuration."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from cardan.api.scene import Scene
from cardan.elements.joints import Distance, Free, Revolute
from cardan.errors import ModelError
from cardan.topology import build
from topology.numbers_of import body_poses, frame_pose, values


def three_bodies():
    """Poses of three bodies, drawn at random."""
    rng = np.random.default_rng(3)
    return [(rng.normal(size=3), Rotation.random(random_state=rng)) for _ in range(3)]


def test_bodies_stand_where_pose_says():
    scene = Scene("m")
    inner = scene.ground
    for k, (position, rotation) in enumerate(three_bodies()):
        body = scene.body(f"b{k}", mass=1.0, pose=(position, rotation))
        scene.joint(f"j{k}", Revolute(), inner, body, at=position + 0.3, axis=(0, 0.6, 0.8))
        inner = body
    system = build(scene)
    for k, (position, rotation) in enumerate(three_bodies()):
        pose = frame_pose(system, f"b{k}")
        np.testing.assert_allclose(pose[:3, 3], position, rtol=0, atol=3e-15)
        np.testing.assert_allclose(pose[:3, :3], rotation.as_matrix(), rtol=0, atol=3e-15)
    # joint frames are parallel to the ground, so the axis is in ground axes
    for k, (position, _) in enumerate(three_bodies()):
        pose = body_poses(system)[k]
        np.testing.assert_allclose(pose[:3, :3], np.eye(3), rtol=0, atol=3e-15)
        np.testing.assert_allclose(pose[:3, 3], position + 0.3, rtol=0, atol=3e-15)
        nodes = system.joints[k].data["axis"][2]
        np.testing.assert_allclose(values(system, nodes), [0, 0.6, 0.8])


def test_a_child_without_pose_has_its_origin_at_the_joint():
    scene = Scene("m")
    a = scene.body("a", mass=1.0)
    b = scene.body("b", mass=1.0)
    scene.joint("j", Revolute("y"), scene.ground, a, at=(1, 0, 0))
    scene.joint("k", Revolute("y"), a, b, at=(1, 0, 2))
    system = build(scene)
    np.testing.assert_allclose(body_poses(system)[1][:3, 3], [1, 0, 2])
    # turning the first joint by a quarter carries the second from (0, 0, 2) to (2, 0, 0)
    np.testing.assert_allclose(body_poses(system, [np.pi / 2, 0])[1][:3, 3], [3, 0, 0], atol=1e-15)


def test_a_floating_body_starts_at_its_pose():
    scene = Scene("m")
    pose = np.eye(4)
    pose[:3, 3] = [0, 0, 3]
    top = scene.body("top", mass=1.0, pose=pose)
    scene.joint("free", Free(), scene.ground, top)
    np.testing.assert_allclose(frame_pose(build(scene), "top"), pose)


def test_frames_and_pose_that_disagree():
    scene = Scene("m")
    a = scene.body("a", mass=1.0, pose=(0, 0, 1))
    scene.joint("j", Revolute("y"), scene.ground.at(0, 0, 0.5), a)
    with pytest.raises(ModelError, match=r"'j'.*'a' 0.5 away"):
        build(scene)
    scene = Scene("m")
    a = scene.body("a", mass=1.0, pose=(0, 0, 1))
    scene.joint("j", Revolute("y"), scene.ground.at(0, 0, 0.5), a.at(0, 0, -0.5))
    np.testing.assert_allclose(frame_pose(build(scene), "a")[:3, 3], [0, 0, 1])


@pytest.mark.parametrize("back", [False, True])
def test_poses_through_joints_of_either_direction(back):
    """Three bodies, one placed by the joint's place, one by its pose, one by frames."""
    scene = Scene("m")
    a, b, c = (scene.body(n, mass=1.0, pose=(1, 2, 3) if n == "b" else None) for n in "abc")
    ends = [(scene.ground, a), (a, b), (b.at(0, 0, 1), c.at(0.5, 0, 0))]
    for name, pair, at in zip("ijk", ends, ((1, 0, 0), (1, 1, 1), None), strict=True):
        scene.joint(name, Revolute("y"), *(pair[::-1] if back else pair), at=at)
    system = build(scene)
    assert [joint.reversed for joint in system.joints] == [back] * 3
    for name, place in zip("abc", ((1, 0, 0), (1, 2, 3), (0.5, 2, 4)), strict=True):
        np.testing.assert_allclose(frame_pose(system, name)[:3, 3], place, rtol=0, atol=1e-15)
    # the joints are where they were put: a quarter turn of the first two about them
    turn = np.array([np.pi / 2, 0, 0]) * (-1 if back else 1)
    np.testing.assert_allclose(frame_pose(system, "a", turn)[:3, 3], [1, 0, 0], atol=1e-15)
    np.testing.assert_allclose(frame_pose(system, "b", turn)[:3, 3], [4, 2, 0], atol=1e-15)


@pytest.mark.parametrize("back", [False, True])
def test_frames_that_stay_apart_at_zero(back):
    """A rod of 2 m down from the joint's place; where the pose says otherwise, it is an error."""
    scene = Scene("m")
    a = scene.body("a", mass=1.0)
    b = scene.body("b", mass=1.0)
    rod = Distance(2.0, "-z")
    scene.joint("j", rod, *((a, scene.ground) if back else (scene.ground, a)), at=(1, 0, 5))
    scene.joint("k", Revolute("y"), a, b, at=(1, 0, 1))
    system = build(scene)
    # declared from body to ground the rod goes down from the body
    places = ((1, 0, 5), (1, 0, 1)) if back else ((1, 0, 3), (1, 0, 1))
    for name, place in zip("ab", places, strict=True):
        q = [1, 0, 0, 0, 0, 0, 0]
        np.testing.assert_allclose(frame_pose(system, name, q)[:3, 3], place, atol=1e-15)
    scene = Scene("m")
    a = scene.body("a", mass=1.0, pose=(0, 0, 1))
    ends = (a.at(0, 0, 0), scene.ground) if back else (scene.ground.at(0, 0, 0), a)
    scene.joint("j", rod, *ends)
    with pytest.raises(ModelError, match=r"'j'.*'a' [13] away"):
        build(scene)
    # between bodies the frame on the parent follows
    scene = Scene("m")
    a = scene.body("a", mass=1.0, pose=(0.3, 0, 1))
    scene.joint("j", rod, *((a, scene.ground) if back else (scene.ground, a)))
    q = [1, 0, 0, 0, 0, 0]
    np.testing.assert_allclose(frame_pose(build(scene), "a", q)[:3, 3], [0.3, 0, 1], atol=1e-15)


def test_at_needs_bodies():
    scene = Scene("m")
    a = scene.body("a", mass=1.0)
    with pytest.raises(ModelError, match="at= needs bodies"):
        scene.joint("j", Revolute("y"), scene.ground, a.at(1, 0, 0), at=(0, 0, 0))
