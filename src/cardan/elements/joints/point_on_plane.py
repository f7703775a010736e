"""A point of the child that stays in a plane of the parent."""

from __future__ import annotations

from typing import ClassVar

from ...ir.matrix import Matrix
from ...records import dataclass
from ...spatial.axis import complement, unit
from ..quantity import RATIO, Direction, Units
from .guided import Guided
from .joint import Component, locked_along


@dataclass(frozen=True)
class PointOnPlane(Guided):
    """The child's origin slides in a plane of the parent, and the child turns freely about it.

    q = [rotation, x, y], u = [angular velocity in child axes [rad/s], rates of x and y]. x and y
    are along two directions of the parent that make a right-handed triad with the normal: the
    parent's own axes where the normal is one of them (x, y for "z"; y, z for "x"; z, x for "y").

    Args:
        normal: Direction in the parent frame: "x", "y", "z", "-x", ... or three numbers or
            expressions (of any length but 0).
        rotation: How the rotation is described, as of :class:`Spherical`.

    Raises:
        ModelError: the normal is zero, NaN or not a direction; the parametrization does not exist.

    Source: M. Géradin, A. Cardona, Flexible Multibody Dynamics, 2001, chapter 7.
    """

    kind: ClassVar[str] = "point_on_plane"
    title: ClassVar[str] = "point on a plane"
    units: ClassVar[Units] = {"normal": RATIO}
    normal: Direction = "z"
    rotation: str = "quaternion"

    @property
    def guides(self) -> tuple[Component, ...]:
        return Component("px", "m"), Component("py", "m")

    def place(self, c: Matrix, **data: Matrix) -> Matrix:
        return self.slope(c, **data) @ c

    def slope(self, c: Matrix, **data: Matrix) -> Matrix:
        return Matrix.hstack(*complement(unit(data["normal"])))

    def blocked(self, c: Matrix, **data: Matrix) -> Matrix:
        return unit(data["normal"])

    def bend(self, c: Matrix, rate: Matrix, **data: Matrix) -> Matrix:
        return Matrix.zeros(c.graph, 3)

    def closure(self, R: Matrix, p: Matrix, **data: Matrix) -> Matrix:
        return unit(data["normal"]).T @ p

    @property
    def locked(self) -> tuple[Component, ...]:
        return (Component(locked_along(self.normal, "p"), "m"),)
