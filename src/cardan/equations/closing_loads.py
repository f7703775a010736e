"""Forces that joints which close circuits put on the bodies of the tree."""

from __future__ import annotations

from ..ir.matrix import Matrix
from .constraints import Constraints
from .kinematics import Kinematics

Wrenches = dict[int, tuple[Matrix, Matrix]]


def closing_loads(c: Constraints, multipliers: Matrix, keep: set[int] | None = None) -> Wrenches:
    """Moment and force on every body, at its origin in its axes.

    Args:
        c: The constraints.
        multipliers: lam (m, 1).
        keep: Frames on which forces count, those of the ground too; by default all that move.
    """
    k, found = c.k, Wrenches()
    for n, cut in enumerate(k.system.cuts):
        with k.graph.made_by(cut.name, "wrench"):
            wrench = c.wrench(n, multipliers)
            # P feels the opposite, at the same point
            rotation, position = c.pose(n)
            turned = [rotation @ wrench.block(slice(s, s + 3)) for s in (0, 3)]
            on_parent = Matrix.vstack(turned[0] + position.cross(turned[1]), turned[1])
            for frame, own in ((cut.child_frame, wrench), (cut.parent_frame, -on_parent)):
                body = k.system.frames[frame].body
                if body >= 0 if keep is None else frame in keep:
                    found[body] = _sum(found.get(body), _at_origin(k, frame, own))
    return found


def together(one: Wrenches, other: Wrenches) -> Wrenches:
    """Sums of two sets of wrenches."""
    total = dict(one)
    for body, wrench in other.items():
        total[body] = _sum(total.get(body), wrench)
    return total


def _sum(
    before: tuple[Matrix, Matrix] | None, more: tuple[Matrix, Matrix]
) -> tuple[Matrix, Matrix]:
    return more if before is None else (before[0] + more[0], before[1] + more[1])


def _at_origin(k: Kinematics, frame: int, wrench: Matrix) -> tuple[Matrix, Matrix]:
    """A wrench in the axes of a frame about its origin, in those of its body about its own."""
    f = k.system.frames[frame]
    axes = k.fixed_to(f.body, k.matrix(3, 3, f.rotation))
    force = axes @ wrench.block(slice(3, 6))
    return axes @ wrench.block(slice(0, 3)) + k.place(frame).cross(force), force
