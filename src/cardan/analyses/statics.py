"""Static loading: a system followed through loads that change, in steps that suit it.

Each step starts where the tangent leads, and is halved where Newton's method does not get there or
ends on another branch. What stops it is a limit point or a bifurcation, and is told so: the last
position is kept. Where the path goes on though it is no longer stable, that is told too.

Source: M. A. Crisfield, Non-linear Finite Element Analysis of Solids and Structures 1 (1991),
section 9.5 (automatic increments).
"""

from __future__ import annotations

import warnings
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..errors import ModelError, SolveError, SolveWarning
from .contract import Contract, contract_of
from .equilibrium import DIRECT, WAYS, Equilibrium, missed, read, record
from .following import Crossing, Place, Step, ahead, first
from .loading import TIME, Loading, loading
from .newton import Search, rest
from .standing import stand, words
from .static_path import StaticPath
from .static_problem import Problem

STEPS = 10
GOOD = 5  # iterations after which the next step may be longer
SMALLEST = 2.0**-20
SHORT = 2.0**-6  # steps in which critical loads are passed; of those that are asked for


def statics(
    model: Any,
    swept: Mapping[str, Any] | None = None,
    *,
    steps: int = STEPS,
    q: Mapping[str, ArrayLike] | ArrayLike | None = None,
    hold: Mapping[str, Any] | None = None,
    inputs: Mapping[str, float] | None = None,
    parameters: Mapping[str, float] | None = None,
    t: float = 0.0,
    check: bool = False,
    **named: Any,
) -> StaticPath:
    """Equilibria under loads that change: ``model.statics(P=(0, 10))``.

    Args:
        model: The compiled model.
        swept, named: Parameter or input (or ``t``) -> (start, end), in steps of the program's
            choice, or values (n,), each of which becomes a row. Several go together.
        steps: Rows of a range, more where the way is hard.
        q: Coordinates to start from, by name or (nq,).
        hold: Coordinate -> value that it keeps, or what is swept: displacements are prescribed.
        inputs, parameters: Values by name that stay, else those of the model.
        t: Time [s], where something is prescribed.
        check: Raise where the end is not reached, instead of warning.

    Returns:
        The path as far as it goes. Where it became unstable a warning says so, between which
        loads; ``crossings`` and ``critical()`` tell the places.

    Raises:
        ModelError: unknown names, nothing swept. ArgumentError: values of a wrong shape.
        SolveError: no equilibrium at the start; with ``check``, none further on.
    """
    system = contract_of(model)
    if not isinstance(steps, int) or steps < 1:
        raise ModelError(f"statics: steps={steps!r}: a number of steps, at least 1")
    if not isinstance(hold, Mapping | None) or not isinstance(swept, Mapping | None):
        raise ModelError("statics: hold= and what is swept go by name, such as P=(0, 10)")
    moved = {n: v for n, v in (hold or {}).items() if np.ndim(v) > 0}
    still = {n: v for n, v in (hold or {}).items() if n not in moved}
    base = read(system, still, inputs, parameters, t)
    way = loading(system, _known(model), base, {**(swept or {}), **named}, moved)
    rows, crossed, failure = _follow(model, Problem(system), way, q, steps)
    lost = _lost(system, way, crossed)
    found = StaticPath.of(way, rows, crossed, failure)
    if failure and check:
        raise SolveError(failure)
    for said in filter(None, (lost, failure)):
        warnings.warn(said, SolveWarning, stacklevel=3)
    return found


def _known(model: Any) -> dict[str, str]:
    """What can be swept."""
    return {
        **dict.fromkeys(model.parameters, "parameter"),
        **dict.fromkeys(model.inputs, "input"),
        TIME: "t",
    }


def _follow(
    model: Any, problem: Problem, way: Loading, q: Any, steps: int
) -> tuple[list[tuple[float, Equilibrium]], list[Crossing], str]:
    """Places of the path and equilibria there, critical loads, and why it ended early."""
    load = way.at(0.0)
    start = rest(problem, problem.begin(load, q), load, WAYS)
    if not start.converged:
        raise SolveError(
            f"statics, at the start ({_said(way, 0.0)}): {missed(problem.system, start)}"
        )
    here = first(problem, start, load)
    rows, crossed = [(0.0, record(model, problem, start, load, here.standing))], list[Crossing]()
    for goal in _goals(way, steps):
        length = goal - here.s
        while here.s < goal:
            s = min(goal, here.s + length)
            s = goal if goal - s < 1e-12 else s
            load = way.at(s)
            step = ahead(problem, here, load)
            found = rest(problem, step.point, load, DIRECT)
            shortest = 0.5 * length < SMALLEST / steps
            there = _reached(step, found, way, s, length * steps <= SHORT, shortest)
            if there is not None:
                if step.crosses(there.standing):
                    crossed.append(Crossing(here, there))
                here = there
                length *= 1.5 if found.iterations <= GOOD else 1.0
                if way.stations is None or s == goal:
                    rows.append((s, record(model, problem, found, load, there.standing)))
                continue
            length *= 0.5
            if shortest:
                return rows, crossed, _stopped(problem.system, way, here, found)
    return rows, crossed, ""


def _reached(
    step: Step, found: Search, way: Loading, s: float, short: bool, shortest: bool
) -> Place | None:
    """The place that was found; None where it is none of the path, or the step is too long."""
    if not found.converged or not step.follows(found.point):
        return None
    there = step.reached(s, found, stand(step.problem, found.point, way.at(s)))
    if shortest:
        return there
    # critical loads are passed in short steps, for other branches not to be taken for this one
    if step.crosses(there.standing) and not (short and step.surely(found.point)):
        return None
    return there if step.returns(there, way.at(step.start.s)) else None


def _goals(way: Loading, steps: int) -> Iterator[float]:
    """Places that are reached exactly, in their order."""
    places = np.linspace(0, 1, steps + 1) if way.stations is None else way.stations
    yield from places[1:].tolist()


def _said(way: Loading, s: float) -> str:
    return ", ".join(f"{name} = {value:.6g}" for name, value in way.values(s).items())


def _stopped(system: Contract, way: Loading, last: Place, found: Search) -> str:
    """Where and why a path ended, and what to do."""
    moving = words(system, found.motion)
    where = f", along {moving}" if moving else ""
    beyond, asked = _said(way, last.s), _said(way, 1.0)
    ended = f"no equilibrium next to the last one beyond {beyond} (asked: {asked})"
    if last.standing.loose:
        free = " and ".join(last.standing.loose)
        return (
            f"{ended}: nothing holds {free} there. Begin where loads or springs hold it, or "
            "hold it: hold={'...': value}"
        )
    return (
        f"{ended}: the stiffness gives way there{where} (lowest eigenvalue "
        f"{last.standing.least:.3g} J): a limit point, a bifurcation, or the "
        "end of what the mechanism can reach. The path up to there is kept; go on "
        "with prescribed displacements (hold={'...': (start, end)})"
    )


def _lost(system: Contract, way: Loading, crossed: list[Crossing]) -> str:
    """Where a path that goes on became unstable, and what to do; "" where it did not."""
    lost = next((crossing for crossing in crossed if crossing.lost), None)
    if lost is None:
        return ""
    moving = words(system, lost.direction)
    return (
        f"unstable from a load between {_said(way, lost.before.s)} and {_said(way, lost.after.s)} "
        f"on: the stiffness gives way along {moving}. The path goes on as it began, where the "
        "system would leave it. path.critical() finds the load; a small load aside, or a shape "
        "that is not perfect, leads onto the branch that it takes"
    )
