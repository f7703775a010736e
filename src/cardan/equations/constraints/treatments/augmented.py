"""Augmented Lagrangian method."""

from __future__ import annotations

from typing import ClassVar

from ....arguments import Count
from ....ir.matrix import Matrix
from ....records import dataclass
from .treatment import Bound, Treatment, by_penalty, stabilized


@dataclass(frozen=True)
class Augmented(Treatment):
    """Penalty with multipliers that take over its forces: a fixed number of repetitions.

    The error of the accelerations falls as (1 / weight) to the power of 1 + repetitions; one
    factorization serves all of them.

    Args:
        weight, frequency, damping: As of the penalty method.
        repetitions: How often the multipliers are mended.

    Source: E. Bayo, J. García de Jalón, M. A. Serna, Comput. Methods Appl. Mech. Eng. 71 (1988).
    """

    name: ClassVar[str] = "augmented"
    exact: ClassVar[bool] = False
    weight: float = 1e5
    frequency: float = 20.0
    damping: float = 1.0
    repetitions: Count = 2

    def accelerations(self, bound: Bound) -> tuple[Matrix, Matrix]:
        gamma = stabilized(bound, self.frequency, self.damping)
        return by_penalty(bound, gamma, self.weight, self.repetitions)
