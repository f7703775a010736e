"""Segments of beams as tables of flexible elements on their nodes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ...elements.flexible import FLEXIBLE
from ...elements.flexible.element import FlexibleElement
from ...elements.flexible.ends import GROUND as AT_GROUND
from ...elements.flexible.ends import NODE as AT_NODE
from ...elements.flexible.ends import OFFSET
from ...errors import DerivationError
from ...ir.function import Function, Output
from ...ir.graph import ZERO, Graph
from ...ir.interpreter import evaluate
from ...topology.convert import IDENTITY, ORIGIN
from ...topology.segment import Segment
from ..blocks import blocks
from .record import GROUND, BlockKind, Group, Integers, Kind, Numbers
from .scene import NODE, Key, Scene

# strain that the data of elements know by name, in the order of that of segments
STRAIN = ("thermal_K1", "thermal_K2", "thermal_K3", "thermal_E1", "thermal_E2", "thermal_E3")
LOADS = {"dead_force": "dead_load", "follower_force": "follower_load"}
MOMENTS = ("dead_moment", "follower_moment")


@dataclass(frozen=True)
class Beamed:
    """What the segments of a scene add.

    Attributes:
        names: Of the nodes between named ones.
        reference: Their coordinates in the reference configuration (7 n,).
        lines: Places of the nodes of every segment, GROUND at ends fixed to the ground.
        groups: The elements.
    """

    names: tuple[str, ...]
    reference: Numbers
    lines: tuple[Integers, ...]
    groups: tuple[Group, ...]


@dataclass(frozen=True)
class _End:
    """Where a segment ends: its place, how it sits there, and the numbers that say so."""

    place: int
    kind: str
    data: tuple[float, ...] = ()


def beamed(scene: Scene, at: Mapping[Key, int], node: BlockKind) -> Beamed:
    """Nodes and elements of all segments.

    Args:
        scene: The scene.
        at: Its places, which the nodes in between follow.
        node: What a node is.

    Raises:
        DerivationError: a property that the kind of element does not have.
    """
    builder = _Builder(scene, at, node)
    names, poses, lines, groups = list[str](), list[Numbers](), list[Integers](), list[Group]()
    place, known = len(at), dict[str, tuple[int, int]]()
    for segment in scene.system.segments:
        count = segment.line.elements
        # nodes and elements are numbered along the whole beam
        nodes, elements = known.get(segment.name, (0, 0))
        known[segment.name] = nodes + count - 1, elements + count
        ends = [builder.end(frame) for frame in (segment.frame_a, segment.frame_b)]
        inner = range(place, place + count - 1)
        line = np.array([ends[0].place, *inner, ends[1].place], dtype=np.intp)
        names += [f"{segment.name}.node{nodes + k + 1}" for k in range(count - 1)]
        place += count - 1
        own = _poses(segment)
        poses.append(own[1:-1].ravel())
        lines.append(line)
        told = [f"{segment.name}.{elements + k + 1}" for k in range(count)]
        groups += builder.groups(segment, told, line, ends, np.hstack([own[:-1], own[1:]]))
    reference = np.concatenate(poses) if poses else np.zeros(0)
    return Beamed(tuple(names), reference, tuple(lines), tuple(groups))


def _poses(segment: Segment) -> Numbers:
    """Unit quaternions and positions of the nodes (n + 1, 7)."""
    from scipy.spatial.transform import Rotation

    xyzw = Rotation.from_matrix(segment.line.rotations).as_quat()
    return np.hstack([xyzw[:, 3:], xyzw[:, :3], segment.line.positions])


class _Builder:
    """Makes the groups of segments; kinds are derived once."""

    def __init__(self, scene: Scene, at: Mapping[Key, int], node: BlockKind) -> None:
        self.scene, self.system = scene, scene.system
        self.at, self.node = at, node
        self.graph: Graph = scene.system.graph.fork()
        self._kinds: dict[str, Kind] = {}

    def end(self, number: int) -> _End:
        """Where a frame at the end of a segment is."""
        frame = self.system.frames[self.scene.frame(number)]
        if frame.body < 0:
            return _End(GROUND, AT_GROUND, self._numbers(frame.rotation + frame.position))
        place = self.at[NODE, frame.body]
        if (frame.rotation, frame.position) == (IDENTITY, ORIGIN):
            return _End(place, AT_NODE)
        return _End(place, OFFSET, self._numbers(frame.rotation + frame.position))

    def _numbers(self, nodes: tuple[int, ...]) -> tuple[float, ...]:
        """Expressions at the values of the parameters: geometry of beams is fixed."""
        made = self._function("place", nodes)
        p = [parameter.value for parameter in self.system.parameters]
        return tuple(float(x) for x in evaluate(made, {"p": p})["data"])

    def _function(self, name: str, nodes: tuple[int, ...]) -> Function:
        output = Output("data", (len(nodes),), nodes)
        return Function(name, self.graph, (blocks(self.system)["p"],), (output,), ("ground",))

    def groups(
        self,
        segment: Segment,
        names: Sequence[str],
        line: Integers,
        ends: Sequence[_End],
        poses: Numbers,
    ) -> Iterator[Group]:
        """The elements of a segment: those at its ends apart where they are no nodes.

        Args:
            segment: The segment.
            names: Of its elements.
            line: Places of its nodes.
            ends: Where it begins and ends.
            poses: Of both nodes of every element in the reference configuration (n, 14).
        """
        for element, values in self._elements(segment):
            own = element.rows(segment.line.stations, poses)
            for part, kinds, data in _parts(segment.line.elements, ends):
                places = np.stack([line[:-1][part], line[1:][part]], axis=1)
                places = places[:, [kind != AT_GROUND for kind in kinds]]
                kind = self._kind(element, kinds)
                rows = own[part]
                yield Group(
                    kind=kind,
                    members=names[part],
                    places=places,
                    rows=np.zeros(len(rows), dtype=np.intp),
                    common=self._function(
                        f"{kind.name}__data", tuple(values[name] for name in element.common)
                    ),
                    own=np.hstack([rows, np.tile(data, (len(rows), 1))]),
                )

    def _kind(self, element: FlexibleElement, kinds: tuple[str, str]) -> Kind:
        name = element.name(kinds)
        if name not in self._kinds:
            moving = sum(kind != AT_GROUND for kind in kinds)
            functions = element.derived(kinds)
            places, source = (self.node,) * moving, element.source
            self._kinds[name] = Kind(name, places, (), 0, element.data(kinds), functions, source)
        return self._kinds[name]

    def _elements(self, segment: Segment) -> Iterator[tuple[FlexibleElement, dict[str, int]]]:
        """The elements that a segment is made of, with the expressions of their common data."""
        values = self._values(segment)
        strain = FLEXIBLE[segment.element]()
        self._refuse(segment, strain, values)
        yield strain, values
        if segment.data["rhoA"][2] != (ZERO,):
            yield FLEXIBLE[f"{segment.inertia}_inertia"](), values
        for key, kind in LOADS.items():
            force = segment.data[key][2]
            if any(node != ZERO for node in force):
                names = [f"{end}_f{i}" for end in ("start", "end") for i in (1, 2, 3)]
                yield FLEXIBLE[kind](), dict(zip(names, force * 2, strict=True))

    def _values(self, segment: Segment) -> dict[str, int]:
        """Common data by name."""
        values = {name: nodes[0] for name, (_, _, nodes) in segment.data.items()}
        values["rhoI1"] = self.graph.add(values["rhoI2"], values["rhoI3"])
        values |= dict(zip(STRAIN, segment.data["strain"][2], strict=True))
        axes = ("gravity_x", "gravity_y", "gravity_z")
        return values | dict(zip(axes, self.system.gravity, strict=True))

    def _refuse(
        self, segment: Segment, element: FlexibleElement, values: Mapping[str, int]
    ) -> None:
        """What the kind of element does not have.

        Raises:
            DerivationError: the beam asks for it.
        """
        missing = [name for name in (*STRAIN, "damping") if name not in element.common]
        asked = [name for name in missing if values[name] != ZERO]
        asked += [key for key in MOMENTS if any(n != ZERO for n in segment.data[key][2])]
        if asked:
            what = ", ".join(name.replace("thermal_", "prestrain ") for name in asked)
            raise DerivationError(
                f"beam '{segment.name}': elements of kind '{segment.element}' have no {what}. "
                "Leave it out"
            )


def _parts(
    count: int, ends: Sequence[_End]
) -> Iterator[tuple[slice, tuple[str, str], tuple[float, ...]]]:
    """Runs of elements between ends of the same kinds, with the data of these ends."""
    first, last = ends
    if count == 1:
        yield slice(0, 1), (first.kind, last.kind), first.data + last.data
        return
    start, stop = int(first.kind != AT_NODE), count - int(last.kind != AT_NODE)
    if start:
        yield slice(0, 1), (first.kind, AT_NODE), first.data
    if stop > start:
        yield slice(start, stop), (AT_NODE, AT_NODE), ()
    if stop < count:
        yield slice(stop, count), (AT_NODE, last.kind), last.data
