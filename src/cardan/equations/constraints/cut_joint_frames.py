"""Relative pose and motion of the two frames of a joint that closes a loop."""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING

from ...ir.matrix import Matrix
from ...records import dataclass
from ...topology.system import Cut
from ..recursion.recursion_boundary import CELLS

if TYPE_CHECKING:
    from ..kinematics.kinematics import Kinematics

TWIST = ("wx", "wy", "wz", "vx", "vy", "vz")


@dataclass(frozen=True)
class Ends:
    """The frames of a cut joint, P on its parent and C on its child.

    Attributes:
        rotation, position: R_PC (3, 3) and p_PC (3, 1) in P axes.
        columns: Speed -> twist of C against P at the origin of C, in C axes (6, 1).
        twist: All of it (6, 1), prescribed motion included.
        open: (joint, number of its speed) -> the same for joints whose speeds are looked for;
            they are not in ``columns`` and ``twist``.
        axes: R from P axes to those of the body where the branches part (3, 3).
    """

    rotation: Matrix
    position: Matrix
    columns: dict[int, Matrix]
    twist: Matrix
    open: dict[tuple[int, int], Matrix]
    axes: Matrix


def ends(
    k: Kinematics, cut: Cut, unknown: Collection[int] = (), from_parent_end: bool = False
) -> Ends:
    """The frames of a cut joint by the joints of its loop, from where its branches part.

    ``pose = [R_Pᵀ R_C, R_Pᵀ (p_C - p_P)]`` of its frames P and C, and
    ``twist = R_Cᵀ sum +-[R w; R v + R w x arm]``, each joint of the loop adding its w, v.

    Args:
        k: Motion of the tree.
        cut: The joint.
        unknown: Joints of the loop whose speeds are looked for.
        from_parent_end: Tell motions of the parent's branch by where that ends: the same where the
            origins of the frames meet, and shorter.
    """
    g = k.graph
    g.describe(ends)
    at = {cut.base: (Matrix.identity(g, 3), Matrix.zeros(g, 3))}
    with g.made_by(cut.name, "pose"):
        for i, _ in cut.path:
            inner, pose = at[k.system.bodies[i].parent], k.pose_of(i)
            at[i] = _hinted(
                (inner[0] @ pose.rotation, inner[1] + inner[0] @ pose.position),
                cut.name,
                f"{k.owner(i)}_",
            )
        (r_p, x_p), (r_c, x_c) = (
            _hinted(frame_pose(k, f, at[k.system.frames[f].body]), cut.name, word)
            for f, word in ((cut.parent_frame, "parent_"), (cut.child_frame, "child_"))
        )
        rotation, position = _hinted((r_p.T @ r_c, r_p.T @ (x_c - x_p)), cut.name, "")
    columns, free = dict[int, Matrix](), dict[tuple[int, int], Matrix]()
    twist = Matrix.zeros(g, 6)
    with g.made_by(cut.name, "twist"):
        for i, sign in cut.path:
            joint = k.system.joints[i].name
            arm = (x_p if from_parent_end and sign < 0 else x_c) - at[i][1]
            arm.hint(cut.name, f"arm_{joint}")
            if i in unknown:
                modes = k.pose_of(i).S
                for n in range(modes.columns):
                    free[i, n] = _moved_twist(at[i][0], arm, modes.column(n)) * sign
                continue
            for slot, column in k.joints[i].columns:
                share = _moved_twist(at[i][0], arm, column) * sign
                columns[slot] = columns[slot] + share if slot in columns else share
            share = _moved_twist(at[i][0], arm, k.joints[i].velocity) * sign
            twist = twist + share.hint(cut.name, f"base_twist_by_{joint}", TWIST)
        twist.hint(cut.name, "base_twist", TWIST)
        to_child = r_c.T
        for slot, column in columns.items():
            word = k.speed_names[slot]
            column.hint(cut.name, f"base_twist_{word}", TWIST)
            columns[slot] = _rotated_twist(to_child, column).hint(cut.name, f"twist_{word}", TWIST)
        free = {key: _rotated_twist(to_child, column) for key, column in free.items()}
        twist = _rotated_twist(to_child, twist).hint(cut.name, "twist", TWIST)
    return Ends(rotation, position, columns, twist, free, r_p)


def _hinted(pose: tuple[Matrix, Matrix], owner: str, word: str) -> tuple[Matrix, Matrix]:
    """A pose whose entries have names."""
    return pose[0].hint(owner, f"{word}R", CELLS), pose[1].hint(owner, f"{word}p")


def frame_pose(k: Kinematics, frame: int, body: tuple[Matrix, Matrix]) -> tuple[Matrix, Matrix]:
    """A frame of a body that is placed in some axes, in those axes."""
    f = k.system.frames[frame]
    rotation, position = body
    axes = k.fixed_to(f.body, k.matrix(3, 3, f.rotation))
    return rotation @ axes, position + rotation @ k.place(frame)


def _moved_twist(rotation: Matrix, arm: Matrix, twist: Matrix) -> Matrix:
    """A twist of a body about its origin, about a point an arm away, in the axes of the base."""
    angular = rotation @ twist.block(slice(0, 3))
    return Matrix.vstack(angular, rotation @ twist.block(slice(3, 6)) + angular.cross(arm))


def _rotated_twist(rotation: Matrix, twist: Matrix) -> Matrix:
    return Matrix.vstack(rotation @ twist.block(slice(0, 3)), rotation @ twist.block(slice(3, 6)))
