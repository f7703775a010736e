"""Solutions at one value of the parameter that no branch leads to.

Newton's method on equations that were multiplied by a number that is infinite at every solution
found before: it converges to others, or not at all.

Source: P. E. Farrell, A. Birkisson, S. W. Funke, SIAM J. Sci. Comput. 37 (2015), A2026-A2045.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice

import numpy as np

from ...arrays import Array
from ...errors import SolveError
from .curve import Curve
from .family import Family, Point, length
from .follow import corrected, place

NEWTON, TIGHT = 30, 1e-10
ALONG = 8  # points of a curve from which searches begin
DIRECTIONS, SOFT = 3, 1e-6  # softest ones, likewise; the part of them that must move something
ASIDE = (0.1, 1.0)  # lengths of the first increments of a search
LONGEST = 0.5  # increment of an iteration
DISTINCT = 1e-5  # lengths of increments between points that differ
SIZE = 1e-14  # of a distance: no number
SINGULAR = 1e-7  # of the next singular value: that of a direction that nothing holds
AT, SECANTS = 1e-12, 4  # of the parameter: the value itself; iterations towards it


def new_solutions(curves: Sequence[Curve], value: float, budget: int) -> Iterator[Point]:
    """Solutions at a value of the parameter that are on none of some curves.

    Args:
        curves: Of one family.
        value: Of the parameter.
        budget: Searches at most.
    """
    points = [point for curve in curves for point in points_at(curve, value)]
    for start in islice(_starts(curves, points, value), budget):
        family = curves[0].family
        try:
            point = _deflated(family, points, start)
            values = family.jacobian(point).weakest(2)[0]
        except SolveError:
            continue
        points.append(point)
        # where nothing holds a direction solutions fill surfaces, along which no curve leads
        if values.min() > SINGULAR * values.max():
            yield point


def _starts(curves: Sequence[Curve], points: Sequence[Point], value: float) -> Iterator[Point]:
    """Starts of searches: mirror images of curves, curves themselves, and beside solutions."""
    family = curves[0].family
    for sign in (-1.0, 1.0):
        for curve in curves:
            first = curve.places[0].point
            for k in np.unique(np.linspace(0, len(curve.places) - 1, ALONG).astype(int)):
                dz = sign * family.step(first, curve.places[int(k)].point)
                dz[-1] = value - family.parameter(first)
                yield family.moved(first, dz)
    for size in ASIDE:
        for point in points:
            _, _, right = family.jacobian(point).weakest(min(DIRECTIONS, len(family.weights) - 1))
            for v in right.T.copy():
                v[-1] = 0.0
                scale = length(family, v)
                for sign in (1.0, -1.0) if scale > SOFT else ():
                    yield family.moved(point, sign * size / scale * v)


def _deflated(family: Family, points: Sequence[Point], point: Point) -> Point:
    """The solution that deflated iterations lead to.

    Raises:
        SolveError: they lead to none.
    """
    n = len(family.weights)
    row, none = np.zeros((1, n)), np.zeros((n - 1, 0))
    row[0, -1] = 1.0
    for _ in range(NEWTON):
        by = family.jacobian(point).bordered(row, none)
        v = by.solve(-family.residual(point), np.zeros(1))[0]
        share = 1.0 - float(_repulsion(family, points, point) @ v)
        if share == 0:
            break
        step = v / share
        size = length(family, step)
        if not np.isfinite(size):
            break
        step = step * min(1.0, LONGEST / size) if size > 0 else step
        point = family.moved(point, step)
        if length(family, v) <= TIGHT:
            distances = [length(family, family.step(one, point)) for one in points]
            if min(distances, default=1.0) > DISTINCT:
                return point
            break
    raise SolveError("no other solution was found")


def _repulsion(family: Family, points: Sequence[Point], point: Point) -> Array:
    """Gradient of the logarithm of prod (1 + 1 / distance^2), by increments (N,)."""
    total = np.zeros(len(family.weights))
    for one in points:
        away = family.step(one, point)
        square = max(length(family, away) ** 2, SIZE**2)
        total -= 2 * family.weights * away / (square**2 + square)
    return total


def points_at(curve: Curve, value: float) -> Iterator[Point]:
    """Points of a curve at which its parameter has a value."""
    family = curve.family
    offsets = [family.parameter(one.point) - value for one in curve.places]
    for k, (before, low) in enumerate(zip(curve.places, offsets, strict=True)):
        if abs(low) <= AT:
            yield before.point
            continue
        if k + 1 == len(offsets) or abs(offsets[k + 1]) <= AT or low * offsets[k + 1] > 0:
            continue
        after, share = curve.places[k + 1], low / (low - offsets[k + 1])
        ds = float(before.tangent @ (family.weights * family.step(before.point, after.point)))
        try:
            for _ in range(SECANTS):
                point = corrected(family, before, share * ds)[0]
                rate = place(family, point, before.tangent).parameter_rate
                share -= (family.parameter(point) - value) / (rate * ds)
            yield corrected(family, before, share * ds)[0]
        except (SolveError, ZeroDivisionError):
            yield (before if share < 0.5 else after).point
