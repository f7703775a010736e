"""Steps over places where branches meet, without a compiler: what ``kernels/passing.c`` does.

Source: as of ``kernels/passing.c``.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from . import record as abi
from .plain_hold import PlainHold
from .plain_methods import Broken, Step

if TYPE_CHECKING:
    from .plain import PlainRunner

Array = NDArray[np.float64]
# as in passing.c, which says what they are
POINTS, SWEEPS = (10, 9, 8, 7, 6), 40
WINDOW, NEAREST, APART, ENOUGH, LOOSE, ROUNDING = 0.25, 0.01, 0.03, 1e-2, 10.0, 1e-14


def gauss(count: int) -> tuple[Array, Array]:
    """Points and weights of Gauss in 0 ... 1."""
    x, w = legendre.leggauss(count)
    return 0.5 * (1 + x), 0.5 * w


def lagrange(points: Array, x: Array) -> Array:
    """Lagrange's polynomials of points (s,) at x (...,): (..., s)."""
    columns = []
    for j, point in enumerate(points):
        others = np.delete(points, j)
        columns.append(np.prod((x[..., None] - others) / (point - others), axis=-1))
    return np.stack(columns, axis=-1)


def integral(points: Array, a: float, b: float) -> Array:
    """Weights (s,) of values at points for the integral from a to b of their polynomial."""
    x, w = gauss(POINTS[0])
    result: Array = (b - a) * (w @ lagrange(points, a + (b - a) * x))
    return result


class PlainPasser:
    """Finds places where branches meet and steps over them.

    Attributes:
        hold: How well the constraints hold.
        limit: How long the next step of the method may be.
    """

    def __init__(self, runner: PlainRunner) -> None:
        self.runner, self.hold = runner, PlainHold(runner)
        self.limit = math.inf
        self._parts: Iterator[Step] | None = None
        self._stop = 0.0

    def cancel(self) -> None:
        """What comes next is not what was: the rest of a step is forgotten."""
        self._parts = None

    def next(self, stop: float) -> Step | None:
        """The next part of a step over such a place; None: the method shall step.

        Raises:
            Broken: the motion is not defined there, or a function has no result.
        """
        step = next(self._parts, None) if self._parts is not None else None
        if step is not None:
            return step
        self._parts = None
        self.limit = math.inf
        runner, run, hold = self.runner, self.runner.record, self.hold
        if not runner.closing.rows:
            return None
        self._stop = stop
        left, y = stop - run.t, runner.views["y"]
        hold.f = runner.derivative(run.t, y)
        wanted = abs(run.h) or abs(left)
        tau = hold.meeting(left, wanted)
        hold.old[:], hold.t_old = y, run.t
        return None if tau is None else self._over(tau, left, wanted)

    def _over(self, tau: float, left: float, wanted: float) -> Step | None:
        """Try steps over a place ``tau`` ahead; else limit the step that leads nearer to it."""
        span = 1 / self.hold.pace()
        h, error = self._length(tau, left, span), math.inf
        near = abs(tau) <= max(wanted, 0.5 * WINDOW * span)
        for _ in range(3):
            if not near or not (abs(h) > 1.2 * abs(tau) or h == left):
                break
            try:
                error, parts = self._attempt(tau, h, span)
            except Broken as broken:
                if broken.answer != abi.OPEN:
                    raise
                error = math.inf
            if error <= 1:
                self.runner.record.passed += int(abs(tau) < abs(h))
                self._parts = parts
                return next(parts)
            h *= 0.6
        if abs(tau) < min(NEAREST * span, abs(left)):
            closing, hold = self.runner.closing, self.hold
            self.runner.record.open_row = closing.positions + int(hold.order[hold.held - 1])
            self.runner.record.correction = math.inf
            raise Broken(abi.OPEN)
        part = min(0.5, max(0.1, 1 - 0.9 * error ** (-1 / POINTS[0]))) if error < math.inf else 0.5
        self.limit = part * abs(tau)
        return None

    def _length(self, tau: float, left: float, span: float) -> float:
        """How long a step over a place should be."""
        h = max(2 * abs(tau), abs(tau) + 0.5 * WINDOW * span)
        if not self.runner.settings.method.adaptive:
            h = self.runner.settings.step * math.ceil(h / self.runner.settings.step)
        return math.copysign(min(h, abs(left)), left)

    def _attempt(self, tau: float, h: float, span: float) -> tuple[float, Iterator[Step]]:
        """Error of a step of length h, in tolerances, and its parts."""
        points, apart = self._points(tau / h)
        if apart < 0.5 * APART:
            raise Broken(abi.OPEN)
        runner, run = self.runner, self.runner.record
        allowed = max(1.0, ROUNDING / (apart * abs(h) / span) ** 3 / self.hold.finest())
        f, correction = self._sweeps(points, h, allowed)
        start, begin, scale = runner.views["y"].copy(), run.t, self._scale()
        error = max(correction, _error(points, h * f[:, : runner.nx] / scale)) / LOOSE
        end = start + h * (gauss(len(points))[1] @ f)
        runner.normalize(end)
        if not self.hold.beside(begin + h, end, True):
            runner.closer.close(begin + h, end, noted=False)
            error = max(error, run.correction)
        return error / allowed, self._play(points, f, start, begin, h)

    def _points(self, place: float) -> tuple[Array, float]:
        """The points that keep apart from a place in 0 ... 1, and how far."""
        best, chosen = 0.0, gauss(POINTS[0])[0]
        for count in POINTS:
            points = gauss(count)[0]
            apart = float(np.abs(points - place).min())
            if apart > 1.5 * best or (best < APART and apart > best):
                best, chosen = apart, points
        return chosen, best

    def _scale(self) -> Array:
        how = self.runner.settings
        return how.atol + how.rtol * np.abs(self.runner.views["y"][: self.runner.nx])

    def _on_constraints(self, t: float, y: Array) -> Array:
        """dy/dt (n,) on the constraints next to y.

        Raises:
            Broken: it does not close.
        """
        self.runner.closer.close(t, y, noted=False)
        return self.runner.derivative(t, y)

    def _sweeps(self, points: Array, h: float, allowed: float) -> tuple[Array, float]:
        """Derivatives (s, n) at the points, and the largest projection there in tolerances."""
        run, start, nx = self.runner.record, self.runner.views["y"].copy(), self.runner.nx
        f = self._predicted(points, h, start)
        weights, scale = gauss(len(points))[1], self._scale()
        table = np.stack([integral(points, 0.0, float(x)) for x in points])
        enough = ENOUGH if self.runner.settings.method.adaptive else 0.0
        last = math.inf
        for k in range(SWEEPS):
            old, correction = f.copy(), 0.0
            for j, x in enumerate(points):
                f[j] = self._on_constraints(run.t + x * h, start + h * (table[j] @ old))
                correction = max(correction, run.correction)
            off = np.abs(h * weights[:, None] * (f - old)[:, :nx]) / scale
            worst = float(off.max(initial=0.0))
            if worst <= enough or (worst <= 10 * allowed and worst > 0.5 * last):
                return f, correction
            if not worst < math.inf or (k > 3 and worst > 2 * last):
                break
            last = worst
        raise Broken(abi.OPEN)

    def _predicted(self, points: Array, h: float, start: Array) -> Array:
        """First derivatives (s, n): each by extrapolation of those before it."""
        run, known, at = self.runner.record, [self.hold.f], np.zeros(1)
        y, f = start, []
        for x in points:
            y = y + h * (integral(at, float(at[-1]), float(x)) @ np.stack(known))
            at = np.append(at, x)
            f.append(self._on_constraints(run.t + x * h, y))
            known.append(f[-1])
        return np.stack(f)

    def _play(
        self, points: Array, f: Array, start: Array, begin: float, h: float
    ) -> Iterator[Step]:
        """The step in parts, as long as those of the method where that has a grid."""
        runner, how = self.runner, self.runner.settings
        rows = how.method.dense_rows
        count = round(abs(h) / how.step) if not how.method.adaptive else 3 if rows >= 6 else 9

        def state(theta: float) -> Array:
            y: Array = start + h * (integral(points, 0.0, theta) @ f)
            runner.normalize(y)
            return y

        for k in range(count):
            low, high = k / count, (k + 1) / count
            t, y, before = begin + high * h, state(high), runner.views["y"].copy()
            if k + 1 == count and abs(self._stop - t) < 1e-9 * abs(h):
                t = self._stop
            if not self.hold.beside(t, y, k + 1 == count):
                try:
                    runner.closer.close(t, y, noted=True)
                except Broken as broken:
                    if broken.answer != abi.OPEN:
                        raise
                    y = state(high)
            theta = np.arange(1, rows + 1) / rows
            inside = [state(low + part * (high - low)) for part in theta[:-1]]
            rise = np.stack([*inside, y]) - before
            yield Step(t, y, partial(_rows_of, theta, rise))


def _error(points: Array, f: Array) -> float:
    """Error from how fast the coefficients of Legendre's polynomials fall; f (s, nx)."""
    s, weights = len(points), gauss(len(points))[1]
    table = legendre.legvander(2 * points - 1, s - 1)
    c = np.abs((weights[:, None] * table).T @ f)
    last, before = c[-1] + c[-2], c[-3] + c[-4]
    last = last * np.minimum(1.0, last / np.maximum(before, 1e-300))
    return float(last.max(initial=0.0)) / (2 * s)


def _rows_of(theta: Array, rise: Array) -> Array:
    """Dense output (rows, n) of what a step has risen by (rows, n) at parts of it (rows,)."""
    factors = np.stack([theta if j % 2 == 0 else 1 - theta for j in range(len(theta))], axis=1)
    found: Array = np.linalg.solve(np.cumprod(factors, axis=1), rise)
    return found
