"""Where branches meet ahead of a run without a compiler: what ``kernels/hold.c`` does."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..runtime.closing import columns_of
from .plain_methods import Broken

if TYPE_CHECKING:
    from .plain import PlainRunner

Array = NDArray[np.float64]
# as in hold.c, which says what they are
TAKEN, LOST, BESIDE, MEETING, NEAR = 1e-3, 1e-4, 0.02, 0.1, 0.15
ROUNDING, AHEAD, STRIDE = 2e-16, 1.3, 0.25
HALVINGS, MOST_LOOKS = 10, 12
SPEEDS = 1e-14  # ROUNDING of derivative.c


def _number(k: int) -> Any:
    """Entry k of what a checkpoint keeps."""

    def get(hold: PlainHold) -> float:
        return float(hold.numbers[k])

    def put(hold: PlainHold, value: float) -> None:
        hold.numbers[k] = value

    return property(get, put)


class PlainHold:
    """How well the constraints of a run hold its motion.

    Attributes:
        hold, best: The hold at the last state that was looked at, and at best.
        ranks: How often the number of constraints that hold has changed.
    """

    hold, best, t_old, ranks = _number(0), _number(1), _number(2), _number(3)

    @property
    def held(self) -> int:
        """How many constraints hold."""
        return int(self.numbers[4])

    @held.setter
    def held(self, count: int) -> None:
        self.numbers[4] = count

    def __init__(self, runner: PlainRunner) -> None:
        self.runner, closing = runner, runner.closer.closing
        self.units = columns_of(runner.model, closing.size)
        self.function = runner.closer.functions.get("constraint_jacobian")
        self.lengths = np.zeros(closing.rates)
        self.order = np.arange(closing.rates)
        self.here = np.zeros((closing.rates, len(self.units)))
        self.numbers = np.zeros(5)
        self.f, self.old = runner.views["y"], runner.views["y"].copy()

    def _rows(self, t: float, y: Array, taken: bool) -> Array:
        """Rows of G (m, nu) at t, y (n,), without units."""
        assert self.function is not None
        rows = np.empty(self.here.size)
        self.runner.at(t, y)
        self.runner.call(self.function, t, y, rows)
        rows = rows.reshape(self.here.shape) * self.units
        if taken:
            self.lengths[:] = np.maximum(self.lengths, np.linalg.norm(rows, axis=1))
        result: Array = rows / np.where(self.lengths > 0, self.lengths, 1.0)[:, None]
        return result

    def _orthogonalize(self, rows: Array, anew: bool, taken: bool) -> float:
        """Take from rows (m, nu), in place, what those before them in the order have."""
        hold = 0.0
        for k in range(len(rows)):
            if anew:
                rest = np.linalg.norm(rows[self.order[k:]], axis=1)
                best = k + int(np.argmax(rest))
                self.order[[k, best]] = self.order[[best, k]]
            row = rows[self.order[k]]
            square = float(row @ row)
            if taken and k >= self.held and square > TAKEN**2:
                self.held, self.ranks = k + 1, self.ranks + 1
            if k >= self.held:
                break
            hold = math.sqrt(square)
            if square > 0:
                others = self.order[k + 1 :]
                rows[others] -= np.outer(rows[others] @ row / square, row)
        return hold

    def _ahead(self, tau: float) -> Array:
        """The state at t + tau: on with the present slope, bent as the last step was."""
        run, y = self.runner.record, self.runner.views["y"]
        h = run.t - self.t_old
        bend = (self.f - (y - self.old) / h) / h if h else 0.0
        ahead: Array = y + tau * (self.f + tau * bend)
        self.runner.normalize(ahead)
        return ahead

    def _hold_at(self, tau: float) -> float:
        y = self._ahead(tau) if tau else self.runner.views["y"]
        self.here = self._rows(self.runner.record.t + tau, y, tau == 0)
        return self._orthogonalize(self.here, True, tau == 0)

    def _turned(self, tau: float) -> bool:
        """Whether what is left of a row has turned round since the last reference."""
        there = self._rows(self.runner.record.t + tau, self._ahead(tau), False)
        self._orthogonalize(there, False, False)
        kept = self.order[: self.held]
        return bool((np.einsum("ij,ij->i", self.here[kept], there[kept]) < 0).any())

    def beside(self, t: float, y: Array, kept: bool) -> bool:
        """Whether branches meet so near that a projection brings in more than it mends."""
        hold = self._orthogonalize(self._rows(t, y, False), True, False)
        rough = math.sqrt(ROUNDING / self.finest())
        return not hold > min(rough, BESIDE * self.best if kept else 1.0)

    def finest(self) -> float:
        """The smallest tolerance of a speed, relative to the fastest."""
        how, model = self.runner.settings, self.runner.model
        u = np.abs(self.runner.views["y"][model.nq : model.nq + model.nu])
        fastest = float(u.max(initial=0.0))
        return (how.atol + how.rtol * float(u.min())) / fastest if fastest > 0 else 1.0

    def pace(self, tau: float = 0.0) -> float:
        """How fast the state moves now or at t + tau [rad/s, sizes/s]."""
        nq, nu = self.runner.model.nq, self.runner.model.nu
        now = self.runner.views["y"][nq : nq + nu]
        then = now + tau * self.f[nq : nq + nu]
        return float((np.maximum(np.abs(now), np.abs(then)) / self.units).max(initial=0.0))

    def bearable(self) -> float:
        """How much a projection may change, in tolerances: 1, or what rounding makes of it."""
        return max(1.0, SPEEDS / self.hold**2 / self.finest()) if self.hold > 0 else 1.0

    @property
    def memory(self) -> list[NDArray[Any]]:
        """What a checkpoint keeps."""
        return [self.numbers, self.lengths, self.order, self.old]

    def begin(self, left: float) -> None:
        """The hold before the first step: rows that hold a little later count too."""
        run, y = self.runner.record, self.runner.views["y"]
        self.f, self.old[:], self.t_old = self.runner.derivative(run.t, y), y, run.t
        self.hold = self._hold_at(0.0)
        tau = math.copysign(min(0.1 * STRIDE / max(self.pace(), 1e-300), abs(left)), left)
        ahead = self._ahead(tau)
        try:
            self.runner.closer.close(run.t + tau, ahead, noted=False)
            rows = self._rows(run.t + tau, ahead, True)
            self.best = self._orthogonalize(rows, True, True)
        except Broken:
            self.best = 0.0
        self.hold = self._hold_at(0.0)
        self.best, self.ranks = max(self.best, self.hold), 0

    def meeting(self, left: float, h: float) -> float | None:
        """Time until branches meet, about as far ahead as a step or two lead; None: they do not.

        Args:
            left: Time to the next stop.
            h: The next step.
        """
        reach = AHEAD * min(h, abs(left))
        v, before = self.pace(math.copysign(reach, left)), self.hold
        if v == 0:
            return None
        self.hold = last = self._hold_at(0.0)
        self.best = max(self.best, last)
        if last < LOST * self.best:
            return 0.0
        since = abs(self.runner.record.t - self.t_old)
        falling = (last - before) / since if since else 0.0
        if last + falling * reach - 0.5 * self.best * (v * reach) ** 2 > NEAR * self.best:
            return None
        return self._search(reach, v, last, math.copysign(1.0, left))

    def _search(self, reach: float, v: float, last: float, sign: float) -> float | None:
        """Look stride by stride for a row that turns round where little is left of it."""
        near, start = self.hold <= NEAR * self.best, 0.0
        for _ in range(MOST_LOOKS):
            to = start + STRIDE / v
            if to > reach and not near:
                if start >= reach:
                    return None
                to = reach
            if self._turned(sign * to):
                low, high = start, to
                for _ in range(HALVINGS):
                    middle = 0.5 * (low + high)
                    low, high = (low, middle) if self._turned(sign * middle) else (middle, high)
                tau = sign * 0.5 * (low + high)
                if self._hold_at(tau) < MEETING * self.best:
                    return tau
            hold = self._hold_at(sign * to)
            if to >= reach and not hold < last:
                return None
            start, last = to, hold
        return None
