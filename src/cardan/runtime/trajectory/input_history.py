"""The inputs of a run that is over."""

from __future__ import annotations

import numpy as np

from ...arguments import Times, checked
from ...arrays import Array
from ...records import dataclass


@dataclass(frozen=True)
class PiecewiseInput:
    """An input by polynomials: c0 + c1 d + c2 d^2 + c3 d^3 with d = t - breaks[k].

    Attributes:
        input: Index in r.
        breaks: (n + 1), ascending [s]; two equal ones are a jump.
        coefficients: (n, 4).
    """

    input: int
    breaks: Array
    coefficients: Array


@dataclass(frozen=True)
class Recorded:
    """The inputs of a run that is over.

    Attributes:
        constants, tabulated: As in :class:`Signals`.
        called: Indices in r of the functions.
        sampled: Whether those kept their values between samples.
        t, r: Times (nt,) and values there (nt, nr).
    """

    constants: Array
    tabulated: tuple[PiecewiseInput, ...]
    called: tuple[int, ...]
    sampled: bool
    t: Array
    r: Array

    @checked
    def __call__(self, times: Times) -> Array:
        """r (m, nr) at times (m,).

        Exact for constants and values at times; functions are held where they are sampled, and
        joined by straight lines otherwise.
        """
        times = np.atleast_1d(np.asarray(times, dtype=np.float64))
        result = np.tile(self.constants, (len(times), 1))
        order = np.argsort(self.t, kind="stable")
        t_rows, r = self.t[order], self.r[order]
        for k in self.called:
            if self.sampled:
                # a row at the end of a step holds the value that led there
                next_row = np.clip(np.searchsorted(t_rows, times), 0, len(t_rows) - 1)
                result[:, k] = r[next_row, k]
            else:
                result[:, k] = np.interp(times, t_rows, r[:, k])
        for segment in self.tabulated:
            where = np.searchsorted(segment.breaks, times, side="right") - 1
            where = np.clip(where, 0, len(segment.coefficients) - 1)
            d, c = times - segment.breaks[where], segment.coefficients[where].T
            result[:, segment.input] = ((c[3] * d + c[2]) * d + c[1]) * d + c[0]
        return result
