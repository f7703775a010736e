"""Spherical joint."""

from __future__ import annotations

from typing import ClassVar

from ...ir.matrix import Matrix
from ...records import dataclass
from .guided import Guided, turns
from .joint import POSITIONS, Component, Step


@dataclass(frozen=True)
class Spherical(Guided):
    """Three rotations about a common point.

    The speeds are the angular velocity of the child against the parent in child axes [rad/s],
    whatever the parametrization: where it is singular, only qdot is.

    Args:
        rotation: How the rotation is described: "quaternion" (w, x, y, z), a sequence of angles
            ("XYZ" body-fixed, "xyz" space-fixed, SciPy's rule), "rodrigues", "mrp", "conformal",
            "rotation_vector", "linear", "euler_rodrigues" or "dcm".

    Raises:
        ModelError: the parametrization does not exist.

    Source: Roberson, Schwertassek, Dynamics of Multibody Systems, 1988, chapter 9.
    """

    kind: ClassVar[str] = "spherical"
    rotation: str = "quaternion"

    def steps(self) -> tuple[Step, ...]:
        return turns(self.rotation)

    @property
    def guides(self) -> tuple[Component, ...]:
        return ()

    def place(self, c: Matrix, **data: Matrix) -> Matrix:
        return Matrix.zeros(c.graph, 3)

    def slope(self, c: Matrix, **data: Matrix) -> Matrix:
        return Matrix.zeros(c.graph, 3, 0)

    def blocked(self, c: Matrix, **data: Matrix) -> Matrix:
        return Matrix.identity(c.graph, 3)

    def bend(self, c: Matrix, rate: Matrix, **data: Matrix) -> Matrix:
        return Matrix.zeros(c.graph, 3)

    def closure(self, R: Matrix, p: Matrix, **data: Matrix) -> Matrix:
        return p

    @property
    def locked(self) -> tuple[Component, ...]:
        return POSITIONS
