"""Screw joint."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

from ...ir.matrix import Matrix
from ...spatial.axis import complement, rotation_about, unit
from ..quantity import Direction, Quantity
from ..written import axis, number
from .joint import Component, Joint


@dataclass(frozen=True)
class Screw(Joint):
    """Rotation about an axis that slides along it in proportion; the angle is the coordinate.

    Args:
        axis: Direction in the parent frame: "x", "y", "z", "-x", ... or three numbers or
            expressions (of any length but 0).
        pitch: Displacement per angle [m/rad], not per turn: lead / (2 pi).

    Raises:
        ModelError: the axis is zero, NaN or not a direction; the pitch is no number.

    Source: Featherstone, Rigid Body Dynamics Algorithms, table 4.1.
    """

    kind: ClassVar[str] = "screw"
    source: ClassVar[str] = "R. Featherstone, Rigid Body Dynamics Algorithms, 2008, table 4.1"
    line: ClassVar[str] = "axis"
    axis: Direction = "z"
    pitch: Any = 0.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "axis", axis("screw joint", "axis", self.axis))
        object.__setattr__(self, "pitch", number("screw joint", "pitch", self.pitch))

    @property
    def coordinates(self) -> tuple[Component, ...]:
        return (Component("", "rad"),)

    def quantities(self) -> dict[str, Quantity]:
        return {
            "axis": Quantity(self.axis, ratio=True),
            "pitch": Quantity(self.pitch, "m/rad"),
        }

    def pose(self, q: Matrix, **data: Matrix) -> tuple[Matrix, Matrix]:
        n = unit(data["axis"])
        return rotation_about(n, q[0]), n * (data["pitch"][0] * q[0])

    def motion(self, q: Matrix, **data: Matrix) -> Matrix:
        n = unit(data["axis"])
        return Matrix.vstack(n, n * data["pitch"][0])

    def constrained(self, q: Matrix, **data: Matrix) -> Matrix:
        n = unit(data["axis"])
        across, zero = Matrix.hstack(*complement(n)), Matrix.zeros(q.graph, 3, 2)
        along = Matrix.vstack(-(n * data["pitch"][0]), n)
        return Matrix.hstack(Matrix.vstack(across, zero), Matrix.vstack(zero, across), along)

    def convective(self, q: Matrix, u: Matrix, **data: Matrix) -> Matrix:
        return Matrix.zeros(q.graph, 6)
