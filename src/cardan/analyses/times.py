"""What ``t`` of a run means."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import ArgumentError, ModelError, SolveError


@dataclass(frozen=True)
class Span:
    """Start and end of a run [s]; ``times`` are the wanted output times, None for every step."""

    start: float
    end: float
    times: NDArray[np.float64] | None = None

    @property
    def length(self) -> float:
        """Duration, positive [s]."""
        return abs(self.end - self.start)


def span(t: Any) -> Span:
    """A run out of an end time, a pair ``(start, end)`` or an array of output times.

    A pair may go backward. A tuple or list of two numbers is a pair, an array of two is two
    output times.

    Raises:
        ModelError: an empty or negative span, times that do not go one way.
        SolveError: a time that is not finite.
        ArgumentError: nothing of the three.
    """
    try:
        array = np.array(t, dtype=np.float64)
    except (TypeError, ValueError):
        raise ArgumentError(_shape(repr(t))) from None
    if array.ndim > 1 or array.size == 0:
        raise ArgumentError(_shape(f"an array of shape {array.shape}"))
    bad = np.flatnonzero(~np.isfinite(np.atleast_1d(array)))
    if len(bad):
        raise SolveError(
            f"t: time {bad[0]} is {np.atleast_1d(array)[bad[0]]}. Times must be finite"
        )
    if array.ndim == 0:
        return _forward(float(array))
    if isinstance(t, tuple | list) and len(array) == 2:
        start, end = array.tolist()
        if start == end:
            raise ModelError(f"t=({start:g}, {end:g}): the run has no length")
        return Span(start, end)
    return _listed(array)


def _forward(end: float) -> Span:
    if end <= 0:
        raise ModelError(
            f"t={end:g}: a run to one end time starts at 0 and goes forward. "
            f"Give (start, end), such as t=(0, {end or -1:g}), to go backward"
        )
    return Span(0.0, end)


def _listed(times: NDArray[np.float64]) -> Span:
    if len(times) < 2:
        raise ModelError("t: output times must be at least two; the first one is the start")
    steps = np.diff(times)
    direction = math.copysign(1, times[-1] - times[0])
    wrong = np.flatnonzero(steps * direction <= 0)
    if len(wrong):
        k = int(wrong[0])
        raise ModelError(
            f"t: output times must ascend or descend; times {k} and {k + 1} are "
            f"{times[k]:g} and {times[k + 1]:g}"
        )
    return Span(float(times[0]), float(times[-1]), times)


def _shape(got: str) -> str:
    return f"t is {got}; give an end time, (start, end) or a 1-d array of output times"
