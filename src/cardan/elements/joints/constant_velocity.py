"""Constant-velocity joint."""

from __future__ import annotations

import math
from typing import ClassVar

from ...ir.matrix import Matrix
from ...records import dataclass
from ...spatial.axis import complement, rotation_about, unit
from ..quantity import RATIO, Direction, Units
from .joint import POSITIONS, Component, Joint


@dataclass(frozen=True)
class ConstantVelocity(Joint):
    """A bent shaft that passes on rotation without change of speed: q = [angle1, angle2].

    The child is turned about a direction across the shaft, never about the shaft itself. The
    coordinates are the angles about the two directions across it (the parent's own axes where the
    shaft is one of them: x, y for "z"): half of the first, the second, the other half of the first.

    Args:
        axis: Direction of the shaft in the parent frame: "x", "y", "z", "-x", ... or three
            numbers or expressions (of any length but 0).

    Raises:
        ModelError: the axis is zero, NaN or not a direction.

    Source: K. H. Hunt, Constant-Velocity Shaft Couplings: A General Theory, J. Engineering for
        Industry 95 (1973).
    """

    kind: ClassVar[str] = "constant_velocity"
    title: ClassVar[str] = "constant-velocity joint"
    units: ClassVar[Units] = {"axis": RATIO}
    axis: Direction = "z"

    @property
    def coordinates(self) -> tuple[Component, ...]:
        return Component("angle1", "rad"), Component("angle2", "rad", reach=math.pi)

    def pose(self, q: Matrix, **data: Matrix) -> tuple[Matrix, Matrix]:
        first, second = complement(unit(data["axis"]))
        half = rotation_about(first, q[0] * 0.5)
        return half @ rotation_about(second, q[1]) @ half, Matrix.zeros(q.graph, 3)

    def _axes(self, q: Matrix, data: dict[str, Matrix]) -> tuple[Matrix, Matrix]:
        """Directions in the child about which the two angles turn."""
        first, second = complement(unit(data["axis"]))
        half = rotation_about(first, q[0] * 0.5).T
        outer = half @ (rotation_about(second, q[1]).T @ first)
        return (first + outer) * 0.5, half @ second

    def motion(self, q: Matrix, **data: Matrix) -> Matrix:
        axes = Matrix.hstack(*self._axes(q, data))
        return Matrix.vstack(axes, Matrix.zeros(q.graph, 3, 2))

    def constrained(self, q: Matrix, **data: Matrix) -> Matrix:
        first, second = self._axes(q, data)
        forces = Matrix.vstack(Matrix.zeros(q.graph, 3, 3), Matrix.identity(q.graph, 3))
        return Matrix.hstack(Matrix.vstack(first.cross(second), Matrix.zeros(q.graph, 3)), forces)

    def closure(self, R: Matrix, p: Matrix, **data: Matrix) -> Matrix:
        # no component of the rotation along the shaft
        first, second = complement(unit(data["axis"]))
        twist = (second.dot(R @ first) - first.dot(R @ second)) * 0.5
        return Matrix.vstack(Matrix.vector(R.graph, [twist]), p)

    @property
    def locked(self) -> tuple[Component, ...]:
        return (Component("twist", "rad"), *POSITIONS)

    def assembly_signs(self, R: Matrix, p: Matrix, **data: Matrix) -> Matrix:
        # a half turn about any direction closes too, and so does the shaft twisted by one
        return Matrix.vector(R.graph, [1 + R[0, 0] + R[1, 1] + R[2, 2]])

    @property
    def domain(self) -> str:
        return "bends by less than 180 degrees: |angle2| < 180 degrees"
