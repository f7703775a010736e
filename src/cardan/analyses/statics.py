"""Static loading: a system followed through loads that change, in steps that suit it.

Each step starts where the last ones lead, and is halved where Newton's method does not get there.
What stops it is a limit point or a bifurcation, and is told so: the last position is kept.

Source: M. A. Crisfield, Non-linear Finite Element Analysis of Solids and Structures 1 (1991),
section 9.5 (automatic increments).
"""

from __future__ import annotations

import warnings
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import ModelError, SolveError, SolveWarning
from .contract import Contract, contract_of
from .equilibrium import DIRECT, WAYS, Equilibrium, missed, read, record
from .loading import TIME, Loading, loading
from .newton import Search, rest
from .saddle import Singular
from .standing import words
from .static_path import StaticPath
from .static_problem import Load, Point, Problem

Array = NDArray[np.float64]
STEPS = 10
GOOD = 5  # iterations after which the next step may be longer
SMALLEST = 2.0**-14
# corrections above this part of the reach and this multiple of the step lead to another branch
JUMP, AHEAD = 0.1, 2.0


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
        The path as far as it goes.

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
    rows, failure = _follow(model, Problem(system), way, q, steps)
    found = StaticPath.of(way, rows, failure)
    if failure:
        if check:
            raise SolveError(failure)
        warnings.warn(failure, SolveWarning, stacklevel=3)
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
) -> tuple[list[tuple[float, Equilibrium]], str]:
    """Places of the path and equilibria there, and why it ended early."""
    load = way.at(0.0)
    start = rest(problem, problem.begin(load, q), load, WAYS)
    if not start.converged:
        raise SolveError(
            f"statics, at the start ({_said(way, 0.0)}): {missed(problem.system, start)}"
        )
    rows = [(0.0, record(model, problem, start, load))]
    track = [(0.0, start.point)]
    for goal in _goals(way, steps):
        length = goal - track[-1][0]
        while track[-1][0] < goal:
            s = min(goal, track[-1][0] + length)
            s = goal if goal - s < 1e-12 else s
            load = way.at(s)
            found = rest(problem, _ahead(problem, way, track, s), load, DIRECT)
            if found.converged and not _jumped(problem, track, s, load, found):
                track.append((s, found.point))
                length *= 1.5 if found.iterations <= GOOD else 1.0
                if way.stations is None or s == goal:
                    rows.append((s, record(model, problem, found, load)))
                continue
            length *= 0.5
            if length < SMALLEST / steps:
                return rows, _stopped(problem.system, way, rows, found)
    return rows, ""


def _goals(way: Loading, steps: int) -> Iterator[float]:
    """Places that are reached exactly, in their order."""
    places = np.linspace(0, 1, steps + 1) if way.stations is None else way.stations
    yield from places[1:].tolist()


def _ahead(problem: Problem, way: Loading, track: list[tuple[float, Point]], s: float) -> Point:
    """Where the last two positions lead."""
    (s1, last), load = track[-1], way.at(s)
    if len(track) < 2:
        return problem.under(last, load)
    s0, before = track[-2]
    x, y = problem.step(before, last)
    share = (s - s1) / (s1 - s0)
    return problem.under(problem.moved(last, share * x, share * y, load), load)


def _jumped(
    problem: Problem, track: list[tuple[float, Point]], s: float, load: Load, found: Search
) -> bool:
    """Whether the search ended on another branch than the one followed."""
    s1, last = track[-1]
    if len(track) > 1:
        s0, before = track[-2]
        way = problem.step(before, last)[0] * ((s - s1) / (s1 - s0))
    else:
        way = _tangent(problem, last, load)
    off = float(np.abs(problem.step(last, found.point)[0] - way).max(initial=0.0))
    return off > JUMP * problem.system.reach + AHEAD * float(np.abs(way).max(initial=0.0))


def _tangent(problem: Problem, last: Point, load: Load) -> Array:
    """Where the stiffness leads under another load; nowhere where it leads everywhere."""
    point = problem.under(last, load)
    force, gap = problem.residual(point, load)
    try:
        way = problem.system.saddle.solve(*problem.tangent(point, load), -force, -gap)[0]
    except Singular:
        return np.zeros(1)
    return way if np.abs(way).max(initial=0.0) <= problem.system.reach else np.zeros(1)


def _said(way: Loading, s: float) -> str:
    return ", ".join(f"{name} = {value:.6g}" for name, value in way.values(s).items())


def _stopped(
    system: Contract, way: Loading, rows: list[tuple[float, Equilibrium]], found: Search
) -> str:
    """Where and why a path ended, and what to do."""
    s, last = rows[-1]
    asked = _said(way, 1.0)
    moving = words(system, found.motion)
    where = f", along {moving}" if moving else ""
    ended = f"no equilibrium next to the last one beyond {_said(way, s)} (asked: {asked})"
    if last.loose:
        free = " and ".join(last.loose)
        return (
            f"{ended}: nothing holds {free} there. Begin where loads or springs hold it, or "
            "hold it: hold={'...': value}"
        )
    return (
        f"{ended}: the stiffness gives way there{where} (lowest eigenvalue {last.least:.3g} J): a "
        "limit point, a bifurcation, or the end of what the mechanism can reach. The path up to "
        "there is kept; go on with prescribed displacements (hold={'...': (start, end)})"
    )
