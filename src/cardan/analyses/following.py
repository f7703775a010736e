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

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..errors import SolveError
from .newton import Search
from .standing import Standing, stand
from .static_problem import Load, Point, Problem

Array = NDArray[np.float64]
# corrections above this multiple of the predicted step and this part of the reach lead to another
# branch; below these none is seen: anywhere, and where the number of unstable directions changes
AHEAD, JUMP = 1.0, 0.1
FLOOR, ROUNDED = 1e-4, 1e-7


@dataclass(frozen=True, eq=False)
class Place:
    """A place of a path.

    Attributes:
        s: Part of the path that leads there.
        point: Where it rests.
        standing: How.
        side: Its number that is another one beyond a critical load; that of the place before
            where something is loose.
    """

    s: float
    point: Point
    standing: Standing
    side: int | None


@dataclass(frozen=True, eq=False)
class Crossing:
    """Where a path passed a critical load.

    Attributes:
        before, after: Places next to it on both sides.
    """

    before: Place
    after: Place

    @property
    def lost(self) -> bool:
        """Whether it stands less stably behind it."""
        return (self.after.side or 0) > (self.before.side or 0)

    @property
    def direction(self) -> Array:
        """The direction (nu,), without units, in which the stiffness gives way."""
        return self.after.standing.direction


@dataclass(frozen=True, eq=False)
class Step:
    """What the stiffness at a place predicts under another load.

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
        """How far a position is from what was predicted, and how far it may be."""
        most = JUMP * self.problem.system.reach
        moved = self.problem.step(self.start.point, point)[0]
        if self.way is None:
            return _size(moved), most
        return _size(moved - self.way), min(AHEAD * _size(self.way), most)

    def follows(self, point: Point) -> bool:
        """Whether a position belongs to the branch that is followed."""
        off, most = self.off(point)
        return off <= most + FLOOR

    def returns(self, there: Place, load: Load) -> bool:
        """Whether the way back from a place leads to where the step began, under its load."""
        return ahead(self.problem, there, load).follows(self.start.point)

    def reached(self, s: float, found: Search, standing: Standing) -> Place:
        """The place where a search ended."""
        side = self.start.side if standing.loose else standing.side
        if self.crosses(standing):
            side = standing.side
        return Place(s, found.point, standing, side)

    def crosses(self, standing: Standing) -> bool:
        """Whether a critical load lies on the way to where it stands like that."""
        before = self.start.standing
        if None in (self.start.side, standing.side) or (before.loose and standing.loose):
            return False
        return self.start.side != standing.side

    def surely(self, point: Point) -> bool:
        """Whether a position belongs to the branch though a critical load lies on the way."""
        off, most = self.off(point)
        return off <= most + ROUNDED


def first(problem: Problem, found: Search, load: Load) -> Place:
    """Where a path begins."""
    standing = stand(problem, found.point, load)
    return Place(0.0, found.point, standing, None if standing.loose else standing.side)


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


def _size(step: Array) -> float:
    return float(np.abs(step).max(initial=0.0))
