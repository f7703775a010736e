"""``model.cycle``: motions that repeat, and how stable they are."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from ...arguments import Count, checked
from ...errors import ModelError, SolveError, SolveWarning, counted, warn
from ...runtime.models.loaded_model import LoadedModel
from ..simulation.settings import settings, watched
from ..simulation.signals import signals
from ..systems import dynamic_system_of
from .cycle_problem import CycleProblem, CycleState
from .cycle_record import CycleRecord, record_of
from .multipliers import monodromy, multipliers_of
from .named_states import symmetry_map
from .period import period_rule
from .preparation import first_state, prepared, refuse_forcing, refuse_memory, scaled
from .section import section_of
from .shooting import Shooting, Solved, solve

LONGEST = 100.0


@checked
def cycle(
    model: LoadedModel,
    start: Mapping[str, ArrayLike] | ArrayLike,
    *,
    period: object = None,
    section: object = None,
    where: object = None,
    crossing: Count = 1,
    symmetry: object = None,
    laps: Count = 1,
    settle: int = 0,
    guess: float | None = None,
    inputs: Mapping[str, object] | None = None,
    parameters: Mapping[str, float] | None = None,
    t: float = 0.0,
    longest: float = LONGEST,
    method: str = "DOP853",
    rtol: float = 1e-13,
    atol: float = 1e-15,
    check: bool = False,
) -> CycleRecord:
    """A motion that repeats, next to a start: ``model.cycle({"x": 1.0}, period=2 * np.pi / 1.4)``.

    A lap ends after ``period``, where something forces the motion at known times; at the event
    ``section``; or where it comes back, with an unknown period. Laps run through events and
    impacts.

    Args:
        model: The compiled model.
        start: State to begin the search with, by name (others as in ``simulate``), or (nx,).
        period: Of a lap [s]; a function of the parameters and inputs by name, or a SymPy expression
            in parameters. None: unknown, or that of the section.
        section: The event that ends a lap: its name, or what ``events=`` of ``simulate`` takes such
            as ``("elbow", 0.5)``, with a direction ``(("elbow", 0.5), "up")``.
        where: What must hold before that event: name -> (low, high), or a function of the named
            state that returns True.
        crossing: Which of the events that fulfill it ends a lap, counted from 1.
        symmetry: What the state behind a lap becomes: name -> the name whose value it takes,
            ``(name, factor)`` or ``(name, factor, shift)``, speeds along with coordinates,
            exchanged where named once; or a function of the named state that returns what changes.
        laps: After how many laps the motion repeats.
        settle: Laps to run before the search, by which a stable cycle is approached.
        guess: Of an unknown period [s]; by default that of the first return.
        inputs: Constants, or functions f(t, x) with the period, by name.
        parameters: Values by name, else those of the model.
        t: Time at which laps begin [s]; of laps that time ends not that of an impact.
        longest: Time within which a lap must end [s].
        method, rtol, atol: Of the runs; ``cycle.derivatives`` says whether those are exact.
        check: Raise where no cycle is reached, instead of warning.

    Returns:
        The cycle, with its multipliers and its motion.

    Raises:
        ModelError: unknown names, a period besides a section, laps of a model that time drives
            without a period. ArgumentError: wrong shapes.
        SolveError: the first lap breaks down or does not end; with ``check``, no cycle.

    Source: R. Seydel, Practical Bifurcation and Stability Analysis (2010), chapter 7; P. Holmes,
    R. J. Full, D. Koditschek, J. Guckenheimer, SIAM Review 48 (2006), 207-304 (return maps).
    """
    if period is not None and section is not None:
        raise ModelError("cycle: period= and section= both end a lap: leave one out")
    model = model if parameters is None else model.with_parameters(parameters)
    system = dynamic_system_of(model)
    forcing = signals(model.manifest.inputs, inputs, None, (t, t))
    units = np.concatenate([system.columns, system.columns, np.ones(model.nz)])
    end = None if section is None else section_of(model, section, where, crossing)
    mirror = None if symmetry is None else symmetry_map(system, model, symmetry)
    problem = CycleProblem(
        model, system, settings(method, rtol, atol, None, None, None), dict(inputs or {}), t,
        longest, end, period_rule(model, period), mirror, laps, units,
    )  # fmt: skip
    span = longest if period is None else problem.period_of(CycleState(units, units, longest))
    problem = replace(problem, how=watched(problem.how, forcing, span, None))
    at = first_state(system, problem, start, forcing.first(t))
    refuse_forcing(problem, at)
    problem, at = prepared(problem, at, guess, settle)
    refuse_memory(problem, at)
    return _checked(recorded(problem, solve(Shooting.of(problem, at), at)), check)


def _checked(record: CycleRecord, check: bool) -> CycleRecord:
    """The cycle, with a warning where none was reached.

    Raises:
        SolveError: none was, with ``check``.
    """
    if not record.converged:
        if check:
            raise SolveError(f"cycle: {record.message}")
        warn(f"cycle of '{record.model.name}': {record.message}", SolveWarning)
    return record


def recorded(problem: CycleProblem, solution: Solved) -> CycleRecord:
    """The cycle at the end of a search."""
    at, n = solution.at, len(problem.units)
    if solution.converged:
        # the search may have begun at a motion of another size
        problem, at = scaled(problem, at)
    DP = Shooting.of(problem, at).jacobian(at)[:n, :n] + np.eye(n)
    along = problem.rate(at) if problem.free_period else None
    values = multipliers_of(monodromy(DP, along), problem.lost(at))
    message = f"a cycle, reached in {counted(len(solution.residuals) - 1, 'iteration')}"
    if not solution.converged:
        history = ", ".join(f"{size:.2g}" for size in solution.residuals)
        message = (
            f"no cycle was reached: laps miss their starts by {history}. Begin nearer to one: "
            "start= from a settled motion, settle= laps, or guess= of the period"
        )
    return record_of(problem, at, values, solution.residuals, solution.converged, message)
