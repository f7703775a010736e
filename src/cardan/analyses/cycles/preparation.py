"""The start of a search for a cycle: its first lap, and the units of its motion."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from ...arrays import Array
from ...errors import ArgumentError, ModelError, SolveError
from ...runtime.calls.argument_values import numbers
from ..systems.dynamic_system import DynamicSystem
from .cycle_problem import RESOLUTION, CycleProblem, CycleState
from .named_states import blocks_of
from .section import section_of

SMALL = 1e-6  # ranges that are nothing beside the largest of their kind
SHIFTS = (0.377, 1.913, 4.111)  # of time, in periods or [s]: forces that it drives would differ
MEMORY = 1e-11  # of units: what does not depend on a sample
DRIVEN = 1e-9  # relative difference of rates there


def first_state(
    system: DynamicSystem, problem: CycleProblem, start: object, values: Array
) -> CycleState:
    """The state that a caller names, with all loops closed.

    Args:
        system, problem: Whose.
        start: Values by name, a state (nx,), or an object with one.
        values: Inputs (nr,).

    Raises:
        ModelError: an unknown name. ArgumentError: a wrong shape.
    """
    named = isinstance(start, Mapping)
    blocks = blocks_of(problem.model, start if isinstance(start, Mapping) else {})
    x0 = None if named else numbers("cycle: start", start)
    if x0 is not None and x0.shape != (problem.model.nx,):
        raise ArgumentError(
            f"cycle: start has shape {x0.shape}, expected ({problem.model.nx},), or values by name"
        )
    q, u, z = (blocks[letter] or None for letter in "quz")
    at = system.state(x0, q, u, z, problem.t, values, None)
    return CycleState(np.concatenate([at.q, at.u, at.z]), system.modes, 0.0)


def refuse_forcing(problem: CycleProblem, at: CycleState) -> None:
    """Refuse laps after which what time drives is not the same again.

    Raises:
        ModelError: time drives the motion and there is no period, or one that forces do not have.
    """
    if problem.symmetry is not None and problem.period is not None:
        return
    free, period = problem.period is None, problem.period_of(at)
    for share in SHIFTS:
        t = problem.t + (0.0 if free else share * period)
        rate = problem.rate(at, t)
        off = np.abs(problem.rate(at, t + (share if free else period)) - rate).max(initial=0.0)
        forced = off > DRIVEN * np.abs(rate).max(initial=0.0)
        if free and (forced or any(callable(value) for value in problem.inputs.values())):
            raise ModelError(
                f"cycle: time drives '{problem.model.name}': give period=, that of what forces it "
                "or a multiple"
            )
        if forced:
            raise ModelError(
                f"cycle: period={period:.10g}: what forces '{problem.model.name}' at known times "
                "does not have this period"
            )


def refuse_memory(problem: CycleProblem, at: CycleState) -> None:
    """Refuse values that controllers hold from lap to lap: they are not unknowns.

    Raises:
        ModelError: a lap depends on them.
    """
    sampled = np.array([not row.labels for row in problem.model.manifest.s], dtype=bool)
    if not sampled.any():
        return
    changed = replace(at, s=np.where(sampled, at.s + 1e-3 * (1 + np.abs(at.s)), at.s))
    off = problem.step(problem.lap(at).x, problem.lap(changed).x)
    if np.abs(off).max(initial=0.0) > MEMORY:
        names = [name for name, one in zip(problem.model.mode_names, sampled, strict=True) if one]
        raise ModelError(
            f"cycle: a lap depends on what controllers hold before it ({', '.join(names)}). Begin "
            "it at a sample, by t=, and let their states be continuous"
        )


def prepared(
    problem: CycleProblem, at: CycleState, guess: float | None, settle: int
) -> tuple[CycleProblem, CycleState]:
    """The problem in units of the motion, and the start of its first lap.

    Args:
        problem: In any units.
        at: The start.
        guess: Of a free period [s].
        settle: Laps to run first.

    Raises:
        SolveError: a lap breaks down, or does not come to an end.
    """
    if problem.free_period:
        period = guess if guess is not None else first_return(problem, at)
        at = replace(at, period=period * (1 if guess is not None else problem.laps))
    for _ in range(settle):
        at = replace(problem.lap(at), period=at.period)
    lap = problem.lap(at)
    at = replace(at, s=lap.s, period=lap.period)
    return scaled(problem, at)


def scaled(problem: CycleProblem, at: CycleState) -> tuple[CycleProblem, CycleState]:
    """The problem in units of the motion of a lap, and its start on the section if it lies there.

    Raises:
        SolveError: the lap breaks down.
    """
    problem = replace(problem, units=units_of(problem, at))
    behind = replace(at, x=problem.lap(at).x)
    problem = replace(problem, normal=problem.normal_of(behind))
    return problem, replace(at, x=problem.on_section(at))


def first_return(problem: CycleProblem, at: CycleState) -> float:
    """Time [s] until the motion comes back to the plane across it.

    Raises:
        SolveError: the start is at rest, or nothing comes back.
    """
    rate = problem.rate(at)
    if not np.any(rate):
        raise SolveError("cycle: the start is at rest; begin at a state that moves")

    def ahead(t: float, x: Array) -> float:
        return float(rate @ problem.step(at.x, problem.mapped(x)))

    section = section_of(problem.model, (ahead, "up"), None, 1)
    returning = replace(problem, section=section, symmetry=None, laps=1, _flows={})
    match = section.counter(problem.t, RESOLUTION * problem.longest)
    end = problem.t + problem.longest
    passage = returning.flow(at.values).passage(at.x, at.s, problem.t, end, match)
    if passage is None:
        raise SolveError(
            f"cycle: the motion does not come back within {problem.longest:g} s; give guess= [s], "
            "or longest="
        )
    return passage.t - problem.t


def units_of(problem: CycleProblem, at: CycleState) -> Array:
    """Ranges of the motion over a lap (n,), those of one kind together."""
    motion = problem.motion(at)
    steps = np.array([problem.step(at.x, x) for x in motion.x]) * problem.units
    ranges, nu = np.ptp(steps, axis=0), problem.model.nu
    kinds = [str(row.unit) for row in problem.model.manifest.speeds]
    labels = [f"q{kind}" for kind in kinds] + [f"u{kind}" for kind in kinds]
    labels += [f"z{k}" for k in range(len(ranges) - 2 * nu)]
    largest = dict.fromkeys(labels, 0.0)
    for label, size in zip(labels, ranges.tolist(), strict=True):
        largest[label] = max(largest[label], size)
    units = np.array([largest[label] for label in labels])
    return np.asarray(np.where(units > SMALL * problem.units, units, problem.units))
