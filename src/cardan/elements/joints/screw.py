"""Screw joint."""

from __future__ import annotations

from typing import ClassVar

from ...ir.arithmetic import atan2, cos, select, sin
from ...ir.matrix import Matrix
from ...records import dataclass
from ...spatial.alignment import tilt
from ...spatial.axis import complement, rotation_about, unit
from ..quantity import RATIO, Direction, Units, Value
from .joint import Component, Joint, locked_across, locked_along, single


@dataclass(frozen=True)
class Screw(Joint):
    """Rotation about an axis that slides along it in proportion; the angle is the coordinate.

    Args:
        axis: Direction in the parent frame: "x", "y", "z", "-x", ... or three numbers or
            expressions (of any length but 0).
        pitch: Displacement per angle [m/rad], not per turn: lead / (2 pi).

    Raises:
        ModelError: the axis is zero, NaN or not a direction; the pitch is not a number.

    Source: R. Featherstone, Rigid Body Dynamics Algorithms, 2008, table 4.1.
    """

    kind: ClassVar[str] = "screw"
    units: ClassVar[Units] = {"axis": RATIO, "pitch": "m/rad"}
    line: ClassVar[str] = "axis"
    axis: Direction = "z"
    pitch: Value = 0.0

    @property
    def coordinates(self) -> tuple[Component, ...]:
        return single("rad")

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

    def closure(self, R: Matrix, p: Matrix, **data: Matrix) -> Matrix:
        """The last row is the displacement minus pitch times angle, without whole turns.

        A pose knows the angle up to turns only: the row is the remainder within half a lead.
        """
        n, pitch = unit(data["axis"]), data["pitch"][0]
        first, second = complement(n)
        x, y, z = first.dot(R @ first), second.dot(R @ first), n.dot(p)
        # the angle that belongs to the displacement, minus that of R, within half a turn
        flat = pitch.apply("eq", 0.0)
        angle = z / select(flat, 1.0, pitch)
        c, s = cos(angle), sin(angle)
        mismatch = select(flat, z, pitch * atan2(s * x - c * y, c * x + s * y))
        sideways = Matrix.hstack(first, second).T @ p
        return Matrix.vstack(tilt(R, n), sideways, Matrix.vector(R.graph, [mismatch]))

    @property
    def locked(self) -> tuple[Component, ...]:
        sideways = locked_across(self.axis, "p")
        return (
            *locked_across(self.axis, "r"),
            *sideways,
            Component(locked_along(self.axis, "p"), "m"),
        )

    def assembly_signs(self, R: Matrix, p: Matrix, **data: Matrix) -> Matrix:
        n = unit(data["axis"])
        return n.T @ (R @ n)

    def convective(self, q: Matrix, u: Matrix, **data: Matrix) -> Matrix:
        return Matrix.zeros(q.graph, 6)
