"""Joint of three translations."""

from __future__ import annotations

from typing import ClassVar

from ...ir.matrix import Matrix
from ...records import dataclass
from ...spatial.alignment import diagonal, rotation_vector
from .joint import ROTATIONS, Component, Joint, Step


@dataclass(frozen=True)
class Translation(Joint):
    """Sliding in all three directions of the parent without turning: q = [x, y, z].

    For a particle, or for a gantry whose axes need no bodies of their own.

    Source: R. Featherstone, Rigid Body Dynamics Algorithms, 2008, table 4.1 (prismatic joints).
    """

    kind: ClassVar[str] = "translation"

    @property
    def coordinates(self) -> tuple[Component, ...]:
        return tuple(Component(axis, "m") for axis in "xyz")

    def steps(self) -> tuple[Step, ...]:
        return tuple(Step(axis, axis, slides=True) for axis in "xyz")

    def pose(self, q: Matrix, **data: Matrix) -> tuple[Matrix, Matrix]:
        return Matrix.identity(q.graph, 3), q

    def motion(self, q: Matrix, **data: Matrix) -> Matrix:
        return Matrix.vstack(Matrix.zeros(q.graph, 3, 3), Matrix.identity(q.graph, 3))

    def constrained(self, q: Matrix, **data: Matrix) -> Matrix:
        return Matrix.vstack(Matrix.identity(q.graph, 3), Matrix.zeros(q.graph, 3, 3))

    def closure(self, R: Matrix, p: Matrix, **data: Matrix) -> Matrix:
        return rotation_vector(R)

    @property
    def locked(self) -> tuple[Component, ...]:
        return ROTATIONS

    def assembly_signs(self, R: Matrix, p: Matrix, **data: Matrix) -> Matrix:
        return diagonal(R)

    def convective(self, q: Matrix, u: Matrix, **data: Matrix) -> Matrix:
        return Matrix.zeros(q.graph, 6)
