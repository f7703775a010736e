"""Events of runs without a compiler: what ``kernels/happening.c`` does."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ..runtime.calling import Array
from . import record as abi
from .plain_methods import Broken, Step
from .plain_search import Inside, earliest, interval, samples_of

if TYPE_CHECKING:
    from .plain import PlainRunner

EPSILON = float(np.finfo(np.float64).eps)
ROUNDING = 256 * EPSILON
CLOSE, BURST = 1e3 * EPSILON, 1e-6  # of the time, of the span
MOST_AT_ONCE, MOST_CLOSE, MOST_IN_A_BURST = 50, 20, 1000


class PlainEvents:
    """What is known of the events of a run.

    Attributes:
        e: 1 for what happens at the present time (ne,).
        happened: Whether that waits for its transition.
        changed: Whether a transition has changed something at the present time.
        log: As ``Happened.log``, row by row.
    """

    def __init__(self, runner: PlainRunner) -> None:
        self.runner, self.may = runner, runner.may
        self.kinds = np.array(self.may.kinds, dtype=np.intp)
        m = self.m = len(self.kinds)
        self.functions = [runner.model._function(name) for name in self.may.functions]
        self.binding: NDArray[np.bool_] = np.isin(self.kinds, (abi.MODE, abi.IMPACT, abi.END))
        self.marks: NDArray[np.bool_] = self.kinds == abi.MARK
        self.looked: NDArray[np.bool_] = self.kinds != abi.TICK
        self.g, self.e, self._slack, self.reach = (np.zeros(m) for _ in range(4))
        self.close, self.burst = np.zeros(m), np.zeros(m)
        self.last, self.since = np.full(m, -math.inf), np.full(m, -math.inf)
        self.armed = np.zeros(m)
        self.ticks = np.zeros((len(self.may.ticks), 2))  # count, time of the next one
        self.happened = self.changed = False
        self.at_once = 0
        self.log: list[Array] = []

    @property
    def memory(self) -> list[Array]:
        """Everything that a checkpoint holds of this."""
        parts = [self.g, self.e, self._slack, self.reach, self.close, self.burst]
        return [*parts, self.last, self.since, self.armed, self.ticks.reshape(-1)]

    def values(self, t: float, y: Array) -> Array:
        """Values (ne,) of all events.

        Raises:
            Broken: one is not finite, or has no result.
        """
        runner = self.runner
        runner.at(t, y)
        g = np.zeros(self.m)
        if self.functions:
            runner.call(self.functions[0], t, y, g[: self.may.model])
        if self.may.watches:
            g[self.may.model :] = self.may.watch(t, y[: runner.nx].copy())
        bad = np.flatnonzero(~np.isfinite(g))
        if len(bad):
            runner.record.culprit = runner.n + int(bad[0])
            raise Broken(abi.NOT_FINITE)
        return g

    @property
    def slack(self) -> Array:
        """What of every value may be rounding (ne,)."""
        return np.maximum(self._slack, ROUNDING * self.reach)

    def arm(self, g: Array) -> None:
        """Arm the events whose values are clear of zero."""
        self.reach = np.maximum(self.reach, np.abs(g))
        clear = g > self.slack
        self.armed[clear], self._slack[clear] = 1.0, 0.0

    def start(self) -> None:
        """Values at the start, the first ticks, and what happens there already."""
        run = self.runner.record
        for row, tick in zip(self.ticks, self.may.ticks, strict=True):
            period, phase = float(tick["period"]), float(tick["phase"])
            row[0] = math.ceil((run.t - phase) / period - 1e-9)
            row[1] = phase + row[0] * period
            if abs(row[1] - run.t) <= 1e-9 * period:
                row[1] = run.t
        if self.m:
            self.g = self.values(run.t, self.runner.views["y"])
            self._enter()

    def _enter(self) -> None:
        """Events that are negative though nothing has fallen: they happen at once."""
        self.armed[self.binding] = 0.0
        # how far below zero it was counts only if it still is
        self._slack = np.where(self._slack < 0, np.where(self.g < 0, -self._slack, 0), self._slack)
        self.arm(self.g)
        self.e = np.where(self.binding & (self.g < -self.slack), 1.0, 0.0)
        self.happened = bool(self.e.any())

    # ticks

    def until(self, stop: float) -> float:
        """Where a step must end: the stop, or a tick before it."""
        return min([stop, *self.ticks[:, 1].tolist()]) if len(self.ticks) else stop

    def due(self) -> bool:
        """Whether a tick is due at the present time."""
        return bool((self.ticks[:, 1] == self.runner.record.t).any())

    def tick(self) -> bool:
        """Let the ticks of the present time happen; whether there are any."""
        for row, tick in zip(self.ticks, self.may.ticks, strict=True):
            if row[1] == self.runner.record.t:
                self.e[tick["event"]] = 1.0
                self.happened = True
                row[0] += 1
                row[1] = float(tick["phase"]) + row[0] * float(tick["period"])
        return self.happened

    # what happens

    def _note(self, t: float, y: Array) -> Array:
        """A row of the log; what lies behind is yet as before."""
        state = np.concatenate([y[: self.runner.nx], self.runner.views["s"]])
        self.log.append(np.concatenate([[t], self.e, state, state]))
        self.runner.record.log_count = len(self.log)
        return self.log[-1]

    def _chatters(self, i: int) -> bool:
        run = self.runner.record
        span = abs(self.runner.end - run.t_start)
        soon = abs(run.t - self.last[i]) <= CLOSE * max(abs(run.t), span)
        self.close[i] = self.close[i] + 1 if soon or not self.armed[i] else 0
        self.last[i] = run.t
        if not abs(run.t - self.since[i]) <= BURST * span:
            self.since[i], self.burst[i] = run.t, 0
        self.burst[i] += 1
        return bool(self.close[i] > MOST_CLOSE or self.burst[i] > MOST_IN_A_BURST)

    def apply(self) -> bool:
        """The events in ``e`` happen: note them, change what they change, see what follows.

        Returns:
            Whether one of them ends the run.

        Raises:
            Broken: the run cannot go on.
        """
        run, y = self.runner.record, self.runner.views["y"]
        self.happened = False
        self.at_once += 1
        row = self._note(run.t, y)
        fired = np.flatnonzero(self.e)
        for i in fired.tolist():
            run.occurred += 1
            if self.at_once > MOST_AT_ONCE:
                self._blame(i, abi.STORM)
            if self.looked[i] and self.at_once == 1 and self._chatters(i):
                self._blame(i, abi.CHATTER)
            rounding = ROUNDING * self.reach[i]
            left = abs(self.g[i])
            # marked by its sign where nothing has fallen
            self._slack[i] = 2 * left if self.armed[i] else -(left + rounding)
            self.armed[i] = 0.0
        if (self.kinds[fired] <= abi.TICK).any():
            self._change()
        half = self.runner.nx + len(self.runner.views["s"])
        row[-half:] = np.concatenate([y[: self.runner.nx], self.runner.views["s"]])
        self.e[:] = 0.0
        ends = fired[np.isin(self.kinds[fired], (abi.END, abi.HALT))]
        if len(ends):
            run.culprit = self.runner.n + int(ends[-1])
            return True
        self.g = self.values(run.t, y)
        self._enter()
        return False

    def _blame(self, i: int, answer: int) -> None:
        self.runner.record.culprit = self.runner.n + i
        self.e[:] = 0.0
        raise Broken(answer)

    def _change(self) -> None:
        """New u, z and s by the transition of the model, on the constraints."""
        runner = self.runner
        model, run, y = runner.model, runner.record, runner.views["y"]
        runner.at(run.t, y)
        out = np.empty(model.nu + model.nz + model.ns)
        runner.call(self.functions[1], run.t, y, out, self.e[: self.may.model])
        states = model.nu + model.nz
        bad = np.flatnonzero(~np.isfinite(out[:states]))
        if len(bad):
            run.culprit = model.nq + int(bad[0])
            raise Broken(abi.NOT_FINITE)
        y[model.nq : model.nq + states] = out[:states]
        runner.views["s"][:] = out[states:]
        runner.closer.close(run.t, y, noted=True)
        runner.jumped()
        self.changed = True

    # where it happens

    def seek(self, t: float, y: Array, step: Step) -> Step:
        """What happened in a step from t, y; it ends at the first event that is no mark."""
        self.at_once = 0
        if not self.m:
            return step
        inside = Inside(self.runner, t, y, step)
        times, values = samples_of(self, inside)
        for k in range(1, len(times)):
            found = interval(self, inside, times[k - 1 : k + 1], values[k - 1 : k + 1])
            if np.isnan(found).all():
                continue
            event = earliest(found, ~self.marks, inside.sign)
            self._note_marks(inside, found, event)
            if event is not None:
                return self._fire(inside, found, event, times[k - 1], values[k - 1])
        self.g = values[-1]
        self.arm(self.g)
        return step

    def _note_marks(self, inside: Inside, found: Array, event: int | None) -> None:
        """Note the marks up to an event, or all of them."""
        while (mark := earliest(found, self.marks, inside.sign)) is not None:
            t = float(found[mark])
            if event is not None and (t - found[event]) * inside.sign > 0:
                return
            self.e[mark] = 1.0
            self._note(t, inside.at(t))
            self.runner.record.occurred += 1
            self.e[mark] = self.armed[mark] = 0.0
            found[mark] = math.nan

    def _fire(self, inside: Inside, found: Array, event: int, start: float, before: Array) -> Step:
        """The step up to an event; those of the same time happen with it."""
        t = float(found[event])
        same = 8 * inside.resolution(start, t)
        step = inside.cut(t)
        self.g = self.values(t, step.y)
        fall = before - self.g
        together = np.abs(found - t) <= same
        late = np.zeros(self.m, dtype=bool)
        if t != start:
            reached = self.g <= np.maximum(self.slack, fall / abs(t - start) * same)
            late = (self.armed != 0) & (fall > 0) & reached
        self.e = np.where(self.looked & ~self.marks & (together | late), 1.0, 0.0)
        self.happened = True
        return step
