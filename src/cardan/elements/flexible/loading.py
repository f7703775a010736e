"""Forces along a beam as forces and moments on its ends, shared by dead and follower loads."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Sequence
from typing import ClassVar

from ...ir.function import Function, Output
from ...ir.matrix import Matrix
from ...records import dataclass
from ..formulas import Lines
from .element import FlexibleElement, balance, energy, tangents
from .element_ends import Ends
from .node_set import Pose


@dataclass(frozen=True)
class LoadElement(FlexibleElement):
    """A force and a moment per length, the same all along the element.

    The force works on the cubic through both ends along their tangents, which makes displacements
    of the ends exact where they are small; the moment works on rotations that vary linearly.

    Attributes:
        fixed: Whether the force keeps its direction: it has a potential then, unless it varies.
        quantities: Names of force and moment.
        variable: More than parameters change them: no data, the ends have their expressions, and
            they have no potential.
    """

    fixed: ClassVar[bool]
    quantities: ClassVar[tuple[str, ...]]
    variable: bool = False

    @property
    def common(self) -> tuple[str, ...]:
        return () if self.variable else self.quantities

    @property
    def variant(self) -> str:
        return "variable" if self.variable else ""

    @property
    def formula_lines(self) -> Lines:
        names = [definition.split(" = ")[0] for _, definition in self.formulas]
        lines = zip(self.formulas, names, strict=True)
        return tuple(line for line, name in lines if not (self.variable and name == "V"))

    @abstractmethod
    def densities(self, ends: Ends, pose: Pose) -> tuple[Matrix, Matrix]:
        """Force in ground axes and moment in axes of the end, per length, as one end has them."""

    def functions(self, ends: Ends) -> dict[str, Function]:
        poses, length = [ends.pose(k) for k in range(2)], ends.number("length")
        axis = Matrix.vector(ends.graph, [1.0, 0.0, 0.0])
        forces: list[Matrix] = []
        moments: list[Matrix] = []
        potential = Matrix.zeros(ends.graph, 1)
        for pose, (along, force) in zip(poses, self.shares(ends, poses), strict=True):
            forces += [-axis.cross(pose.rotation.T @ along), -force]
            moments += [self.densities(ends, pose)[1] * (length * -0.5), force * 0.0]
            potential = potential - along.T @ pose.rotation.column(0) - force.T @ pose.position
        return self._functions(ends, ends.assembled(forces), ends.assembled(moments), potential)

    def _functions(
        self, ends: Ends, forces: Matrix, moments: Matrix, potential: Matrix
    ) -> dict[str, Function]:
        """The functions of loads on the nodes, from forces and from moments."""
        loads, read, changes = forces + moments, ends.blocks("q", "p"), "q"
        moving = ends.blocks("q", "u", "p")
        if self.variable:
            read, changes = ends.blocks("t", "q", "u", "z", "s", "r", "p"), "qu"
            moving = read
        speeds = Matrix(
            ends.graph, loads.rows, 1, [ends.graph.var("u", k) for k in range(loads.rows)]
        )
        # forces of a fixed direction and size have a potential, and no power besides
        conservative = self.fixed and not self.variable
        driving = moments if conservative else loads
        power = Output("power", (1,), (-(driving.T @ speeds)).nodes, ("power",), ("W",))
        functions = {
            "balance": self.function(ends, "balance", read, balance(ends, loads)),
            "balance_tangent": self.function(
                ends, "balance_tangent", read, *tangents(ends, loads, *changes)
            ),
            "power": self.function(ends, "power", moving, power),
        }
        if conservative:
            functions["energy"] = self.function(ends, "energy", read, energy(None, potential))
        return functions

    def shares(self, ends: Ends, poses: Sequence[Pose]) -> list[tuple[Matrix, Matrix]]:
        """Shares of a load on the tangent and on the position of each end (3, 1) [N m, N]."""
        length = ends.number("length")
        one, two = (self.densities(ends, pose)[0] for pose in poses)
        shares: list[tuple[Matrix, Matrix]] = []
        for near, far, sign in ((one, two, 1.0), (two, one, -1.0)):
            force = near * (length * 0.35) + far * (length * 0.15)
            square = length * length * sign
            shares.append((near * (square / 20.0) + far * (square / 30.0), force))
        return shares
