"""Where events happen inside a step, in runs without a compiler.

What ``kernels/search.c`` and ``kernels/dips.c`` do, with the same bounds.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ..runtime.calling import Array
from ..runtime.dense import Dense, shortened
from .plain_methods import Step

if TYPE_CHECKING:
    from .plain import PlainRunner
    from .plain_events import PlainEvents

EPSILON = float(np.finfo(np.float64).eps)
MOST_TRIALS, SAMPLES, MOST_SAMPLES, FINE, MOST_LOOKS = 150, 5, 24, 32, 6
NEAR = 0.1


class Inside:
    """The states inside a step.

    Args:
        runner: The run.
        t, y: Start of the step.
        step: The step.
    """

    def __init__(self, runner: PlainRunner, t: float, y: Array, step: Step) -> None:
        self.runner, self.t, self.y, self.step = runner, t, y, step
        self.sign = math.copysign(1.0, step.t - t)
        self._spread = step.spread()
        ends, values = np.array([t, step.t]), np.stack([y, step.y])
        self._dense = Dense(ends, values, self._spread[None], runner.quaternions)

    def at(self, t: float) -> Array:
        """State y (n,) at a time, on the constraints."""
        if t == self.step.t:
            return self.step.y.copy()
        y: Array = self._dense.at(np.array([t]))[0]
        self.runner.closer.between(t, y)
        return y

    def resolution(self, a: float, b: float) -> float:
        """What two times differ by at least."""
        return 2 * EPSILON * max(abs(a), abs(b), abs(self.step.t - self.t))

    def cut(self, t: float) -> Step:
        """The step that ends at an earlier time."""
        if t == self.step.t:
            return self.step
        y = self.at(t)
        spread = shortened(self._spread, (t - self.t) / (self.step.t - self.t))
        spread[0] = y - self.y
        return Step(t, y, lambda: spread)


def samples_of(events: PlainEvents, inside: Inside) -> tuple[list[float], list[Array]]:
    """Times and values (ne,) of the samples of a step, those included where one may dip."""
    start, h = inside.t, inside.step.t - inside.t
    theta = [k / (SAMPLES - 1) for k in range(SAMPLES)]
    values = [events.g]

    def look(place: float) -> Array:
        t = inside.step.t if place == 1 else start + place * h
        return events.values(t, inside.at(t))

    values += [look(place) for place in theta[1:]]
    suspected = [
        _suspicion(np.array([v[i] for v in values])) if events.looked[i] else -1.0
        for i in range(events.m)
    ]
    for i, first in enumerate(suspected):
        where = first
        for _ in range(MOST_LOOKS):
            if not (where > 0 and len(theta) < MOST_SAMPLES):
                break
            k = int(np.searchsorted(theta, where, side="right"))
            theta.insert(k, where)
            values.insert(k, look(where))
            where = _lower(np.array(theta), np.array([v[i] for v in values]))
    return [inside.step.t if p == 1 else start + p * h for p in theta], values


def _suspicion(f: Array) -> float:
    """Where the polynomial through positive samples comes near zero, else a negative number."""
    if f.min() < 0 or f.max() == f.min():
        return -1.0
    places = np.arange(1, FINE) / FINE
    nodes = np.linspace(0.0, 1.0, SAMPLES)
    fitted = np.polyval(np.polyfit(nodes, f, SAMPLES - 1), places)
    k = int(fitted.argmin())
    return float(places[k]) if fitted[k] < NEAR * (f.max() - f.min()) else -1.0


def _lower(theta: Array, f: Array) -> float:
    """The lowest point of the parabola around the lowest inner sample; negative: known well."""
    k = 1 + int(f[1:-1].argmin())
    a, b, c = theta[k - 1 : k + 2].tolist()
    fa, fb, fc = f[k - 1 : k + 2].tolist()
    if fb <= 0 or fb > fa or fb > fc:
        return -1.0
    top = (b - a) ** 2 * (fb - fc) - (b - c) ** 2 * (fb - fa)
    base = (b - a) * (fb - fc) - (b - c) * (fb - fa)
    if base == 0:
        return -1.0
    where = float(b - 0.5 * top / base)
    return where if a < where < c and abs(where - b) > 1e-6 * (c - a) else -1.0


def interval(events: PlainEvents, inside: Inside, times: list[float], values: list[Array]) -> Array:
    """When every event happens between two samples (ne,); NaN where it does not."""
    found = np.full(events.m, math.nan)
    a, b = times
    before, after = values
    events.arm(np.where(events.looked, before, 0.0))
    for i in np.flatnonzero(events.looked).tolist():
        if events.armed[i] and after[i] <= 0:
            bracket = (a, b, float(before[i]), float(after[i]))
            found[i] = _locate(events, inside, i, bracket) if before[i] > 0 else a
        elif not events.armed[i] and events.binding[i] and after[i] < -events.slack[i]:
            found[i] = _locate_sunk(events, inside, i, (a, b, float(before[i]), float(after[i])))
    return found


Bracket = tuple[float, float, float, float]


def _locate(
    events: PlainEvents, inside: Inside, i: int, bracket: Bracket, shift: float = 0.0
) -> float:
    """Where a value plus ``shift``, positive at a and not so at b, falls through zero."""
    a, b, fa, fb = bracket
    side = 0
    for trial in range(MOST_TRIALS):
        width, fine = b - a, inside.resolution(a, b)
        if abs(width) <= fine:
            break
        part = 0.5 if trial % 4 == 3 else fa / (fa - fb)
        part = abs(width) * (part if 0 <= part <= 1 else 0.5)
        t = a + math.copysign(min(max(part, 0.5 * fine), abs(width) - 0.5 * fine), width)
        if t in (a, b):
            break
        f = float(events.values(t, inside.at(t))[i]) + shift
        if f > 0:
            a, fa = t, f
            fb = 0.5 * fb if side == 1 else fb
            side = 1
        else:
            b, fb = t, f
            fa = 0.5 * fa if side == -1 else fa
            side = -1
    return b


def _locate_sunk(events: PlainEvents, inside: Inside, i: int, bracket: Bracket) -> float:
    """Where a binding event falls that was about zero at a: after a rise, or at once."""
    a, b, fa, fb = bracket
    low, t = float(events.slack[i]), b
    while True:
        t = a + 0.5 * (t - a)
        if abs(t - a) <= inside.resolution(a, t):
            break
        f = float(events.values(t, inside.at(t))[i])
        if f > low:
            events.armed[i] = 1.0
            return _locate(events, inside, i, (t, b, f, fb))
        if f < -low:
            b, fb = t, f
    return _locate(events, inside, i, (a, b, max(fa + low, 0.0), fb + low), low)


def earliest(found: Array, some: NDArray[np.bool_], sign: float) -> int | None:
    """The event of some that happens first; None where none does."""
    times = np.where(some & ~np.isnan(found), sign * found, math.inf)
    first = int(times.argmin()) if len(times) else 0
    return first if len(times) and times[first] < math.inf else None
