"""Fewer triangles for nearly the same picture.

Vertices are gathered in the cells of a grid, and each cell keeps one: the point that is nearest
to the planes of all triangles around it, so that edges and corners stay sharp.

Source: P. Lindstrom, Out-of-core simplification of large polygonal models, SIGGRAPH 2000.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array
from .mesh_files.part import Part, compact

BISECTIONS, FINEST = 16, 2**20  # cells along the longest edge of the box, at most
RANK = 1e-3  # a plane direction below this share of the largest eigenvalue leaves a point free


def reduced(part: Part, triangles: int) -> Part:
    """A part with at most so many triangles.

    Args:
        part: The part; it is returned as it is if it is small enough.
        triangles: Largest number of them.

    Returns:
        The part on the finest grid that leaves few enough; a handful may leave none.
    """
    if len(part.triangles) <= triangles:
        return part
    low = part.vertices.min(axis=0).astype(np.float64)
    span = float((part.vertices - low).max())
    points, rows = (part.vertices - low) / span, part.triangles.astype(np.intp)
    edge = _edge(points, rows, triangles)
    cells = _cells(points, edge)
    vertices = span * _representatives(points, rows, cells, edge) + low
    return compact(vertices.astype(np.float32), _unique_triangles(cells[rows]), part.color)


def coarsened(vertices: Array, rows: NDArray[np.intp], triangles: int) -> NDArray[np.intp]:
    """At most so many triangles between some of the vertices, which all stay where they are.

    Args:
        vertices: Positions (n, 3).
        rows: Triangles (m, 3).
        triangles: Largest number of them.

    Returns:
        Triangles (k, 3) between vertices, those given if they are few enough.
    """
    if len(rows) <= triangles:
        return rows
    used = np.unique(rows)
    low = vertices[used].min(axis=0)
    points = (vertices[used] - low) / float((vertices[used] - low).max())
    local = np.searchsorted(used, rows)
    cells = _cells(points, _edge(points, local, triangles))
    size = np.bincount(cells)
    mean = np.stack([np.bincount(cells, x) for x in points.T], axis=1) / size[:, None]
    # of each cell the vertex that is nearest to their mean
    order = np.lexsort((np.linalg.norm(points - mean[cells], axis=1), cells))
    nearest = used[order[np.cumsum(size) - size]]
    chosen: NDArray[np.intp] = nearest[_unique_triangles(cells[local])]
    return chosen


def _edge(points: Array, rows: NDArray[np.intp], triangles: int) -> float:
    """Edge of the smallest cells that leave few enough triangles."""
    # the number of triangles rises with that of cells, but for small steps; it begins with none
    coarse, fine = -2.0, float(np.log2(FINEST))
    for _ in range(BISECTIONS):
        middle = (coarse + fine) / 2
        count = len(_unique_triangles(_cells(points, 2**-middle)[rows]))
        coarse, fine = (middle, fine) if count <= triangles else (coarse, middle)
    return float(2**-coarse)


def _cells(points: Array, edge: float) -> NDArray[np.intp]:
    """Number of the cell of every point, those without points not counted."""
    x, y, z = np.floor(points / edge + 0.5).astype(np.int64).T
    keys = (x * (2 * FINEST) + y) * (2 * FINEST) + z
    numbers: NDArray[np.intp] = np.unique(keys, return_inverse=True)[1]
    return numbers


def _unique_triangles(rows: NDArray[np.intp]) -> NDArray[np.intp]:
    """Triangles with three different corners, each once; which corner is first does not matter."""
    a, b, c = rows.T
    rows = rows[(a != b) & (b != c) & (c != a)]
    order = (rows.argmin(axis=1)[:, None] + np.arange(3)) % 3
    a, b, c = np.take_along_axis(rows, order, axis=1).T
    count = int(rows.max(initial=0)) + 1
    pairs: NDArray[np.intp] = np.unique(a * count + b, return_inverse=True)[1]
    first: NDArray[np.intp] = np.unique(pairs * count + c, return_index=True)[1]
    return np.stack([a[first], b[first], c[first]], axis=1)


def _representatives(
    points: Array, rows: NDArray[np.intp], cells: NDArray[np.intp], edge: float
) -> Array:
    """The point of every cell (k, 3): least squared distance to the planes of its triangles."""
    count = int(cells.max()) + 1
    size = np.bincount(cells, minlength=count)
    sums = [np.bincount(cells, points[:, i], count) for i in range(3)]
    mean: Array = np.stack(sums, axis=1) / size[:, None]
    # sums over the planes at a cell: n n^T, and n times the distance from the mean
    matrix, moment = np.zeros((count, 3, 3)), np.zeros((count, 3))
    for corners, normal in _planes(points, rows):
        for corner in corners.T:
            cell = cells[corner]
            distance = np.einsum("ij,ij->i", normal, points[corner] - mean[cell])
            for i in range(3):
                moment[:, i] += np.bincount(cell, normal[:, i] * distance, count)
                for j in range(i + 1):
                    matrix[:, i, j] += np.bincount(cell, normal[:, i] * normal[:, j], count)
    values, vectors = np.linalg.eigh(matrix)
    inverse = np.where(values > RANK * values[:, -1:], 1 / np.where(values > 0, values, 1), 0)
    step = np.einsum("kij,kj,klj,kl->ki", vectors, inverse, vectors, moment)
    return np.asarray(mean + np.clip(step, -edge, edge))


def _planes(points: Array, rows: NDArray[np.intp]) -> Iterator[tuple[NDArray[np.intp], Array]]:
    """Corners, and normals (m, 3) as long as areas: of triangles, then across open edges."""
    a, b, c = points[rows[:, 0]], points[rows[:, 1]], points[rows[:, 2]]
    normal = np.cross(b - a, c - a)
    yield rows, normal
    edges = np.concatenate([rows[:, [0, 1]], rows[:, [1, 2]], rows[:, [2, 0]]])
    ends = np.sort(edges, axis=1)
    keys = ends[:, 0] * len(points) + ends[:, 1]
    _, first, uses = np.unique(keys, return_index=True, return_counts=True)
    open_ = first[uses == 1]
    along = points[edges[open_, 1]] - points[edges[open_, 0]]
    flat = normal[open_ % len(rows)]
    length = np.linalg.norm(flat, axis=1, keepdims=True)
    across = np.cross(along, flat / np.where(length > 0, length, 1))
    yield edges[open_], across * np.linalg.norm(along, axis=1, keepdims=True)
