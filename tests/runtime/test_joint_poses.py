"""Joints are judged by their poses: those of every kind, and of kinds that nobody listed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import pytest

import cardan as cd
from cardan.elements.joints import JOINTS
from cardan.elements.joints.joint import Component, Joint
from cardan.errors import BuildError
from cardan.ir.arithmetic import cos, sin
from cardan.ir.matrix import Matrix
from cardan.runtime.trajectory import frame_history
from cardan.runtime.trajectory.joint_poses import POSES, joints_of
from cardan.runtime.verification.flat_scene import scene_from, scene_of
from cardan.runtime.verification.joint_motion import Expansion
from cardan.runtime.verification.newton_euler import poses
from mechanisms import ZOO
from mechanisms.rolling import ROLLING
from table import each

# every kind of joint once or more, told forth and back
MEMBERS = (
    *("double_pendulum", "cylindrical", "screw", "universal", "planar", "constant_velocity"),
    *("point_on_plane", "roller_coaster", "distance", "gear", "backwards", "backwards_guided"),
    *("spherical_ZXZ", "free_quaternion", "cart_pole", "coin"),
)


@dataclass(frozen=True)
class Cam(Joint):
    """A slide along y that follows the turn about z: one angle."""

    kind: ClassVar[str] = "cam"
    source: ClassVar[str] = "none"
    wrong: float = 0.0

    @property
    def coordinates(self) -> tuple[Component, ...]:
        return (Component("", "rad"),)

    def pose(self, q: Matrix, **data: Matrix) -> tuple[Matrix, Matrix]:
        c, s = cos(q[0]), sin(q[0])
        turned = Matrix(q.graph, 3, 3, [x.node for x in self._rows(q, c, s)])
        return turned, Matrix.vector(q.graph, [0 * q[0], 0.1 * (1 - c), 0 * q[0]])

    def _rows(self, q, c, s):
        none, one = 0 * q[0], 0 * q[0] + 1
        return c, -s, none, s, c, none, none, none, one

    def motion(self, q: Matrix, **data: Matrix) -> Matrix:
        c, s = cos(q[0]), sin(q[0])
        rise, none = (0.1 + self.wrong) * s, 0 * q[0]
        return Matrix.vector(q.graph, [none, none, none + 1, s * rise, c * rise, none])

    def constrained(self, q: Matrix, **data: Matrix) -> Matrix:
        return Matrix.zeros(q.graph, 6, 0)


def cam(wrong: float) -> cd.CompiledModel:
    scene = cd.Scene("cam")
    body = scene.body("follower", mass=1.0, com=(0.2, 0.1, 0), inertia=(0.1, 0.2, 0.3))
    scene.joint("lifts", Cam(wrong), scene.ground, body)
    return cd.compile(scene)


def test_a_new_joint_is_judged_on_arrival():
    model = cam(0.0)
    model.prepare("forward_dynamics", "inverse_dynamics", "bias", "qdot")
    result = model.verify()
    assert {"forward_dynamics", "inverse_dynamics", "bias", "qdot"} <= set(result.checked)
    assert result.worst < 1e-12


@pytest.mark.parametrize("function", ["mass_matrix", "bias", "forward_dynamics"])
def test_a_new_joint_whose_motion_is_wrong_is_found(function):
    with pytest.raises(BuildError, match=f"compiled {function} differs"):
        cam(1e-3).prepare(function)


def test_joints_that_move_alike_share_a_pose():
    scene = cd.Scene("chain")
    parent = scene.ground
    for k in range(6):
        body = scene.body(f"link{k}", mass=1.0, com=(0, 0, 0.5))
        scene.joint(f"hinge{k}", cd.Revolute("xy"[k % 2]), parent, body)
        parent = body
    manifest = cd.compile(scene).manifest["scene"]
    assert manifest["poses"] == ["scene_pose_0", "scene_pose_1"] * 3


@each("name", MEMBERS)
def test_kinds_of_saved_runs_stand_as_the_poses_say(name):
    """Saved runs know kinds and numbers, models the poses as they were written."""
    model = cd.compile(ZOO[name].build() if name in ZOO else ROLLING[name]())
    scene, numbers = scene_of(model), frame_history.numbers(model)
    known = scene_from(model.manifest, numbers, joints_of(model.manifest, numbers))
    q, _ = model.split(model.random_state(1, (4,)))
    for one, other in zip(poses(scene, q), poses(known, q), strict=True):
        for mine, right in zip(one, other, strict=True):
            size = max(1.0, np.abs(right).max())
            assert np.abs(mine - right).max() < 100 * len(one) * np.finfo(float).eps * size


def test_kinds_of_saved_runs_are_in_the_catalogue():
    assert set(POSES) == set(JOINTS) - {"custom"}


def test_derivatives_are_exact_to_rounding():
    def pose(q):
        turned = np.zeros((len(q), 9), dtype=q.dtype)
        return turned, np.stack([np.sin(q[:, 0]) * q[:, 1], np.exp(q[:, 1]), q[:, 0]], axis=-1)

    here, first, second = Expansion(pose).derivatives(np.array([[0.3, 0.7]]))
    assert np.abs(here[0, 9:] - [np.sin(0.3) * 0.7, np.exp(0.7), 0.3]).max() < 1e-15
    assert np.abs(first[0, :, 9] - [np.cos(0.3) * 0.7, np.sin(0.3)]).max() < 1e-14
    # rounding over the square of the radius of the largest circle
    assert abs(second[0, 0, 0, 9] + np.sin(0.3) * 0.7) < 1e-13
    assert abs(second[0, 0, 1, 9] - np.cos(0.3)) < 1e-13
    assert abs(second[0, 1, 1, 10] - np.exp(0.7)) < 1e-13
