"""Penalty method."""

from __future__ import annotations

from typing import ClassVar

from ....ir.matrix import Matrix
from ....records import dataclass
from .treatment import Bound, Treatment, by_penalty, stabilized


@dataclass(frozen=True)
class Penalty(Treatment):
    """Fictitious mass, damper and spring at every constraint: lam = -w (gddot + 2 zeta w0 gdot +
    w0² g).

    The error of the accelerations falls as 1 / weight.

    Args:
        weight: w [kg for rows in m, kg m² for rows in rad].
        frequency: w0 [rad/s].
        damping: zeta.

    Source: E. Bayo, J. García de Jalón, M. A. Serna, Comput. Methods Appl. Mech. Eng. 71 (1988).
    """

    name: ClassVar[str] = "penalty"
    exact: ClassVar[bool] = False
    weight: float = 1e7
    frequency: float = 20.0
    damping: float = 1.0

    def accelerations(self, bound: Bound) -> tuple[Matrix, Matrix]:
        return by_penalty(bound, stabilized(bound, self.frequency, self.damping), self.weight, 0)
