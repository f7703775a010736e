"""Joints of superelements: small motions of an interface, and modal coordinates."""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar

from ..ir.matrix import Matrix
from ..records import dataclass
from ..spatial.exponential import exp, tangent
from .joints.joint import Component, Joint

TRANSLATIONS, ROTATIONS = ("x", "y", "z"), ("rx", "ry", "rz")


@dataclass(frozen=True)
class Elastic(Joint):
    """Motion of an interface against the frame of its superelement.

    A displacement in axes of the frame and a rotation vector; the speeds are their rates.

    Args:
        motions: Which of x, y, z, rx, ry, rz it has: of the rotations one, all or none.

    Source: Géradin and Cardona, Flexible Multibody Dynamics (2001), section 8.4.
    """

    kind: ClassVar[str] = "elastic"
    motions: tuple[str, ...] = (*TRANSLATIONS, *ROTATIONS)

    @property
    def coordinates(self) -> tuple[Component, ...]:
        return tuple(Component(name, "rad" if name in ROTATIONS else "m") for name in self.motions)

    def pose(self, q: Matrix, **data: Matrix) -> tuple[Matrix, Matrix]:
        return exp(self._part(q, ROTATIONS)), self._part(q, TRANSLATIONS)

    def _part(self, q: Matrix, names: Sequence[str]) -> Matrix:
        """Three entries of the displacement or of the rotation vector, those without motion 0."""
        entries = dict(zip(self.motions, q, strict=True))
        return Matrix.vector(q.graph, [entries.get(name, 0.0) for name in names])

    def motion(self, q: Matrix, **data: Matrix) -> Matrix:
        return self._columns(q, self.motions)

    def constrained(self, q: Matrix, **data: Matrix) -> Matrix:
        missing = [name for name in (*ROTATIONS, *TRANSLATIONS) if name not in self.motions]
        return self._columns(q, missing)

    def _columns(self, q: Matrix, names: Sequence[str]) -> Matrix:
        """Velocities of the child, in its axes, by unit rates of some motions (6, names)."""
        theta, graph = self._part(q, ROTATIONS), q.graph
        rotation, rates, zero = exp(theta), tangent(theta), Matrix.zeros(graph, 3)
        # about one axis the rotation vector turns as its angle does, and other axes stay
        single = sum(name in ROTATIONS for name in self.motions) < len(ROTATIONS)
        rates = Matrix.identity(graph, 3) if single else rates
        columns = [Matrix.zeros(graph, 6, 0)]
        for name in names:
            if name in ROTATIONS:
                parts = rates.column(ROTATIONS.index(name)), zero
            else:
                parts = zero, rotation.T.column(TRANSLATIONS.index(name))
            columns.append(Matrix.vstack(*parts))
        return Matrix.hstack(*columns)

    @property
    def closes_by_coordinates(self) -> bool:
        return True


@dataclass(frozen=True)
class Modal(Joint):
    """Modal coordinates of a superelement: they move none of its interfaces.

    Args:
        count: Number of modes.
    """

    kind: ClassVar[str] = "modal"
    count: int = 1

    @property
    def coordinates(self) -> tuple[Component, ...]:
        return tuple(Component(f"mode{k + 1}", "") for k in range(self.count))

    def pose(self, q: Matrix, **data: Matrix) -> tuple[Matrix, Matrix]:
        return Matrix.identity(q.graph, 3), Matrix.zeros(q.graph, 3)

    def motion(self, q: Matrix, **data: Matrix) -> Matrix:
        return Matrix.zeros(q.graph, 6, self.count)

    def constrained(self, q: Matrix, **data: Matrix) -> Matrix:
        return Matrix.identity(q.graph, 6)

    @property
    def closes_by_coordinates(self) -> bool:
        return True
