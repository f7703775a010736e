"""The tangent operator of the rotation vector, and derivatives along rotations.

All are entire functions of the vector, written with Stumpff functions c_k of its square length:
exact at 0 and accurate beside it.

Source: Géradin and Cardona, Flexible Multibody Dynamics (2001), section 4.6.
"""

from __future__ import annotations

from ..ir.arithmetic import Scalar, stumpff
from ..ir.matrix import Matrix


def tangent(vector: Matrix) -> Matrix:
    """T = 1 - c_2 [v] + c_3 [v]², (3, 3): omega = T(v) vdot in the turned axes.

    In the fixed axes the same holds with the transpose.

    Args:
        vector: Rotation vector [rad], (3, 1).
    """
    x = vector.dot(vector)
    return _polynomial(vector, -stumpff(2, x), stumpff(3, x))


def inverse_tangent(vector: Matrix) -> Matrix:
    """1 + [v]/2 + (c_3 - 2 c_4) / (2 c_2) [v]², (3, 3): vdot = T⁻¹(v) omega.

    Regular for rotations by less than 2 pi.

    Args:
        vector: Rotation vector [rad], (3, 1).
    """
    x = vector.dot(vector)
    half = Scalar(vector.graph, vector.graph.const(0.5))
    # (1 - c_1 / (2 c_2)) / x without its cancellation at 0
    return _polynomial(vector, half, (stumpff(3, x) - 2 * stumpff(4, x)) / (2 * stumpff(2, x)))


def _polynomial(vector: Matrix, first: Scalar, second: Scalar) -> Matrix:
    """1 + first [v] + second [v]²."""
    identity = Matrix.identity(vector.graph, 3)
    square = vector.outer(vector) - identity * vector.dot(vector)
    return identity + vector.skew * first + square * second
