"""Planar joint."""

from __future__ import annotations

from typing import ClassVar

from ...ir.matrix import Matrix
from ...records import dataclass
from ...spatial.alignment import tilt
from ...spatial.axis import complement, rotation_about, unit
from ..quantity import RATIO, Direction, Units
from .joint import Component, Joint, Step, letter, locked_across, locked_along


@dataclass(frozen=True)
class Planar(Joint):
    """Sliding in a plane and turning about its normal: q = [x, y, angle].

    x and y are along two directions of the parent that make a right-handed triad with the normal:
    the parent's own axes where the normal is one of them (x, y for "z"; y, z for "x"; z, x for
    "y").

    Args:
        normal: Direction in the parent frame: "x", "y", "z", "-x", ... or three numbers or
            expressions (of any length but 0).

    Raises:
        ModelError: the normal is zero, NaN or not a direction.

    Source: Featherstone, Rigid Body Dynamics Algorithms, table 4.1 (with speeds of our own).
    """

    kind: ClassVar[str] = "planar"
    units: ClassVar[Units] = {"normal": RATIO}
    normal: Direction = "z"

    @property
    def coordinates(self) -> tuple[Component, ...]:
        return Component("x", "m"), Component("y", "m"), Component("angle", "rad")

    def steps(self) -> tuple[Step, ...]:
        k, sign = letter(self.normal)
        if k is None:
            return ()
        first, second = ("yzx"[k], "zxy"[k])[::sign]
        slides = Step("x", first, slides=True), Step("y", second, slides=True)
        return (*slides, Step("angle", self.normal))

    def pose(self, q: Matrix, **data: Matrix) -> tuple[Matrix, Matrix]:
        n = unit(data["normal"])
        first, second = complement(n)
        return rotation_about(n, q[2]), first * q[0] + second * q[1]

    def motion(self, q: Matrix, **data: Matrix) -> Matrix:
        n, zero = unit(data["normal"]), Matrix.zeros(q.graph, 3)
        directions = rotation_about(n, q[2]).T @ Matrix.hstack(*complement(n))
        sliding = Matrix.vstack(Matrix.zeros(q.graph, 3, 2), directions)
        return Matrix.hstack(sliding, Matrix.vstack(n, zero))

    def constrained(self, q: Matrix, **data: Matrix) -> Matrix:
        n, zero = unit(data["normal"]), Matrix.zeros(q.graph, 3)
        across = Matrix.vstack(Matrix.hstack(*complement(n)), Matrix.zeros(q.graph, 3, 2))
        return Matrix.hstack(across, Matrix.vstack(zero, n))

    def closure(self, R: Matrix, p: Matrix, **data: Matrix) -> Matrix:
        n = unit(data["normal"])
        return Matrix.vstack(tilt(R, n), n.T @ p)

    @property
    def locked(self) -> tuple[Component, ...]:
        return (*locked_across(self.normal, "r"), Component(locked_along(self.normal, "p"), "m"))

    def assembly_signs(self, R: Matrix, p: Matrix, **data: Matrix) -> Matrix:
        n = unit(data["normal"])
        return n.T @ (R @ n)

    def convective(self, q: Matrix, u: Matrix, **data: Matrix) -> Matrix:
        # the speeds are along directions of the parent: nothing is left without udot
        return Matrix.zeros(q.graph, 6)
