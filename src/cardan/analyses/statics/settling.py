"""Rest of systems whose elements have modes: stops, latches, dry friction.

In a mode an element may hold a velocity, or push; what it holds is a constraint like others. Sign
functions tell where a mode ends: a gap closes, a stop would have to pull, friction would have to
bear more than it can. A search for rest keeps the modes. Where it ends in none, or in one that a
sign function forbids, the system creeps from where it was until the first of them falls through 0,
and what the element does in a run happens here too, without speeds.

A position that friction holds is one of many that it would hold as well.

Source: F. Pfeiffer, Ch. Glocker, Multibody Dynamics with Unilateral Contacts (1996), chapters 5 and
6; M. Jean, Comput. Methods Appl. Mech. Eng. 177 (1999), 235-257 (quasi-static motion with contact).
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ...arrays import Array, Booleans
from ...errors import ModelError, SolveError
from ...records import dataclass
from .newton import Search, crept, equilibrium_search
from .static_problem import Load, Point, Problem

CHANGES = 60  # of modes in one search
CREEPING, SHORT, THIN = 300, 1e-9, 0.3  # steps, those that rest, and how resistance falls
LIMIT_TOL = 1e-9  # a start so little beyond a stop is at it
BISECTED = 60
# what a mode may lack, in units of its kind; and speeds that tell a direction alone
LACKING, SLOW = 1e-9, 1e-9


def settled(problem: Problem, point: Point, load: Load, ways: tuple[str, ...]) -> Search:
    """Rest under a load next to a point, with the modes that it takes.

    Args:
        problem, point, load: Of what, from where, under what.
        ways: As :func:`cardan.analyses.statics.newton.equilibrium_search` takes them.

    Raises:
        ModelError: it starts beyond a stop.
    """
    system = problem.system
    if not system.events:
        return equilibrium_search(problem, point, load, ways)
    _refuse_beyond(problem, point)
    point, spent, visited = _decided(problem, point), 0, set[bytes]()
    search = equilibrium_search(problem, point, load, ways[:1])
    for _ in range(CHANGES):
        spent += search.iterations
        fits = search.converged and not forbidden(problem, point, search.point).any()
        if fits:
            point = _sticking(problem, search.point)
            key = point.at.s.tobytes()
            if np.array_equal(point.at.s, search.point.at.s) or key in visited:
                return replace(search, iterations=spent)
            visited.add(key)
        else:
            crept_to, fired, steps = _creep(problem, point, load)
            spent += steps
            if not fired.any():
                break
            point = fired_at(problem, crept_to, fired)
        search = equilibrium_search(problem, point, load, ways[:1])
    search = equilibrium_search(problem, point, load, ways)
    fits = search.converged and not forbidden(problem, point, search.point).any()
    return replace(search, iterations=spent + search.iterations, converged=fits)


def with_modes(problem: Problem, point: Point, load: Load, search: Search) -> Search:
    """Result of a search from a point, continued where modes forbid it."""
    if not problem.system.events or not search.converged:
        return search
    if not forbidden(problem, point, search.point).any():
        return search
    return settled(problem, problem.under(point, load), load, ("full",))


def signs_of_modes(problem: Problem, point: Point, way: Array | None = None) -> Array:
    """Sign functions (ne,), of events that change modes; others are 1."""
    system, at = problem.system, point.at
    moving = replace(at, u=0 * at.u if way is None else SLOW * way)
    signs = system.signs(moving)
    of_modes = np.array([kind in ("mode", "impact") for _, kind, _ in system.events])
    return np.where(of_modes, signs, 1.0)


def forbidden(problem: Problem, start: Point, point: Point) -> Booleans:
    """Mask of the events that would have occurred on the way to a point (ne,)."""
    way = problem.system.difference(start.at.q, point.at.q)
    return np.asarray(signs_of_modes(problem, point, way) < -LACKING * _scales(problem, point))


def _scales(problem: Problem, point: Point) -> Array:
    """Scales of the sign functions (ne,): the size of the scene, its loads."""
    system, size = problem.system, problem.system.size
    load = max(1e-300, float(system.loads(point.at).max(initial=0.0)))
    scales = {"m": size, "rad": 1.0, "N": load / size, "N*m": load}
    scales |= {"m/s": SLOW * size, "rad/s": SLOW}
    return np.array([scales.get(unit, min(1.0, load)) for unit in system.sign_units])


def _sticking(problem: Problem, point: Point) -> Point:
    """The point with the modes in which it stays: sliding that has come to rest sticks."""
    system, signs = problem.system, signs_of_modes(problem, point)
    slides = np.array([kind == "mode" for _, kind, _ in system.events])
    return fired_at(problem, point, slides & (signs == 0))


def _decided(problem: Problem, point: Point) -> Point:
    """The point with the modes of a start at rest."""
    for _ in range(CHANGES):
        fired = signs_of_modes(problem, point) < 0
        if not fired.any():
            break
        after = fired_at(problem, point, fired)
        if np.array_equal(after.at.s, point.at.s):
            break
        point = after
    return point


def fired_at(problem: Problem, point: Point, fired: Booleans) -> Point:
    """The point behind events, without speeds."""
    if not fired.any():
        return point
    at = replace(point.at, u=0 * point.at.u)
    return replace(point, at=replace(point.at, s=problem.system.modes_after(at, fired)))


def _creep(problem: Problem, point: Point, load: Load) -> tuple[Point, Booleans, int]:
    """The way down to the first event, which events happen there, and steps."""
    system, resistance = problem.system, 1.0
    none = np.zeros(len(system.events), dtype=bool)
    for k in range(1, CREEPING + 1):
        try:
            step, y = crept(problem, point, load, resistance)[:2]
        except SolveError:
            return point, none, k
        size = float(np.abs(step).max(initial=0.0))
        if not np.isfinite(size):
            return point, none, k
        share = min(1.0, THIN * system.reach / max(size, 1e-300))

        way = _Way(problem, point, load, share * step, share * y)
        if way.events(1.0).any():
            low, high = way.first()
            return way.at(low), way.events(high), k
        point = way.at(1.0)
        if size <= SHORT:
            break
        resistance *= 1.0 if size > 0.03 * system.reach else THIN
    return point, none, k


@dataclass(frozen=True, eq=False)
class _Way:
    """A step of a creeping system.

    Attributes:
        problem, start, load: Of what, from where, under what.
        x, y: The step of the unknowns.
    """

    problem: Problem
    start: Point
    load: Load
    x: Array
    y: Array

    def at(self, part: float) -> Point:
        """The point after a part of it."""
        return self.problem.moved(self.start, part * self.x, part * self.y, self.load)

    def events(self, part: float) -> Booleans:
        """Mask of the events that have occurred up to there (ne,)."""
        way = self.x[: len(self.problem.system.columns)] * self.problem.system.columns
        return np.asarray(signs_of_modes(self.problem, self.at(part), way) < 0)

    def first(self) -> tuple[float, float]:
        """Parts next to each other between which the first event happens."""
        low, high = 0.0, 1.0
        for _ in range(BISECTED):
            middle = 0.5 * (low + high)
            if middle in (low, high):
                break
            low, high = (low, middle) if self.events(middle).any() else (middle, high)
        return low, high


def _refuse_beyond(problem: Problem, point: Point) -> None:
    """Raises:
    ModelError: a start that no motion could have come to.
    """
    signs = problem.system.signs(replace(point.at, u=0 * point.at.u))
    for value, (name, _, beyond) in zip(signs.tolist(), problem.system.events, strict=True):
        if beyond and value < -LIMIT_TOL:
            raise ModelError(f"{beyond} ('{name}'), by {-value:.6g}: start within its range")
