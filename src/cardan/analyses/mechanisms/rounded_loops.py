"""Loops whose redundant conditions disagree a little, because lengths or axes are rounded.

Redundant conditions are consistent for exact numbers only. With rounded ones they
leave a residual, or allow single positions without motion. Where residuals stay below a bound they
are ignored, in assembly and in runs alike, and the user is told.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ...arrays import Array
from ...errors import SolveWarning, warn
from .mechanism import ROUNDED_TOL, Mechanism
from .position_solver import PositionSolver, Solution
from .searches import search
from .targets import Target

ROUNDED = 1e-7  # residuals without units that rounded numbers may leave
AGREED = 1e-13  # those that double precision leaves
WORTH_A_WARNING = 1e-10  # those that are worth a warning
MARGIN = 100.0  # by which they may grow along a motion
OFFSET = 1e-2  # a step, without units, to a place that is not singular by chance


def rounded(
    m: Mechanism, targets: Sequence[Target], begin: Array, starts: int, seed: int
) -> list[Solution]:
    """Searches that let redundant conditions disagree; the mechanism keeps the slack they need.

    Args:
        m: The mechanism; its ``closure_tol`` is set where a search ends well.
        targets, begin, starts, seed: As :func:`.searches.search` takes them.
    """
    m.closure_tol = ROUNDED
    solutions = search(m, targets, begin, starts, seed)
    if any(one.met for one in solutions):
        worst = max(one.open for one in solutions if one.met)
        m.closure_tol = MARGIN * worst
        warn_of_residual(m, worst)
    else:
        m.closure_tol = 0.0
    return solutions


def closure_tolerance(m: Mechanism, q: Array) -> float:
    """The residual that redundant conditions leave beside a closed position; 0 if they agree.

    Args:
        m, q: Mechanism and a position at which all conditions hold.
    """
    values, rows = m.decomposition(q)[1], m.positions
    if rows < len(m.closing.rows):
        values = np.asarray(np.linalg.svd(m.jacobian(q)[:rows], compute_uv=False), np.float64)
    if not len(values) or (len(values) == rows and values[-1] > ROUNDED_TOL * values[0]):
        return 0.0
    released = m.without(m.released)
    released.closure_tol = ROUNDED
    aside = np.random.default_rng(0).uniform(-OFFSET, OFFSET, m.nu)
    solution = PositionSolver(released).solve(m.advance(q, aside))
    if not AGREED < solution.open <= ROUNDED:
        return 0.0
    warn_of_residual(m, solution.open)
    return MARGIN * solution.open


def warn_of_residual(m: Mechanism, residual: float) -> None:
    """Warn of a residual without units, if it is more than the last digits."""
    if residual < WORTH_A_WARNING:
        return
    joints = ", ".join(f"'{cut.name}'" for cut in m.cuts)
    warn(
        f"model '{m.model.name}': loops (of {joints}) close to {residual * m.size:.1g} m only. "
        "Redundant conditions disagree by that much, as rounded lengths or axes make them: give "
        "the numbers more digits. Until then the residual is ignored (it may be "
        f"{ROUNDED:g} of the size of the mechanism), and rtol below {MARGIN * residual:.0e} is in "
        "vain",
        SolveWarning,
    )
