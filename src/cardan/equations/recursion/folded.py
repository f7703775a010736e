"""Long regular trees folded: of bodies that repeat a few are derived, the rest follows.

A chain of equal links is derived from a short one. Which bodies repeat is read from the system
graph, expression by expression; that the visits of a recursion do is checked where bodies were left
out: steps and places must go on beyond the gap exactly as they came.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import fields, replace
from typing import Any, NamedTuple

from ...ir.graph import Graph
from ...ir.ops import LEAVES
from ...ir.recursion import STORE, Turns, Visit, ahead
from ...ir.strided_visits import LONGEST, as_turns, visit_stride
from ...records import dataclass
from ...topology.system import Force, Joint, System

# turns kept on both sides of the gap: the first ones differ, their neighbors being others
MARGIN = 6
# fewer bodies are not worth it
FEWEST = 40


class Signature(NamedTuple):
    """A body as the recursion sees it.

    Attributes:
        pattern: Its expressions without names, its kind of joint, where its children are.
        places: Parameters in the order of use, slots of q and u.
    """

    pattern: object
    places: tuple[int, ...]


@dataclass(frozen=True)
class Fold:
    """A system without the bodies in the middle of a repetition.

    Attributes:
        system: What is left; slots and parameters are those of the whole.
        numbers: Of every body left its number in the whole.
        at: First body after the gap, in numbers of what is left.
        period: Bodies of one turn.
        turns: Turns that were left out.
    """

    system: System
    numbers: tuple[int, ...]
    at: int
    period: int
    turns: int

    def unfolded_visit(self, visit: Visit, body: int, size: int) -> Visit:
        """A visit of a body beyond the gap: what it shares with bodies before it, it shares with
        the last of those left out.

        Args:
            size: Length of the store, [body][field] of the whole.
        """
        if body < self.at:
            return visit
        fields = size // (self.numbers[-1] + 1)
        # the first body has the sums of all: it is nobody's neighbor beyond the gap
        first, last = max(self.at - MARGIN * self.period, 1) * fields, self.at * fields
        further = self.turns * self.period * fields

        def shifted(places: tuple[int, ...]) -> tuple[int, ...]:
            return tuple([k + further if first <= k < last else k for k in places])

        reads = dict(visit.reads)
        if STORE in reads:
            reads[STORE] = shifted(reads[STORE])
        return Visit(visit.step, reads, shifted(visit.stores), visit.outs)

    def completed(
        self, bodies: Sequence[int], visits: Sequence[Visit]
    ) -> tuple[Visit | Turns, ...] | None:
        """All visits of a sweep from those of the bodies left, in the order of the sweep.

        None where they do not go on beyond the gap as they came.
        """
        outward = len(bodies) < 2 or bodies[0] < bodies[1]
        inside = [b for b in bodies if self.at - self.period <= b < self.at]
        n, cut = len(inside), sum((b < self.at) == outward for b in bodies)
        before, after = list(visits[:cut]), list(visits[cut:])
        if n == 0:
            return as_turns(visits)
        if len(before) < 2 * n or len(after) < n:
            return None
        # the last two turns before the gap say how it goes on
        pairs = zip(before[-2 * n : -n], before[-n:], strict=True)
        strides = [visit_stride(a, b) for a, b in pairs]
        strides_used = tuple(s for s in strides if s is not None)
        if len(strides_used) < n:
            return None
        beyond = zip(before[-n:], strides_used, after[:n], strict=True)
        if any(ahead(a, s, self.turns + 1) != b for a, s, b in beyond):
            return None
        middle = Turns(tuple(before[-n:]), strides_used, self.turns + 2)
        before, after = before[:-n], after[n:]
        # turns that belong to it already
        while len(before) >= n and tuple(before[-n:]) == middle.turn(-1):
            middle = Turns(tuple(before[-n:]), strides_used, middle.times + 1)
            before = before[:-n]
        while len(after) >= n and tuple(after[:n]) == middle.turn(middle.times):
            middle = middle._replace(times=middle.times + 1)
            after = after[n:]
        return (*as_turns(before), middle, *as_turns(after))


def fold(system: System) -> Fold | None:
    """A system without what repeats in its longest repetition; None where nothing does."""
    if len(system.bodies) < FEWEST:
        return None
    signatures = _signatures(system)
    start, end, period = max(
        (_longest(system, signatures, n) for n in range(1, LONGEST + 1)),
        key=lambda run: run[1] - run[0],
    )
    turns = (end - start) // period - 2 * MARGIN
    if turns < 1:
        return None
    gap, after = start + MARGIN * period, start + (MARGIN + turns) * period
    # nothing may hang on what is left out but the next turn
    parents = (body.parent for body in system.bodies[after + period :])
    if any(gap <= above < after for above in parents):
        return None
    return _without(system, gap, turns, period)


def _without(system: System, gap: int, turns: int, period: int) -> Fold:
    """The system without turns from body ``gap`` on."""
    left_out = turns * period
    numbers = [i for i in range(len(system.bodies)) if not gap <= i < gap + left_out]
    number = {original: k for k, original in enumerate(numbers)}

    def parent(original: int) -> int:
        """Beyond the gap the last bodies before it stand in for those left out."""
        while original >= 0 and original not in number:
            original -= period
        return number.get(original, -1)

    bodies = []
    for whole in numbers:
        above = system.bodies[whole].parent
        if gap <= above < gap + left_out:
            above -= left_out
        bodies.append(replace(system.bodies[whole], parent=parent(above)))
    frames = tuple(replace(f, body=number.get(f.body, -1)) for f in system.frames)
    forces = tuple(
        replace(f, joints={role: number[j] for role, j in f.joints.items()})
        for f in system.forces
        if all(j in number for j in f.joints.values())
    )
    atoms = {
        name: replace(a, frame=number.get(a.frame, -1)) if a.quantity in ("q", "u") else a
        for name, a in system.atoms.items()
    }
    joints = tuple(_renumbered(system.joints[whole], number) for whole in numbers)
    short = replace(
        system, bodies=tuple(bodies), joints=joints, frames=frames, forces=forces, atoms=atoms
    )
    return Fold(short, tuple(numbers), gap, period, turns)


def _renumbered(joint: Joint, number: dict[int, int]) -> Joint:
    if joint.coupling is None:
        return joint
    return replace(joint, coupling=replace(joint.coupling, leader=number[joint.coupling.leader]))


# which bodies repeat


def _longest(
    system: System, signatures: Sequence[Signature | None], period: int
) -> tuple[int, int, int]:
    """(first body, the one after the last, period) of the longest repetition."""
    best, start = (0, 0, period), 0
    strides: list[tuple[int, ...] | None] = [None] * len(signatures)
    for i in range(len(signatures)):
        strides[i] = _stride(system, signatures, i, period) if i - period >= start else ()
        if signatures[i] is None:
            start = i + 1
        elif strides[i] is None:
            start = i - period + 1
        elif i - 2 * period >= start and strides[i] != strides[i - period]:
            start = i - 2 * period + 1
        if i + 1 - start > best[1] - best[0]:
            best = (start, i + 1, period)
    return best


def _stride(
    system: System, signatures: Sequence[Signature | None], i: int, period: int
) -> tuple[int, ...] | None:
    """Offsets of places from those a period before; None where the bodies differ."""
    a, b = signatures[i - period], signatures[i]
    if a is None or b is None or a.pattern != b.pattern:
        return None
    parents = system.bodies[i].parent - system.bodies[i - period].parent
    if parents not in (0, period):
        return None
    # a parent that moves on with the body must belong to the repetition itself
    if parents and i - system.bodies[i].parent > period:
        return None
    return (parents, *(y - x for x, y in zip(a.places, b.places, strict=True)))


def _signatures(system: System) -> list[Signature | None]:
    """Signature of every body; None where it takes part in more than its neighborhood."""
    count = len(system.bodies)
    children: list[list[int]] = [[] for _ in range(count)]
    for i, body in enumerate(system.bodies):
        if body.parent >= 0:
            children[body.parent].append(i - body.parent)
    special, forces = _special(system), [list[Force]() for _ in range(count)]
    for force in system.forces:
        for j in set(force.joints.values()):
            forces[j].append(force)
    signatures: list[Signature | None] = []
    for i in range(count):
        if i in special:
            signatures.append(None)
            continue
        joint, body = system.joints[i], system.bodies[i]
        nodes = [*joint.rotation, *joint.position, body.mass, *body.first_moment, *body.inertia]
        shapes: list[object] = [_kind(joint.element)]
        owners: list[Joint | Force] = [joint, *forces[i]]
        for owner in owners:
            for name, (rows, columns, entries) in owner.data.items():
                shapes.append((name, rows, columns))
                nodes += entries
        shapes += [
            (_kind(f.element, set(f.element.joints().values())), sorted(f.joints))
            for f in forces[i]
        ]
        pattern, places = _pattern(system.graph, nodes)
        if pattern is None:
            signatures.append(None)
            continue
        signature = (tuple(map(repr, shapes)), pattern, tuple(children[i]))
        signatures.append(Signature(signature, (*places, joint.q, joint.u)))
    return signatures


def _special(system: System) -> set[int]:
    """Bodies that forces, couplings or motions tie to others or to the time."""
    special = set[int]()
    for i, joint in enumerate(system.joints):
        if joint.motion is not None:
            special.add(i)
        if joint.coupling is not None:
            special |= {i, joint.coupling.leader}
    for force in system.forces:
        special |= {system.frames[f].body for f in force.frames.values()}
        joints = set(force.joints.values())
        if len(joints) > 1:
            special |= joints
    for atom in system.atoms.values():
        if atom.quantity in ("q", "u"):
            special.add(atom.frame)
        else:
            special |= {system.frames[f].body for f in (atom.frame, atom.wrt, atom.in_)}
    return special


def _kind(element: Any, joints: Collection[str] = ()) -> tuple[object, ...]:
    """An element without its numbers and the names of its joints."""
    attributes = [(f.name, getattr(element, f.name)) for f in fields(element)]
    plain = [(name, x) for name, x in attributes if isinstance(x, (str, bool, type(None)))]
    return (type(element), *[(name, x) for name, x in plain if x not in joints])


def _pattern(graph: Graph, roots: Sequence[int]) -> tuple[object, tuple[int, ...]]:
    """Expressions in local numbers, and the parameters they read; None if they read more."""
    nodes = graph.nodes
    number: dict[int, int] = {}
    pattern_nodes: list[tuple[Any, ...]] = []
    places: list[int] = []
    stack = list(reversed(roots))
    while stack:
        i = stack[-1]
        if i in number:
            stack.pop()
            continue
        node = nodes[i]
        op = node[0]
        if op == "const":
            pattern_nodes.append(node)
        elif op in LEAVES:
            if op != "var" or node[1] != "p":
                return None, ()
            pattern_nodes.append(("p", len(places)))
            places.append(node[2])
        else:
            read = node[4:] if op == "solve" else node[1:2] if op == "item" else node[1:]
            waiting = [k for k in read if k not in number]
            if waiting:
                stack += reversed(waiting)
                continue
            attributes = node[1:4] if op == "solve" else node[2:] if op == "item" else ()
            pattern_nodes.append((op, *attributes, *[number[k] for k in read]))
        number[i] = len(number)
        stack.pop()
    return (tuple(pattern_nodes), tuple([number[i] for i in roots])), tuple(places)
