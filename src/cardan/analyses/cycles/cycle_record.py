"""Cycles as users take them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from functools import cached_property

import numpy as np

from ...arrays import Array
from ...records import dataclass
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.trajectory.trajectory import TrajectoryRecord
from ..systems.dynamic_system import NamedState
from .cycle_problem import CycleProblem, CycleState
from .multipliers import Complexes, unstable
from .named_states import named_state

MAX_PRINTED = 8


@dataclass(frozen=True, repr=False, eq=False)
class CycleRecord(NamedState):
    """A motion that repeats; ``cycle["elbow"]`` is an entry of the state at its start.

    ``cycle.model.simulate(cycle.period, x0=cycle)`` runs it; ``model.continuation(..., of="cycles",
    start=cycle)`` follows it as parameters change.

    Attributes:
        model: The model, with the parameters of the cycle.
        x: State [q, u, z] (nx,) at its start: behind the section, at ``t`` of laps that time ends.
        modes: Discrete states of elements (ns,) there.
        period: Until it repeats, up to its symmetry [s].
        multipliers: Growth of small disturbances from lap to lap (m,), complex, the largest first.
            That along the motion itself, 1, is left out of cycles whose period is free.
        residual: What is left, in units of the motion.
        residuals: The same, iteration by iteration.
        iterations: Linear systems solved.
        converged: Whether it is a cycle.
        message: The same as a sentence.
        values: Parameters and inputs that were swept, by name.
        derivatives: Where those of a lap come from: "exact", by a sweep over its steps, or
            "differences of runs: " and why.
        problem, at: For analyses that go on from here.
    """

    model: LoadedModel
    x: Array
    modes: Array
    period: float
    multipliers: Complexes
    residual: float
    residuals: tuple[float, ...]
    iterations: int
    converged: bool
    message: str
    values: Mapping[str, float]
    derivatives: str
    problem: CycleProblem = field(repr=False)
    at: CycleState = field(repr=False)

    @property
    def state(self) -> dict[str, float]:
        """Coordinates, speeds and internal states at its start, by name."""
        return named_state(self.model, self.x)

    @property
    def named(self) -> dict[str, float]:
        """The same."""
        return self.state

    @property
    def n_unstable(self) -> int:
        """Number of multipliers outside of the unit circle."""
        return unstable(self.multipliers)

    @property
    def stable(self) -> bool:
        """True when no small disturbance grows from lap to lap."""
        return self.n_unstable == 0

    @cached_property
    def motion(self) -> TrajectoryRecord:
        """The motion over a period; with a symmetry over one lap."""
        return self.problem.motion(self.at)

    def __repr__(self) -> str:
        state = ", ".join(f"{name} = {value:.10g}" for name, value in self.state.items())
        values_text = ", ".join(_written(one) for one in self.multipliers[:MAX_PRINTED])
        more = ", ..." if len(self.multipliers) > MAX_PRINTED else ""
        values = "".join(f", {name} = {value:.10g}" for name, value in self.values.items())
        return (
            f"cycle of '{self.model.name}'{values}: {self.message}\n"
            f"  period {self.period:.12g} s, {'stable' if self.stable else 'unstable'}\n"
            f"  {state}\n"
            f"  multipliers {values_text}{more}\n"
            f"  derivatives of laps: {self.derivatives}"
        )


def _written(value: complex) -> str:
    """A multiplier."""
    if abs(value.imag) <= 1e-12 * max(1.0, abs(value)):
        return f"{value.real:.8g}"
    return f"{value.real:.8g}{value.imag:+.8g}i"


def record_of(
    problem: CycleProblem,
    at: CycleState,
    multipliers: Complexes,
    residuals: tuple[float, ...],
    converged: bool,
    message: str,
) -> CycleRecord:
    """The record of a cycle."""
    model = problem.flow(at.values).model
    reasons = "; ".join(problem.reasons)
    derivatives = f"differences of runs: {reasons}" if reasons else "exact"
    return CycleRecord(
        model, at.x, at.s, at.period, multipliers, residuals[-1] if residuals else np.nan,
        residuals, max(0, len(residuals) - 1), converged, message, dict(at.values),
        derivatives, problem, at,
    )  # fmt: skip
