"""Rotation matrices of every parametrization, in NumPy, for checks and random states.

Written apart from :mod:`cardan.spatial` on purpose: each formula is another route to the same
rotation. Everything holds for complex numbers, so that a complex step differentiates it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...records import dataclass

Matrix = NDArray[Any]


def cross_matrix(v: Matrix) -> Matrix:
    """[v] (..., 3, 3) with [v] w = v x w."""
    x, y, z = v[..., 0], v[..., 1], v[..., 2]
    o = np.zeros_like(x)
    return np.stack([o, -z, y, z, o, -x, -y, x, o], axis=-1).reshape(*v.shape[:-1], 3, 3)


def axial(m: Matrix) -> Matrix:
    """Axial vector v (..., 3) of a matrix (..., 3, 3): that of its skew part [v]."""
    pairs = ((2, 1), (0, 2), (1, 0))
    return np.asarray(np.stack([m[..., i, j] - m[..., j, i] for i, j in pairs], axis=-1) / 2)


def vector_of(r: Matrix) -> Matrix:
    """Rotation vectors (..., 3) of real rotations (..., 3, 3); the real part of complex ones."""
    r = r.real
    across = axial(r)
    sine = np.linalg.norm(across, axis=-1)
    cosine = (np.trace(r, axis1=-2, axis2=-1) - 1) / 2
    # a half turn has no sine: any axis will do, it is far from closed
    lost = np.where((sine < 1e-9) & (cosine < 0), np.pi, 0.0)
    factor = np.arctan2(sine, cosine) / np.where(sine < 1e-9, 1.0, sine)
    factor = np.where((sine < 1e-9) & (cosine > 0), 1.0, factor)
    return np.asarray(across * factor[..., None] + lost[..., None])


def unit(q: Matrix, quaternions: Sequence[int]) -> Matrix:
    """Coordinates (..., nq) with quaternions of length 1, by where these begin."""
    q, entries = q.copy(), np.array(quaternions, dtype=np.intp)[:, None] + np.arange(4)
    q[..., entries] /= np.linalg.norm(q[..., entries], axis=-1)[..., None]
    return q


def about(axis: Matrix, angle: Matrix) -> Matrix:
    """Rotation (..., 3, 3) about a unit axis (3,) by angles (...)."""
    k = cross_matrix(axis)
    s, c = np.sin(angle)[..., None, None], np.cos(angle)[..., None, None]
    result: Matrix = np.eye(3) + s * k + (1 - c) * (k @ k)
    return result


def _from_products(v: Matrix, first: Matrix, second: Matrix) -> Matrix:
    """1 + first [v] + second [v]²."""
    k = cross_matrix(v)
    result: Matrix = np.eye(3) + first[..., None, None] * k + second[..., None, None] * (k @ k)
    return result


def _square(v: Matrix) -> Matrix:
    return np.asarray((v * v).sum(axis=-1))


def quaternion(q: Matrix) -> Matrix:
    """Unit quaternion (w, x, y, z): 1 + 2 w [v] + 2 [v]²."""
    return _from_products(q[..., 1:], 2 * q[..., 0], np.full_like(q[..., 0], 2.0))


def euler_rodrigues(q: Matrix) -> Matrix:
    """2 n sin(phi/2): the vector part of a unit quaternion, doubled."""
    return quaternion(np.concatenate([np.sqrt(1 - _square(q) / 4)[..., None], q / 2], axis=-1))


def rotation_vector(q: Matrix) -> Matrix:
    """phi n: the exponential of [q]."""
    x = _square(q)
    small = np.abs(x) < 1e-8
    angle = np.sqrt(np.where(small, 1.0, x))
    first = np.where(small, 1 - x / 6, np.sin(angle) / angle)
    second = np.where(small, 0.5 - x / 24, 2 * (np.sin(angle / 2) / angle) ** 2)
    return _from_products(q, first, second)


def rodrigues(q: Matrix) -> Matrix:
    """n tan(phi/2): Cayley's transform of [q]."""
    k = cross_matrix(q)
    return np.linalg.solve(np.eye(3) - k, np.eye(3) + k)


def mrp(q: Matrix) -> Matrix:
    """n tan(phi/4): Cayley's transform, twice."""
    once = rodrigues(q)
    return once @ once


def conformal(q: Matrix) -> Matrix:
    """4 n tan(phi/4)."""
    return mrp(q / 4)


def linear(q: Matrix) -> Matrix:
    """n sin(phi), |phi| < pi/2."""
    cosine = np.sqrt(1 - _square(q))
    return _from_products(q, np.ones_like(cosine), 1 / (1 + cosine))


def dcm(q: Matrix) -> Matrix:
    """The first two columns of R, stacked."""
    a, b = q[..., :3], q[..., 3:]
    return np.stack([a, b, np.cross(a, b)], axis=-1)


def angles(sequence: str) -> Callable[[Matrix], Matrix]:
    """Three angles: ``"XYZ"`` turns about body axes in this order, ``"xyz"`` about fixed ones."""
    axes = [np.eye(3)["xyz".index(letter)] for letter in sequence.lower()]

    def matrix(q: Matrix) -> Matrix:
        first, second, third = (about(axis, q[..., k]) for k, axis in enumerate(axes))
        if sequence.isupper():
            return np.asarray(first @ second @ third)
        return np.asarray(third @ second @ first)

    return matrix


@dataclass(frozen=True)
class Parameters:
    """A parametrization.

    Attributes:
        size: Number of coordinates.
        matrix: Coordinates (..., size) -> R (..., 3, 3), axes C to axes P.
        of_vector: Rotation vector (..., 3) -> coordinates, for random states.
        reach: Largest angle [rad] that random states turn by.
    """

    size: int
    matrix: Callable[[Matrix], Matrix]
    of_vector: Callable[[Matrix], Matrix]
    reach: float


def _scaled(length: Callable[[Matrix], Matrix]) -> Callable[[Matrix], Matrix]:
    """n f(phi) of a rotation vector phi n."""

    def convert(v: Matrix) -> Matrix:
        angle = np.sqrt(_square(v))[..., None]
        return np.asarray(v / angle * length(angle))

    return convert


def _quaternion_of(v: Matrix) -> Matrix:
    angle = np.sqrt(_square(v))[..., None]
    return np.concatenate([np.cos(angle / 2), v / angle * np.sin(angle / 2)], axis=-1)


def _columns_of(v: Matrix) -> Matrix:
    r = rotation_vector(v)
    return np.concatenate([r[..., 0], r[..., 1]], axis=-1)


def _angles_of(sequence: str) -> Callable[[Matrix], Matrix]:
    """Any three numbers of moderate size, the second away from where the angles are singular."""
    proper = sequence[0].lower() == sequence[2].lower()

    def convert(v: Matrix) -> Matrix:
        second = 1.5 + 0.4 * v[..., 1] if proper else 0.4 * v[..., 1]
        return np.stack([v[..., 0], second, v[..., 2]], axis=-1)

    return convert


SEQUENCES = tuple(
    "".join(axes)
    for letters in ("XYZ", "xyz")
    for axes in product(letters, repeat=3)
    if axes[0] != axes[1] != axes[2]
)

PARAMETERS: dict[str, Parameters] = {
    "quaternion": Parameters(4, quaternion, _quaternion_of, 3.1),
    "rotation_vector": Parameters(3, rotation_vector, lambda v: v, 2.8),
    "rodrigues": Parameters(3, rodrigues, _scaled(lambda a: np.tan(a / 2)), 2.2),
    "mrp": Parameters(3, mrp, _scaled(lambda a: np.tan(a / 4)), 2.8),
    "conformal": Parameters(3, conformal, _scaled(lambda a: 4 * np.tan(a / 4)), 2.8),
    "euler_rodrigues": Parameters(3, euler_rodrigues, _scaled(lambda a: 2 * np.sin(a / 2)), 2.5),
    "linear": Parameters(3, linear, _scaled(np.sin), 1.2),
    "dcm": Parameters(6, dcm, _columns_of, 3.1),
    **{s: Parameters(3, angles(s), _angles_of(s), 3.1) for s in SEQUENCES},
}
