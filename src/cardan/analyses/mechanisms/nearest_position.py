"""The assembled position nearest to a start: the one rule by which runs of closed systems begin.

Distances are those of joint coordinates: angles count in radians, lengths in sizes of the scene,
unit quaternions by the angle between rotations. What is named is the same in all positions.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import cache

import numpy as np

from ...arrays import Array
from ...errors import SolveWarning, warn
from .assembly_diagnosis import explain
from .branches import Branch, refuse, tie_advice
from .mechanism import Mechanism
from .position_solver import PositionSolver, Solution
from .rounded_loops import rounded
from .searches import aside, search
from .targets import Coordinates, Target

LONG_LOOP = 8  # speeds of joints above which random starts seldom close a loop
NEARLY = 1e-4  # residuals without units of values that were meant to fit, and are rounded
NAMED = "Name fewer coordinates at the start: loops determine the others"
NEAR = 0.3  # a position not farther away is the nearest without further searches
LOOKS = 6  # searches for others where it is farther away
EQUAL = 1e-6  # distances that differ by less are equal
COST_TOL = 1e-9
QUATERNION = 0.5  # what its components count in: they change by half of the angle


def assembled(m: Mechanism, goals: list[Target], q: Array) -> Solution:
    """The position next to a start (nq,); other starts are tried where that does not close.

    Args:
        m: The mechanism.
        goals: What is named, to be held.
        q: The start, with named and default values.

    Raises:
        ModelError: no position fulfills the goals.
    """
    solver = PositionSolver(m, goals)
    first = solver.search(q)
    if not first.closed and m.nu > LONG_LOOP:
        ends = (solver.search(start) for start in aside(m, solver, first.q))
        first = next((end for end in ends if end.met), first)
    if first.met and not m.outside(first.q):
        return nearest(m, goals, q, first)
    solutions = search(m, goals, q, m.searches, 0)
    met = [one for one in solutions if one.met]
    if not met:
        # numbers that fit but for their last digits
        wished = [replace(goal, weight=1.0) for goal in goals]
        close = PositionSolver(m, wished).search(q)
        if close.met and close.cost <= NEARLY**2:
            return close
        solutions = rounded(m, goals, q, m.searches, 0)
        met = [one for one in solutions if one.met]
    if not met:
        explain(
            m,
            goals,
            solutions,
            lambda n, some: search(n, some, q, min(6, m.searches), 0),
            NAMED,
            "q=",
        )
    return nearest(m, goals, q, choose(m, met, [], q))


def nearest(m: Mechanism, goals: list[Target], q: Array, first: Solution) -> Solution:
    """The nearest of the positions that are found from a start and from around it.

    Args:
        m, goals, q: As :func:`assembled` takes them.
        first: Where the search from the start ended.

    Warns:
        SolveWarning: two positions are equally near.
    """
    wish = wished(m, goals, q)
    near = cache(lambda: PositionSolver(m, [*goals, wish]))
    solutions = [_drawn_near(near, wish, first)]
    if wish.distance(solutions[0].q) > NEAR:
        solver = PositionSolver(m, goals)
        for begin in _around(m, q, solutions[0].q):
            end = solver.search(begin)
            if not end.met or m.outside(end.q):
                continue
            end = _drawn_near(near, wish, replace(end, q=m.nearest(end.q, q)))
            if not any(_same(m, end.q, other.q) for other in solutions):
                solutions.append(end)
    least = min(wish.distance(end.q) for end in solutions)
    best = [end for end in solutions if wish.distance(end.q) <= (1 + EQUAL) * least]
    if len(best) > 1:
        best = sorted(best, key=lambda end: places(m, end.q))
        # angles that differ by full turns are one position
        distinct = [end for end in best[1:] if not _same(m, best[0].q, m.nearest(end.q, best[0].q))]
        if distinct:
            _warn_of_tie(m, goals, [best[0], *distinct], solutions)
    return best[0]


def _around(m: Mechanism, q: Array, solution: Array) -> Iterator[Array]:
    """Candidate starts for positions nearer to a start (nq,) than the solution at hand.

    A branch as near as this one lies on the other side of the start; others lie anywhere.
    """
    step = m.difference(q, solution)
    yield m.advance(q, -step)
    rng, away = np.random.default_rng(0), float(np.linalg.norm(step))
    for _ in range(min(LOOKS, m.searches) - 1):
        direction = rng.standard_normal(m.nu)
        yield m.advance(q, away / np.linalg.norm(direction) * direction)


def wished(m: Mechanism, goals: Sequence[Target], q: Array) -> Coordinates:
    """Target that keeps the coordinates that are not named at their start."""
    named = {k for g in goals if g.kind == "coordinate" for k in range(g.place.start, g.place.stop)}
    manifest = m.model.manifest
    quaternion_entries = {k for start in manifest.quaternions for k in range(start, start + 4)}
    entries = np.array([k for k in m.led.tolist() if k not in named], dtype=np.intp)
    units = {k: manifest.coordinates[k].unit for k in entries.tolist()}
    scales = [
        QUATERNION if k in quaternion_entries else m.size if u == "m" else 1.0
        for k, u in units.items()
    ]
    return Coordinates(
        "", "coordinates", q[entries], weight=1.0, entries=entries, scales=np.array(scales)
    )


def _drawn_near(
    near: Callable[[], PositionSolver], wish: Coordinates, solution: Solution
) -> Solution:
    """Move along remaining freedoms to the position nearest to a start."""
    if not solution.freedoms or wish.distance(solution.q) <= EQUAL:
        return solution
    end = near().search(solution.q)
    better = end.met and not near().m.outside(end.q)
    return replace(end, freedoms=solution.freedoms) if better else solution


def _same(m: Mechanism, one: Array, other: Array) -> bool:
    """True when two positions are one."""
    return bool(np.abs(one[m.led] - other[m.led]).max(initial=0.0) < EQUAL)


def _warn_of_tie(
    m: Mechanism, goals: Sequence[Target], best: Sequence[Solution], solutions: Sequence[Solution]
) -> None:
    """Warn of positions that are equally near, with what differs between them and lines that
    choose."""
    one, other = best[0].q, best[1].q
    names, differing = m.model.coordinates, m.led[np.abs(one[m.led] - other[m.led]) >= EQUAL][:4]
    said = [", ".join(f"{names[k]} = {q[k]:.6g}" for k in differing.tolist()) for q in (one, other)]
    alternatives = [end.q for end in solutions if end is not best[0]]
    warn(
        f"the start of '{m.model.name}' is equally near to two positions: {said[0]}; or {said[1]}. "
        f"The first is taken. {tie_advice(m, goals, best[0], alternatives)}",
        SolveWarning,
    )


def choose(
    m: Mechanism, solutions: Sequence[Solution], requested: Sequence[Branch], begin: Array
) -> Solution:
    """The position that runs and assemblies take: one rule, whatever rounding does.

    On a branch, inside limits if there is one: where the first search ended, which began at the
    start; else the one next to the start. :func:`nearest` goes on from there.

    Args:
        m: The mechanism.
        solutions: Positions in the order of the searches.
        requested: Branches.
        begin: The start (nq,).

    Raises:
        ModelError: none is on the branch.
    """
    allowed = [one for one in solutions if all(branch.holds(one.q) for branch in requested)]
    if not allowed:
        refuse(requested, [one.q for one in solutions])
    best = min(one.cost for one in allowed)

    def order(one: Solution) -> tuple[bool, int, bool, float]:
        worse = one.cost > best + COST_TOL
        away = math.hypot(*m.difference(begin, one.q))
        return worse, m.outside(one.q), not one.first, float(np.rint(away / EQUAL))

    return min(allowed, key=order)


def places(m: Mechanism, q: Array) -> tuple[float, ...]:
    """Coordinates of the joints that are moved, for an order that rounding cannot turn."""
    return tuple(-np.round(q[m.led] / EQUAL))
