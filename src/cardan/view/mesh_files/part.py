"""Triangles of one color, checked, with equal vertices merged."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...errors import ModelError
from ...records import dataclass

MOST_TRIANGLES = 1_000_000  # of one file
LARGEST_POSITION = 1e6

Color = tuple[float, float, float]
Triangles = NDArray[np.uint32]


@dataclass(frozen=True)
class Part:
    """Triangles of one color.

    Attributes:
        vertices: Positions (n, 3), in the axes and unit of the file; all different.
        triangles: Rows of vertices (m, 3), counterclockwise seen from outside.
        color: Red, green, blue in 0 ... 1; None where the file gives none.
    """

    vertices: NDArray[np.float32]
    triangles: Triangles
    color: Color | None = None


def merged(points: ArrayLike, triangles: ArrayLike, color: Color | None = None) -> Part:
    """A part out of points (n, 3) and rows of them (m, 3): used points only, equal ones once.

    Triangles with two equal corners are left out.

    Raises:
        ModelError: a row that is none, a position that is not finite or too large, or too many
            triangles.
    """
    rows = np.asarray(triangles, dtype=np.int64).reshape(-1, 3)
    positions = np.asarray(points, dtype=np.float64).reshape(-1, 3)
    if len(rows) > MOST_TRIANGLES:
        raise ModelError(f"{len(rows)} triangles; at most {MOST_TRIANGLES} are read")
    if rows.size and not (rows.min() >= 0 and rows.max() < len(positions)):
        raise ModelError(f"a triangle names a vertex that is none of the {len(positions)}")
    if not np.all(np.abs(positions[rows]) <= LARGEST_POSITION):
        raise ModelError(f"a vertex is not finite, or farther than {LARGEST_POSITION:g} away")
    # minus zero is zero
    corners = positions[rows.ravel()].astype(np.float32) + np.float32(0)
    x, y, z = corners.view(np.uint32).astype(np.uint64).T
    _, xy = np.unique(x << 32 | y, return_inverse=True)
    keys = xy.astype(np.uint64) << 32 | z
    _, first, numbers = np.unique(keys, return_index=True, return_inverse=True)
    return compact(corners[first], numbers.reshape(-1, 3), color)


def compact(
    vertices: NDArray[np.float32], triangles: NDArray[np.intp], color: Color | None
) -> Part:
    """A part without triangles that have two equal corners, and without unused vertices."""
    a, b, c = triangles.T
    rows = triangles[(a != b) & (b != c) & (c != a)]
    used, numbers = np.unique(rows, return_inverse=True)
    return Part(vertices[used], numbers.reshape(-1, 3).astype(np.uint32), color)


def rgb(numbers: Sequence[float]) -> Color | None:
    """A color out of its first three numbers; None if they are not in 0 ... 1."""
    if len(numbers) < 3 or not all(0 <= one <= 1 for one in numbers[:3]):
        return None
    return float(numbers[0]), float(numbers[1]), float(numbers[2])
