"""One step of a load path: where the tangent leads, and whether what is found there belongs to it.

Newton's method converges to other branches without saying so. What it found is taken for the
branch that is followed where it lies no further from what the tangent predicts than the place
where the step began, where the same holds for the way back, and where the number of directions in
which the stiffness pushes away is the same. A critical load that is passed changes that number too:
steps are halved until they are so short that it is a place on the way and no other branch.

Source: R. Seydel, Practical Bifurcation and Stability Analysis (2010), sections 4.2, 4.5 and 5.2
(predictors, step control, test functions).
"""

from __future__ import annotations

import numpy as np

from ...arrays import Array
from ...errors import SolveError
from ...records import dataclass
from .load_path import Loading
from .newton import Search
from .stability_at_equilibrium import Stability, stand
from .static_problem import Load, Point, Problem

# corrections above this multiple of the predicted step and this part of the reach lead to another
# branch; below these none is seen: anywhere, and where the number of unstable directions changes
AHEAD, JUMP = 1.0, 0.1
FLOOR, ROUNDED = 1e-4, 1e-7
NEARBY = 1e-4  # of a step, over which forces are differentiated


@dataclass(frozen=True, eq=False)
class Place:
    """A place of a path.

    Attributes:
        s: Part of the path that leads there.
        point: Where it rests.
        stability: How.
        side: Its number that is another one beyond a critical load; the last one that was known.
        dead: The same of the system under dead loads in place of what is prescribed.
        free: Whether something was loose where the path began, in either system: then rounding
            counts on neither side; elsewhere an eigenvalue that small passes 0.
    """

    s: float
    point: Point
    stability: Stability
    side: int | None
    dead: int | None
    free: tuple[bool, bool]


@dataclass(frozen=True, eq=False)
class Crossing:
    """A critical load on a path.

    Attributes:
        before, after: Places next to it on both sides; of a limit load ``after`` lies on it.
        of: ``"held"``: the system as it is followed; ``"dead load"``: as it stands under dead
            loads in place of displacements that are prescribed, and is not followed; ``"limit"``:
            the load beyond which there is no equilibrium.
        exact: The critical load itself where it is known.
    """

    before: Place
    after: Place
    of: str = "held"
    exact: Place | None = None

    @property
    def lost(self) -> bool:
        """True when it stands less stably behind it."""
        sides = (self.side(self.after) or 0, self.side(self.before) or 0)
        return self.of == "limit" or sides[0] > sides[1]

    @property
    def kind(self) -> str:
        """``"flutter"`` where an oscillation begins or ceases to grow, else ``"divergence"``."""
        both = (self.stability_at(place) for place in (self.before, self.after))
        return "flutter" if any(stability.frequency for stability in both) else "divergence"

    @property
    def direction(self) -> Array:
        """The direction (nu,), without units, in which the stiffness gives way."""
        return self.stability_at(self.after).direction

    def stability_at(self, place: Place) -> Stability:
        """Stability at a place, of the system that it is about."""
        follows_path = self.of == "held"
        return place.stability if follows_path else place.stability.under_dead_load

    def side(self, place: Place) -> int | None:
        """The number of that system which changes here."""
        return place.side if self.of == "held" else place.dead


@dataclass(frozen=True, eq=False)
class Step:
    """Prediction of the stiffness at a place for another load.

    Attributes:
        problem: Of what.
        start: Where it begins.
        way: Predicted unknowns (nu + nz,), without units; None where the stiffness holds nothing
            or leads further than that means something.
        point: Where a search begins.
    """

    problem: Problem
    start: Place
    way: Array | None
    point: Point

    def off(self, point: Point) -> tuple[float, float]:
        """Distance of a position from the prediction, and the distance allowed."""
        most = JUMP * self.problem.system.reach
        moved = self.problem.step(self.start.point, point)[0]
        if self.way is None:
            return _size(moved), most
        return _size(moved - self.way), min(AHEAD * _size(self.way), most)

    def follows(self, point: Point) -> bool:
        """True when a position belongs to the branch that is followed."""
        off, most = self.off(point)
        return off <= most + FLOOR

    def solve_at(self, s: float, search: Search, stability: Stability) -> Place:
        """The place where a search ended; numbers that are not known there are the last known."""
        return place_of(s, search.point, stability, self.start)

    def crosses(self, there: Place) -> bool:
        """True when a critical load lies on the way to a place."""
        return _differ(self.start.side, there.side)

    def crossings(self, there: Place) -> list[Crossing]:
        """Critical loads that lie on the way to a place."""
        pairs = (("held", self.start.side, there.side), ("dead load", self.start.dead, there.dead))
        compared = pairs if there.stability.dead is not None else pairs[:1]
        return [Crossing(self.start, there, of) for of, *sides in compared if _differ(*sides)]

    def surely(self, point: Point) -> bool:
        """True when a position belongs to the branch though a critical load lies on the way."""
        off, most = self.off(point)
        return off <= most + ROUNDED


def first(problem: Problem, search: Search, load: Load) -> Place:
    """First place of a path."""
    return place_of(0.0, search.point, stand(problem, search.point, load), None)


def place_of(s: float, point: Point, stability: Stability, last: Place | None) -> Place:
    """The place where a system stands like that; ``last``: the one before, None of the first."""
    both = (stability, stability.under_dead_load)
    if last is None:
        # what is loose at first, such as an upright column without load, stands on neither side
        side, dead = (None if one.free_motions else one.side for one in both)
        return Place(
            s,
            point,
            stability,
            side,
            dead,
            (bool(both[0].free_motions), bool(both[1].free_motions)),
        )
    pairs = zip(both, last.free, (last.side, last.dead), strict=True)
    latest = [(one.side if free else one.signed, before) for one, free, before in pairs]
    side, dead = (before if now is None else now for now, before in latest)
    return Place(s, point, stability, side, dead, last.free)


def _differ(before: int | None, after: int | None) -> bool:
    return before is not None and after is not None and before != after


def ahead(problem: Problem, start: Place, load: Load) -> Step:
    """The step from a place to another load, along the tangent."""
    point = problem.under(start.point, load)
    try:
        force, gap = problem.residual(point, load)
        x, y = problem.system.saddle.solve(*problem.tangent(point, load), -force, -gap)
    except SolveError:
        return Step(problem, start, None, point)
    if not _size(x) <= problem.system.reach:
        return Step(problem, start, None, point)
    return Step(problem, start, x, problem.under(problem.moved(point, x, y, load), load))


def by_rate(problem: Problem, start: Place, way: Loading, s: float) -> Step:
    """The step from a place to another one of a path, along the tangent at the place.

    It is that of the load there: under the other load the position of the start may belong to
    another regime, such as that of a cable that is slack.
    """
    load, goal = way.at(start.s), way.at(s)
    shifted = way.at(start.s + NEARBY * (s - start.s))
    point = problem.under(start.point, goal)
    try:
        here = problem.residual(start.point, load)
        there = problem.residual(problem.under(start.point, shifted), shifted)
        force, gap = ((b - a) / NEARBY for a, b in zip(here, there, strict=True))
        x, y = problem.system.saddle.solve(*problem.tangent(start.point, load), -force, -gap)
    except SolveError:
        return Step(problem, start, None, point)
    if not _size(x) <= problem.system.reach:
        return Step(problem, start, None, point)
    return Step(problem, start, x, problem.under(problem.moved(point, x, y, goal), goal))


def by_load(problem: Problem, start: Place, way: Loading, s: float) -> Step:
    """The same by :func:`ahead`."""
    return ahead(problem, start, way.at(s))


def _size(step: Array) -> float:
    return float(np.abs(step).max(initial=0.0))
