"""Curves that guide points, in plain numbers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]


@dataclass(frozen=True)
class Curve:
    """A piecewise polynomial in space.

    Attributes:
        breaks: Ends of the pieces, (n + 1,).
        coefficients: Highest power of the distance from the left end first, by component and
            piece, (3, n, k).
        period: After which it comes round again, 0 where it does not.
    """

    breaks: Array
    coefficients: Array
    period: float = 0.0

    def at(self, s: Array, order: int) -> Array:
        """Derivative by s, (..., 3)."""
        if self.period:
            s = s - self.period * np.floor(s.real / self.period)
        piece = np.clip(np.searchsorted(self.breaks, s.real) - 1, 0, len(self.breaks) - 2)
        step = s - self.breaks[piece]
        rows = [np.moveaxis(row[piece], -1, 0) for row in self.coefficients]
        for _ in range(order):
            powers = np.arange(len(rows[0]) - 1, 0, -1)
            rows = [row[:-1] * powers.reshape(-1, *([1] * s.ndim)) for row in rows]
        return np.stack([_horner(row, step) for row in rows], axis=-1)


def _horner(coefficients: Array, x: Array) -> Array:
    total = np.zeros_like(x)
    for c in coefficients:
        total = total * x + c
    return total
