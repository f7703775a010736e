"""Locate critical loads on a load path, and the limit load at which it ends.

Critical loads are bracketed: by how many directions push away, or how many motions grow, and where
forces have a potential by the eigenvalue that passes 0 as well. Next to a limit load there are two
equilibria or none; there the displacement that gives way most is prescribed and the load
follows: it is largest where its rate along that displacement is 0.

Source: R. Seydel, Practical Bifurcation and Stability Analysis (2010), sections 4.3 and 5.3 (change
of the parameter, test functions); W. Govaerts, Numerical Methods for Bifurcations of Dynamical
Equilibria (2000), chapter 3 (bordered systems).
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy.optimize import brentq, minimize_scalar
from scipy.sparse import csr_array, issparse

from ...arrays import Array
from ...errors import SolveError
from .continuation_step import Crossing, Place, place_of
from .equilibrium import DIRECT
from .force_balance import balance
from .load_path import Loading
from .newton import equilibrium_search
from .stability_at_equilibrium import stand
from .static_problem import Matrix, Point, Problem

CLOSE = 1e-14  # of the path: two places that are one
# of the path: next to a critical load searches may fail so far; stiffnesses are differences of
# forces, known to the square root of rounding
BRACKET_TOL = 1e-8
LOAD_STEP = 1e-4  # of the path: over which the load is differentiated
NEWTON, MOST, GROWTH = 12, 40, 2.0
CLOSED = 1e-9  # steps that end a search: the load is known to their square
FIRST, LONGEST = 1e-4, 0.05  # of the reach: steps of the displacement that is prescribed
WEAK = 1e-4  # of the largest stiffness: a spring


def located(loading: Loading, crossing: Crossing) -> tuple[Place, float]:
    """The place at which a path passes a critical load, and within which part of the path it lies.

    The part is 0 where the load is known as well as rounding allows. Where searches inside the
    bracket find no equilibrium it is narrowed from both sides; the place is in the middle of what
    is left, and its point that of the nearest load at which the system was found at rest.
    """
    if crossing.of == "limit":
        return crossing.after, 0.0
    bracket = _Bracket(loading, crossing, [crossing.before, crossing.after])
    low, high = crossing.before.s, crossing.after.s
    widest = replace(crossing.before, s=0.5 * (low + high)), high - low
    if bracket.past(low) >= 0 or bracket.past(high) <= 0 or bracket.failed:
        return widest
    s = float(brentq(bracket.past, low, high, xtol=CLOSE))
    if bracket.failed:
        # that may be where searches cease to converge: the same from the other side
        bracket.unknown = -1.0
        if bracket.past(low) >= 0 or bracket.past(high) <= 0:
            return widest
        brentq(bracket.past, low, high, xtol=CLOSE)
        low, high = (place.s for place in bracket.last)
        if not 0 <= high - low <= BRACKET_TOL:
            return replace(bracket.last[0], s=0.5 * (low + high)), abs(high - low)
    # loads next to it have the same equilibrium to rounding, and are solved for more surely
    near = min(bracket.last, key=lambda place: abs(place.s - s))
    load = loading.at(s)
    search = equilibrium_search(
        bracket.problem, bracket.problem.under(near.point, load), load, DIRECT
    )
    return replace(near, s=s, point=search.point if search.converged else near.point), 0.0


@dataclass(eq=False)
class _Bracket:
    """Places next to a critical load, which come closer as it is looked for.

    Attributes:
        loading, crossing: Of what.
        last: The last places that were found before and behind it.
        failed: Whether a search found no equilibrium.
        unknown: On which side such a load counts: 1 behind the critical load, -1 before it.
    """

    loading: Loading
    crossing: Crossing
    last: list[Place]
    failed: bool = False
    unknown: float = 1.0

    def __post_init__(self) -> None:
        self.problem = Problem(self.loading.system)

    def past(self, s: float) -> float:
        """Negative before, positive behind; by size how far the stiffness is from giving way."""
        problem, load, crossing = self.problem, self.loading.at(s), self.crossing
        begun = problem.under(self.last[0].point, load)
        search = equilibrium_search(problem, begun, load, DIRECT)
        point = search.point
        if not search.converged:
            # where the stiffness gives way steps are rounding; so near the last point will do
            if not balance(problem, begun, load).holds:
                self.failed = True
                return self.unknown
            point = begun
        there = place_of(s, point, stand(problem, point, load), crossing.before)
        behind = crossing.side(there) != crossing.side(crossing.before)
        self.last[behind] = there
        margin = crossing.stability_at(there).margin
        size = margin if np.isfinite(margin) else 1.0
        return size if behind else -size


@dataclass(frozen=True, eq=False)
class _Arc:
    """The way on from a place with a displacement prescribed in place of the load.

    Attributes:
        problem, loading: Of what, under what.
        start: Where it begins.
        k: The displacement, an entry of the increments without units.
        spring: A stiffness there with which nothing gives way.
    """

    problem: Problem
    loading: Loading
    start: Place
    k: int
    spring: float

    def answers(self, s: float, point: Point) -> tuple[Array, Array, Array]:
        """Steps of all unknowns (n + m,) with the spring: by what is open, the load, a push."""
        problem, load = self.problem, self.loading.at(s)
        under = problem.under(point, load)
        K, G = problem.tangent(under, load)
        force, gap = problem.residual(under, load)
        ends = max(0.0, s - LOAD_STEP), min(1.0, s + LOAD_STEP)
        loads = (self.loading.at(end) for end in ends)
        sides = [problem.residual(problem.under(point, at), at) for at in loads]
        by_force, by_gap = ((b - a) / (ends[1] - ends[0]) for a, b in zip(*sides, strict=True))
        push = np.eye(1, len(force), self.k)[0]
        right = np.stack([-force, -by_force, push], axis=1)
        below = np.stack([-gap, -by_gap, 0 * gap], axis=1)
        x, y = problem.system.saddle.solve(_stiffer(K, self.k, self.spring), G, right, below)
        both = np.concatenate([x, y])
        return both[:, 0], both[:, 1], both[:, 2]

    def at(self, way: float, s: float, point: Point) -> tuple[float, Point]:
        """The load and the equilibrium where the displacement has gone so far, from a near one.

        Raises:
            SolveError: there is none next to it.
        """
        problem, k = self.problem, self.k
        n = len(problem.system.columns) + len(problem.system.internals)
        for _ in range(NEWTON):
            left = way - problem.step(self.start.point, point)[0][k]
            by_gaps, by_load, by_push = self.answers(s, point)
            step = by_gaps + self.spring * left * by_push
            ds = float((left - step[k]) / by_load[k])
            step = step + ds * by_load
            size = float(np.abs(step[:n]).max())
            if not (np.isfinite(step).all() and size <= problem.system.reach and abs(ds) <= 1):
                break
            s, load = s + ds, self.loading.at(s + ds)
            point = problem.under(problem.moved(point, step[:n], step[n:], load), load)
            if size <= CLOSED and abs(ds) <= CLOSED:
                return s, point
        raise SolveError("there is no equilibrium with this displacement")


def limit_load(problem: Problem, loading: Loading, first: Place, last: Place) -> Place | None:
    """The largest load of a path that found no equilibrium beyond its last place.

    Args:
        problem, loading: Of what, under what.
        first: Where the path began.
        last: Its last place.

    Returns:
        The place; None where the load does not pass a largest value next to the last place.
    """
    direction = np.abs(last.stability.direction)
    if last.stability.free_motions or not direction.any():
        return None
    k = int(direction.argmax())
    try:
        return _highest(_Arc(problem, loading, last, k, _stiff(problem, loading, first, k)))
    except (SolveError, np.linalg.LinAlgError):
        return None


def _highest(arc: _Arc) -> Place | None:
    """Place of the largest load along a way."""
    length = FIRST * arc.problem.system.reach
    begin = (0.0, arc.start.s, arc.start.point)
    sides = [(way, *arc.at(way, *begin[1:])) for way in (-length, length)]
    samples = sorted([*sides, begin], key=lambda one: one[0])
    if sides[0][1] > begin[1] < sides[1][1]:
        return None
    rising = -1 if sides[0][1] > sides[1][1] else 1
    samples = samples if rising == 1 else samples[::-1]
    # on, the load rising, until it falls
    while samples[-1][1] > samples[-2][1]:
        length = min(GROWTH * length, LONGEST * arc.problem.system.reach)
        way = samples[-1][0] + rising * length
        samples.append((way, *arc.at(way, *samples[-1][1:])))
        if len(samples) > MOST or not samples[-1][1] <= 1:
            return None
    near = samples[-2]

    def load(way: float) -> float:
        return -arc.at(way, *near[1:])[0]

    ends = sorted((samples[-3][0], samples[-1][0]))
    close = {"xatol": 1e-7 * (ends[1] - ends[0])}
    way = minimize_scalar(load, bounds=ends, method="bounded", options=close).x
    s, point = arc.at(float(way), *near[1:])
    return place_of(s, point, stand(arc.problem, point, arc.loading.at(s)), arc.start)


def _stiff(problem: Problem, loading: Loading, first: Place, k: int) -> float:
    """Stiffness of a displacement at the start of a path;

    of the largest where that is not known.
    """
    load = loading.at(first.s)
    K, G = problem.tangent(first.point, load)
    push = np.eye(1, K.shape[0], k)[0]
    try:
        compliance = problem.system.saddle.solve(K, G, push, np.zeros(G.shape[0]))[0][k]
    except SolveError:
        compliance = 0.0
    return abs(1 / compliance) if compliance else WEAK * float(abs(K).max())


def _stiffer(K: Matrix, k: int, spring: float) -> Matrix:
    """A stiffness with a spring along an entry of its unknowns."""
    if issparse(K):
        return csr_array(K + csr_array(([spring], ([k], [k])), shape=K.shape))
    added = K.copy()
    added[k, k] += spring
    return added
