"""Whether cells have shapes that can be integrated over."""

from __future__ import annotations

import numpy as np

from ..arrays import Array, Integers
from ..errors import ModelError, ModelWarning, counted, warn
from .cells import SOLIDS, Cell

CHUNK = 4096  # cells treated at once, so that memory stays bounded
ALONG, ACROSS = 0.25, 0.5  # of the length of an edge: how far its node may lie from the middle
MISTAKEN, MATCHED = 0.2, 0.1  # of an edge: from its middle, and from that of another one
MOST = 100  # cells in which nodes are compared with all edges
THIN = 1e-7  # the same of a cell that is nearly flat
FLAT = 1e-9  # volume in the cube of the longest edge below which a cell has none
ROUNDING = 1e-6


def check_edges(source: str, kind: str, points: Array, cells: Integers) -> None:
    """Check that nodes between corners lie near the middle of their edges.

    Raises:
        ModelError: one lies on another edge, or so far off that the cell folds over.
    """
    cell = SOLIDS[kind]
    if not cell.edges:
        return
    ends = np.array(cell.edges)
    start, end = points[cells[:, ends[:, 0]]], points[cells[:, ends[:, 1]]]
    edge = end - start
    squared = (edge**2).sum(axis=2)
    offset = points[cells[:, cell.corners :]] - (start + end) / 2
    # what is no edge at all is folded, and found as such
    squared[squared == 0] = np.inf
    along = (offset * edge).sum(axis=2) / squared
    across = np.sqrt(((offset - along[:, :, None] * edge) ** 2).sum(axis=2) / squared)
    far = np.hypot(along, across)

    def place(row: int, k: int) -> str:
        node, (a, b) = cells[row, cell.corners + k], cells[row, ends[k]]
        who = f"{source}: cell {row} of {kind}: node {node}"
        return f"{who}, the middle of nodes {a} and {b}, lies"

    # nodes in another order: at least two of a cell lie far off, in the middle of other edges
    for row in np.flatnonzero((far > MISTAKEN).sum(axis=1) > 1)[:MOST]:
        for k in np.flatnonzero(far[row] > MISTAKEN):
            other = _edge_of(points, cells[row], cell, points[cells[row, cell.corners + k]])
            if other is not None:
                c, d = cells[row, ends[other]]
                raise ModelError(
                    f"{place(int(row), int(k))} between nodes {c} and {d}: the nodes of "
                    f"its edges are in another order than in VTK, which is {_order(cell)}"
                )
    bad = np.argwhere((np.abs(along) > ALONG + ROUNDING) | (across > ACROSS + ROUNDING))
    if not len(bad):
        return
    row, k = bad[0]
    raise ModelError(
        f"{place(row, k)} {far[row, k]:.2g} edge lengths from there ("
        f"{counted(len(bad), 'node')} in all lie that far off): the cell folds over beyond 1/4 "
        "along the edge. Mesh again, with straight edges or smaller cells where it is curved"
    )


def _edge_of(points: Array, nodes: Integers, cell: Cell, place: Array) -> int | None:
    """The edge of a cell in whose middle a place lies."""
    for k, (a, b) in enumerate(cell.edges):
        start, end = points[nodes[a]], points[nodes[b]]
        if np.linalg.norm(place - (start + end) / 2) < MATCHED * np.linalg.norm(end - start):
            return k
    return None


def _order(cell: Cell) -> str:
    """The edges of a kind in words, corners numbered from 0."""
    return ", ".join(f"{a}-{b}" for a, b in cell.edges)


def volumes(cell: Cell, points: Array, cells: Integers, at: Array) -> Array:
    """Volume per reference volume (cells, places) at places of the reference cell."""
    slope = cell.slope(at)
    result = np.empty((len(cells), len(at)))
    for start in range(0, len(cells), CHUNK):
        rows = slice(start, start + CHUNK)
        maps = np.einsum("car,pak->cprk", points[cells[rows]], slope, optimize=True)
        result[rows] = np.linalg.det(maps)
    return result


def check_folds(source: str, kind: str, points: Array, cells: Integers) -> None:
    """Check that cells are mapped one to one, by the sign of the volume.

    Raises:
        ModelError: a cell is inside out, flat, or folds over where it is integrated.
    """
    cell = SOLIDS[kind]
    nodes = np.array(cell.nodes, float)
    places = np.concatenate([cell.stiffness.points, cell.mass.points, cell.stress.points, nodes])
    volume = volumes(cell, points, cells, places)
    box = np.ptp(points[cells[:, : cell.corners]], axis=1).max(axis=1)
    relative = volume / np.maximum(box, np.finfo(float).tiny)[:, None] ** 3
    inner = relative[:, : -len(nodes)]
    bad = np.flatnonzero((inner <= FLAT).any(axis=1))
    if len(bad):
        row = int(bad[0])
        who = f"{source}: cell {row} of {kind} (nodes {', '.join(map(str, cells[row]))})"
        raise ModelError(f"{who} {_fault(inner[row], inner, len(bad), cell)}")
    thin = np.flatnonzero((inner <= THIN).any(axis=1))
    if len(thin):
        warn(
            f"{source}: {counted(len(thin), 'cell')} of {kind} are nearly flat, the first of them "
            f"number {thin[0]} with nodes {', '.join(map(str, cells[thin[0]]))}: matrices lose "
            "digits. Mesh the place again, or merge nodes",
            ModelWarning,
        )
    sharp = np.flatnonzero((relative < -ROUNDING).any(axis=1))
    if len(sharp):
        warn(
            f"{source}: {counted(len(sharp), 'cell')} of {kind}, the first of them number "
            f"{sharp[0]}, fold over at a node, outside of the points of quadrature: results "
            "near them are poor. Smaller cells where the surface is curved are the cure",
            ModelWarning,
        )


def _fault(values: Array, every: Array, count: int, cell: Cell) -> str:
    """What is wrong with a cell, and the cure."""
    also = f" ({counted(count, 'cell')} in all)"
    if np.abs(values).max() <= FLAT:
        return f"is flat{also}: its nodes lie in a plane; leave it out, or merge its nodes"
    if (values < 0).all():
        if len(every) > 1 and (every < 0).all():
            return (
                f"is inside out, as all {len(every)} of its kind: nodes are numbered in the order "
                "of a left-handed program, or coordinates were mirrored. Mirror them back"
            )
        return (
            f"is inside out{also}: number its nodes the other way round, so that its first face, "
            "seen from inside the cell, runs counterclockwise"
        )
    order = (
        "bottom and top face, each around" if cell.corners == 8 else "any, the first face around"
    )
    return (
        f"folds over{also}: corners are in another order than that of VTK ({order}), or it is too "
        "distorted: mesh again"
    )
