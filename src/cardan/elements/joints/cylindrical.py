"""Cylindrical joint."""

from __future__ import annotations

from typing import ClassVar

from ...ir.matrix import Matrix
from ...records import dataclass
from ...spatial.alignment import tilt
from ...spatial.axis import complement, rotation_about, unit
from ..quantity import RATIO, Direction, Units
from .joint import Component, Joint, Step, locked_across


@dataclass(frozen=True)
class Cylindrical(Joint):
    """Rotation about an axis and sliding along it: q = [angle, displacement].

    Args:
        axis: Direction in the parent frame: "x", "y", "z", "-x", ... or three numbers or
            expressions (of any length but 0).

    Raises:
        ModelError: the axis is zero, NaN or not a direction.

    Source: R. Featherstone, Rigid Body Dynamics Algorithms, 2008, table 4.1.
    """

    kind: ClassVar[str] = "cylindrical"
    units: ClassVar[Units] = {"axis": RATIO}
    line: ClassVar[str] = "axis"
    angle: ClassVar[int | None] = 0
    axis: Direction = "z"

    @property
    def coordinates(self) -> tuple[Component, ...]:
        return Component("angle", "rad"), Component("displacement", "m")

    def steps(self) -> tuple[Step, ...]:
        return Step("angle", self.axis), Step("displacement", self.axis, slides=True)

    def pose(self, q: Matrix, **data: Matrix) -> tuple[Matrix, Matrix]:
        n = unit(data["axis"])
        return rotation_about(n, q[0]), n * q[1]

    def motion(self, q: Matrix, **data: Matrix) -> Matrix:
        n, zero = unit(data["axis"]), Matrix.zeros(q.graph, 3)
        return Matrix.hstack(Matrix.vstack(n, zero), Matrix.vstack(zero, n))

    def constrained(self, q: Matrix, **data: Matrix) -> Matrix:
        across = Matrix.hstack(*complement(unit(data["axis"])))
        zero = Matrix.zeros(q.graph, 3, 2)
        return Matrix.vstack(Matrix.hstack(across, zero), Matrix.hstack(zero, across))

    def closure(self, R: Matrix, p: Matrix, **data: Matrix) -> Matrix:
        n = unit(data["axis"])
        return Matrix.vstack(tilt(R, n), Matrix.hstack(*complement(n)).T @ p)

    @property
    def locked(self) -> tuple[Component, ...]:
        return (*locked_across(self.axis, "r"), *locked_across(self.axis, "p"))

    def assembly_signs(self, R: Matrix, p: Matrix, **data: Matrix) -> Matrix:
        n = unit(data["axis"])
        return n.T @ (R @ n)

    def convective(self, q: Matrix, u: Matrix, **data: Matrix) -> Matrix:
        return Matrix.zeros(q.graph, 6)
