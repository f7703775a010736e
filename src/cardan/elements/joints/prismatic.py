"""Prismatic joint."""

from __future__ import annotations

from typing import ClassVar

from ...ir.matrix import Matrix
from ...records import dataclass
from ...spatial.alignment import diagonal, rotation_vector
from ...spatial.axis import complement, unit
from ..quantity import RATIO, Direction, Units
from .joint import ROTATIONS, Component, Joint, locked_across, single


@dataclass(frozen=True)
class Prismatic(Joint):
    """One translation along an axis fixed in both bodies.

    Args:
        axis: Direction in the parent frame: "x", "y", "z", "-x", ... or three numbers or
            expressions (of any length but 0). The displacement [m] is the coordinate.

    Raises:
        ModelError: the axis is zero, NaN or not a direction.

    Source: R. Featherstone, Rigid Body Dynamics Algorithms, 2008, table 4.1.
    """

    kind: ClassVar[str] = "prismatic"
    units: ClassVar[Units] = {"axis": RATIO}
    line: ClassVar[str] = "axis"
    axis: Direction = "z"

    @property
    def coordinates(self) -> tuple[Component, ...]:
        return single("m")

    def pose(self, q: Matrix, **data: Matrix) -> tuple[Matrix, Matrix]:
        return Matrix.identity(q.graph, 3), unit(data["axis"]) * q[0]

    def motion(self, q: Matrix, **data: Matrix) -> Matrix:
        return Matrix.vstack(Matrix.zeros(q.graph, 3), unit(data["axis"]))

    def constrained(self, q: Matrix, **data: Matrix) -> Matrix:
        across = Matrix.hstack(*complement(unit(data["axis"])))
        graph = q.graph
        return Matrix.vstack(
            Matrix.hstack(Matrix.identity(graph, 3), Matrix.zeros(graph, 3, 2)),
            Matrix.hstack(Matrix.zeros(graph, 3, 3), across),
        )

    def closure(self, R: Matrix, p: Matrix, **data: Matrix) -> Matrix:
        sideways = Matrix.hstack(*complement(unit(data["axis"]))).T @ p
        return Matrix.vstack(rotation_vector(R), sideways)

    @property
    def locked(self) -> tuple[Component, ...]:
        return (*ROTATIONS, *locked_across(self.axis, "p"))

    def assembly_signs(self, R: Matrix, p: Matrix, **data: Matrix) -> Matrix:
        return diagonal(R)

    def convective(self, q: Matrix, u: Matrix, **data: Matrix) -> Matrix:
        return Matrix.zeros(q.graph, 6)
