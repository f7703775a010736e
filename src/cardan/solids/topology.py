"""Faces of cells and what hangs together."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ..arrays import Integers
from ..records import dataclass
from .cells import FACES, SOLIDS

FACE_KINDS = {len(cell.nodes): cell for cell in FACES.values()}


@dataclass(frozen=True)
class FaceTable:
    """All faces with one number of corners of all cells, once for each cell.

    Attributes:
        corners: Sorted corners (faces, corners).
        cell: Number of the cell, counted over all kinds in their order (faces,).
        kind, row: Kind of the face, and its row in ``nodes[kind]`` (faces,).
        nodes: Nodes of the faces of each kind, positive outside.
    """

    corners: Integers
    cell: Integers
    kind: list[str]
    row: Integers
    nodes: dict[str, Integers]


def faces(cells: Mapping[str, Integers]) -> list[FaceTable]:
    """The faces of all cells, by number of corners."""
    rows: dict[int, list[tuple[str, Integers, Integers]]] = {}
    start = 0
    for kind, members in cells.items():
        numbers = np.arange(start, start + len(members))
        start += len(members)
        for face in SOLIDS[kind].faces:
            shape = FACE_KINDS[len(face)]
            entry = (shape.kind, members[:, list(face)], numbers)
            rows.setdefault(shape.corners, []).append(entry)
    return [_table(corners, entries) for corners, entries in sorted(rows.items())]


def _table(corners: int, entries: list[tuple[str, Integers, Integers]]) -> FaceTable:
    nodes: dict[str, list[Integers]] = {}
    kind: list[str] = []
    row: list[Integers] = []
    for name, members, _ in entries:
        start = sum(map(len, nodes.get(name, [])))
        nodes.setdefault(name, []).append(members)
        kind += [name] * len(members)
        row.append(np.arange(start, start + len(members)))
    return FaceTable(
        np.sort(np.concatenate([members[:, :corners] for _, members, _ in entries]), axis=1),
        np.concatenate([numbers for _, _, numbers in entries]),
        kind,
        np.concatenate(row),
        {name: np.concatenate(members) for name, members in nodes.items()},
    )


@dataclass(frozen=True)
class Boundary:
    """Faces that belong to one cell only.

    Attributes:
        faces: Their nodes by kind (faces, nodes), positive outside.
        pairs: Numbers of cells that share a face (pairs, 2).
        crowded: Corners of faces that three or more cells have.
    """

    faces: dict[str, Integers]
    pairs: Integers
    crowded: list[Integers]


def boundary(cells: Mapping[str, Integers]) -> Boundary:
    """The outer faces, and which cells are neighbors."""
    outer: dict[str, list[Integers]] = {}
    pairs: list[Integers] = []
    crowded: list[Integers] = []
    for table in faces(cells):
        _, first, inverse, count = np.unique(
            table.corners, axis=0, return_index=True, return_inverse=True, return_counts=True
        )
        order = np.argsort(inverse.ravel(), kind="stable")
        # equal faces are consecutive in this order
        same = np.diff(inverse.ravel()[order]) == 0
        pairs.append(np.stack([table.cell[order[:-1][same]], table.cell[order[1:][same]]], axis=1))
        crowded += list(table.corners[first[count > 2]])
        for k in first[count == 1]:
            outer.setdefault(table.kind[k], []).append(table.nodes[table.kind[k]][table.row[k]])
    joined = np.concatenate(pairs) if pairs else np.zeros((0, 2), int)
    return Boundary({kind: np.array(rows) for kind, rows in outer.items()}, joined, crowded)


def components(size: int, pairs: Integers) -> tuple[int, Integers]:
    """Number of connected components, and that of each member.

    Args:
        size: How many members.
        pairs: Connected members (pairs, 2).
    """
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    graph = coo_matrix((np.ones(len(pairs), np.int8), (pairs[:, 0], pairs[:, 1])), (size, size))
    count, label = connected_components(graph, directed=False)
    return int(count), label.astype(np.intp)


def by_nodes(cells: Mapping[str, Integers], size: int) -> tuple[int, Integers]:
    """Components of the cells (numbered over all kinds) that common nodes connect.

    Args:
        cells: Nodes of the cells by kind.
        size: How many nodes.
    """
    pairs: list[Integers] = []
    start = size
    for members in cells.values():
        numbers = np.arange(start, start + len(members))
        start += len(members)
        pairs.append(np.stack([np.repeat(numbers, members.shape[1]), members.ravel()], axis=1))
    _, label = components(start, np.concatenate(pairs))
    names, compact = np.unique(label[size:], return_inverse=True)
    return len(names), compact.ravel().astype(np.intp)
