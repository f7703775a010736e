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
from ..superelements.coarsening import cells_of, edge_of, unique_triangles
from .mesh_files.part import Part, compact

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
    edge = edge_of(points, rows, triangles)
    cells = cells_of(points, edge)
    vertices = span * _representatives(points, rows, cells, edge) + low
    return compact(vertices.astype(np.float32), unique_triangles(cells[rows]), part.color)


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
