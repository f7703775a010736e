"""A point of the child that stays on a curve of the parent."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import accumulate, pairwise
from typing import ClassVar

from ...errors import ModelError, brief
from ...ir.derivative import forward
from ...ir.graph import ONE
from ...ir.matrix import Matrix
from ...ir.rewrite import rebuild
from ...records import dataclass
from ...spatial.axis import complement, unit
from ..quantity import Quantity, Rows
from ..tables import Interpolation, table
from ..validation import is_expression, vector
from .guided import Guided
from .joint import Component

PARAMETER = "s"


@dataclass(frozen=True)
class PointOnCurve(Guided):
    """The child's origin slides along a curve of the parent, and the child turns freely about it.

    q = [rotation, s], u = [angular velocity in child axes [rad/s], rate of s]. The curve is the
    cubic spline through the points, with two continuous derivatives; s [m] is 0 at the first
    point and grows by the distance from point to point. Beyond its ends the curve continues; a
    closed one comes round again.

    Args:
        points: Places in parent axes [m], (n, 3) numbers, n >= 2, no two in a row alike.
        closed: The curve goes on from the last point to the first; n >= 3.
        rotation: How the rotation is described, as of :class:`Spherical`.

    Raises:
        ModelError: too few points, points that are not three numbers, or two in a row alike; the
            parametrization does not exist.

    Source: Géradin and Cardona, Flexible Multibody Dynamics, chapter 7 (curvilinear slider).
    """

    kind: ClassVar[str] = "point_on_curve"
    title: ClassVar[str] = "point on a curve"
    points: Rows
    closed: bool = False
    rotation: str = "quaternion"

    def __post_init__(self) -> None:
        if type(self.closed).__name__ not in ("bool", "bool_"):
            raise ModelError(f"point on a curve: closed={brief(self.closed)}: give True or False")
        object.__setattr__(self, "points", _points(self.points, self.closed))
        super().__post_init__()

    def _splines(self) -> tuple[float, list[Interpolation]]:
        """Length of the curve as s counts it; x, y and z as functions of s."""
        points = (*self.points, self.points[0]) if self.closed else self.points
        s = list(accumulate((math.dist(a, b) for a, b in pairwise(points)), initial=0.0))
        kind = "periodic" if self.closed else "cubic"
        return s[-1], [table(s, column, kind) for column in zip(*points, strict=True)]

    @property
    def guides(self) -> tuple[Component, ...]:
        return (Component(PARAMETER, "m"),)

    def quantities(self) -> dict[str, Quantity]:
        from sympy import Mod, Symbol

        length, splines = self._splines()
        s = Symbol(PARAMETER)
        at = tuple(spline(Mod(s, length) if self.closed else s) for spline in splines)
        return {"curve": Quantity(at, "m", local=(PARAMETER,))}

    @property
    def coincident(self) -> bool:
        return False

    def _derivative(self, order: int, c: Matrix, data: dict[str, Matrix]) -> Matrix:
        """Derivative of the curve by s, (3, 1)."""
        graph, nodes = c.graph, data["curve"].nodes
        seed = {graph.atom(PARAMETER): ONE}
        for _ in range(order):
            nodes = tuple(forward(graph, nodes, seed))
        local = {graph.atom(PARAMETER): c.nodes[0]}
        return Matrix(graph, 3, 1, rebuild(graph, nodes, local, into=graph)[1])

    def place(self, c: Matrix, **data: Matrix) -> Matrix:
        return self._derivative(0, c, data)

    def slope(self, c: Matrix, **data: Matrix) -> Matrix:
        return self._derivative(1, c, data)

    def blocked(self, c: Matrix, **data: Matrix) -> Matrix:
        return Matrix.hstack(*complement(unit(self.slope(c, **data))))

    def bend(self, c: Matrix, rate: Matrix, **data: Matrix) -> Matrix:
        return self._derivative(2, c, data) * (rate[0] * rate[0])

    @property
    def closes_by_coordinates(self) -> bool:
        return True


def _points(points: object, closed: bool) -> tuple[tuple[float, ...], ...]:
    """Rows of three numbers.

    Raises:
        ModelError: they are not, or they make no curve.
    """
    rows = points.tolist() if hasattr(points, "tolist") else points
    least = 3 if closed else 2
    if isinstance(rows, str | bytes) or not isinstance(rows, Sequence) or len(rows) < least:
        raise ModelError(f"point on a curve: points must be at least {least} rows of 3 numbers")
    checked = tuple(
        vector("point on a curve", f"points[{i}]", row, 3) for i, row in enumerate(rows)
    )
    for i, row in enumerate(checked):
        if any(is_expression(x) for x in row):
            raise ModelError(f"point on a curve: points[{i}] must be numbers; it has expressions")
        if i and row == checked[i - 1]:
            raise ModelError(
                f"point on a curve: points[{i}] is the point before it again; leave it out"
            )
    if closed and checked[0] == checked[-1]:
        raise ModelError(
            "point on a curve: the last point is the first again; leave it out, closed=True "
            "leads back to it"
        )
    return checked
