"""Locate critical loads on a load path, and the limit load at which it ends.

Critical loads are bracketed: by how many directions push away, or how many motions grow, and where
forces have a potential by the eigenvalue that passes 0 as well. Next to a limit load there are two
equilibria or none; there the path is followed by its length, along which the load turns back.

Source: R. Seydel, Practical Bifurcation and Stability Analysis (2010), section 5.3.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from scipy.optimize import brentq

from ...errors import SolveError
from ...records import dataclass
from ..continuation.equilibria import EquilibriumFamily, Loaded
from ..continuation.family import along_parameter
from ..continuation.follow import Reach, place, steps
from .continuation_step import Crossing, Place, place_of
from .equilibrium import DIRECT
from .force_balance import balance
from .load_path import Loading
from .newton import equilibrium_search
from .stability_at_equilibrium import stand
from .static_problem import Problem

CLOSE = 1e-14  # of the path: two places that are one
# of the path: next to a critical load searches may fail so far; stiffnesses are differences of
# forces, known to the square root of rounding
BRACKET_TOL = 1e-8
MOST = 60  # steps on the way to a limit load, and their lengths
FIRST, LONGEST = 1e-3, 0.1


def located(loading: Loading, crossing: Crossing) -> tuple[Place, float]:
    """The place at which a path passes a critical load, and within which part of the path it lies.

    The part is 0 where the load is known as well as rounding allows. Where searches inside the
    bracket find no equilibrium it is narrowed from both sides; the place is in the middle of what
    is left, and its point that of the nearest load at which the system was found at rest.
    """
    if crossing.exact is not None:
        return crossing.exact, 0.0
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


def limit_load(problem: Problem, loading: Loading, places: Sequence[Place]) -> Place | None:
    """The largest load of a path that found no equilibrium beyond its last place.

    The path is followed once more by its length, from a place where the stiffness is well above
    its rounding.

    Args:
        problem, loading: Of what, under what.
        places: Those of the path.

    Returns:
        The place; None where the load does not turn back next to the last place.
    """
    last = places[-1]
    if not np.isfinite(last.stability.least):
        return None
    firm = [one for one in places if one.s < last.s and not one.stability.free_motions]
    begin = firm[-1] if firm else last
    family = EquilibriumFamily.of(problem, loading, begin.point, begin.s)
    try:
        start = place(family, family.start(begin.point, begin.s), along_parameter(family))
        longest = min(LONGEST, 2 * (1 - begin.s))
        for step, _ in zip(steps(family, start, Reach(FIRST, longest)), range(MOST), strict=False):
            if not step.after.point.s <= 1:
                return None
            if step.after.parameter_rate <= 0:
                fold: Loaded = step.fold(family, 0.0, 1.0).point
                stability = stand(problem, fold.point, fold.load)
                return place_of(fold.s, fold.point, stability, begin)
    except SolveError:
        return None
    return None
