"""Baumgarte's stabilization."""

from __future__ import annotations

from typing import ClassVar

from ....ir.matrix import Matrix
from ....records import dataclass
from .treatment import Bound, Treatment, by_multipliers, stabilized


@dataclass(frozen=True)
class Baumgarte(Treatment):
    """Multipliers for gddot + 2 zeta w0 gdot + w0² g = 0 instead of gddot = 0.

    Drift decays instead of being projected away. On the constraints the accelerations are exact.

    Args:
        frequency: w0 [rad/s].
        damping: zeta; 1 decays without overshoot.

    Source: J. Baumgarte, Comput. Methods Appl. Mech. Eng. 1 (1972).
    """

    name: ClassVar[str] = "baumgarte"
    exact: ClassVar[bool] = True
    frequency: float = 20.0
    damping: float = 1.0

    def accelerations(self, bound: Bound) -> tuple[Matrix, Matrix]:
        return by_multipliers(bound, stabilized(bound, self.frequency, self.damping))
