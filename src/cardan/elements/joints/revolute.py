"""Revolute joint."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ...ir.matrix import Matrix
from ...spatial.alignment import tilt
from ...spatial.axis import complement, rotation_about, unit
from ..quantity import Direction, Quantity
from ..written import axis
from .joint import POSITIONS, Component, Joint, held_across


@dataclass(frozen=True)
class Revolute(Joint):
    """One rotation about an axis fixed in both bodies.

    Args:
        axis: Direction in the parent frame: "x", "y", "z", "-x", ... or three numbers or
            expressions (of any length but 0). The angle [rad] is the coordinate.

    Raises:
        ModelError: the axis is zero, NaN or not a direction.

    Source: Featherstone, Rigid Body Dynamics Algorithms, table 4.1.
    """

    kind: ClassVar[str] = "revolute"
    source: ClassVar[str] = "R. Featherstone, Rigid Body Dynamics Algorithms, 2008, table 4.1"
    line: ClassVar[str] = "axis"
    angle: ClassVar[int | None] = 0
    axis: Direction = "z"

    def __post_init__(self) -> None:
        object.__setattr__(self, "axis", axis("revolute joint", "axis", self.axis))

    @property
    def coordinates(self) -> tuple[Component, ...]:
        return (Component("", "rad"),)

    def quantities(self) -> dict[str, Quantity]:
        return {"axis": Quantity(self.axis, ratio=True)}

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
    def held(self) -> tuple[Component, ...]:
        return (*held_across(self.axis, "r"), *POSITIONS)

    def facing(self, R: Matrix, p: Matrix, **data: Matrix) -> Matrix:
        n = unit(data["axis"])
        return n.T @ (R @ n)

    def convective(self, q: Matrix, u: Matrix, **data: Matrix) -> Matrix:
        return Matrix.zeros(q.graph, 6)
