"""Deviation of a rotation from leaving a direction, or everything, as it is.

All entries are sums of products of entries of R, so that structural zeros of plane motion stay
zeros, and are small rotation angles [rad] to first order.
"""

from __future__ import annotations

from ..ir.matrix import Matrix
from .axis import complement


def tilt(R: Matrix, n: Matrix) -> Matrix:
    """Rotation of R across a direction n, about its :func:`complement`; (2, 1).

    Vanishes where R n = n, and where R n = -n.

    Args:
        R: Rotation matrix, (3, 3).
        n: Unit vector, (3, 1).
    """
    first, second = complement(n)
    rotated = R @ n
    return Matrix.vector(R.graph, [-second.dot(rotated), first.dot(rotated)])


def rotation_vector(R: Matrix) -> Matrix:
    """Rotation of R about x, y and z, (3, 1): R = 1 + [turning] to first order.

    Vanishes where R = 1, and at seven rotations that map the axes to axes or their opposites.
    """
    return Matrix.vector(R.graph, [R[2, 1], R[0, 2], R[1, 0]])


def diagonal(R: Matrix) -> Matrix:
    """Cosines between the axes and the turned axes, (3, 1)."""
    return Matrix.vector(R.graph, [R[0, 0], R[1, 1], R[2, 2]])
