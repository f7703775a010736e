"""Newton's method for a start that a lap leads back to."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from ...arrays import Array
from ...errors import CardanError, SolveError
from ...records import dataclass
from ..systems.central_differences import by_differences
from .cycle_problem import CycleProblem, CycleState
from .lap_derivative import WIDE, LapDerivative, Sweep, lap_derivative, refusal

NEWTON, HALVINGS = 30, 8
ROUGH = 1e-5  # increments of differences that steer Newton's method
FINE = 0.02  # of the steps that differences take: runs bend more than forces do
CHORD = 1e-6  # residuals below which the derivative of a lap stays as it is
ROUNDING, CLOSED = 1e-9, 1e-13  # residuals of cycles, and those that are enough
ELSEWHERE = 0.5  # of the distance from rest: what is missed of no cycle
SINGULAR = 1e-9  # of the largest singular value: directions along which cycles form families


@dataclass(frozen=True, eq=False)
class Phase:
    """The place on a cycle of free period at which it starts: a plane across the flow.

    Attributes:
        x: A state (nx,) of the plane.
        normal: Across it (n,).
    """

    x: Array
    normal: Array


@dataclass(frozen=True, eq=False)
class Shooting:
    """The residual of a start and its derivatives.

    Attributes:
        problem: Of what.
        phase: The place at which cycles of free period start; None of others.
    """

    problem: CycleProblem
    phase: Phase | None

    @classmethod
    def of(cls, problem: CycleProblem, at: CycleState) -> Shooting:
        """Equations of cycles near to a start.

        Raises:
            SolveError: nothing moves there.
        """
        if not problem.free_period:
            return cls(problem, None)
        rate = problem.rate(at)
        size = float(np.linalg.norm(rate))
        if not size > 0:
            raise SolveError("cycle: the start is at rest; start= from a state that moves")
        return cls(problem, Phase(at.x, rate / size))

    @property
    def fine(self) -> float:
        """Increments that differences take; those of a mode have the units of large motions."""
        return FINE if self.problem.level is None else 0.25 * FINE

    def residual(self, at: CycleState) -> Array:
        """What a lap misses its start by (n,), and the distance from the phase.

        Raises:
            SolveError: the lap breaks down.
        """
        problem = self.problem
        if problem.level is None:
            missed = problem.step(at.x, problem.lap(at).x)
        else:
            begun = problem.closed(at)
            missed = problem.step(at.x, begun.x) + self._missed_at_energy(begun)
        if self.phase is None:
            return missed
        off = float(self.phase.normal @ problem.step(self.phase.x, at.x))
        return np.append(missed, off)

    def _missed_at_energy(self, at: CycleState) -> Array:
        """What a lap misses its start by, and along the gradient of the energy what that is off.

        Energy is kept: along its gradient nothing is missed where the rest is not.
        """
        missed, along = self.problem.step(at.x, self.problem.lap(at).x), self.problem.uphill(at)
        off = float(along @ missed)
        if abs(off) > ELSEWHERE * self.problem.amplitude(at):
            raise SolveError("cycle: a lap leads to another state of the same energy")
        return missed + along * (self.problem.energy_off(at) - off)

    def moved(self, at: CycleState, dz: Array) -> CycleState:
        """The start an increment (n,), or (n + 1,) with the part that the period grows by, away."""
        n = len(self.problem.units)
        period = at.period * (1 + float(dz[n])) if self.problem.free_period else at.period
        return replace(at, x=self.problem.moved(at.x, dz[:n]), period=period)

    def jacobian(self, at: CycleState) -> Array:
        """Derivative of the residual.

        Raises:
            SolveError: a lap breaks down.
        """
        count = len(self.problem.units) + self.problem.free_period
        return self.derivative(at, lambda dz: self.residual(self.moved(at, dz)), count)

    def derivative(
        self,
        at: CycleState,
        residual: Callable[[Array], Array],
        count: int,
        rough: bool = False,
        values: Sweep | None = None,
    ) -> Array:
        """Derivative of residuals: by a sweep over a lap, or by central differences of runs.

        Args:
            at: The start.
            residual: Of increments (count,) from there, those of the start first.
            count: Number of increments.
            rough: Differences of second order, by half of the laps.
            values: What is swept by the last of the increments; None where nothing is.

        Raises:
            SolveError: a lap breaks down.
        """
        reasons = self.problem.reasons
        # the last derivative tells where those of a cycle come from
        reasons[:] = [text for text in [refusal(self.problem)] if text]
        if not reasons:
            try:
                return self._exact(at, lap_derivative(self.problem, at, values), values)
            except CardanError as error:
                reasons[:] = [str(error)]
        return self._by_differences(at, residual, count, rough)

    def _exact(self, at: CycleState, lap: LapDerivative, values: Sweep | None) -> Array:
        """Derivative of the residual from that of a lap."""
        problem = self.problem
        by_begun, by_end = _of_step(problem, lap.begun.x, lap.end.x)
        if problem.level is None:
            columns = [by_begun + by_end @ lap.by_start]
            if problem.free_period:
                columns.append(by_end @ lap.by_period[:, None])
            if values is not None:
                columns.append(by_end @ lap.by_value[:, None])
            J = np.hstack(columns)
        else:
            J = self._exact_at_energy(at, lap, values, by_begun, by_end)
        if self.phase is None:
            return J
        row = np.zeros(J.shape[1])
        row[: len(J)] = self.phase.normal @ _of_step(problem, self.phase.x, at.x)[1]
        return np.vstack([J, row])

    def _exact_at_energy(
        self,
        at: CycleState,
        lap: LapDerivative,
        values: Sweep | None,
        by_begun: Array,
        by_end: Array,
    ) -> Array:
        """The same where energy is kept; the direction of its gradient counts as fixed."""
        problem, begun, level = self.problem, lap.begun, self.problem.level
        assert level is not None
        flow, n = problem.flow(at.values), len(problem.units)
        # the start brought onto constraints, what a lap misses, the energy along its slope
        slope = level.gradient(problem.system, flow, begun.x, problem.t) * problem.units
        columns = [by_begun @ lap.onto + by_end @ lap.by_start]
        moved, energy = [lap.onto - np.eye(n)], [slope / level.size @ lap.onto]
        if problem.free_period:
            columns.append(by_end @ lap.by_period[:, None])
            moved.append(np.zeros((n, 1)))
            energy.append(np.zeros(1))
        if values is not None:
            swept = values

            def off(ds: Array) -> Array:
                there = problem.closed(replace(at, values=swept(float(ds[0]))))
                return np.array([problem.energy_off(there)])

            shift = lap.begun_by_value[:, None]
            columns.append(by_begun @ shift + by_end @ lap.by_value[:, None])
            moved.append(shift)
            energy.append(by_differences(off, np.full(1, FINE))[0])
        missed, along = np.hstack(columns), problem.uphill(begun)
        return np.hstack(moved) + missed + np.outer(along, np.concatenate(energy) - along @ missed)

    def _by_differences(
        self, at: CycleState, residual: Callable[[Array], Array], count: int, rough: bool
    ) -> Array:
        """Derivative of residuals by central differences of runs.

        Raises:
            SolveError: a lap breaks down.
        """
        allowed = self.problem.allowed(at)
        if allowed is None:
            return _differences(residual, np.eye(count), self.fine, rough)
        n, (ways, parts) = len(self.problem.units), allowed
        d = ways.shape[1]
        steps = np.zeros((count, d + count - n))
        steps[:n, :d], steps[n:, d:] = ways, np.eye(count - n)
        columns = _differences(residual, steps, self.fine, rough)
        # what leads off the constraints is taken away before the lap begins
        off = np.eye(n) - ways @ parts
        states = columns[:, :d] @ parts
        states[:n] -= off
        if self.phase is not None:
            states[n] += self.phase.normal @ off
        return np.concatenate([states, columns[:, d:]], axis=1)


def _of_step(problem: CycleProblem, before: Array, after: Array) -> tuple[Array, Array]:
    """Derivatives (n, n) of the step between two states, by increments of both."""
    n, system = len(problem.units), problem.system
    by_before, by_after = -np.eye(n), np.eye(n)
    names = enumerate(system.increments)
    rotations = np.array([k for k, name in names if name not in system.coordinates], dtype=np.intp)
    if len(rotations):
        units = np.full(n, WIDE)
        by_before[:, rotations] = by_differences(
            lambda dx: problem.step(problem.moved(before, dx), after), units, rotations
        )
        by_after[:, rotations] = by_differences(
            lambda dx: problem.step(before, problem.moved(after, dx)), units, rotations
        )
    return by_before, by_after


def _differences(
    residual: Callable[[Array], Array], steps: Array, fine: float, rough: bool
) -> Array:
    """Derivatives of residuals along steps (count, k)."""
    if not rough:
        units = np.full(steps.shape[1], fine)
        return by_differences(lambda share: residual(steps @ share), units)
    sides = [residual(ROUGH * step) - residual(-ROUGH * step) for step in steps.T]
    return np.stack(sides, axis=1) / (2 * ROUGH)


@dataclass(frozen=True, eq=False)
class Solved:
    """The end of a search.

    Attributes:
        at: The start of a lap.
        residuals: Largest ones, iteration by iteration.
        converged: Whether it is a cycle.
    """

    at: CycleState
    residuals: tuple[float, ...]
    converged: bool


def solve(shooting: Shooting, start: CycleState) -> Solved:
    """The cycle next to a start, by Newton's method with steps that are halved.

    Raises:
        SolveError: the first lap breaks down.
    """
    at, left = start, shooting.residual(start)
    sizes: list[float] = [_size(left)]
    J: Array | None = None
    for _ in range(NEWTON):
        if J is None or sizes[-1] > CHORD:
            J = shooting.jacobian(at)
        dz = np.asarray(np.linalg.lstsq(J, -left, SINGULAR)[0], dtype=np.float64)
        step = _halved(shooting, at, dz, sizes[-1])
        if step is None:
            break
        at, left = step
        sizes.append(_size(left))
        if sizes[-1] < CLOSED or (sizes[-1] < CHORD and sizes[-1] > 0.1 * sizes[-2]):
            break
    s = shooting.problem.lap(at).s
    settled = bool((s == at.s).all())
    if not settled:
        # what a controller holds is set anew where a lap begins
        again = replace(at, s=s)
        after = shooting.problem.lap(again).s
        close = np.abs(after - s) <= ROUNDING * (1 + np.abs(s))
        settled = bool(close.all()) and _size(shooting.residual(again)) <= ROUNDING
        at = again if settled else at
    period = at.period if shooting.problem.free_period else shooting.problem.lap(at).period
    at = replace(at, x=shooting.problem.on_section(at), period=period)
    return Solved(at, tuple(sizes), sizes[-1] <= ROUNDING and settled)


def _size(left: Array) -> float:
    return float(np.abs(left).max(initial=0.0))


def _halved(
    shooting: Shooting, at: CycleState, dz: Array, before: float
) -> tuple[CycleState, Array] | None:
    """The start behind a step that leaves less, halved until it does; None where none does."""
    share = min(1.0, 1.0 / max(float(np.abs(dz).max(initial=0.0)), 1e-300))
    for _ in range(HALVINGS):
        there = shooting.moved(at, share * dz)
        try:
            left = shooting.residual(there)
        except SolveError:
            left = np.full(1, np.inf)
        if _size(left) < before * (1 - 0.1 * share):
            return there, left
        share *= 0.5
    return None
