"""Derivatives of poses by means over circles in the complex plane.

Source: Cauchy's integral formula; Lyness, Moler, Numerical differentiation of analytic functions
(1967).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]
# coordinates (n, k), real or complex -> rotations (n, 3, 3) and positions (n, 3)
Pose = Callable[[Array], tuple[Array, Array]]
# radii of circles round coordinates, and points on each
CIRCLES, POINTS = tuple(0.2 * 0.25**k for k in range(7)), 16
ROUND = np.exp(2j * np.pi * np.arange(POINTS) / POINTS)
# means over all points of a circle and over every other one that differ by less, of the largest
# slope, are good
SURE = 1e-10


class Expansion:
    """A pose and its derivatives by the coordinates that describe no rotation.

    Args:
        pose: Differentiated.
        first: Coordinates before this one are not moved.
    """

    def __init__(self, pose: Pose, first: int = 0) -> None:
        self.pose, self.first = pose, first
        self._known: tuple[bytes, tuple[int, ...], tuple[Array, Array, Array]] | None = None

    def __call__(self, q: Array) -> tuple[Array, Array]:
        """Rotation (..., 3, 3) and position (..., 3) at coordinates (..., n)."""
        turned, shifted = self.pose(q.reshape(int(np.prod(q.shape[:-1])), q.shape[-1]))
        return turned.reshape(*q.shape[:-1], 3, 3), shifted.reshape(*q.shape[:-1], 3)

    def derivatives(self, q: Array) -> tuple[Array, Array, Array]:
        """The pose (..., 12) and its first (..., k, 12) and second (..., k, k, 12) derivatives at
        real coordinates (..., n): the rotation, row by row, then the position.

        The last ones are known by heart.
        """
        key = q.tobytes()
        if self._known is None or self._known[:2] != (key, q.shape):
            self._known = key, q.shape, self._derivatives(q)
        return self._known[2]

    def _derivatives(self, q: Array) -> tuple[Array, Array, Array]:
        lead, n = q.shape[:-1], q.shape[-1]
        axes, k = np.eye(n)[self.first :], n - self.first
        # along every axis, and along the sum of every two
        one, other = np.triu_indices(k, 1)
        ways = np.concatenate([axes, axes[one] + axes[other]])
        if not k:
            return self._rows(q), np.zeros((*lead, 0, 12)), np.zeros((*lead, 0, 0, 12))
        slopes = settled(lambda radius: self._means(q, ways, radius), lead).real
        here, slopes = slopes[..., :12], slopes[..., 12:]
        first, along = np.moveaxis(slopes.reshape(*lead, 2, len(ways), 12), -3, 0)
        second = np.zeros((*lead, k, k, 12))
        second[..., range(k), range(k), :] = along[..., :k, :]
        mixed = (along[..., k:, :] - along[..., one, :] - along[..., other, :]) / 2
        second[..., one, other, :] = second[..., other, one, :] = mixed
        return here, first[..., :k, :], second

    def _rows(self, q: Array) -> Array:
        """The pose (..., 12) in one row."""
        turned, shifted = self(q)
        return np.concatenate([turned.reshape(*q.shape[:-1], 9), shifted], axis=-1)

    def _means(self, q: Array, ways: Array, radius: float) -> tuple[Array, Array]:
        """The pose (..., 12), then first and second derivatives along ways (ways, n).

        By means over all points of circles, and over every other one.
        """
        circle = np.append(0, radius * ROUND)
        rows = self._rows(q[..., None, None, :] + circle[:, None] * ways[:, None, :])
        here, rows = rows[..., 0, 0, :], rows[..., 1:, :]
        whole, half = (
            np.stack(
                [
                    np.einsum("...kjx,j->...kx", rows[..., ::skip, :], ROUND[::skip] ** -k)
                    * (k * skip / POINTS / radius**k)
                    for k in (1, 2)
                ],
                axis=-3,
            ).reshape(*q.shape[:-1], -1)
            for skip in (1, 2)
        )
        return np.concatenate([here, whole], axis=-1), np.concatenate([here, half], axis=-1)


def settled(means: Callable[[float], tuple[Array, Array]], lead: tuple[int, ...]) -> Array:
    """Means (*lead, k) over circles as large as they may be, state by state.

    Large ones lose no digits; in small ones a pose is a polynomial, and no case of it begins.
    """
    best, doubt = np.zeros((*lead, 1)), np.full(lead, np.inf)
    for radius in CIRCLES:
        with np.errstate(all="ignore"):
            whole, half = means(radius)
            size = np.maximum(1.0, np.abs(whole).max(axis=-1, initial=0.0))
            apart = np.abs(whole - half).max(axis=-1, initial=0.0) / size
        apart = np.where(np.isfinite(apart), apart, np.inf)
        best = np.where((apart < doubt)[..., None], whole, best)
        doubt = np.minimum(apart, doubt)
        if (doubt <= SURE).all():
            break
    return np.asarray(best)
