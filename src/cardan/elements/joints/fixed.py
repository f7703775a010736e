"""Fixed joint."""

from __future__ import annotations

from typing import ClassVar

from ...ir.matrix import Matrix
from ...records import dataclass
from ...spatial.alignment import diagonal, rotation_vector
from .joint import POSITIONS, ROTATIONS, Component, Joint


@dataclass(frozen=True)
class Fixed(Joint):
    """No motion: the two bodies become one, keep their frames, and the reaction can be asked for.

    Source: R. Featherstone, Rigid Body Dynamics Algorithms, 2008, section 3.3.
    """

    kind: ClassVar[str] = "fixed"

    @property
    def coordinates(self) -> tuple[Component, ...]:
        return ()

    def pose(self, q: Matrix, **data: Matrix) -> tuple[Matrix, Matrix]:
        return Matrix.identity(q.graph, 3), Matrix.zeros(q.graph, 3)

    def motion(self, q: Matrix, **data: Matrix) -> Matrix:
        return Matrix.zeros(q.graph, 6, 0)

    def constrained(self, q: Matrix, **data: Matrix) -> Matrix:
        return Matrix.identity(q.graph, 6)

    def closure(self, R: Matrix, p: Matrix, **data: Matrix) -> Matrix:
        return Matrix.vstack(rotation_vector(R), p)

    @property
    def locked(self) -> tuple[Component, ...]:
        return (*ROTATIONS, *POSITIONS)

    def assembly_signs(self, R: Matrix, p: Matrix, **data: Matrix) -> Matrix:
        return diagonal(R)
