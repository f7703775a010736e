"""Perturbed Lagrangian method."""

from __future__ import annotations

from typing import ClassVar

from ....ir.matrix import Matrix
from ....records import dataclass
from .treatment import Bound, Treatment, by_multipliers, stabilized


@dataclass(frozen=True)
class Perturbed(Treatment):
    """Multipliers of constraints that give a little: G udot - gamma + compliance lam = 0.

    The matrix (G M⁻¹ Gᵀ + compliance) is regular whatever the constraints are: redundant ones
    share their force evenly. The error of the accelerations falls with the compliance.

    Args:
        compliance: [1/kg for rows in m, 1/(kg m²) for rows in rad].
        frequency: Of the decay of drift [rad/s].
        damping: Of that decay.

    Source: J. C. Simo, P. Wriggers, R. L. Taylor, Comput. Methods Appl. Mech. Eng. 50 (1985);
        Géradin and Cardona, Flexible Multibody Dynamics (2001).
    """

    name: ClassVar[str] = "perturbed"
    exact: ClassVar[bool] = False
    compliance: float = 1e-8
    frequency: float = 20.0
    damping: float = 1.0

    def accelerations(self, bound: Bound) -> tuple[Matrix, Matrix]:
        gamma = stabilized(bound, self.frequency, self.damping)
        return by_multipliers(bound, gamma, self.compliance)
