"""Measured data as a piecewise polynomial."""

from __future__ import annotations

import math
from bisect import bisect_right
from functools import reduce
from itertools import pairwise

from ..records import dataclass


@dataclass(frozen=True)
class Table:
    """A piecewise polynomial of measured data; its first and last piece continue outside.

    Attributes:
        breaks: Increasing abscissae, (n+1,).
        coefficients: Per piece, highest power first, of ``x - breaks[piece]``, (n, order).
    """

    breaks: tuple[float, ...]
    coefficients: tuple[tuple[float, ...], ...]

    @property
    def order(self) -> int:
        """Number of coefficients of a piece; this derivative and higher ones are zero."""
        return len(self.coefficients[0])

    def interval(self, x: float) -> int:
        """Number of the piece in which x lies; a break belongs to the piece it begins."""
        return min(max(bisect_right(self.breaks, x) - 1, 0), len(self.coefficients) - 1)

    def integral(self) -> Table:
        """The exact integral of the polynomial from 0 on, which is one of a power more."""
        rows, total = [], 0.0
        for row, (left, right) in zip(self.coefficients, pairwise(self.breaks), strict=True):
            raised = [c / power for c, power in zip(row, range(self.order, 0, -1), strict=True)]
            rows.append((*raised, total))
            total = _polynomial(rows[-1], right - left)
        k = self.interval(0.0)
        start = _polynomial(rows[k], -self.breaks[k])
        return Table(self.breaks, tuple((*row[:-1], row[-1] - start) for row in rows))

    def factors(self, derivative: int) -> list[int]:
        """Factors that the powers x^j, highest first, leave when they are differentiated."""
        return [math.perm(j, derivative) for j in range(self.order - 1, derivative - 1, -1)]


def _polynomial(coefficients: tuple[float, ...], x: float) -> float:
    """Value of a polynomial, highest power first."""
    return reduce(lambda value, c: value * x + c, coefficients, 0.0)
