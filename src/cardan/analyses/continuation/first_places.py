"""Where a curve starts: at a regular point, at a fold, or where curves cross."""

from __future__ import annotations

import numpy as np

from ...arrays import Array
from ...errors import SolveError
from .family import DenseJacobian, Family, Point, length
from .follow import Place, place
from .singular_point import half_branches, singular_point
from .special_points import BRANCH, MOST_LOST, Special

LOST = 1e-13  # singular values of rank that is lost, in the largest entry of J
PARALLEL = 1 - 1e-6  # cosine of directions that are one, or opposite ones
SAME = 1e-6  # lengths of increments between points that are one


def first_places(family: Family, point: Point, toward: Array) -> tuple[list[Place], list[Special]]:
    """The first places of the curve through a point, and that point where curves cross there.

    Args:
        family, point: Of what, and where.
        toward: A direction (N,) that the curve goes along as far as it can.

    Raises:
        SolveError: no curve was found that leads away.
    """
    try:
        regular = [place(family, point, toward)]
    except SolveError:
        regular = []
    for k in range(1, MOST_LOST + 1 if not regular or _singular(family, point) else 1):
        try:
            return _crossing(family, point, k)
        except SolveError:
            continue
    # at a fold nothing moves along the parameter
    return regular or [place(family, point, family.jacobian(point).weakest(1)[2][:, -1])], []


def _singular(family: Family, point: Point) -> bool:
    """True where J has lost rank up to rounding; False where that is not known."""
    jacobian = family.jacobian(point)
    if not isinstance(jacobian, DenseJacobian) or not jacobian.matrix.size:
        return False
    return bool(jacobian.weakest(1)[0].max() <= LOST * np.abs(jacobian.matrix).max())


def _crossing(family: Family, point: Point, lost: int) -> tuple[list[Place], list[Special]]:
    """The same where J has lost some of its rank.

    Raises:
        SolveError: it has not, or no curves were found.
    """
    singular = singular_point(family, point, lost)
    if length(family, family.step(point, singular.point)) > SAME:
        raise SolveError("the start is not singular")
    halves = half_branches(singular)
    if not halves:
        raise SolveError("no curve leaves the start")
    # the one along which the parameter rises fastest, and no path before its start
    half = max(halves, key=lambda half: float(half.tangent[-1]))
    along = [float(half.tangent @ (family.weights * other.tangent)) for other in halves]
    leaving = [h for h, cosine in zip(halves, along, strict=True) if abs(cosine) < PARALLEL]
    start = Place(singular.point, half.tangent, float(half.tangent[-1]), 0.0)
    special = Special(BRANCH, "", start, 0, 0.0, singular, leaving)
    return [start, place(family, half.point, half.direction)], [special]
