"""Large trees: one body of every kind is derived, the others do the same with other entries.

Bodies are of one kind where their expressions differ by the names of parameters and coordinates
only. A small tree has one body of each: next to the ground those that are jointed to it, and all
others outboard of one body that stands for any parent. What bodies hand on has one form for all
kinds (:mod:`.common_forms`), so that it does not matter which parent and which children a body has.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Collection, Sequence
from dataclasses import replace
from functools import cached_property
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from ...elements.outline import Outlines
from ...ir.function import live, pattern
from ...records import dataclass
from ...topology.system import Force, Joint, System

# fewer bodies are not worth it, nor are kinds with fewer bodies each
FEWEST, ALIKE = 40, 4
Ints: TypeAlias = npt.NDArray[np.int64]
# (block, entry), None for one that other bodies read too
Entries: TypeAlias = tuple[tuple[str, int] | None, ...]


class Signature(NamedTuple):
    """A body as the recursion sees it.

    Attributes:
        pattern: Its expressions without names, its kind of joint, where it is in the tree.
        entries: Parameters, inputs and internal states in the order of use.
    """

    pattern: object
    entries: Entries


@dataclass(frozen=True)
class Representatives:
    """A small tree with a body of every kind.

    Attributes:
        system: The small tree; slots and parameters are those of the large one.
        large: The large one.
        numbers: Of every body of the small tree its number in the large one.
        members: Of every body of the small tree those of the large one that it stands for.
        parent: The body of the small tree that stands for any parent, itself for no body; -1 where
            the first body is the only parent.
        alone: Whether a body stands for itself only, because others may be tied to it.
        formed: Whether other bodies may read what it hands on.
        entries: Parameters, inputs and internal states of every body of the large tree, in the
            order of use, as far as no other body reads them.
        shared: Those that several bodies read.
    """

    system: System
    large: System
    numbers: tuple[int, ...]
    members: tuple[Ints, ...]
    parent: int
    alone: tuple[bool, ...]
    formed: tuple[bool, ...]
    entries: tuple[Entries, ...]
    shared: frozenset[tuple[str, int]]

    @cached_property
    def parents(self) -> Ints:
        return np.array([body.parent for body in self.large.bodies], dtype=np.int64)

    @cached_property
    def slots(self) -> dict[str, Ints]:
        """First slots of every body in q and in u, -1 where it has none."""
        q, u = zip(*((joint.q, joint.u) for joint in self.large.joints), strict=True)
        return {"q": np.array(q, np.int64), "u": np.array(u, np.int64)}

    @cached_property
    def owners(self) -> dict[tuple[str, int], int]:
        """Entry of a block that belongs to one body alone -> that body."""
        return {entry: i for i, entries in enumerate(self.entries) for entry in entries if entry}


def representatives(system: System) -> Representatives | None:
    """A body of every kind; None where bodies are few or hardly any are alike."""
    bodies = system.bodies
    if len(bodies) < FEWEST or any(body.turn is not None for body in bodies):
        return None
    special = _special(system)
    expressions = _signatures(system, special)
    shared = _shared(system, expressions)
    signatures = [None if s is None else _with_shared(s, shared) for s in expressions]
    kinds: dict[object, list[int]] = defaultdict(list)
    alone = []
    for i, signature in enumerate(signatures):
        if signature is None:
            alone.append(i)
        else:
            kinds[signature.pattern].append(i)
    if ALIKE * (len(kinds) + len(alone)) > len(bodies):
        return None
    inboard = {body.parent for body in bodies}
    parents = [kind for kind in kinds.values() if kind[0] in inboard]
    inner = [kind for kind in parents if bodies[kind[0]].parent >= 0]
    any_parent = max(inner or parents, key=len, default=[])[1:2]
    if not any_parent and inboard - {-1, 0}:
        return None
    # bodies next to the ground first, then the one that stands for all parents
    groups = sorted([*([i] for i in alone), *kinds.values()], key=lambda kind: kind[0])
    first = [kind for kind in groups if bodies[kind[0]].parent < 0]
    outboard = [kind for kind in groups if bodies[kind[0]].parent >= 0]
    parent = len(first) if any_parent else -1
    groups = [*first, *([any_parent] if any_parent else ()), *outboard]
    numbers = tuple([kind[0] for kind in groups])
    inboard_of = [-1] * len(first) + [0 if inner else -1] * len(any_parent)
    inboard_of += [max(parent, 0)] * len(outboard)
    single = set(alone)
    return Representatives(
        _small(system, numbers, inboard_of),
        system,
        numbers,
        tuple([np.array(() if k == parent else kind, np.int64) for k, kind in enumerate(groups)]),
        parent,
        tuple([k != parent and number in single for k, number in enumerate(numbers)]),
        tuple([number in inboard or number in single for number in numbers]),
        tuple([() if s is None else s.entries for s in signatures]),
        shared,
    )


def _small(system: System, numbers: Sequence[int], parents: Sequence[int]) -> System:
    """Some bodies of a system, jointed to others of them."""
    number = {original: k for k, original in enumerate(numbers)}
    bodies = [
        replace(system.bodies[original], parent=parent)
        for original, parent in zip(numbers, parents, strict=True)
    ]
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
    joints = tuple(_renumbered(system.joints[original], number) for original in numbers)
    return replace(
        system, bodies=tuple(bodies), joints=joints, frames=frames, forces=forces, atoms=atoms
    )


def _renumbered(joint: Joint, number: dict[int, int]) -> Joint:
    if joint.coupling is None:
        return joint
    return replace(joint, coupling=replace(joint.coupling, leader=number[joint.coupling.leader]))


# which bodies are alike


def _signatures(system: System, special: Collection[int]) -> list[Signature | None]:
    """Signature of every body; None of those that others are tied to."""
    count = len(system.bodies)
    forces: list[list[Force]] = [[] for _ in range(count)]
    for force in system.forces:
        for j in set(force.joints.values()):
            forces[j].append(force)
    inboard, sliding = {body.parent for body in system.bodies}, only_slides(system)
    outlines = Outlines()
    signatures: list[Signature | None] = []
    for i, (body, joint) in enumerate(zip(system.bodies, system.joints, strict=True)):
        nodes = [*joint.rotation, *joint.position, body.mass, *body.first_moment, *body.inertia]
        nodes += [joint.offset, *(body.second_moment or ())]
        shapes: list[object] = [outlines[joint.element], body.second_moment is None]
        owners: list[Joint | Force] = [joint, *forces[i]]
        for owner in owners:
            for name, (rows, columns, of_data) in owner.data.items():
                shapes.append((name, rows, columns))
                nodes += of_data
        shapes += [(outlines[f.element], *sorted(f.joints)) for f in forces[i]]
        # a slide next to the ground moves what is outboard of it in another way than a hinge
        place = (min(body.parent, 0), body.parent >= 0 and sliding[body.parent], i in inboard)
        expressions, entries = pattern(system.graph, nodes, ("p", "r"))
        if expressions is None or i in special:
            signatures.append(None)
            continue
        states = [("z", f.z + k) for f in forces[i] for k in range(len(f.element.internals()))]
        states += [("s", f.s + k) for f in forces[i] for k in range(len(f.element.modes()))]
        signatures.append(Signature((*shapes, place, expressions), (*entries, *states)))
    return signatures


def only_slides(system: System) -> list[bool]:
    """Bodies to which only translations lead from the ground, True for each."""
    sliding = list[bool]()
    for body, joint in zip(system.bodies, system.joints, strict=True):
        units = {coordinate.unit for coordinate in joint.element.coordinates}
        sliding.append(units == {"m"} and (body.parent < 0 or sliding[body.parent]))
    return sliding


def _shared(system: System, signatures: Sequence[Signature | None]) -> frozenset[tuple[str, int]]:
    """Entries of blocks that several bodies read, and those of gravity, which all do."""
    nodes = system.graph.nodes
    uses = Counter(k for s in signatures if s is not None for k in s.entries if k is not None)
    of_all = [nodes[i] for i in live(system.graph, system.gravity) if nodes[i][0] == "var"]
    return frozenset([k for k, n in uses.items() if n > 1] + [leaf[1:] for leaf in of_all])


def _with_shared(signature: Signature, shared: Collection[tuple[str, int]]) -> Signature:
    """The same; bodies that read what others read, too, are alike where they read the same."""
    same = tuple([entry if entry in shared else None for entry in signature.entries])
    alone = tuple([None if entry in shared else entry for entry in signature.entries])
    return Signature((signature.pattern, same), alone)


def _special(system: System) -> set[int]:
    """Bodies that forces, couplings or motions tie to others or to the time, and the first: sums
    over all bodies are its.
    """
    special = {0}
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
