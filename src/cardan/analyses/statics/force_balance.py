"""Check the balance of forces at the end of a search for equilibrium, row by row, to rounding.

What may be left of a row is 1e-8 of the loads that act, and the rounding of the forces that meet
there: 50 units of rounding of their sizes. The size of an elastic force is not its value, which
may be 0, but stiffness times position over length: positions are rounded, and strains are their
differences. So a stiff part of a system hides nothing in a soft one.

Source: N. J. Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed. (2002), section 3.1.
"""

from __future__ import annotations

import numpy as np

from ...arrays import Array
from ...errors import SolveError
from ...records import dataclass
from ..systems.dynamic_system import DynamicSystem, Moment
from .static_problem import Load, Matrix, Point, Problem

SHARE = 1e-8  # of the loads that act
HOPS = 2  # a node, its body without mass, the coordinate of their joint
UNITS = 50 * float(np.finfo(float).eps)
WORTH_A_WARNING = 1e-4  # of the loads: rounding above this is told


@dataclass(frozen=True, eq=False)
class Balance:
    """Forces that are left at a point.

    Attributes:
        left: Sizes of the forces (nu + nz,), without units: energies [J].
        rounding: What rounding alone may leave of them (nu + nz,).
        loads: The largest load that acts, without units.
    """

    left: Array
    rounding: Array
    loads: float

    @property
    def holds(self) -> bool:
        """True when every row balances."""
        return bool((self.left <= self.rounding + SHARE * self.loads).all())

    @property
    def worst(self) -> int:
        """The row that is furthest from balance."""
        return int((self.left - self.rounding).argmax()) if len(self.left) else 0

    @property
    def share(self) -> float:
        """The largest rounding over the loads; 0 where nothing acts."""
        return float(self.rounding.max(initial=0.0)) / self.loads if self.loads else 0.0


def balance(
    problem: Problem, point: Point, load: Load, tangent: tuple[Matrix, Matrix] | None = None
) -> Balance:
    """Residual forces at a point under a load.

    Args:
        problem, point, load: Of what, where, under what.
        tangent: K and G there, or next to it: only their sizes are asked for.

    Raises:
        SolveError: forces are not determined there.
    """
    system, at = problem.system, point.at
    K, G = problem.tangent(point, load) if tangent is None else tangent
    force = problem.residual(point, load)[0]
    loads = system.loads(at)
    rounding = elastic(system, at, K)
    rounding[: len(loads)] += UNITS * loads
    # what constraints bear is the sum of other forces, and rounded as these are
    constraint_forces = np.concatenate([at.lam * system.rows, point.reaction_forces])
    for _ in range(HOPS):
        # and these hand on what rounding left of the others
        rounding = np.maximum(
            rounding, abs(G.T) @ (UNITS * np.abs(constraint_forces) + abs(G) @ rounding)
        )
    largest = max(
        float(loads.max(initial=0.0)), float(np.abs(point.reaction_forces).max(initial=0.0))
    )
    return Balance(np.abs(force), rounding, largest)


def elastic(system: DynamicSystem, at: Moment, K: Matrix) -> Array:
    """Elastic forces that rounding of positions may leave (n,), without units.

    Args:
        system: The system.
        at: Where.
        K: Its stiffness there (n, n), without units.
    """
    sizes = np.concatenate([system.sizes(at), np.abs(at.z)])
    rounding: Array = UNITS * (abs(K) @ sizes[: K.shape[0]])
    return rounding


def balances(problem: Problem, point: Point, load: Load, tangent: tuple[Matrix, Matrix]) -> bool:
    """True when forces balance at a point; not where they are not determined."""
    try:
        return balance(problem, point, load, tangent).holds
    except SolveError:
        return False
