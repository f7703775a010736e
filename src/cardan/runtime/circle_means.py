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
# coordinates (n, k), complex -> rotations (n, 3, 3) and positions (n, 3)
Pose = Callable[[Array], tuple[Array, Array]]
# radii of circles round coordinates, and points on each
CIRCLES, POINTS = tuple(0.05 * 0.25**k for k in range(6)), 16
ROUND = np.exp(2j * np.pi * np.arange(POINTS) / POINTS)
# means over all points of a circle and over every other one that differ by less, of the largest
# slope, are good
SURE = 1e-10


def means_of(pose: Pose, q: Array, ways: Array, radius: float) -> tuple[Array, Array]:
    """First and second derivatives (..., 24 (n + 1)) of a pose along ways (..., n + 1, n).

    By means over all points of circles, and over every other one.
    """
    places = q[..., None, None, :] + radius * ROUND[:, None] * ways[..., None, :]
    turned, placed = pose(places.reshape(-1, q.shape[-1]))
    rows = np.concatenate([turned.reshape(-1, 9), placed], axis=-1)
    rows = rows.reshape(*places.shape[:-1], 12)
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
    return whole, half


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
