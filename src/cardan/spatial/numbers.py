"""Rotations in plain numbers, as files of scenes have them; quarter turns are exact."""

from __future__ import annotations

import math
from collections.abc import Sequence

from ..errors import ModelError, brief

Rows = list[list[float]]
Vector = tuple[float, float, float]
UPRIGHT: Rows = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
QUARTER = math.pi / 2


def check_axes(axes: str, who: str) -> None:
    """A sequence of axes in SciPy's case rule.

    Raises:
        ModelError: not three letters of one case.
    """
    if len(axes) != 3 or axes.lower().strip("xyz") or not (axes.islower() or axes.isupper()):
        raise ModelError(
            f"'{who}': a sequence is three letters of XYZ (body-fixed) or xyz (fixed axes), "
            f"not {brief(axes)}"
        )


def of_sequence(axes: str, angles: Sequence[float]) -> Rows:
    """R (3, 3) of three turns: "XYZ" about body-fixed axes, "xyz" about fixed ones [rad].

    Quarter turns are exact.
    """
    turns = [_about(axis, angle) for axis, angle in zip(axes.lower(), angles, strict=True)]
    if axes.islower():
        turns.reverse()
    return product(product(turns[0], turns[1]), turns[2])


def _about(axis: str, angle: float) -> Rows:
    c, s = cosine_sine(angle)
    i = "xyz".index(axis)
    j, k = (i + 1) % 3, (i + 2) % 3
    rows = [[0.0] * 3 for _ in range(3)]
    rows[i][i], rows[j][j], rows[k][k] = 1.0, c, c
    rows[j][k], rows[k][j] = -s, s
    return rows


def cosine_sine(angle: float) -> tuple[float, float]:
    """Cosine and sine; exact at the doubles next to multiples of a quarter turn."""
    turns = quarter_turns(angle)
    if turns is not None:
        return ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[turns % 4]
    return math.cos(angle), math.sin(angle)


def quarter_turns(angle: float) -> int | None:
    """Number of quarter turns of an angle, None where it is not an integer."""
    turns = round(angle / QUARTER)
    # two roundings: that of the constant and that of the product
    return turns if abs(angle - turns * QUARTER) <= 4e-16 * abs(angle) else None


def product(a: Rows, b: Rows) -> Rows:
    """Product of two 3x3 matrices."""
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def check_orthonormal(rows: Rows, who: str) -> None:
    """The rows are those of a rotation, to 1e-6.

    Raises:
        ModelError: they are not.
    """
    for i in range(3):
        for j in range(3):
            product = sum(rows[i][k] * rows[j][k] for k in range(3))
            if not abs(product - (i == j)) < 1e-6:
                raise ModelError(
                    f"'{who}': not a rotation: rows {i + 1} and {j + 1} have the product "
                    f"{product:g}"
                )
    (a, b, c), (d, e, f), (g, h, k) = rows
    if a * (e * k - f * h) - b * (d * k - f * g) + c * (d * h - e * g) < 0:
        raise ModelError(f"'{who}': a reflection, not a rotation: its determinant is -1")


def roll_pitch_yaw(rows: Rows) -> tuple[float, float, float]:
    """Angles of R = Rz(yaw) Ry(pitch) Rx(roll)."""
    across = math.hypot(rows[0][0], rows[1][0])
    pitch = math.atan2(-rows[2][0], across)
    if across < 1e-9:
        # gimbal lock: only a combination of roll and yaw counts
        return math.atan2(-rows[1][2], rows[1][1]), pitch, 0.0
    return math.atan2(rows[2][1], rows[2][2]), pitch, math.atan2(rows[1][0], rows[0][0])


def congruent(rotation: Rows, tensor: Rows) -> Rows:
    """R T R^T: a tensor of inertia in other axes."""
    return product(product(rotation, tensor), transposed(rotation))


def rotated(rotation: Rows, vector: Sequence[float]) -> Vector:
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
    largest_row = rows[max(range(4), key=squares.__getitem__)]
    size = math.hypot(*largest_row) * (1 if largest_row[0] >= 0 else -1)
    w, x, y, z = (entry / size for entry in largest_row)
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
