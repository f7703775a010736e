"""Triangles between fewer points, which stand for those around them.

Points are gathered in the cells of a grid, and each cell has one.

Source: P. Lindstrom, Out-of-core simplification of large polygonal models, SIGGRAPH 2000.
"""

from __future__ import annotations

import numpy as np

from ..arrays import Array, Integers

BISECTIONS, FINEST = 16, 2**20  # cells along the longest edge of the box, at most


def coarsened(vertices: Array, rows: Integers, triangles: int) -> Integers:
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
    cells = cells_of(points, edge_of(points, local, triangles))
    size = np.bincount(cells)
    mean = np.stack([np.bincount(cells, x) for x in points.T], axis=1) / size[:, None]
    # of each cell the vertex that is nearest to their mean
    order = np.lexsort((np.linalg.norm(points - mean[cells], axis=1), cells))
    nearest = used[order[np.cumsum(size) - size]]
    chosen: Integers = nearest[unique_triangles(cells[local])]
    return chosen


def edge_of(points: Array, rows: Integers, triangles: int) -> float:
    """Edge of the smallest cells that leave few enough triangles."""
    # the number of triangles rises with that of cells, but for small steps; it begins with none
    coarse, fine = -2.0, float(np.log2(FINEST))
    for _ in range(BISECTIONS):
        middle = (coarse + fine) / 2
        count = len(unique_triangles(cells_of(points, 2**-middle)[rows]))
        coarse, fine = (middle, fine) if count <= triangles else (coarse, middle)
    return float(2**-coarse)


def cells_of(points: Array, edge: float) -> Integers:
    """Number of the cell of every point, those without points not counted."""
    x, y, z = np.floor(points / edge + 0.5).astype(np.int64).T
    keys = (x * (2 * FINEST) + y) * (2 * FINEST) + z
    numbers: Integers = np.unique(keys, return_inverse=True)[1]
    return numbers


def unique_triangles(rows: Integers) -> Integers:
    """Triangles with three different corners, each once; which corner is first does not matter."""
    a, b, c = rows.T
    rows = rows[(a != b) & (b != c) & (c != a)]
    order = (rows.argmin(axis=1)[:, None] + np.arange(3)) % 3
    a, b, c = np.take_along_axis(rows, order, axis=1).T
    count = int(rows.max(initial=0)) + 1
    pairs: Integers = np.unique(a * count + b, return_inverse=True)[1]
    first: Integers = np.unique(pairs * count + c, return_index=True)[1]
    return np.stack([a[first], b[first], c[first]], axis=1)
