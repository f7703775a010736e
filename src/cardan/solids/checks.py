"""Checks of meshes that somebody else made: each message names node or cell, and the cure."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..arrays import Array, Integers
from ..errors import ModelError, brief, counted, near
from ..superelements.values import numbers as given_numbers
from .cells import CELLS
from .connectivity import check_parts
from .distortion import check_edges, check_folds

FARTHEST = 1e30  # so that volumes do not overflow
LARGEST = 1 << 28  # nodes and cells: node numbers are 32-bit in C, dofs as well
SAME_PLACE = 1e-6  # of the usual distance between nodes


def checked_points(source: str, points: ArrayLike, scale: float | None) -> Array:
    """Positions (nodes, 3) [m].

    Raises:
        ModelError: another shape, or numbers that are not finite.
    """
    positions = given_numbers(f"{source}: points", points)
    if positions.ndim != 2 or positions.shape[1] != 3 or not len(positions):
        raise ModelError(f"{source}: points have the shape {positions.shape}, expected (nodes, 3)")
    if len(positions) > LARGEST:
        raise ModelError(f"{source}: {len(positions)} nodes, at most {LARGEST} are treated")
    bad = np.flatnonzero(~(np.abs(positions) < FARTHEST).all(axis=1))
    if len(bad):
        raise ModelError(
            f"{source}: node {bad[0]} lies at {positions[bad[0]].tolist()}"
            f"{_more(len(bad), 'node')}: give finite coordinates below {FARTHEST:g}"
        )
    if scale is not None:
        unit = given_numbers(f"{source}: scale", scale)
        if unit.ndim or not 0 < unit < np.inf:
            raise ModelError(
                f"{source}: scale={brief(scale)}: give the length of a unit [m], above 0"
            )
    return np.ascontiguousarray(positions * (1.0 if scale is None else scale))


def checked_cells(
    source: str, cells: Mapping[str, ArrayLike], nodes: int, dimension: int = 3
) -> dict[str, Integers]:
    """Nodes of cells by kind, in the order of the kinds given; empty kinds are left out.

    Args:
        source: What messages call the mesh.
        cells: Nodes of the cells by kind, by its name here or in meshio.
        nodes: How many nodes there are.
        dimension: 3 for solids, 2 for faces.

    Raises:
        ModelError: unknown kinds, wrong shapes, nodes that do not exist or are there twice.
    """
    kinds = {
        name: cell
        for cell in CELLS.values()
        if cell.dimension == dimension
        for name in (cell.kind, cell.meshio)
    }
    result: dict[str, Integers] = {}
    if not isinstance(cells, Mapping):
        raise ModelError(f"{source}: cells={brief(cells)}: give nodes of cells by kind")
    for kind, entries in cells.items():
        if kind not in kinds:
            names = [cell.kind for cell in CELLS.values() if cell.dimension == dimension]
            raise ModelError(
                f"{source}: there is no kind of cells {brief(kind)}.{near(kind, names)}"
            )
        cell = kinds[kind]
        array = _numbers(f"{source}: {kind}", entries, len(cell.nodes))
        if not len(array):
            continue
        _check_numbers(f"{source}: cell {{}} of {kind}", array, nodes)
        if cell.kind in result:
            raise ModelError(f"{source}: {cell.kind} is there twice, also as {brief(kind)}")
        result[cell.kind] = array
    if not result:
        raise ModelError(f"{source}: it has no cells of a kind that is treated: {', '.join(kinds)}")
    return result


def _numbers(who: str, entries: ArrayLike, width: int) -> Integers:
    try:
        array = np.array(entries)
    except ValueError:
        array = np.zeros(0)
    if not array.size:
        return np.zeros((0, width), np.intp)
    if array.ndim != 2 or array.shape[1] != width or not np.issubdtype(array.dtype, np.integer):
        raise ModelError(
            f"{who}: an array of {array.dtype} of shape {array.shape}, expected node numbers "
            f"(cells, {width})"
        )
    if len(array) > LARGEST:
        raise ModelError(f"{who}: {len(array)} cells, at most {LARGEST} are treated")
    # not yet as integers of this machine: unsigned ones could wrap around
    return array if array.dtype == np.intp else _as_integers(who, array)


def _as_integers(who: str, array: NDArray[np.integer]) -> Integers:
    if array.max() > LARGEST or array.min() < 0:
        wrong = array.max() if array.min() >= 0 else array.min()
        raise ModelError(f"{who}: there is no node {wrong}")
    return np.ascontiguousarray(array, dtype=np.intp)


def _check_numbers(who: str, cells: Integers, nodes: int) -> None:
    """Every node exists, no cell has one twice, and no two cells have the same nodes."""
    bad = np.argwhere((cells < 0) | (cells >= nodes))
    if len(bad):
        row, column = bad[0]
        raise ModelError(
            f"{who.format(row)}: there is no node {cells[row, column]}; nodes are numbered 0 to "
            f"{nodes - 1}"
        )
    ordered = np.sort(cells, axis=1)
    twice = np.argwhere(ordered[:, 1:] == ordered[:, :-1])
    if len(twice):
        row, column = twice[0]
        raise ModelError(
            f"{who.format(row)} has node {ordered[row, column]} twice{_more(len(twice), 'cell')}: "
            "collapsed cells are not treated; mesh the place with tetrahedra"
        )
    _, first, count = np.unique(ordered, axis=0, return_index=True, return_counts=True)
    if (count > 1).any():
        row = int(first[count > 1].min())
        again = np.flatnonzero((ordered == ordered[row]).all(axis=1))
        raise ModelError(
            f"{who.format(row)} is there again as number {again[1]}, with the same nodes: leave "
            "out one of them"
        )


def _more(count: int, noun: str) -> str:
    """The number of others with the same fault."""
    return f" (and {counted(count - 1, 'more ' + noun)})" if count > 1 else ""


def checked_shapes(source: str, points: Array, cells: Mapping[str, Integers], parts: int) -> None:
    """Check positions against cells.

    Raises:
        ModelError: unused nodes, nodes in one place, folded cells, unconnected parts.
    """
    used = np.zeros(len(points), bool)
    for members in cells.values():
        used[members] = True
    unused = np.flatnonzero(~used)
    if len(unused):
        raise ModelError(
            f"{source}: no cell has node {unused[0]}{_more(len(unused), 'node')}, so nothing "
            "holds it: leave it out"
        )
    _check_places(source, points)
    for kind, members in cells.items():
        check_edges(source, kind, points, members)
        check_folds(source, kind, points, members)
    check_parts(source, points, cells, parts)


def spacing(points: Array) -> float:
    """The usual distance between nodes, roughly [m]."""
    return float(np.linalg.norm(np.ptp(points, axis=0)) / len(points) ** (1 / 3))


def _check_places(source: str, points: Array) -> None:
    """No two nodes lie in one place."""
    if len(points) < 2:
        return
    first, second, distance = closest(points)
    if distance <= SAME_PLACE * spacing(points):
        x, y, z = points[first]
        raise ModelError(
            f"{source}: nodes {first} and {second} lie in one place, ({x:.6g}, {y:.6g}, {z:.6g}): "
            "cells that should share a node do not. Give read() merge=, the distance below which "
            "nodes become one [m]"
        )


def closest(points: Array) -> tuple[int, int, float]:
    """Two nodes that are nearest to each other, and their distance [m]."""
    from scipy.spatial import cKDTree

    # nodes at exactly one place first: a tree of many of them is slow
    _, inverse, count = np.unique(points, axis=0, return_inverse=True, return_counts=True)
    if (count > 1).any():
        group = np.flatnonzero(inverse.ravel() == np.flatnonzero(count > 1)[0])
        return int(group[0]), int(group[1]), 0.0
    distance, neighbor = cKDTree(points).query(points, k=2)
    k = int(np.argmin(distance[:, 1]))
    pair = sorted((k, int(neighbor[k, 1])))
    return pair[0], pair[1], float(distance[k, 1])
