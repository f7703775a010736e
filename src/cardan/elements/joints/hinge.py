"""Turning about one axis: what a revolute joint and a gear have in common."""

from __future__ import annotations

from typing import ClassVar

from ...ir.matrix import Matrix
from ...spatial.alignment import tilt
from ...spatial.axis import complement, rotation_about, unit
from ..quantity import RATIO, Direction, Units
from .joint import POSITIONS, Component, Joint, locked_across, single


class Hinge(Joint):
    """A rotation about ``axis``, fixed in both bodies; the angle [rad] is the coordinate."""

    line: ClassVar[str] = "axis"
    units: ClassVar[Units] = {"axis": RATIO}
    angle: ClassVar[int | None] = 0
    axis: Direction

    @property
    def coordinates(self) -> tuple[Component, ...]:
        return single("rad")

    def pose(self, q: Matrix, **data: Matrix) -> tuple[Matrix, Matrix]:
        return rotation_about(unit(data["axis"]), q[0]), Matrix.zeros(q.graph, 3)

    def motion(self, q: Matrix, **data: Matrix) -> Matrix:
        return Matrix.vstack(unit(data["axis"]), Matrix.zeros(q.graph, 3))

    def constrained(self, q: Matrix, **data: Matrix) -> Matrix:
        across = Matrix.hstack(*complement(unit(data["axis"])))
        graph = q.graph
        return Matrix.vstack(
            Matrix.hstack(across, Matrix.zeros(graph, 3, 3)),
            Matrix.hstack(Matrix.zeros(graph, 3, 2), Matrix.identity(graph, 3)),
        )

    def closure(self, R: Matrix, p: Matrix, **data: Matrix) -> Matrix:
        return Matrix.vstack(tilt(R, unit(data["axis"])), p)

    @property
    def locked(self) -> tuple[Component, ...]:
        return (*locked_across(self.axis, "r"), *POSITIONS)

    def assembly_signs(self, R: Matrix, p: Matrix, **data: Matrix) -> Matrix:
        n = unit(data["axis"])
        return n.T @ (R @ n)

    def convective(self, q: Matrix, u: Matrix, **data: Matrix) -> Matrix:
        return Matrix.zeros(q.graph, 6)
