"""Circuits that can be solved in closed form, found by their joints.

A circuit with as many free coordinates as closing conditions left over in two or three joints next
to the one that closes it is solved for these: two joints of a plane or about a point (a dyad), or a
universal joint with a slide that ends in a spherical one (a leg). Circuits are taken one after the
other, those that already have the fewest free joints first; what one determines the next may use.

Source: M. Hiller and A. Kecskemethy, work on characteristic pairs of joints.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

from ..errors import TopologyError, near
from .system import Closure, Cut, Joint

# what a circuit moves in and the kinds of the joints that are looked for -> how it is solved
PATTERNS: dict[tuple[str, str, tuple[str, ...]], str] = {
    ("planar", "revolute", ("revolute", "revolute")): "planar",
    ("planar", "revolute", ("prismatic", "revolute")): "planar",
    ("spherical", "revolute", ("revolute", "revolute")): "spherical",
    ("", "spherical", ("prismatic", "universal")): "leg",
}
SIGNS = {"+": 1, "-": -1}


def closed_forms(
    cuts: Sequence[Cut], joints: Sequence[Joint], free: Sequence[bool], branches: Mapping[str, str]
) -> tuple[tuple[Closure, ...], tuple[Cut, ...]]:
    """The circuits that are solved, in the order of solution, and those that are left.

    Args:
        cuts: All circuits.
        joints, free: Of the tree; whether nothing prescribes their motion.
        branches: Joint that closes a circuit -> "+" or "-": which solution.

    Raises:
        TopologyError: a branch of a circuit that does not exist or is not solved in closed form.
    """
    waiting, closures = list(cuts), list[Closure]()
    # what others follow must stay a coordinate
    leaders = {joint.coupling.leader for joint in joints if joint.coupling is not None}
    followers = {i for i, joint in enumerate(joints) if joint.coupling is not None}
    taken = leaders | followers | {i for i in range(len(joints)) if not free[i]}
    while True:
        open_joints = {cut.name: _open(cut, taken) for cut in waiting}
        ready = [cut for cut in waiting if _solution(cut, joints, open_joints[cut.name])]
        if not ready:
            break
        cut = min(ready, key=lambda c: len(open_joints[c.name]))
        solution = _solution(cut, joints, open_joints[cut.name])
        assert solution is not None
        kind, unknown = solution
        closures.append(Closure(cut, kind, unknown, SIGNS.get(branches.get(cut.name, ""), 0)))
        # what this circuit starts from must not follow from one that comes later
        taken |= {i for i, _ in cut.path}
        waiting.remove(cut)
    _check(branches, closures, waiting)
    return tuple(closures), tuple(waiting)


def _check(branches: Mapping[str, str], closures: Sequence[Closure], rest: Sequence[Cut]) -> None:
    solved = [closure.cut.name for closure in closures]
    for name, sign in branches.items():
        if name in (cut.name for cut in rest):
            raise TopologyError(
                f"branch of '{name}': this circuit is not solved in closed form, and has no named "
                "branches. Choose its branch by initial values"
            )
        if name not in solved:
            raise TopologyError(f"branch of '{name}': it closes no circuit.{near(name, solved)}")
        if sign not in SIGNS:
            raise TopologyError(f"branch of '{name}' is '{sign}'; it can be '+' or '-'")


def _open(cut: Cut, taken: Collection[int]) -> list[int]:
    """Free joints of a circuit, those nearest to the cut first."""
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


def _solution(
    cut: Cut, joints: Sequence[Joint], free: Sequence[int]
) -> tuple[str, tuple[int, ...]] | None:
    """How to solve a circuit, and for which of its free joints."""
    side = dict(cut.path)
    for pair in _pairs(cut, free):
        if any(joints[i].reversed and joints[i].element.kind == "universal" for i in pair):
            continue
        kinds = tuple(sorted(joints[i].element.kind for i in pair))
        count = sum(len(joints[i].element.speeds) for i in pair)
        kind = PATTERNS.get((cut.group, cut.element.kind, kinds))
        if kind is None or count != len(cut.rows):
            continue
        # the slide of a leg is carried by its universal joint
        carried = joints[pair[0]].element.kind == "universal" and side[pair[0]] == side[pair[1]]
        if kind != "leg" or carried:
            return kind, pair
    return None


def _pairs(cut: Cut, free: Sequence[int]) -> list[tuple[int, int]]:
    """Pairs of joints that may be looked for, those nearest to the cut first."""
    side = dict(cut.path)
    found = [(a, b) for n, b in enumerate(free) for a in free[:n]]
    legs = [p for p in found if side[p[0]] == side[p[1]]]
    ordered = legs + found if cut.element.kind == "spherical" else found
    return [(min(pair), max(pair)) for pair in ordered]
