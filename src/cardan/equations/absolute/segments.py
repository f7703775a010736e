"""Segments of beams -> nodes between their ends, and groups of flexible elements.

Every element couples the nodes of its two ends; only those at the ends of a segment may be fixed to
a body away from its origin, or to the ground. Nothing here is done element by element.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import overload

import numpy as np

from ...elements.flexible import (
    BEAMS,
    INERTIAS,
    Damping,
    DeadLoad,
    FlexibleElement,
    FollowerLoad,
)
from ...elements.flexible.ends import GROUND as FIXED
from ...elements.flexible.ends import NODE, OFFSET
from ...ir.function import Function, Output
from ...ir.graph import ONE, ZERO
from ...topology.segment import Segment
from ...topology.system import Frame, System
from ..blocks import blocks
from .record import BlockKind, Group, Integers, Kind, Numbers

IDENTITY = (ONE, ZERO, ZERO, ZERO, ONE, ZERO, ZERO, ZERO, ONE)
ORIGIN = (ZERO, ZERO, ZERO)
GRAVITY = ("gravity_1", "gravity_2", "gravity_3")


@dataclass(frozen=True)
class Numbered(Sequence[str]):
    """Names ``stem[first]``, ``stem[first + 1]``, ... of nodes or elements along a beam."""

    stem: str
    first: int
    count: int

    def __len__(self) -> int:
        return self.count

    @overload
    def __getitem__(self, k: int) -> str: ...
    @overload
    def __getitem__(self, k: slice) -> list[str]: ...

    def __getitem__(self, k: int | slice) -> str | list[str]:
        if isinstance(k, slice):
            return [self[i] for i in range(*k.indices(self.count))]
        if not 0 <= k < self.count:
            raise IndexError(k)
        return f"{self.stem}[{self.first + k}]"


@dataclass(frozen=True)
class Run:
    """A segment with the numbers of its nodes among the places.

    Attributes:
        segment: What lies between the ends.
        first: Number of its first element, counted along the whole beam.
        place: The places of its nodes (n + 1,); of an end on the ground -1.
        ends: How both ends are fixed to their nodes.
        start: Coordinates of the nodes in between in the reference configuration (n - 1, 7).
    """

    segment: Segment
    first: int
    place: Integers
    ends: tuple[str, str]
    start: Numbers

    @property
    def inner(self) -> Numbered:
        """Names of the nodes in between."""
        return Numbered(self.segment.name, self.first + 1, len(self.start))


def runs(system: System, bodies: Mapping[int, int], places: int) -> list[Run]:
    """The segments of a system, their inner nodes numbered behind ``places`` others.

    Args:
        system: With segments.
        bodies: Body -> its place.
        places: How many there are.
    """
    found, counted = [], dict[str, int]()
    for segment in system.segments:
        line, inner = segment.line, segment.line.elements - 1
        frames = [system.frames[k] for k in (segment.frame_a, segment.frame_b)]
        one, other = (bodies[f.body] if f.body >= 0 else -1 for f in frames)
        first = counted.get(segment.name, 0)
        counted[segment.name] = first + line.elements
        place = np.concatenate(([one], places + np.arange(inner), [other])).astype(np.intp)
        poses = _poses(line.rotations, line.positions)
        ends = _end(frames[0]), _end(frames[1])
        found.append(Run(segment, first, place, ends, poses[1:-1]))
        places += inner
    return found


def _end(frame: Frame) -> str:
    if frame.body < 0:
        return FIXED
    return NODE if (frame.rotation, frame.position) == (IDENTITY, ORIGIN) else OFFSET


def _poses(rotations: Numbers, positions: Numbers) -> Numbers:
    """Unit quaternions and positions (n, 7); neighbors on the same side."""
    from scipy.spatial.transform import Rotation

    x, y, z, w = Rotation.from_matrix(rotations).as_quat().T
    quaternions = np.stack([w, x, y, z], axis=1)
    signs = np.sign(np.sum(quaternions[1:] * quaternions[:-1], axis=1))
    quaternions[1:] *= np.cumprod(np.where(signs == 0, 1.0, signs))[:, None]
    return np.concatenate([quaternions, positions], axis=1)


def groups(system: System, found: Sequence[Run], node: BlockKind, row: int) -> Iterator[Group]:
    """The elements of all segments.

    Args:
        system: With segments.
        found: These with their places.
        node: What a node is.
        row: First multiplier that is free; flexible elements have none.
    """
    for run in found:
        for element in _elements(system, run.segment):
            for kinds, members in _parts(run):
                yield _group(system, run, element, kinds, members, node, row)


def _elements(system: System, segment: Segment) -> Iterator[FlexibleElement]:
    """What a segment consists of."""
    yield BEAMS[segment.element]
    if any(_value(system, segment, name) for name in ("rhoA", "rhoI2", "rhoI3")):
        yield INERTIAS[segment.inertia]
    if _value(system, segment, "damping"):
        yield Damping()
    for kind, names in (
        (DeadLoad, ("dead_force", "dead_moment")),
        (FollowerLoad, ("follower_force", "follower_moment")),
    ):
        if any(_value(system, segment, name) for name in names):
            yield kind()


def _value(system: System, segment: Segment, name: str) -> bool:
    """Whether data may be other than zero."""
    entry = segment.data.get(name)
    return entry is not None and any(system.graph.value(node) != 0.0 for node in entry[2])


def _parts(run: Run) -> Iterator[tuple[tuple[str, str], slice]]:
    """Elements that are alike in their ends: the first, those in between, the last."""
    count = run.segment.line.elements
    if count == 1:
        yield run.ends, slice(0, 1)
        return
    start = 0 if run.ends[0] == NODE else 1
    stop = count if run.ends[1] == NODE else count - 1
    if start:
        yield (run.ends[0], NODE), slice(0, 1)
    if stop > start:
        yield (NODE, NODE), slice(start, stop)
    if stop < count:
        yield (NODE, run.ends[1]), slice(count - 1, count)


def _group(
    system: System,
    run: Run,
    element: FlexibleElement,
    kinds: tuple[str, str],
    members: slice,
    node: BlockKind,
    row: int,
) -> Group:
    line, count = run.segment.line, members.stop - members.start
    poses = _poses(line.rotations, line.positions)[members.start : members.stop + 1]
    stations = line.stations[members.start : members.stop + 1]
    own = element.rows(stations, np.concatenate([poses[:-1], poses[1:]], axis=1))
    offsets = [_offset(system, run.segment, k) for k in range(2) if kinds[k] != NODE]
    if offsets:
        own = np.concatenate([own, np.tile(np.concatenate(offsets), (count, 1))], axis=1)
    pairs = np.stack([run.place[:-1], run.place[1:]], axis=1)[members]
    moving = [k for k in range(2) if kinds[k] != FIXED]
    return Group(
        kind=Kind(
            name=element.name(kinds),
            blocks=(node,) * len(moving),
            rows=(),
            mp=0,
            data=element.data(kinds),
            functions=element.derived(kinds),
            source=element.source,
        ),
        members=Numbered(run.segment.name, run.first + members.start, count),
        places=np.ascontiguousarray(pairs[:, moving]),
        rows=np.full(count, row, dtype=np.intp),
        common=_common(system, run, element, kinds),
        own=own,
    )


def _offset(system: System, segment: Segment, k: int) -> Numbers:
    """Rotation (9) and position (3) of an end in axes of its body; they are geometry: numbers."""
    frame = system.frames[(segment.frame_a, segment.frame_b)[k]]
    values = [system.graph.value(node) for node in (*frame.rotation, *frame.position)]
    if any(value is None for value in values):
        from ...ir.interpreter import evaluate

        nodes = (*frame.rotation, *frame.position)
        at = Function("offset", system.graph, (blocks(system)["p"],), (Output("at", (12,), nodes),))
        values = evaluate(at, {"p": [entry.value for entry in system.parameters]})["at"]
    return np.array(values, dtype=np.float64)


def _common(
    system: System, run: Run, element: FlexibleElement, kinds: tuple[str, str]
) -> Function | None:
    """The data that section, material and loads give, as a function of the parameters."""
    if not element.common:
        return None
    known = dict(zip(GRAVITY, system.gravity, strict=True))
    for name, (_, _, nodes) in run.segment.data.items():
        known |= {name: nodes[0]} if len(nodes) == 1 else _numbered(name, nodes)
    listed = tuple(known.get(name, ZERO) for name in element.common)
    words = "".join(c if c.isalnum() else "_" for c in f"{run.segment.name}_{run.first}")
    name = f"{element.name(kinds)}__data_{words}"
    output = Output("data", (len(listed),), listed)
    return Function(name, system.graph, (blocks(system)["p"],), (output,), ("ground",))


def _numbered(name: str, nodes: Sequence[int]) -> dict[str, int]:
    return {f"{name}_{k}": node for k, node in enumerate(nodes, start=1)}
