"""Spherical joint."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ...ir.matrix import Matrix
from ...spatial.rotations import Rotation, parametrization
from .joint import POSITIONS, Component, Joint


@dataclass(frozen=True)
class Spherical(Joint):
    """Three rotations about a common point.

    The speeds are the angular velocity of the child against the parent in child axes [rad/s],
    whatever the parametrization: where it is singular, only qdot is.

    Args:
        rotation: How the rotation is described: "quaternion" (w, x, y, z), a sequence of angles
            ("XYZ" body-fixed, "xyz" space-fixed, SciPy's rule), "rodrigues", "mrp", "conformal",
            "rotation_vector", "linear", "euler_rodrigues" or "dcm".

    Raises:
        ModelError: the parametrization does not exist.

    Source: Roberson and Schwertassek, Dynamics of Multibody Systems, chapter 9.
    """

    kind: ClassVar[str] = "spherical"
    source: ClassVar[str] = "Roberson, Schwertassek, Dynamics of Multibody Systems, 1988, chapter 9"
    rotation: str = "quaternion"

    def __post_init__(self) -> None:
        parametrization(self.rotation, "spherical joint")

    @property
    def parameters(self) -> Rotation:
        """The parametrization itself."""
        return parametrization(self.rotation)

    @property
    def coordinates(self) -> tuple[Component, ...]:
        r = self.parameters
        return tuple(map(Component, r.components, r.units, r.defaults))

    @property
    def speeds(self) -> tuple[Component, ...]:
        return tuple(Component(name, "rad/s") for name in "xyz")

    def pose(self, q: Matrix, **data: Matrix) -> tuple[Matrix, Matrix]:
        return self.parameters.matrix(q), Matrix.zeros(q.graph, 3)

    def motion(self, q: Matrix, **data: Matrix) -> Matrix:
        return Matrix.vstack(Matrix.identity(q.graph, 3), Matrix.zeros(q.graph, 3, 3))

    def constrained(self, q: Matrix, **data: Matrix) -> Matrix:
        return Matrix.vstack(Matrix.zeros(q.graph, 3, 3), Matrix.identity(q.graph, 3))

    def closure(self, R: Matrix, p: Matrix, **data: Matrix) -> Matrix:
        return p

    @property
    def held(self) -> tuple[Component, ...]:
        return POSITIONS

    def rates(self, q: Matrix, u: Matrix, **data: Matrix) -> Matrix:
        return self.parameters.rates(q, u)

    def speeds_of(self, q: Matrix, qdot: Matrix, **data: Matrix) -> Matrix:
        return self.parameters.omega(q, qdot)

    def convective(self, q: Matrix, u: Matrix, **data: Matrix) -> Matrix:
        return Matrix.zeros(q.graph, 6)

    def integrate(self, q: Matrix, du: Matrix, **data: Matrix) -> Matrix:
        return self.parameters.integrate(q, du)

    def difference(self, q0: Matrix, q1: Matrix, **data: Matrix) -> Matrix:
        return self.parameters.difference(q0, q1)

    @property
    def quaternion(self) -> int | None:
        return 0 if self.parameters.unit_quaternion else None

    @property
    def domain(self) -> str:
        return self.parameters.domain
