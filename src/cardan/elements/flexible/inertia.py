"""Inertia of beam elements, shared by its kinds."""

from __future__ import annotations

from abc import abstractmethod

from ...ir.arithmetic import Scalar
from ...ir.function import Function, Output
from ...ir.matrix import Matrix
from .element import FlexibleElement, balance, energy, tangents
from .element_ends import Ends
from .section import diagonal

# per length: mass [kg/m], moments of inertia about axes 2 and 3 of the section [kg m]
DENSITY = ("rhoA", "rhoI2", "rhoI3")

# by what shear is soft
SHEAR = ("EI2", "EI3", "GA2", "GA3")


def cubic_share(ends: Ends) -> Scalar:
    """Share of the cubic in the shape of an element: less where shear is soft."""
    length = ends.number("length")
    soft = ends.number("EI2") / ends.number("GA3") + ends.number("EI3") / ends.number("GA2")
    return (1.0 / (1.0 + 6.0 * soft / (length * length))).note("share")


def spin(ends: Ends, share: float) -> Matrix:
    """A share of the moments of inertia of the element (3, 3); about 1 the sum of the others."""
    length = ends.number("length") * share
    second, third = (length * ends.number(name) for name in DENSITY[1:])
    return diagonal(ends.graph, [second + third, second, third])


class InertiaElement(FlexibleElement):
    """Mass of a beam between its ends, with its weight."""

    @abstractmethod
    def loads(self, ends: Ends) -> list[Matrix]:
        """Forces that hold the ends: moment and force on end 1, on end 2."""

    @abstractmethod
    def energies(self, ends: Ends) -> tuple[Matrix, Matrix]:
        """Kinetic and potential energy, (1, 1) each."""

    @abstractmethod
    def momentum(self, ends: Ends) -> Matrix:
        """Angular momentum about the origin of the ground, momentum (6, 1)."""

    def functions(self, ends: Ends) -> dict[str, Function]:
        made_by = ends.graph.made_by
        with made_by("", "loads"):
            loads = ends.assembled(self.loads(ends))
        with made_by("", "momentum"):
            momentum = self.momentum(ends)
        with made_by("", "energy"):
            energies = self.energies(ends)
        names = ("hx", "hy", "hz", "px", "py", "pz")
        units = ("N*m*s",) * 3 + ("N*s",) * 3
        moved = ends.blocks("q", "u", "udot", "p")
        return {
            "balance": self.function(ends, "balance", moved, balance(ends, loads)),
            "balance_tangent": self.function(
                ends, "balance_tangent", moved, *tangents(ends, loads, "q", "u", "udot")
            ),
            "energy": self.function(ends, "energy", ends.blocks("q", "u", "p"), energy(*energies)),
            "momentum": self.function(
                ends,
                "momentum",
                ends.blocks("q", "u", "p"),
                Output("momentum", (6,), momentum.nodes, names, units),
            ),
        }
