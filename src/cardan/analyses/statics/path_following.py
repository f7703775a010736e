"""Equilibria along a path of loads or prescribed displacements, in steps that suit it.

Each step starts where the tangent leads, and is halved where Newton's method does not get there or
ends on another branch.

Source: M. A. Crisfield, Non-linear Finite Element Analysis of Solids and Structures 1 (1991),
section 9.5 (automatic increments).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TypeAlias, TypeVar

import numpy as np

from ...records import dataclass
from .continuation_step import Crossing, Place, Step, by_load
from .critical_load import limit_load
from .equilibrium import DIRECT
from .load_path import Loading
from .newton import Search, equilibrium_search
from .settling import with_modes
from .stability_at_equilibrium import stand
from .static_problem import Problem

GOOD = 5  # iterations after which the next step may be longer
SMALLEST = 2.0**-20
SHORT = 2.0**-6  # steps in which critical loads are passed; of those that are asked for

Row = TypeVar("Row")
Predictor: TypeAlias = Callable[[Problem, Place, Loading, float], Step]


@dataclass(frozen=True, eq=False)
class EarlyEnd:
    """The place where a path ended early.

    Attributes:
        last: The last place.
        search: The search that found none beyond it.
        limit: The limit point that it ended at; None where it is none, or was not located.
    """

    last: Place
    search: Search
    limit: Place | None


def _never(_: Place) -> bool:
    return False


def follow(
    problem: Problem,
    way: Loading,
    begin: Place,
    steps: int,
    row: Callable[[Search, Place], Row],
    rows: list[tuple[float, Row]],
    crossed: list[Crossing],
    leaves: Callable[[Place], bool] = _never,
    predicted: Predictor = by_load,
) -> EarlyEnd | None:
    """Note rows of a path and the critical loads between them.

    Args:
        problem, way: What is loaded, along which path.
        begin: Where the path begins; its row is the caller's.
        steps: Rows of a path without stations; a measure of short steps elsewhere.
        row: Makes a row of an equilibrium.
        rows, crossed: Take (place, row) and critical loads as they come.
        leaves: True of a place at which the path is not to be followed any more.
        predicted: Makes the step from a place to another one.

    Returns:
        Where it ended early; None where it reached its end.
    """
    here, places = begin, [begin]
    for goal in _goals(way, steps, begin.s):
        length = goal - here.s
        # predict along the tangent, correct by Newton's method, halve the step where that fails
        while here.s < goal:
            s = min(goal, here.s + length)
            s = goal if goal - s < 1e-12 else s
            load = way.at(s)
            step = predicted(problem, here, way, s)
            search = with_modes(
                problem, here.point, load, equilibrium_search(problem, step.point, load, DIRECT)
            )
            shortest = 0.5 * length < SMALLEST / steps
            there = _next_place(step, search, way, s, length * steps <= SHORT, shortest)
            if there is not None and not (shortest or _returns(step, there, way, predicted)):
                there = None
            # accepted: note what changed in between, and take longer steps where Newton was quick
            if there is not None:
                crossed += step.crossings(there)
                here = there
                places.append(here)
                if leaves(here):
                    return EarlyEnd(here, search, None)
                length *= 1.5 if search.iterations <= GOOD else 1.0
                if way.stations is None or s == goal:
                    rows.append((s, row(search, there)))
                continue
            length *= 0.5
            if shortest:
                limit = limit_load(problem, way, places)
                if limit is not None:
                    # what balances beyond it does so within rounding alone
                    most = max(limit.s, 0.0)
                    here = [place for place in places if place.s <= most][-1]
                    rows[:] = [one for one in rows if one[0] <= most]
                    crossed[:] = [one for one in crossed if one.after.s <= most]
                    crossed.append(Crossing(here, limit, "limit"))
                return EarlyEnd(here, search, limit)
    return None


def _next_place(
    step: Step, search: Search, way: Loading, s: float, short: bool, shortest: bool
) -> Place | None:
    """The place that was found; None where it is none of the path, or the step is too long."""
    if not search.converged or not step.follows(search.point):
        return None
    there = step.solve_at(s, search, stand(step.problem, search.point, way.at(s)))
    if shortest:
        return there
    # critical loads are passed in short steps, for other branches not to be taken for this one
    if step.crosses(there) and not (short and step.surely(search.point)):
        return None
    return there


def _returns(step: Step, there: Place, way: Loading, predicted: Predictor) -> bool:
    """True when the way back from a place leads to where the step began."""
    return predicted(step.problem, there, way, step.start.s).follows(step.start.point)


def _goals(way: Loading, steps: int, start: float) -> Iterator[float]:
    """Places behind a start that are reached exactly, in their order."""
    places = np.linspace(0, 1, steps + 1) if way.stations is None else way.stations
    yield from places[places > start].tolist()
