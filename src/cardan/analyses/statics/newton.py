"""Newton's method for rest under loads, and what is done where it does not get there.

Full steps come first: they turn slender structures far in few iterations. Then the forces that are
out of balance at the start come on little by little. Then steps are shortened until the residual
falls. Where that fails too the system creeps: each step is one of a motion without inertia in ever
thicker time steps, which ends where it rests stably.

Source: E. Allgower, K. Georg, Introduction to Numerical Continuation Methods, section 1.2 (global
homotopy); C. T. Kelley, D. E. Keyes, SIAM J. Numer. Anal. 35 (1998), 508-523 (pseudo-transient
continuation).
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.sparse import csr_array, diags_array, issparse

from ...arrays import Array
from ...errors import SolveError
from ...records import dataclass
from ..systems.saddle_point import Dense, Singular
from .force_balance import balances
from .static_problem import Load, Matrix, Point, Problem

TIGHT = 1e-10  # steps without units that end the search; the next would be their square
NOISE = 1e-7  # steps that no longer fall below this are rounding
# where forces are rounding, of the largest stiffness, larger steps are
ROUNDED, ROUGH = 4e-15, 1e-4
NEWTON, CREEPING, FEW = 30, 400, 100
HASTE = 0.03  # steps of a creeping system that are not worth it below that
HALVINGS = 12
FIRST, LEAST = 0.125, 2.0**-12  # parts of a load that comes on
SLOW, AWAY = 15, 0.1  # steps after which others are this part of the reach at most
GROWTH = 1e3  # steps this much larger than the smallest before them lead away


@dataclass(frozen=True, eq=False)
class Search:
    """End of a search.

    Attributes:
        point: Its last position.
        iterations: Linear systems solved.
        converged: Whether it rests there.
        motion: Where it was going (nu + nz,), without units; of one that did not converge.
        pushed: Whether nothing holds that motion.
    """

    point: Point
    iterations: int
    converged: bool
    motion: Array
    pushed: bool = False


def newton(problem: Problem, point: Point, load: Load, damped: bool = False) -> Search:
    """Newton's method.

    Args:
        problem, point, load: Of what, from where, under what.
        damped: Shorten steps until the residual falls.
    """
    if damped:
        return _steps(problem, point, load, damped)
    search = _steps(problem, problem.with_internal_unknowns(point), load, damped)
    return replace(search, point=problem.closed(search.point))


def _steps(problem: Problem, point: Point, load: Load, damped: bool) -> Search:
    last, least, step = np.inf, np.inf, np.zeros(0)
    for k in range(1, NEWTON + 1):
        try:
            K, G = problem.tangent(point, load)
            force, gap = problem.residual(point, load)
            step, y = problem.system.saddle.solve(K, G, -force, -gap)
        except Singular as singular:
            motion = step if singular.motion is None else singular.motion
            return Search(point, k, False, motion, singular.motion is not None)
        except SolveError:
            return Search(point, k, False, step)
        size = _size(step)
        if not np.isfinite(size) or size > GROWTH * max(least, problem.system.reach):
            break
        if k > SLOW and size > AWAY * problem.system.reach and not damped:
            break
        share = min(1.0, problem.system.reach / max(size, 1e-300))
        point, share = _moved(problem, point, load, step, y, share, K if damped else None)
        # rounding is all that is left where neither steps nor forces fall any more
        rounded = size <= NOISE or np.abs(force).max() <= ROUNDED * float(abs(K).max())
        ended = size <= TIGHT or (rounded and ROUGH >= size >= 0.5 * last)
        if share == 1.0 and ended and balances(problem, problem.closed(point), load, (K, G)):
            return Search(point, k, True, step)
        last, least = size, min(least, size)
    return Search(point, k, False, step)


def _moved(
    problem: Problem, point: Point, load: Load, x: Array, y: Array, share: float, K: Matrix | None
) -> tuple[Point, float]:
    """The point after a step, shortened until the residual falls where K is given."""
    full_step = problem.moved(point, share * x, share * y, load)
    if K is None:
        return full_step, share
    unit = max(float(abs(K).max()), 1e-300)
    before, first = _miss(problem, point, load, unit), (full_step, share)
    for _ in range(HALVINGS):
        shortened = problem.moved(point, share * x, share * y, load)
        if _miss(problem, shortened, load, unit) <= (1 - 1e-4 * share) * before:
            return shortened, share
        share *= 0.5
    # rounding is all that is left, or the direction does not lead down
    return first if _size(x) <= NOISE else (shortened, share)


def _miss(problem: Problem, point: Point, load: Load, unit: float) -> float:
    """The residual in steps; infinite outside a domain."""
    try:
        force, gap = problem.residual(point, load)
    except SolveError:
        return np.inf
    return float(np.hypot(np.linalg.norm(force / unit), np.linalg.norm(gap)))


def ramp(problem: Problem, point: Point, load: Load) -> Search:
    """Newton's method while what is out of balance at the start is taken back in steps."""
    force, gap = problem.residual(point, load)
    done, part, spent = 0.0, FIRST, 0
    search = Search(point, 0, False, np.zeros(0))
    while part >= LEAST:
        share = min(1.0, done + part)
        left = ((1 - share) * force, (1 - share) * gap)
        search = newton(problem, point, replace(load, left=left))
        spent += search.iterations
        # a long way in one step leads elsewhere
        if search.converged and _near(problem, point, search):
            point, done, part = search.point, share, 1.5 * part
            if done == 1.0:
                return replace(search, iterations=spent)
        else:
            part *= 0.5
    return replace(search, iterations=spent, converged=False)


def _near(problem: Problem, point: Point, search: Search) -> bool:
    return _size(problem.step(point, search.point)[0]) <= 0.5 * problem.system.reach


def creep(problem: Problem, point: Point, load: Load) -> Search:
    """Motion without inertia until it rests, then Newton's method.

    Stiffness alone pulls towards rest of any kind; with the resistance it leads downhill.
    """
    system, resistance, last, step, total = problem.system, 1.0, np.inf, np.zeros(0), 0
    for total in range(1, (CREEPING if isinstance(system.saddle, Dense) else FEW) + 1):
        try:
            # one implicit Euler step of D x' = f(x), damped like a viscous fluid
            step, y, below, unit = crept(problem, point, load, resistance)
        except SolveError:
            return Search(point, total, False, step)
        size = _size(step)
        share = min(1.0, 0.3 * system.reach / max(size, 1e-300))
        point = problem.moved(point, share * step, share * y, load)
        # close to a minimum: Newton's method converges quadratically from here
        near = size <= 1e-6 and resistance < 1e-3 and below >= -1e-9 * unit
        if near or size <= TIGHT:
            search = newton(problem, point, load)
            return Search(
                search.point,
                total + search.iterations,
                search.converged,
                search.motion if len(search.motion) else step,
                search.pushed,
            )
        # thicker steps as it comes to rest, and while stiffness that has no part in it holds it up
        if size < HASTE * system.reach:
            resistance *= 0.3
        elif 0 < last < np.inf and share == 1.0:
            resistance = min(1.0, resistance * min(max(size / last, 0.3), 2.0))
        elif last == 0:
            resistance *= 0.3
        last = size
    return Search(point, total, False, step)


def crept(
    problem: Problem, point: Point, load: Load, resistance: float
) -> tuple[Array, Array, float, float]:
    """A step of a system that creeps.

    Args:
        problem, point, load: Of what, from where, under what.
        resistance: Over the largest stiffness or force.

    Returns:
        The step of the unknowns, and of multipliers; the lowest eigenvalue of the stiffness, at
        most 0; the largest stiffness or force.

    Raises:
        SolveError: there is none.
    """
    saddle = problem.system.saddle
    K, G = problem.tangent(point, load)
    force, gap = problem.residual(point, load)
    unit = max(float(abs(K).max()), float(np.abs(force).max(initial=0.0)), 1e-300)
    nu = len(problem.system.columns)
    below = float(saddle.lowest(K[:nu, :nu], G[:, :nu]).values[:1].min(initial=0.0))
    # where the stiffness pushes away, enough of it to lead down
    amounts = np.full(K.shape[0], max(resistance * unit, -2 * below))
    # internal states follow their rates, which fall as they rise
    amounts[nu:] = -resistance * float(abs(K[nu:, nu:]).max()) if len(amounts) > nu else 0.0
    thick = csr_array(K + diags_array(amounts)) if issparse(K) else K + np.diag(amounts)
    step, y = saddle.solve(thick, G, -force, -gap)
    return step, y, below, unit


def _size(step: Array) -> float:
    return float(np.abs(step).max(initial=0.0))


FALLBACKS = {"ramp": ramp, "creep": creep}


def equilibrium_search(problem: Problem, point: Point, load: Load, ways: tuple[str, ...]) -> Search:
    """Rest under a load next to a point.

    Args:
        problem, point, load: Of what, from where, under what.
        ways: Of ``"full"``, ``"damped"``, ``"ramp"`` and ``"creep"`` those to try, in this order.
    """
    spent, pushed = 0, None
    for way in ways:
        # steps that lead too far end a search: what overflows there is no news
        with np.errstate(over="ignore", invalid="ignore"):
            if way in FALLBACKS:
                search = FALLBACKS[way](problem, point, load)
            else:
                search = newton(problem, point, load, way == "damped")
        spent += search.iterations
        if search.converged:
            break
        # what nothing holds is told rather than where the last way led
        pushed = search if search.pushed and pushed is None else pushed
    outcome = search if search.converged or pushed is None else pushed
    return replace(search, iterations=spent, motion=outcome.motion, pushed=outcome.pushed)
