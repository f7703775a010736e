"""A finite-element mesh of a solid: nodes, cells, and named sets of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field
from typing import TypeAlias, TypeVar

import numpy as np
from numpy.typing import ArrayLike

from ..arrays import Array, Integers
from ..errors import ModelError, brief, counted, near
from ..records import dataclass
from ..superelements.values import checked_name
from .cells import FACES
from .checks import checked_cells, checked_points, checked_shapes
from .topology import Boundary, boundary
from .units import judge_place, judge_size

# a name of the mesh, or node numbers
Place: TypeAlias = "str | Sequence[int] | Integers"
ByKind: TypeAlias = "Mapping[str, Integers]"


@dataclass(frozen=True, eq=False)
class Mesh:
    """A mesh of solid cells; made by :func:`read` or :func:`from_arrays`. Numbers count from 0.

    Attributes:
        points: Positions of the nodes (nodes, 3) [m].
        cells: Nodes of the cells (cells, nodes of a cell) by kind, such as ``"tet10"``.
        node_sets: Node numbers by name.
        surfaces: Nodes of faces (faces, nodes of a face) by kind, by name.
        regions: Numbers of cells by kind, by name.
        source: Where it came from, for messages.
        boundary: The outer faces, positive outside.
    """

    points: Array
    cells: ByKind
    node_sets: ByKind = field(default_factory=dict)
    surfaces: Mapping[str, ByKind] = field(default_factory=dict)
    regions: Mapping[str, ByKind] = field(default_factory=dict)
    source: str = "mesh"
    boundary: Boundary = field(init=False, repr=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "boundary", boundary(self.cells))

    def __repr__(self) -> str:
        cells = ", ".join(f"{len(members)} {kind}" for kind, members in self.cells.items())
        names = ", ".join(self.names) or "none"
        return f"Mesh({counted(len(self.points), 'node')}, {cells}; named: {names})"

    @property
    def names(self) -> list[str]:
        """Names of surfaces, node sets and regions."""
        return list(dict.fromkeys([*self.surfaces, *self.node_sets, *self.regions]))

    @property
    def dofs(self) -> int:
        """Degrees of freedom: 3 for each node, those of node k are 3 k, 3 k + 1, 3 k + 2."""
        return 3 * len(self.points)

    @property
    def triangles(self) -> Integers:
        """The outside as flat triangles between nodes (triangles, 3), positive outside."""
        lists = [
            rows[:, FACES[kind].triangles].reshape(-1, 3)
            for kind, rows in self.boundary.faces.items()
        ]
        return np.concatenate(lists)

    def nodes(self, place: Place) -> Integers:
        """Node numbers of a surface, a node set or a region, ascending; numbers stay what they are.

        Args:
            place: A name, or node numbers.

        Raises:
            ModelError: there is nothing of that name, or no such node.
        """
        if not isinstance(place, str):
            return self._numbers(place)
        arrays: list[Integers] = [
            *self.surfaces.get(place, {}).values(),
            *((self.node_sets[place],) if place in self.node_sets else ()),
            *(self.cells[kind][rows] for kind, rows in self.regions.get(place, {}).items()),
        ]
        if not arrays:
            raise ModelError(
                f"{self.source}: there is no surface, set or region {brief(place)}."
                f"{near(place, self.names)}"
            )
        return np.unique(np.concatenate([array.ravel() for array in arrays]))

    def _numbers(self, place: Sequence[int] | Integers) -> Integers:
        try:
            numbers = np.asarray(place)
        except ValueError:
            numbers = np.zeros(0)
        if numbers.ndim != 1 or not len(numbers) or not np.issubdtype(numbers.dtype, np.integer):
            raise ModelError(
                f"{self.source}: nodes={brief(place)}: give a list of node numbers or the name of "
                f"a surface or set: {', '.join(self.names) or 'this mesh has none'}"
            )
        if numbers.min() < 0 or numbers.max() >= len(self.points):
            wrong = numbers.max() if numbers.min() >= 0 else numbers.min()
            raise ModelError(
                f"{self.source}: there is no node {wrong}; nodes are numbered 0 to "
                f"{len(self.points) - 1}"
            )
        return np.unique(numbers).astype(np.intp)

    def faces(self, place: Place) -> dict[str, Integers]:
        """Outer faces of a surface by kind (faces, nodes), positive outside.

        Args:
            place: Name of a surface; or a node set or node numbers: the outer faces all of whose
                nodes are among them.

        Raises:
            ModelError: nothing has that name, a face is not on the outside, or there is none.
        """
        nodes = self.nodes(place)
        inside = np.zeros(len(self.points), bool)
        inside[nodes] = True
        chosen: dict[str, Integers] = {}
        for kind, rows in self.boundary.faces.items():
            chosen[kind] = rows[inside[rows].all(axis=1)]
        if isinstance(place, str) and place in self.surfaces:
            chosen = self._of_surface(place, chosen)
        chosen = {kind: rows for kind, rows in chosen.items() if len(rows)}
        if not chosen:
            raise ModelError(
                f"{self.source}: no outer face of a cell has all its nodes in {brief(place)}; give "
                "a surface, or all nodes of one"
            )
        return chosen

    def _of_surface(self, name: str, chosen: dict[str, Integers]) -> dict[str, Integers]:
        """Those of some outer faces that a surface lists."""
        result: dict[str, Integers] = {}
        for kind, rows in self.surfaces[name].items():
            outer = chosen.get(kind, np.zeros((0, rows.shape[1]), np.intp))
            listed = {tuple(row): k for k, row in enumerate(np.sort(outer, axis=1).tolist())}
            picked = []
            for row in np.sort(rows, axis=1).tolist():
                if tuple(row) not in listed:
                    raise ModelError(
                        f"{self.source}: surface '{name}': its {kind} face with nodes "
                        f"{', '.join(map(str, row))} is not an outer face of a cell"
                    )
                picked.append(listed[tuple(row)])
            result[kind] = outer[np.unique(picked)]
        return result


def from_arrays(
    points: ArrayLike,
    cells: Mapping[str, ArrayLike],
    node_sets: Mapping[str, ArrayLike] | None = None,
    surfaces: Mapping[str, Mapping[str, ArrayLike]] | None = None,
    regions: Mapping[str, Mapping[str, ArrayLike]] | None = None,
    scale: float | None = None,
    parts: int = 1,
    source: str = "mesh",
) -> Mesh:
    """A mesh of plain arrays, checked. Numbers count from 0.

    Args:
        points: Positions of the nodes (nodes, 3).
        cells: Nodes of the cells (cells, nodes of a cell) by kind: ``"tet4"``, ``"tet10"``,
            ``"hex8"``, ``"hex20"``, nodes in the order of VTK.
        node_sets: Node numbers by name.
        surfaces: Nodes of faces by kind (``"tri3"``, ``"tri6"``, ``"quad4"``, ``"quad8"``), by
            name.
        regions: Numbers of cells by kind, by name.
        scale: Length of a unit of ``points`` [m]: 1e-3 for millimeters. By default they are meters,
            and a warning is given where that makes no sense.
        parts: How many unconnected parts are meant.
        source: What messages call it.

    Raises:
        ModelError: arrays of wrong shape, numbers that are not finite, nodes that no cell has or
            that lie in one place, cells inside out or folded, unconnected parts.
    """
    if not isinstance(parts, int) or isinstance(parts, bool) or parts < 1:
        raise ModelError(f"{source}: parts={brief(parts)}: give how many are meant, such as 1")
    positions = checked_points(source, points, scale)
    members = checked_cells(source, cells, len(positions))
    faces = {
        name: checked_cells(f"{source}: surface '{name}'", kinds, len(positions), dimension=2)
        for name, kinds in _by_name(source, "surfaces", surfaces)
    }
    sets = {
        name: _listed(f"{source}: set '{name}'", numbers, len(positions), "node")
        for name, numbers in _by_name(source, "node_sets", node_sets)
    }
    groups = {
        name: {
            kind: _listed(
                f"{source}: region '{name}'", numbers, len(members.get(kind, ())), f"{kind} cell"
            )
            for kind, numbers in _by_name(source, f"regions: '{name}'", kinds)
        }
        for name, kinds in _by_name(source, "regions", regions)
    }
    judge_place(source, positions)
    checked_shapes(source, positions, members, parts)
    if scale is None:
        judge_size(source, positions)
    for array in (positions, *members.values()):
        array.setflags(write=False)
    return Mesh(positions, members, sets, faces, groups, source)


Entry = TypeVar("Entry")


def _by_name(source: str, who: str, entries: Mapping[str, Entry] | None) -> list[tuple[str, Entry]]:
    """Entries by name.

    Raises:
        ModelError: they are not, or a name cannot be printed.
    """
    if entries is None:
        return []
    if not isinstance(entries, Mapping):
        raise ModelError(f"{source}: {who}={brief(entries)}: give values by name, {{'hole': ...}}")
    return [(checked_name(f"{source}: {who}", name), one) for name, one in entries.items()]


def _listed(who: str, numbers: ArrayLike, size: int, noun: str) -> Integers:
    try:
        array = np.asarray(numbers)
    except ValueError:
        array = np.zeros((0, 0))
    if array.ndim != 1 or (len(array) and not np.issubdtype(array.dtype, np.integer)):
        raise ModelError(f"{who}: {brief(numbers)}: give a list of numbers of {noun}s")
    if len(array) and (array.min() < 0 or array.max() >= size):
        wrong = array[(array < 0) | (array >= size)][0]
        there = f"numbers go from 0 to {size - 1}" if size else "there are none"
        raise ModelError(f"{who}: there is no {noun} {wrong}; {there}")
    return np.unique(array).astype(np.intp)
