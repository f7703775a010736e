"""Lagrange multipliers."""

from __future__ import annotations

from typing import ClassVar

from ....ir.matrix import Matrix
from ....records import dataclass
from .treatment import Bound, Treatment, by_multipliers


@dataclass(frozen=True)
class Multipliers(Treatment):
    """Forces of constraint from G M⁻¹ Gᵀ lam = gamma - G M⁻¹ drive.

    M is eliminated in static order; the circuit matrix is factored with pivoting, so that rows
    which depend on others do no harm: their multipliers are 0. Positions and velocities are kept
    on the constraints by projection between steps; there are no gains.

    Source: Roberson and Schwertassek, Dynamics of Multibody Systems, section 8.4.
    """

    name: ClassVar[str] = "multipliers"
    exact: ClassVar[bool] = True

    def accelerations(self, bound: Bound) -> tuple[Matrix, Matrix]:
        return by_multipliers(bound, bound.gamma)
