"""Segments of beams as tables of flexible elements on their nodes."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence

import numpy as np

from ...arrays import Integers
from ...elements.flexible.element import FlexibleElement
from ...elements.flexible.element_ends import GROUND as AT_GROUND
from ...elements.flexible.element_ends import NODE as AT_NODE
from ...elements.flexible.element_ends import OFFSET
from ...ir.function import Function, Output
from ...ir.interpreter import evaluate
from ...records import dataclass
from ...schema.finite_elements import GROUND, ON_TREE
from ...topology.beams.segment_tables import Segment
from ...topology.conversion import IDENTITY, ORIGIN
from ..functions.blocks import parameters
from .blocks import Holds
from .element_systems import Cutting
from .ends_on_trees import INSIDE, TREE, TREE_OFFSET, TreeElement
from .nodal_scene import NODE, Key, Scene
from .planar_kinds import flattened
from .record import BlockKind, Group, Kind, Numbers, unique
from .segment_elements import elements_of, poses_of

# elements of a segment up to which they share a table with those of others
FEW = 100


@dataclass(frozen=True)
class Beamed:
    """Places and groups that the segments of a scene add.

    Attributes:
        names: Of the nodes between named ones.
        reference: Their coordinates in the reference configuration, one after the other.
        kinds: What each of them holds.
        space: Kinds of elements in space by the name of those in a plane.
        lines: Places of the nodes of every segment, GROUND at ends fixed to the ground, ON_TREE - k
            at those on body k of ``tree_ends``.
        tree_ends: Bodies of rigid trees that segments end at.
        groups: The elements.
    """

    names: tuple[str, ...]
    reference: Numbers
    kinds: tuple[BlockKind, ...]
    space: dict[str, Kind]
    lines: tuple[Integers, ...]
    tree_ends: tuple[int, ...]
    groups: tuple[Group, ...]


@dataclass(frozen=True)
class _End:
    """End of a segment: its place, its attachment there, the numbers of it, and its body."""

    place: int
    kind: str
    data: tuple[float, ...] = ()
    body: int = GROUND


@dataclass(frozen=True)
class _Part:
    """Elements of one kind in a segment.

    Attributes:
        kind: Theirs.
        names: Of the elements.
        places: Of their nodes (n, number of nodes).
        common: Expressions of their common data.
        attributes: The other data (n, k).
        power: Number of the source of power, -1 for none.
        cutting: The small system that they stand in; None where they need none.
    """

    kind: Kind
    names: Sequence[str]
    places: Integers
    common: tuple[int, ...]
    attributes: Numbers
    power: int
    cutting: Cutting | None = None


def beamed(
    scene: Scene, at: Mapping[Key, int], holds: Holds, powers: dict[str, int], taken: set[str]
) -> Beamed:
    """Nodes and elements of all segments.

    Args:
        scene: The scene.
        at: Its places, which the nodes in between follow.
        holds: What places hold.
        powers: Numbers of the sources of power; beams are added.
        taken: Names of kinds that there are.
    """
    builder = _Builder(scene, at, holds, powers, taken)
    names, poses, lines, parts = list[str](), list[Numbers](), list[Integers](), list[_Part]()
    kinds = list[BlockKind]()
    place, counts = len(at), dict[str, tuple[int, int]]()
    for number, segment in enumerate(scene.system.segments):
        count = segment.line.elements
        # nodes and elements are numbered along the whole beam
        nodes, elements = counts.get(segment.name, (0, 0))
        counts[segment.name] = nodes + count - 1, elements + count
        ends = [builder.end(frame) for frame in (segment.frame_a, segment.frame_b)]
        inner = range(place, place + count - 1)
        line = np.array([ends[0].place, *inner, ends[1].place], dtype=np.intp)
        names += [f"{segment.name}.node{nodes + k + 1}" for k in range(count - 1)]
        place += count - 1
        poses_here = poses_of(segment)
        inside = holds.inside(number)
        poses.append(_coordinates(inside, poses_here[1:-1]).ravel())
        kinds += [inside] * (count - 1)
        lines.append(line)
        labels = [f"{segment.name}.{elements + k + 1}" for k in range(count)]
        pairs = np.hstack([poses_here[:-1], poses_here[1:]])
        parts += builder.parts(segment, labels, line, ends, pairs, inside)
    reference = np.concatenate(poses) if poses else np.zeros(0)
    return Beamed(
        names=tuple(names),
        reference=reference,
        kinds=tuple(kinds),
        space=builder.space,
        lines=tuple(lines),
        tree_ends=tuple(builder.tree_ends),
        groups=tuple(builder.groups(parts)),
    )


def _coordinates(kind: BlockKind, poses: Numbers) -> Numbers:
    """Coordinates of nodes at poses (n, 7)."""
    return poses if kind.plane is None else kind.plane.coordinates_of(poses)


class _Builder:
    """Makes the groups of segments; kinds are derived once."""

    def __init__(
        self,
        scene: Scene,
        at: Mapping[Key, int],
        holds: Holds,
        powers: dict[str, int],
        taken: set[str],
    ) -> None:
        self.scene, self.system = scene, scene.system
        self.at, self.holds, self.powers, self.taken = at, holds, powers, taken
        self.keys = list(at)
        self.space: dict[str, Kind] = {}
        self.tree_ends: list[int] = []
        self._kinds: dict[tuple[str, ...], Kind] = {}
        self._tree_numbers = {i: k for k, i in enumerate(sorted(scene.in_trees))}

    def end(self, number: int) -> _End:
        """Attachment of a frame at the end of a segment."""
        frame = self.system.frames[self.scene.frame(number)]
        if frame.body < 0:
            return _End(GROUND, AT_GROUND, self._numbers(frame.rotation + frame.position))
        at_origin = (frame.rotation, frame.position) == (IDENTITY, ORIGIN)
        data = () if at_origin else self._numbers(frame.rotation + frame.position)
        if frame.body not in self.scene.in_trees:
            kind = AT_NODE if at_origin else OFFSET
            return _End(self.at[NODE, frame.body], kind, data, frame.body)
        if frame.body not in self.tree_ends:
            self.tree_ends.append(frame.body)
        place = ON_TREE - self.tree_ends.index(frame.body)
        return _End(place, TREE if at_origin else TREE_OFFSET, data, frame.body)

    def _center(self, number: int) -> _End | None:
        """A center that moves, as an end; its frame is among the common data."""
        body = self.system.frames[self.scene.frame(number)].body
        if body < 0:
            return None
        tree = body in self.scene.in_trees
        place = ON_TREE if tree else self.at[NODE, body]
        return _End(place, TREE_OFFSET if tree else OFFSET, (), body)

    def _numbers(self, nodes: tuple[int, ...]) -> tuple[float, ...]:
        """Expressions at the values of the parameters: geometry of beams is fixed."""
        function = self._function("place", nodes)
        p = [parameter.value for parameter in self.system.parameters]
        return tuple(float(x) for x in evaluate(function, {"p": p})["data"])

    def _function(self, name: str, nodes: tuple[int, ...], *shape: int) -> Function:
        output = Output("data", shape or (len(nodes),), nodes)
        p = parameters(self.system)
        return Function(name, self.system.graph, (p,), (output,), ("ground",))

    def groups(self, parts: Sequence[_Part]) -> Iterator[Group]:
        """One table for each kind; long parts have one of their own, with data told once."""
        sorted_by: dict[tuple[object, ...], list[_Part]] = {}
        for part in parts:
            shared_data = part.common if len(part.names) > FEW else ()
            sorted_by.setdefault((part.kind.name, shared_data), []).append(part)
        for number, some in enumerate(sorted_by.values()):
            kind, counts = some[0].kind, [len(part.names) for part in some]
            power = np.repeat([part.power for part in some], counts)[:, None]
            yield Group(
                kind=kind,
                members=[name for part in some for name in part.names],
                places=np.concatenate([part.places for part in some]),
                rows=np.zeros((sum(counts), 2), dtype=np.intp),
                common=self._common(f"{kind.name}__data_{number}", some),
                attributes=np.concatenate([part.attributes for part in some]),
                powers=power.astype(np.intp) if "power" in kind.functions else None,
                reactions=_table(
                    some, lambda cutting: [self._tree_numbers[i] for i in cutting.moved]
                )
                if "reactions" in kind.functions
                else None,
                z=_table(some, lambda cutting: cutting.z),
                s=_table(some, lambda cutting: cutting.s),
            )

    def _common(self, name: str, parts: Sequence[_Part]) -> Function | None:
        """Common data of a group as a function of the parameters of the scene."""
        first = parts[0].common
        if not first:
            return None
        if all(part.common == first for part in parts):
            return self._function(name, first)
        nodes = [node for part in parts for node in part.common * len(part.names)]
        return self._function(name, tuple(nodes), len(nodes) // len(first), len(first))

    def parts(
        self,
        segment: Segment,
        names: Sequence[str],
        line: Integers,
        ends: Sequence[_End],
        poses: Numbers,
        inside: BlockKind,
    ) -> Iterator[_Part]:
        """The elements of a segment: those at its ends apart where they are not nodes.

        Args:
            segment: The segment.
            names: Of its elements.
            line: Places of its nodes.
            ends: Where it begins and ends.
            poses: Of both nodes of every element in the reference configuration (n, 14).
            inside: What its nodes inside hold.
        """
        for element, values, variable, frame in elements_of(self.scene, segment):
            center = None if frame is None else self._center(frame)
            rows_of_elements = element.rows(segment.line.stations, poses)
            centers = () if center is None else (center,)
            separate = [
                end.place >= 0 and self._block_at(end.place, inside) != inside for end in ends
            ]
            runs = _parts(segment.line.elements, ends, separate, center is None)
            for part, pair, data in runs:
                every = (*pair, *centers)
                kinds = tuple(end.kind for end in every)
                columns = [line[:-1][part], line[1:][part]]
                columns += [np.full(len(columns[0]), end.place) for end in centers]
                places = np.stack(columns, axis=1)
                tree: TreeElement | None = None
                if variable or TREE in kinds or TREE_OFFSET in kinds:
                    bodies = tuple(end.body for end in every)
                    tree = TreeElement(self.scene, element, kinds, bodies, variable)
                    inner = places[:, [end.body == INSIDE for end in every]]
                    named = np.tile([self.at[key] for key in tree.cutting.places], (len(places), 1))
                    places = np.hstack([named, inner]).astype(np.intp)
                else:
                    places = places[:, [kind != AT_GROUND for kind in kinds]]
                at = places[0] if len(places) else ()
                end_blocks = tuple(self._block_at(int(place), inside) for place in at)
                kind = self._kind(element, kinds, end_blocks, tree)
                rows = rows_of_elements[part]
                attributes = np.hstack([rows, np.tile(data, (len(rows), 1))])
                common = tuple(values[name] for name in element.common)
                power = self._power(segment) if "power" in kind.functions else -1
                cutting = tree.cutting if tree else None
                common = (*cutting.data, *common) if cutting else common
                yield _Part(kind, names[part], places, common, attributes, power, cutting)

    def _power(self, segment: Segment) -> int:
        """Entry for the power of elements: one sum for the whole beam."""
        return self.powers.setdefault(segment.name, len(self.powers))

    def _block_at(self, place: int, inside: BlockKind) -> BlockKind:
        """Block kind of a node of a segment."""
        return self.holds.here[self.keys[place]] if place < len(self.keys) else inside

    def _kind(
        self,
        element: FlexibleElement,
        kinds: tuple[str, ...],
        end_blocks: tuple[BlockKind, ...],
        tree: TreeElement | None = None,
    ) -> Kind:
        """The kind of an element between such ends, whose nodes hold this."""
        name = f"{element.name()}_tree" if tree else element.name(kinds)
        places = (self.holds.node,) * len(end_blocks)
        if tree:
            named = tuple(self.holds.space[key] for key in tree.cutting.places)
            places = (*named, *places[len(named) :])
        on_tree = (*(block.name for block in places), tree.structure()) if tree else ()
        key = (name, *(block.name for block in end_blocks), *on_tree)
        if key not in self._kinds:
            name = unique(name, self.taken) if tree else name
            kind = Kind(
                name=name,
                blocks=places,
                rows=(),
                mp=0,
                data=tree.data if tree else element.data(kinds),
                functions=tree.functions(name) if tree else element.derived(kinds),
                source=element.source,
                formulas=element.formula_lines,
                symbol_shapes=element.symbol_shapes,
                element=element.kind,
                part="beam",
                strain=element.strain,
            )
            if end_blocks != places:
                space, planar_name = kind, unique(name, self.taken)
                kind = flattened(planar_name, space, end_blocks)
                self.space[planar_name] = space
            self._kinds[key] = kind
        return self._kinds[key]


def _table(parts: Sequence[_Part], entries: Callable[[Cutting], list[int]]) -> Integers | None:
    """Entries of the scene that members read or change (n, k); None without."""
    rows = [entries(part.cutting) if part.cutting else [] for part in parts for _ in part.names]
    return np.array(rows, dtype=np.intp) if any(rows) else None


def _parts(
    count: int, ends: Sequence[_End], separate: Sequence[bool], still: bool
) -> Iterator[tuple[slice, tuple[_End, _End], tuple[float, ...]]]:
    """Runs of elements between ends of the same kinds, with the data of these ends.

    Where a node at an end holds other coordinates than those inside, its element is apart too. One
    element from ground to ground cannot move: it is left out where nothing else does (``still``).
    """
    first, last = ends
    inner = _End(GROUND, AT_NODE, (), INSIDE)
    if count == 1:
        if still and (first.kind, last.kind) == (AT_GROUND, AT_GROUND):
            return
        yield slice(0, 1), (first, last), first.data + last.data
        return
    start = int(first.kind != AT_NODE or separate[0])
    stop = count - int(last.kind != AT_NODE or separate[1])
    if start:
        yield slice(0, 1), (first, inner), first.data
    if stop > start:
        yield slice(start, stop), (inner, inner), ()
    if stop < count:
        yield slice(stop, count), (inner, last), last.data
