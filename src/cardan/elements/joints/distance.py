"""A massless rod between two points."""

from __future__ import annotations

import math
from typing import ClassVar

from ...ir.arithmetic import Scalar, cos, sin
from ...ir.matrix import Matrix
from ...records import dataclass
from ...spatial.axis import complement, unit
from ..limits import Limit, positive
from ..quantity import RATIO, Direction, Units, Value
from .guided import Guided
from .joint import Component


@dataclass(frozen=True)
class Distance(Guided):
    """The origins of both frames stay one length apart: a rod without mass on two ball joints.

    q = [rotation, rod1, rod2], u = [angular velocity in child axes [rad/s], rates of the
    angles]. The rotation is that of the child against the parent. The rod lies along the axis
    where both angles are 0; they turn it about the two directions of the parent that make a
    right-handed triad with the axis (x, y for "z"; y, z for "x"; z, x for "y"), first by rod2
    about the second, then by rod1 about the first.

    Args:
        length: Length of the rod [m], positive.
        axis: Direction of the rod in the parent frame at zero angles: "x", "y", "z", "-x", ... or
            three numbers or expressions (of any length but 0).
        rotation: How the rotation is described, as of :class:`Spherical`.

    Raises:
        ModelError: the axis is zero, NaN or not a direction; the length is not positive; the
            parametrization does not exist.

    Source: Roberson, Schwertassek, Dynamics of Multibody Systems, 1988, chapter 9.
    """

    kind: ClassVar[str] = "distance"
    title: ClassVar[str] = "distance"
    units: ClassVar[Units] = {"length": "m", "axis": RATIO}
    length: Value
    axis: Direction = "z"
    rotation: str = "quaternion"

    def limits(self) -> tuple[Limit, ...]:
        return positive("length", requirement="a number above 0 [m]")

    @property
    def guides(self) -> tuple[Component, ...]:
        return Component("rod1", "rad"), Component("rod2", "rad", reach=math.pi / 2)

    @property
    def coincident(self) -> bool:
        return False

    def place(self, c: Matrix, **data: Matrix) -> Matrix:
        first, ahead, _ = _frame(c, data)
        along = first * sin(c[1]) + ahead * cos(c[1])
        return along * data["length"][0]

    def slope(self, c: Matrix, **data: Matrix) -> Matrix:
        first, ahead, side = _frame(c, data)
        length = data["length"][0]
        by_second = first * cos(c[1]) - ahead * sin(c[1])
        return Matrix.hstack(side * (length * cos(c[1])), by_second * length)

    def blocked(self, c: Matrix, **data: Matrix) -> Matrix:
        first, ahead, _ = _frame(c, data)
        return first * sin(c[1]) + ahead * cos(c[1])

    def bend(self, c: Matrix, rate: Matrix, **data: Matrix) -> Matrix:
        first, ahead, side = _frame(c, data)
        one, two, length = rate[0], rate[1], data["length"][0]
        fast: Scalar = one * one + two * two
        return (
            first * (-(length * sin(c[1]) * two * two))
            - ahead * (length * cos(c[1]) * fast)
            - side * (2.0 * length * sin(c[1]) * one * two)
        )

    def closure(self, R: Matrix, p: Matrix, **data: Matrix) -> Matrix:
        length = data["length"][0]
        stretch = (p.dot(p) - length * length) / (2.0 * length)
        return Matrix.vector(R.graph, [stretch])

    @property
    def locked(self) -> tuple[Component, ...]:
        return (Component("length", "m"),)

    @property
    def domain(self) -> str:
        return f"|rod2| < 90 degrees; {self.parameters.domain}"


def _frame(c: Matrix, data: dict[str, Matrix]) -> tuple[Matrix, Matrix, Matrix]:
    """The first direction, the axis turned about it by rod1, and where that goes with it."""
    n = unit(data["axis"])
    first, second = complement(n)
    co, si = cos(c[0]), sin(c[0])
    return first, n * co - second * si, -(n * si) - second * co
