"""A straight piece of a cable, or a bar of a truss."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ...ir.arithmetic import norm
from ...ir.function import Function
from ...ir.matrix import Matrix
from ..formulas import Lines
from .element import FlexibleElement, balance, energy, tangents
from .element_ends import Ends
from .formulas import CABLE, TRUSS


@dataclass(frozen=True)
class Cable(FlexibleElement):
    """Elastic along the line between its ends, between points or anything else.

    The strain is that of the distance, ell/L - 1 less ``strain_4``: ``energy = EA L strain² / 2``;
    pieces of a cable are slack where it is negative.

    Args:
        compression: The bar of a truss: it pushes too.

    Source: Irvine, Cable Structures (1981), chapter 1; Géradin and Cardona, Flexible Multibody
        Dynamics (2001), section 5.2.
    """

    kind: ClassVar[str] = "cable"
    geometric: ClassVar[tuple[str, ...]] = ("length",)
    compression: bool = False

    @property
    def common(self) -> tuple[str, ...]:
        return ("EA", "strain_4")

    @property
    def variant(self) -> str:
        return "truss" if self.compression else ""

    @property
    def formula_lines(self) -> Lines:
        return TRUSS if self.compression else CABLE

    def functions(self, ends: Ends) -> dict[str, Function]:
        length, stiffness = ends.number("length"), ends.number("EA")
        span = ends.pose(1).position - ends.pose(0).position
        distance = norm(*span)
        strain = distance / length - 1.0 - ends.number("strain_4")
        if not self.compression:
            strain = strain.apply("max", 0.0)
        pull = span * (stiffness * strain / distance)
        none, read = Matrix.zeros(ends.graph, 3), ends.blocks("q", "p")
        loads = ends.assembled([none, -pull, none, pull])
        stored = Matrix.vector(ends.graph, [0.5 * length * stiffness * strain * strain])
        return {
            "balance": self.function(ends, "balance", read, balance(ends, loads)),
            "balance_tangent": self.function(
                ends, "balance_tangent", read, *tangents(ends, loads, "q")
            ),
            "energy": self.function(ends, "energy", read, energy(None, stored)),
        }
