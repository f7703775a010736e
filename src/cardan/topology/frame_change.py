"""A system told in other frames of its bodies: the same motion, coordinates and speeds."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cached_property

from ..ir.arithmetic import Scalar
from ..ir.graph import Graph
from ..ir.matrix import Matrix
from ..records import dataclass
from ..spatial.moments import Inertia, moved, turn_symmetric
from .system import Body, Frame, Joint, System


@dataclass(frozen=True)
class FrameChange:
    """The new frame of a body in its old one.

    Attributes:
        rotation: R from new to old axes (3, 3).
        origin: New origin in old axes (3, 1).
    """

    rotation: Matrix
    origin: Matrix

    @cached_property
    def rotates(self) -> bool:
        """True when it has other axes."""
        return self.rotation.nodes != Matrix.identity(self.rotation.graph, 3).nodes

    @cached_property
    def same(self) -> bool:
        """True when it is the old frame."""
        return self.origin.is_zero and not self.rotates

    def rotated(self, x: Matrix) -> Matrix:
        """A vector or the columns of a rotation, from old to new axes."""
        return self.rotation.T @ x if self.rotates else x

    def point(self, p: Matrix) -> Matrix:
        """A point, from the old frame to the new one."""
        return self.rotated(p - self.origin)


def change_frames(
    system: System, graph: Graph, new_frames: Sequence[FrameChange], joints: Mapping[int, Joint]
) -> System:
    """The system in new frames of its bodies.

    Args:
        system: In old frames.
        graph: A fork of the system's, with the new expressions.
        new_frames: New frame of every body.
        joints: Joints that change in another way too: their parent side is taken as it stands.
            Of all others the motion must commute with the change of the outer frame.
    """
    assert all(body.second_moment is None for body in system.bodies), "regrouping comes last"
    joints_changed = []
    for i, joint in enumerate(system.joints):
        if i in joints:
            joints_changed.append(joints[i])
            continue
        parent = system.bodies[i].parent
        if new_frames[i].same and (parent < 0 or new_frames[parent].same):
            joints_changed.append(joint)
            continue
        rotation, position = new_joint_pose(system, graph, new_frames, i)
        joints_changed.append(replace(joint, rotation=rotation.nodes, position=position.nodes))
    return replace(
        system,
        graph=graph,
        bodies=tuple(_body(graph, b, at) for b, at in zip(system.bodies, new_frames, strict=True)),
        joints=tuple(joints_changed),
        frames=tuple(_frame(graph, f, new_frames) for f in system.frames),
    )


def new_joint_pose(
    system: System, graph: Graph, new_frames: Sequence[FrameChange], i: int
) -> tuple[Matrix, Matrix]:
    """Parent side of joint i in new frames: R (3, 3) and position (3, 1) in axes of the parent."""
    joint, parent, change = system.joints[i], system.bodies[i].parent, new_frames[i]
    rotation = Matrix(graph, 3, 3, joint.rotation)
    position = Matrix(graph, 3, 1, joint.position)
    if not change.origin.is_zero:
        position = position + rotation @ change.origin
    if change.rotates:
        rotation = rotation @ change.rotation
    if parent < 0:
        return rotation, position
    return new_frames[parent].rotated(rotation), new_frames[parent].point(position)


def _body(graph: Graph, body: Body, at: FrameChange) -> Body:
    """Mass properties about the new origin in new axes; the parts stay with the old system."""
    if at.same:
        return replace(body, parts=())
    with graph.made_by(body.name, "mass"):
        inertia = Inertia(
            Scalar(graph, body.mass),
            Matrix(graph, 3, 1, body.first_moment),
            Matrix(graph, 3, 3, body.inertia),
        )
        # the new origin sees the old one at -origin
        inertia = moved(inertia, -at.origin)
        moment = at.rotated(inertia.moment)
        tensor = turn_symmetric(at.rotation.T, inertia.tensor) if at.rotates else inertia.tensor
    return replace(body, first_moment=moment.nodes, inertia=tensor.nodes, parts=())


def _frame(graph: Graph, frame: Frame, new_frames: Sequence[FrameChange]) -> Frame:
    if frame.body < 0 or new_frames[frame.body].same:
        return frame
    at = new_frames[frame.body]
    rotation = at.rotated(Matrix(graph, 3, 3, frame.rotation))
    position = at.point(Matrix(graph, 3, 1, frame.position))
    return replace(frame, rotation=rotation.nodes, position=position.nodes)
