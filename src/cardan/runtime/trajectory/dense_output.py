"""Dense output kept by a run: the state at any time inside it."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property

import numpy as np

from ...arrays import Array
from ...records import dataclass


@dataclass(frozen=True, eq=False)
class Dense:
    """A polynomial over every step.

    With theta from 0 to 1 over a step: y_old + theta (F0 + (1 - theta) (F1 + theta (F2 + ...))).

    Attributes:
        t: Ends of the steps (n + 1), in the direction of the run [s].
        y: Values there (n + 1, size).
        spreads: F0, F1, ... of every step (n, rows, size).
        quaternions: First entries of the quaternions; values come out with unit length.
        charted: Whether rows hold increments (0, rotation vector in body axes) at quaternions.
    """

    t: Array
    y: Array
    spreads: Array
    quaternions: tuple[int, ...]
    charted: bool = False

    def at(self, times: Array) -> Array:
        """Values (m, size) at times (m,), which must lie inside the run."""
        sign = 1.0 if self.t[-1] >= self.t[0] else -1.0
        last = len(self.spreads) - 1
        step = np.clip(np.searchsorted(sign * self.t, sign * times, side="right") - 1, 0, last)
        # a step without length is a jump: what counts is what lies behind it
        length = self.t[step + 1] - self.t[step]
        theta = np.divide(times - self.t[step], length, out=np.ones_like(times), where=length != 0)
        theta = theta[:, None]
        total = np.zeros((len(times), self.y.shape[1]))
        for row in range(self.spreads.shape[1] - 1, -1, -1):
            total = (total + self.spreads[step, row]) * (theta if row % 2 == 0 else 1 - theta)
        values: Array = self.y[step] + total
        for start in self.quaternions if self.charted else ():
            four = slice(start, start + 4)
            values[:, four] = rotated(self.y[step, four], total[:, start + 1 : start + 4])
        for start in self.quaternions:
            q = values[:, start : start + 4]
            q /= np.linalg.norm(q, axis=1, keepdims=True)
        # at the end of the run the sum may miss the last bit
        values[times == self.t[-1]] = self.y[-1]
        return values


class LaterDense(Dense):
    """The same, whose rows are made when somebody first asks for them.

    Attributes:
        make: Makes them; it is asked once.
    """

    def __init__(
        self,
        t: Array,
        y: Array,
        make: Callable[[], Array],
        quaternions: tuple[int, ...],
        charted: bool,
    ) -> None:
        values = {"t": t, "y": y, "quaternions": quaternions, "charted": charted, "make": make}
        self.__dict__.update(values)

    @cached_property
    def spreads(self) -> Array:
        """F0, F1, ... of every step (n, rows, size)."""
        make: Callable[[], Array] | None = self.__dict__.get("make")
        # another thread has it made meanwhile
        rows: Array = self.__dict__["spreads"] if make is None else make()
        self.__dict__["spreads"] = rows
        # which holds what the rows are made of
        self.__dict__.pop("make", None)
        return rows

    def as_data(self) -> Dense:
        """As data."""
        return Dense(self.t, self.y, self.spreads, self.quaternions, self.charted)


def rotated(q: Array, v: Array) -> Array:
    """Quaternions (m, 4) turned by rotation vectors v (m, 3) in body axes: q exp(v / 2)."""
    half = 0.5 * np.linalg.norm(v, axis=1, keepdims=True)
    w, by = np.cos(half), 0.5 * np.sinc(half / np.pi) * v
    first = q[:, :1] * w - (q[:, 1:] * by).sum(axis=1, keepdims=True)
    return np.hstack([first, q[:, :1] * by + w * q[:, 1:] + np.cross(q[:, 1:], by)])


def shortened(coefficients: Array, part: float) -> Array:
    """The dense output of a step over a part of it.

    Args:
        coefficients: F0, F1, ... (rows, size).
        part: 0 ... 1.
    """
    rows, size = coefficients.shape
    a = np.zeros((rows + 1, size))
    # powers of theta, those of phi = theta / part, and back again
    for j in range(rows - 1, -1, -1):
        a[0] += coefficients[j]
        down = np.concatenate([np.zeros((1, size)), a[:-1]])
        a = down if j % 2 == 0 else a - down
    a *= part ** np.arange(rows + 1)[:, None]
    result = np.empty_like(coefficients)
    for j in range(rows):
        if j % 2 == 0:
            # divided by phi; what is left after the row vanishes at phi = 1
            a = np.concatenate([a[1:], np.zeros((1, size))])
            result[j] = a.sum(axis=0)
        else:
            # divided by 1 - phi; what is left vanishes at phi = 0
            a = np.cumsum(a, axis=0)
            result[j] = a[0]
        a[0] -= result[j]
    return result
