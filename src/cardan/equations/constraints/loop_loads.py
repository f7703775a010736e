"""Forces that joints which close loops put on the bodies of the tree."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING

from ...ir.matrix import Matrix
from ...records import dataclass
from ...topology.system import Cut
from ..kinematics.accelerations import Accelerations
from ..kinematics.joint_forces import along_joint, driving_force, joint_forces
from ..kinematics.kinematics import Kinematics
from ..kinematics.loads import Loads, Wrenches, merged

if TYPE_CHECKING:
    from ..functions.dynamics import Dynamics


@dataclass(frozen=True)
class Closing:
    """Wrench of a joint that closes a loop.

    Attributes:
        cut: The joint.
        pose: R_PC (3, 3) and p_PC (3, 1) of its frames.
        wrench: Of P on C at the origin of C, in C axes (6, 1).
    """

    cut: Cut
    pose: tuple[Matrix, Matrix]
    wrench: Matrix


def closing_wrenches(
    d: Dynamics, tau: Matrix, udot: Matrix, acc: Accelerations
) -> tuple[Closing, ...]:
    """Wrenches of all joints that close loops.

    Args:
        d: The dynamics, with all applied forces.
        tau: Generalized applied force (nu, 1).
        udot: The accelerations that follow (nu, 1).
        acc: Those of the bodies.
    """
    k, closings = d.k, list[Closing]()
    for n, cut in enumerate(k.system.cuts):
        with k.graph.made_by(cut.name, "wrench"):
            c = d.constraints
            closings.append(Closing(cut, c.pose(n), c.wrench(n, d.bound(tau)[1])))
    return (*closings, *_solved(k, acc, udot, with_closing(k, d.loads, closings)))


def with_closing(
    k: Kinematics, loads: Loads, closing: Iterable[Closing], frames: set[int] | None = None
) -> Loads:
    """Loads with those of joints that close loops; see :func:`pair`."""
    wrenches = loads.wrenches
    for one in closing:
        wrenches = merged(wrenches, pair(k, one.cut, one.pose, one.wrench, frames))
    return replace(loads, wrenches=wrenches)


def _solved(k: Kinematics, acc: Accelerations, udot: Matrix, loads: Loads) -> list[Closing]:
    """The joints of loops in closed form.

    They do what is left to do along the joints that the loop determines, on which nothing else
    acts. What a loop starts from feels it: the last one is taken first.
    """
    closings = []
    for n in range(len(k.system.closures) - 1, -1, -1):
        closure, velocity = k.system.closures[n], k.closures.velocity(n)
        with k.graph.made_by(closure.cut.name, "wrench"):
            forces = joint_forces(k, acc, loads)
            missing = [
                driving_force(k, i, forces, loads, along_joint(k, i, udot)) for i in closure.unknown
            ]
            wrench = velocity.gradient.T @ (velocity.inverse.T @ Matrix.vstack(*missing))
            one = Closing(closure.cut, (velocity.ends.rotation, velocity.ends.position), wrench)
        closings.append(one)
        loads = with_closing(k, loads, [one])
    return closings


def pair(
    k: Kinematics,
    cut: Cut,
    pose: tuple[Matrix, Matrix],
    wrench: Matrix,
    frames: set[int] | None = None,
) -> Wrenches:
    """The wrench of P on C of a cut joint and its opposite, on their bodies.

    Args:
        k: Motion of the tree.
        cut: The joint.
        pose: R_PC and p_PC.
        wrench: At the origin of C in C axes (6, 1).
        frames: Frames on which forces count, those of the ground too; by default all that move.
    """
    wrenches: Wrenches = {}
    rotation, position = pose
    # P feels the opposite, at the same point
    rotated = [rotation @ wrench.block(slice(s, s + 3)) for s in (0, 3)]
    on_parent = Matrix.vstack(rotated[0] + position.cross(rotated[1]), rotated[1])
    for frame, at_frame in ((cut.child_frame, wrench), (cut.parent_frame, -on_parent)):
        body = k.system.frames[frame].body
        if body >= 0 if frames is None else frame in frames:
            wrenches = merged(wrenches, {body: _at_origin(k, frame, at_frame)})
    return wrenches


def _at_origin(k: Kinematics, frame: int, wrench: Matrix) -> tuple[Matrix, Matrix]:
    """A wrench in the axes of a frame about its origin, in those of its body about its own."""
    f = k.system.frames[frame]
    axes = k.fixed_to(f.body, k.matrix(3, 3, f.rotation))
    force = axes @ wrench.block(slice(3, 6))
    return axes @ wrench.block(slice(0, 3)) + k.place(frame).cross(force), force
