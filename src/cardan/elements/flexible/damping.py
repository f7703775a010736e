"""Structural damping of a beam element."""

from __future__ import annotations

from typing import ClassVar

from ...ir.function import Function, Output
from ...records import dataclass
from ...spatial.short_rotations import Slopes
from ..formulas import Lines, Shapes
from .element import FlexibleElement, balance, tangents
from .element_ends import Ends
from .formulas import DAMPING, STRAIN_SHAPES
from .relative import Relative, forces, moved, transport, transport_slope
from .section import STIFFNESS, diagonal, without_locking


@dataclass(frozen=True)
class Damping(FlexibleElement):
    """Stress proportional to the rate of strain, after Kelvin and Voigt.

    It is the stiffness of the section times ``damping`` [s] times the rate of the helicoidal
    strain, ``stress = damping C y' / L``; shear is as soft as in an element that bends linearly, so
    that slender elements are not damped for strains that they do not have.

    Source: J. Linn, H. Lang, A. Tuganov, Geometrically exact Cosserat rods with Kelvin-Voigt type
        viscous damping, Mechanical Sciences 4, 2013.
    """

    kind: ClassVar[str] = "damping"
    geometric: ClassVar[tuple[str, ...]] = ("length",)
    symbol_shapes: ClassVar[Shapes] = STRAIN_SHAPES
    formulas: ClassVar[Lines] = DAMPING

    @property
    def common(self) -> tuple[str, ...]:
        return (*STIFFNESS, "damping")

    def functions(self, ends: Ends) -> dict[str, Function]:
        at = Relative.of(ends.pose(0), ends.pose(1))
        one, two = ends.motion(0), ends.motion(1)
        first, second = Slopes(-0.5), at.inverse
        # rates of theta and e are linear in those of the ends, as their changes are
        speeds = (one.omega, one.velocity, two.omega, two.velocity)
        rate = moved(at, speeds, first, second)
        length = ends.number("length")
        stiffness = without_locking(list(ends.vector(*STIFFNESS)), length)
        factor = ends.number("damping") / length
        stress = diagonal(ends.graph, [x * factor for x in stiffness]) @ rate
        m, n = stress.block(slice(3)), stress.block(slice(3, 6))
        bent = transport_slope(at.turn, first, second, at.position)
        moment = at.slope.T @ (m + bent.T @ n)
        loads = ends.assembled(forces(at, moment, transport(at.turn, first, second).T @ n))
        power = Output("power", (1,), (-(stress.T @ rate)).nodes, ("power",), ("W",))
        read = ends.blocks("q", "u", "p")
        return {
            "balance": self.function(ends, "balance", read, balance(ends, loads)),
            "balance_tangent": self.function(
                ends, "balance_tangent", read, *tangents(ends, loads, "q", "u")
            ),
            "power": self.function(ends, "power", read, power),
        }
