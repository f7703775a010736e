"""Poses in plain numbers: how the parts of a file stand to each other."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from ..rotation import Rows, cosine_sine, product, roll_pitch_yaw
from .angles import RESIDUE

UPRIGHT: Rows = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
Vector = tuple[float, float, float]


@dataclass(frozen=True)
class Pose:
    """A frame seen from another.

    Attributes:
        rotation: Its axes to those of the other, rows of R (3, 3).
        position: Its origin in axes of the other (3) [m].
    """

    rotation: Rows
    position: Vector

    def then(self, inner: Pose) -> Pose:
        """A frame that is seen from this one, seen from the other."""
        return Pose(product(self.rotation, inner.rotation), self.point(inner.position))

    def point(self, point: Sequence[float]) -> Vector:
        """A point of this frame, seen from the other."""
        moved = turned(self.rotation, point)
        x, y, z = (a + b for a, b in zip(self.position, moved, strict=True))
        return x, y, z

    def inverse(self) -> Pose:
        """The other frame seen from this one."""
        back = transposed(self.rotation)
        x, y, z = (-entry for entry in turned(back, self.position))
        return Pose(back, (x, y, z))


HERE = Pose(UPRIGHT, (0.0, 0.0, 0.0))


def turned(rotation: Rows, vector: Sequence[float]) -> Vector:
    """R v."""
    x, y, z = (sum(a * b for a, b in zip(row, vector, strict=True)) for row in rotation)
    return x, y, z


def transposed(rotation: Rows) -> Rows:
    """R^T."""
    return [list(column) for column in zip(*rotation, strict=True)]


def of_quaternion(w: float, x: float, y: float, z: float) -> Rows:
    """R of a quaternion of any length; equal entries give exact quarter turns."""
    n = w * w + x * x + y * y + z * z
    xx, yy, zz, ww = x * x, y * y, z * z, w * w
    return [
        [(ww + xx - yy - zz) / n, 2 * (x * y - w * z) / n, 2 * (x * z + w * y) / n],
        [2 * (x * y + w * z) / n, (ww - xx + yy - zz) / n, 2 * (y * z - w * x) / n],
        [2 * (x * z - w * y) / n, 2 * (y * z + w * x) / n, (ww - xx - yy + zz) / n],
    ]


def to_quaternion(rotation: Rows) -> tuple[float, float, float, float]:
    """The unit quaternion of R, its scalar not negative; from the largest entry."""
    r = rotation
    squares = (
        1 + r[0][0] + r[1][1] + r[2][2],
        1 + r[0][0] - r[1][1] - r[2][2],
        1 - r[0][0] + r[1][1] - r[2][2],
        1 - r[0][0] - r[1][1] + r[2][2],
    )
    w, x, y, z = r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1], 0.0
    a, b, c = r[0][1] + r[1][0], r[0][2] + r[2][0], r[1][2] + r[2][1]
    table = ((squares[0], w, x, y), (w, squares[1], a, b), (x, a, squares[2], c))
    rows = (*table, (y, b, c, squares[3]))
    found = rows[max(range(4), key=squares.__getitem__)]
    size = math.hypot(*found) * (1 if found[0] >= 0 else -1)
    w, x, y, z = (entry / size for entry in found)
    return w, x, y, z


def about(axis: Sequence[float], angle: float) -> Rows:
    """R of a turn about a unit vector; quarter turns are exact."""
    c, s = cosine_sine(angle)
    x, y, z = axis
    d = 1 - c
    return [
        [c + x * x * d, x * y * d - z * s, x * z * d + y * s],
        [x * y * d + z * s, c + y * y * d, y * z * d - x * s],
        [x * z * d - y * s, y * z * d + x * s, c + z * z * d],
    ]


def upright_to(direction: Sequence[float]) -> Rows:
    """The smallest turn that takes z to a direction."""
    x, y, z = unit(direction)
    across = math.hypot(x, y)
    # a smaller turn is lost in doubles, and its axis in what lies below them
    if across < 1e-30:
        return UPRIGHT if z > 0 else about((1.0, 0.0, 0.0), math.pi)
    return about((-y / across, x / across, 0.0), math.atan2(across, z))


def unit(vector: Sequence[float]) -> Vector:
    """A vector of length 1; one along an axis is exact."""
    length = math.hypot(*vector)
    x, y, z = (entry / length for entry in vector)
    return x, y, z


def written(rotation: Rows) -> Any:
    """A rotation as bodies and frames take it: ("xyz", roll, pitch, yaw), None for none."""
    angles = [0.0 if abs(a) <= 4 * RESIDUE else a for a in roll_pitch_yaw(rotation)]
    return ("xyz", *angles) if any(angles) else None
