"""Directions: unit axes, their complements, and the rotation about one."""

from __future__ import annotations

from ..ir.arithmetic import Scalar, cos, select, sin, sqrt
from ..ir.graph import MINUS_ONE, ONE, ZERO
from ..ir.matrix import Matrix


def principal(axis: Matrix) -> tuple[int, int] | None:
    """(k, sign) of an axis that is structurally +-e_k, None for any other."""
    filled = [(k, node) for k, node in enumerate(axis.nodes) if node != ZERO]
    if len(filled) == 1 and filled[0][1] in (ONE, MINUS_ONE):
        k, node = filled[0]
        return k, 1 if node == ONE else -1
    return None


def unit(axis: Matrix) -> Matrix:
    """The axis divided by its length; an axis that is structurally a unit axis is kept."""
    if principal(axis) is not None:
        return axis
    return axis / sqrt(axis.dot(axis))


def complement(n: Matrix) -> tuple[Matrix, Matrix]:
    """Two directions t1, t2 that make a right-handed orthonormal triad t1, t2, n.

    For n along an axis they are the next two axes (x, y for z; y, z for x; z, x for y; swapped
    for a negative axis). For any other n they are the x and y axes, carried along by the shortest
    rotation that takes z to n (from -z, with t2 = -y, where n points below the xy plane).

    Args:
        n: Unit vector, (3, 1).

    Source: T. Duff and others, Building an Orthonormal Basis, Revisited, JCGT 6 (2017).
    """
    graph, along = n.graph, principal(n)
    if along is not None:
        k, sign = along
        identity = Matrix.identity(graph, 3)
        first, second = identity.column((k + 1) % 3), identity.column((k + 2) % 3)
        return (first, second) if sign > 0 else (second, first)
    x, y, z = n
    sign_z = select(z.apply("lt", 0.0), -1.0, 1.0)
    a = -1.0 / (sign_z + z)
    b = x * y * a
    for name, step in (("side", sign_z), ("scale", a), ("xy", b)):
        graph.note(step.node, name)
    first = Matrix.vector(graph, [1 + sign_z * x * x * a, sign_z * b, -(sign_z * x)])
    return first, Matrix.vector(graph, [b, sign_z + y * y * a, -y])


def rotation_about(n: Matrix, angle: Scalar) -> Matrix:
    """R = n nᵀ + cos(angle) (1 - n nᵀ) + sin(angle) [n], for a unit vector n.

    The parts made of n alone stay together, so that they are prepared once per parameter set.
    """
    graph, along = n.graph, principal(n)
    c, s = cos(angle), sin(angle)
    if along is None:
        dyad = n.outer(n)
        return dyad + (Matrix.identity(graph, 3) - dyad) * c + n.skew * s
    k, sign = along
    return elementary(k, c, s if sign > 0 else -s)


def elementary(k: int, c: Scalar, s: Scalar) -> Matrix:
    """Rotation about the k-th axis by an angle with cosine c and sine s."""
    i, j = (k + 1) % 3, (k + 2) % 3
    entries = [ZERO] * 9
    entries[4 * k] = ONE
    entries[4 * i] = entries[4 * j] = c.node
    entries[3 * i + j] = (-s).node
    entries[3 * j + i] = s.node
    return Matrix(c.graph, 3, 3, entries)
