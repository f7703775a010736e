"""pose= of bodies and at=/axis= of joints, in ground axes at the reference configuration."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from cardan.elements.joints import Free, Revolute
from cardan.errors import ModelError
from cardan.model import Model
from cardan.topology import build
from topology.numbers_of import body_poses, frame_pose, values


def three_bodies():
    """Poses of three bodies, drawn at random."""
    rng = np.random.default_rng(3)
    return [(rng.normal(size=3), Rotation.random(random_state=rng)) for _ in range(3)]


def test_bodies_stand_where_pose_says():
    scene = Model("m")
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
    scene = Model("m")
    a = scene.body("a", mass=1.0)
    b = scene.body("b", mass=1.0)
    scene.joint("j", Revolute("y"), scene.ground, a, at=(1, 0, 0))
    scene.joint("k", Revolute("y"), a, b, at=(1, 0, 2))
    system = build(scene)
    np.testing.assert_allclose(body_poses(system)[1][:3, 3], [1, 0, 2])
    # turning the first joint by a quarter carries the second from (0, 0, 2) to (2, 0, 0)
    np.testing.assert_allclose(body_poses(system, [np.pi / 2, 0])[1][:3, 3], [3, 0, 0], atol=1e-15)


def test_a_floating_body_starts_at_its_pose():
    scene = Model("m")
    pose = np.eye(4)
    pose[:3, 3] = [0, 0, 3]
    top = scene.body("top", mass=1.0, pose=pose)
    scene.joint("free", Free(), scene.ground, top)
    np.testing.assert_allclose(frame_pose(build(scene), "top"), pose)


def test_frames_and_pose_that_disagree():
    scene = Model("m")
    a = scene.body("a", mass=1.0, pose=(0, 0, 1))
    scene.joint("j", Revolute("y"), scene.ground.at(0, 0, 0.5), a)
    with pytest.raises(ModelError, match=r"'j'.*'a' 0.5 away"):
        build(scene)
    scene = Model("m")
    a = scene.body("a", mass=1.0, pose=(0, 0, 1))
    scene.joint("j", Revolute("y"), scene.ground.at(0, 0, 0.5), a.at(0, 0, -0.5))
    np.testing.assert_allclose(frame_pose(build(scene), "a")[:3, 3], [0, 0, 1])


def test_at_needs_bodies():
    scene = Model("m")
    a = scene.body("a", mass=1.0)
    with pytest.raises(ModelError, match="at= needs bodies"):
        scene.joint("j", Revolute("y"), scene.ground, a.at(1, 0, 0), at=(0, 0, 0))
