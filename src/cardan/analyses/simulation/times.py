"""Meanings of the argument ``t`` of a run."""

from __future__ import annotations

import math

import numpy as np

from ...arrays import Array
from ...errors import ArgumentError, ModelError, SolveError, brief
from ...records import dataclass


@dataclass(frozen=True)
class Span:
    """Start and end of a run [s].

    Attributes:
        start, end: Both.
        times: The wanted output times, None for every step.
        stops: More times inside at which a step must end.
    """

    start: float
    end: float
    times: Array | None = None
    stops: tuple[float, ...] = ()

    @property
    def length(self) -> float:
        """Duration, positive [s]."""
        return abs(self.end - self.start)


def span(t: object, t_eval: object = None) -> Span:
    """A run out of an end time, a pair ``(start, end)`` or output times.

    A pair may go backward. A tuple or list of two numbers is a pair; an array, or more numbers, are
    output times. An array of two could be meant as both: it is refused.

    Args:
        t: One of the three, None where ``t_eval`` says it.
        t_eval: Output times; the run goes from the first to the last of them.

    Raises:
        ModelError: an empty or negative span, times that do not go one way, or to another end.
        SolveError: a time that is not finite.
        ArgumentError: nothing of the three.
    """
    if t_eval is not None:
        return _evaluated(t, t_eval)
    array = _times("t", t)
    if array.ndim == 0:
        return _forward(float(array))
    if isinstance(t, tuple | list) and len(array) == 2:
        start, end = array.tolist()
        if start == end:
            raise ModelError(f"t=({start:g}, {end:g}): the run has no length")
        return Span(start, end)
    if len(array) == 2:
        raise ArgumentError(
            f"t is an array of two times: give the pair ({array[0]:g}, {array[1]:g}) for a run "
            "with every step, or t_eval= these two for output at them alone"
        )
    return _listed(array)


def _times(name: str, values: object) -> Array:
    """Finite times, one or a row."""
    try:
        array = np.array([] if values is None else values, dtype=np.float64)
    except (TypeError, ValueError, OverflowError, RecursionError):
        raise ArgumentError(_shape(name, brief(values))) from None
    if array.ndim > 1 or array.size == 0:
        got = f"an array of shape {array.shape}" if values is not None else "None"
        raise ArgumentError(_shape(name, got))
    bad = np.flatnonzero(~np.isfinite(np.atleast_1d(array)))
    if len(bad):
        raise SolveError(
            f"{name}: time {bad[0]} is {np.atleast_1d(array)[bad[0]]}. Times must be finite"
        )
    return array


def _evaluated(t: object, t_eval: object) -> Span:
    """A run with output at given times, whose ends are those of ``t`` where that is given."""
    over = _listed(np.atleast_1d(_times("t_eval", t_eval)))
    if t is None:
        return over
    ends = span(t)
    if ends.times is not None or (ends.start, ends.end) != (over.start, over.end):
        raise ModelError(
            f"t_eval: these output times go from {over.start:g} s to {over.end:g} s, the run from "
            f"{ends.start:g} s to {ends.end:g} s; leave out t, or give t_eval= the same ends"
        )
    return over


def _forward(end: float) -> Span:
    if end <= 0:
        raise ModelError(
            f"t={end:g}: a run to one end time starts at 0 and goes forward. "
            f"Give (start, end), such as t=(0, {end or -1:g}), to go backward"
        )
    return Span(0.0, end)


def _listed(times: Array) -> Span:
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


def _shape(name: str, got: str) -> str:
    return f"{name} is {got}; give an end time, (start, end) or a 1-d array of output times"
