"""Rotations in plain numbers."""

from __future__ import annotations

import math
from collections.abc import Sequence

from ..errors import ModelError, shown

Rows = list[list[float]]
QUARTER = math.pi / 2


def check_axes(axes: str, who: str) -> None:
    """A sequence of axes in SciPy's case rule.

    Raises:
        ModelError: not three letters of one case.
    """
    if len(axes) != 3 or axes.lower().strip("xyz") or not (axes.islower() or axes.isupper()):
        raise ModelError(
            f"'{who}': a sequence is three letters of XYZ (body-fixed) or xyz (fixed axes), "
            f"not {shown(axes)}"
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
    """How many quarter turns an angle is, None where it is no whole number of them."""
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
            found = sum(rows[i][k] * rows[j][k] for k in range(3))
            if not abs(found - (i == j)) < 1e-6:
                raise ModelError(
                    f"'{who}': not a rotation: rows {i + 1} and {j + 1} have the product {found:g}"
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
