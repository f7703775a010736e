"""Rotation vectors and rotation matrices: exponential, its tangent, logarithm, quaternions.

Unit quaternions are (w, x, y, z), scalar first. Nothing here is singular at the identity.
"""

from __future__ import annotations

from ..ir.arithmetic import Scalar, atan2, select, sqrt, stumpff
from ..ir.matrix import Matrix

# asin(s)/s as a polynomial in s², for s² below SMALL to double precision
ARCSINE_SERIES = (1.0, 1 / 6, 3 / 40, 15 / 336, 105 / 3456, 945 / 42240, 10395 / 599040)
SMALL = 1e-3


def exp(vector: Matrix) -> Matrix:
    """R = 1 + c_1 [v] + c_2 [v]², (3, 3), of a rotation vector v [rad]."""
    x = vector.dot(vector)
    skew = vector.skew
    square = vector.outer(vector) - Matrix.identity(vector.graph, 3) * x
    return Matrix.identity(vector.graph, 3) + skew * stumpff(1, x) + square * stumpff(2, x)


def tangent(vector: Matrix) -> Matrix:
    """T = 1 - c_2 [v] + c_3 [v]², (3, 3): omega = T(v) vdot in the turned axes.

    In the fixed axes the same holds with the transpose.

    Args:
        vector: Rotation vector v [rad], (3, 1).

    Source: Géradin and Cardona, Flexible Multibody Dynamics (2001), section 4.6.
    """
    x, identity = vector.dot(vector), Matrix.identity(vector.graph, 3)
    square = vector.outer(vector) - identity * x
    return identity + vector.skew * -stumpff(2, x) + square * stumpff(3, x)


def exp_quaternion(vector: Matrix) -> Matrix:
    """Unit quaternion (4, 1) of a rotation vector [rad]."""
    x = vector.dot(vector) / 4.0
    half = vector * (stumpff(1, x) / 2.0)
    return Matrix.vector(vector.graph, [stumpff(0, x), *half])


def log_quaternion(quaternion: Matrix) -> Matrix:
    """Rotation vector of length at most pi of a unit quaternion of either sign."""
    w, x, y, z = quaternion
    v = Matrix.vector(quaternion.graph, [x, y, z])
    square = v.dot(v)
    small = square.apply("lt", SMALL)
    # near the identity asin(s)/s by its series, elsewhere atan2 of a sine that is not 0
    s = sqrt(select(small, 1.0, square))
    general = atan2(s, w.apply("abs")) / s
    factor = 2.0 * select(small, _series(square), general)
    return v * select(w.apply("lt", 0.0), -factor, factor)


def log(R: Matrix) -> Matrix:
    """Rotation vector (3, 1) of length at most pi, of a rotation matrix."""
    return log_quaternion(quaternion_of(R))


def quaternion_of(R: Matrix) -> Matrix:
    """Unit quaternion with w >= 0 of a rotation matrix, accurate for every rotation.

    Source: S. W. Shepperd, Quaternion from Rotation Matrix, J. Guidance and Control 1 (1978).
    """
    a, b, c = R[0, 0], R[1, 1], R[2, 2]
    # four columns, each the quaternion times four of its own components: take the longest
    squares = [1 + (a + b + c), 1 + (a - b - c), 1 + (b - a - c), 1 + (c - a - b)]
    wx, wy, wz = R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]
    xy, xz, yz = R[0, 1] + R[1, 0], R[0, 2] + R[2, 0], R[1, 2] + R[2, 1]
    columns = [
        [squares[0], wx, wy, wz],
        [wx, squares[1], xy, xz],
        [wy, xy, squares[2], yz],
        [wz, xz, yz, squares[3]],
    ]
    largest, best = squares[0], columns[0]
    for square, column in zip(squares[1:], columns[1:], strict=True):
        better = largest.apply("lt", square)
        best = [select(better, new, old) for new, old in zip(column, best, strict=True)]
        largest = select(better, square, largest)
    length = 2.0 * sqrt(largest)
    factor = select(best[0].apply("lt", 0.0), -1.0 / length, 1.0 / length)
    return Matrix.vector(R.graph, best) * factor


def multiply(p: Matrix, q: Matrix) -> Matrix:
    """The quaternion product p q: first q, then p, seen in fixed axes."""
    a, b, c, d = p
    w, x, y, z = q
    return Matrix.vector(
        p.graph,
        [
            a * w - b * x - c * y - d * z,
            a * x + b * w + c * z - d * y,
            a * y - b * z + c * w + d * x,
            a * z + b * y - c * x + d * w,
        ],
    )


def conjugate(q: Matrix) -> Matrix:
    """The inverse of a unit quaternion."""
    w, x, y, z = q
    return Matrix.vector(q.graph, [w, -x, -y, -z])


def _series(square: Scalar) -> Scalar:
    total = square * ARCSINE_SERIES[-1]
    for coefficient in ARCSINE_SERIES[-2:0:-1]:
        total = (total + coefficient) * square
    return total + ARCSINE_SERIES[0]
