"""Loops that can be solved in closed form, found by their joints.

A loop with as many free coordinates as closing conditions left over in two or three joints next
to the one that closes it is solved for these: two joints of a plane or about a point (a dyad), or
joints that carry the center of a ball joint (:mod:`.legs`). Loops are taken one after the other,
those that already have the fewest free joints first; what one determines the next may use.

Source: M. Hiller and A. Kecskemethy, work on characteristic pairs of joints.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Collection, Mapping, Sequence

from ...errors import TopologyError, near
from ..system import Closure, Cut, Joint
from .legs import Axes

# what a loop moves in and the kinds of the joints that are looked for -> how it is solved
PATTERNS: dict[tuple[str, str, tuple[str, ...]], str] = {
    ("planar", "revolute", ("revolute", "revolute")): "planar",
    ("planar", "revolute", ("prismatic", "revolute")): "planar",
    ("spherical", "revolute", ("revolute", "revolute")): "spherical",
}
SIGNS = {"+": 1, "-": -1}


def closed_forms(
    cuts: Sequence[Cut], axes: Axes, free: Sequence[bool], branches: Mapping[str, str]
) -> tuple[tuple[Closure, ...], tuple[Cut, ...]]:
    """The loops that are solved, in the order of solution, and those that are left.

    Args:
        cuts: All loops.
        axes, free: The joints of the tree; which of them may follow from the others.
        branches: Joint that closes a loop, or motor or slide of its leg -> "+" or "-": which
            solution.

    Raises:
        TopologyError: a branch of a loop that does not exist or is not solved in closed form.
    """
    waiting, closures, joints = list(cuts), list[Closure](), axes.joints
    # what others follow must stay a coordinate
    leaders = {joint.coupling.leader for joint in joints if joint.coupling is not None}
    followers = {i for i, joint in enumerate(joints) if joint.coupling is not None}
    taken = leaders | followers | {i for i in range(len(joints)) if not free[i]}
    while True:
        ready = []
        for cut in waiting:
            open_joints = _open(cut, taken)
            closure = _solution(cut, axes, open_joints)
            if closure is not None:
                ready.append((len(open_joints), closure))
        if not ready:
            break
        closure = min(ready, key=lambda pair: pair[0])[1]
        closures.append(_named(closure, joints, branches))
        # what this loop starts from must not follow from one that comes later
        taken |= {i for i, _ in closure.cut.path}
        waiting.remove(closure.cut)
    _check(branches, closures, waiting, joints)
    return tuple(closures), tuple(waiting)


def _named(closure: Closure, joints: Sequence[Joint], branches: Mapping[str, str]) -> Closure:
    """The closure with the signs that the user has named; 0 where none was."""
    branch, side = SIGNS.get(branches.get(closure.cut.name, ""), 0), 1
    if closure.third >= 0:
        side = SIGNS.get(branches.get(joints[closure.third].name, ""), 0)
    return dataclasses.replace(closure, branch=branch, side=side)


def _check(
    branches: Mapping[str, str],
    closures: Sequence[Closure],
    open_cuts: Sequence[Cut],
    joints: Sequence[Joint],
) -> None:
    solved = [closure.cut.name for closure in closures]
    solved += [joints[closure.third].name for closure in closures if closure.third >= 0]
    for name, sign in branches.items():
        if name in (cut.name for cut in open_cuts):
            raise TopologyError(
                f"branch of '{name}': this loop is not solved in closed form, and has no named "
                "branches. Choose its branch by initial values"
            )
        if name not in solved:
            raise TopologyError(
                f"branch of '{name}': it closes no loop, and is not a motor or slide of a leg."
                f"{near(name, solved)}"
            )
        if sign not in SIGNS:
            raise TopologyError(f"branch of '{name}' is '{sign}'; it can be '+' or '-'")


def _open(cut: Cut, taken: Collection[int]) -> list[int]:
    """Free joints of a loop, those nearest to the cut first."""
    free: dict[int, list[int]] = {1: [], -1: []}
    for i, sign in reversed(cut.path):
        if i not in taken:
            free[sign].append(i)
    ordered: list[int] = []
    while free[1] or free[-1]:
        # in turns from both branches; the branch of the child first
        for sign in (1, -1):
            if free[sign]:
                ordered.append(free[sign].pop(0))
    return ordered


def _solution(cut: Cut, axes: Axes, free: Sequence[int]) -> Closure | None:
    """Closed form of a loop, and the free joints it solves for; branches are not chosen."""
    joints = axes.joints
    for pair in _pairs(free):
        kinds = tuple(sorted(joints[i].element.kind for i in pair))
        kind = PATTERNS.get((cut.group, cut.element.kind, kinds))
        if kind is not None and len(cut.rows) == len(pair):
            return Closure(cut, kind, pair, 0)
    for leg in axes.legs(cut, free):
        return Closure(cut, leg.kind, leg.unknown, 0, 0, leg.third)
    return None


def _pairs(free: Sequence[int]) -> list[tuple[int, int]]:
    """Pairs of joints that may be looked for, those nearest to the cut first."""
    pairs = [(a, b) for n, b in enumerate(free) for a in free[:n]]
    return [(min(pair), max(pair)) for pair in pairs]
