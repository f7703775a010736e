"""Periodic motions of joints within limits, whatever numbers describe them.

q = c + sum over l of (a_l sin(l w t) - b_l cos(l w t)) / (l w): finite sums, so that speeds and
accelerations are known exactly and measured periods can be averaged.

Source: Swevers, Ganseman, Tukel, De Schutter and Van Brussel, Optimal Robot Excitation and
Identification, IEEE Trans. Robotics and Automation 13 (1997).
"""

from __future__ import annotations

import numpy as np

from ...arrays import Array
from ...records import dataclass

# points per wave of the highest harmonic at which limits are kept, and what lies between them
FINE, MARGIN = 40, 0.005


@dataclass(frozen=True)
class Limits:
    """Limits of every joint (n,):

    positions, speeds, accelerations; infinite where there are none.
    """

    lower: Array
    upper: Array
    speed: Array
    acceleration: Array


@dataclass(frozen=True)
class Series:
    """Coefficients c (..., n), a and b (..., n, harmonics) of motions with a period [s]."""

    period: float
    c: Array
    a: Array
    b: Array

    def at(self, t: Array) -> tuple[Array, Array, Array]:
        """q, u and udot at times (m,): (..., m, n) each."""
        rates = 2 * np.pi / self.period * np.arange(1, self.a.shape[-1] + 1)
        sine, cosine = np.sin(np.outer(t, rates)), np.cos(np.outer(t, rates))

        def total(sines: Array, cosines: Array) -> Array:
            values = sines @ sine.T + cosines @ cosine.T
            return np.asarray(np.swapaxes(values, -1, -2))

        q = self.c[..., None, :] + total(self.a / rates, -self.b / rates)
        return q, total(self.b, self.a), total(-self.a * rates, self.b * rates)


def feasible(numbers: Array, period: float, harmonics: int, limits: Limits) -> Series:
    """The motion that free numbers (..., n, 2 harmonics + 2) stand for, inside the limits.

    The first ones are a shape; the last two say which part of the largest motion of that shape is
    taken, and where between the limits it lies.
    """
    a, b = numbers[..., :harmonics], numbers[..., harmonics : 2 * harmonics]
    still = np.zeros(a.shape[:-1])
    t = period * np.arange(FINE * harmonics) / (FINE * harmonics)
    q, u, udot = Series(period, still, a, b).at(t)
    span = (limits.upper - limits.lower) / np.maximum(np.ptp(q, axis=-2), 1e-300)
    fastest = limits.speed / np.maximum(np.abs(u).max(axis=-2), 1e-300)
    hardest = limits.acceleration / np.maximum(np.abs(udot).max(axis=-2), 1e-300)
    most = np.minimum(np.minimum(span, fastest), hardest) * (1 - MARGIN)
    size = most * _part(numbers[..., -2])
    low, high = size * q.min(axis=-2), size * q.max(axis=-2)
    margin = MARGIN * (high - low)
    room = np.maximum(limits.upper - limits.lower - (high - low) - margin, 0.0)
    c = limits.lower + margin / 2 - low + room * _part(numbers[..., -1])
    return Series(period, c, a * size[..., None], b * size[..., None])


def _part(x: Array) -> Array:
    """A number between 0 and 1."""
    return np.asarray(0.5 * (1 + np.tanh(x)))
