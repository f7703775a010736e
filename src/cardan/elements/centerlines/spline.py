"""A smooth line through given points."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from ...arrays import Array
from ...errors import ModelError
from ...records import dataclass
from ..quantity import Quantity, Rows
from ..validation import vector
from .centerline import TOLERANCE, Centerline, Curve

if TYPE_CHECKING:
    from scipy.interpolate import CubicSpline

# Gauss points per piece of a span, and pieces per span: the arc length is exact to rounding on
# lines without kinks
POINTS, SEGMENTS = 8, 8


@dataclass(frozen=True)
class Spline(Centerline):
    """A cubic spline through points, the first and last of which are the ends of the beam.

    Args:
        points: At least three points (n, 3) [m] in ground axes.

    Raises:
        ModelError: fewer points, or one without three finite components.

    Source: C. de Boor, A Practical Guide to Splines, 1978, chapter 4 (not-a-knot ends).
    """

    kind: ClassVar[str] = "spline"
    points: Rows

    def __post_init__(self) -> None:
        points = self.points.tolist() if hasattr(self.points, "tolist") else self.points
        if isinstance(points, str) or not isinstance(points, Sequence) or len(points) < 3:
            raise ModelError(
                "spline: at least three points are wanted, the ends of the beam among them; a "
                "beam between two is straight without line="
            )
        rows = tuple(vector("spline", f"points[{k}]", row, 3) for k, row in enumerate(points))
        object.__setattr__(self, "points", rows)

    def quantities(self) -> dict[str, Quantity]:
        return {"points": Quantity(self.points, "m")}

    def curve(self, start: Array, end: Array, data: Mapping[str, Array]) -> Curve:
        from scipy.interpolate import CubicSpline

        points = data["points"]
        chords = np.linalg.norm(np.diff(points, axis=0), axis=1)
        if not chords.all():
            k = int(np.argmin(chords))
            raise ModelError(f"spline: points {k + 1} and {k + 2} are the same; leave out one")
        for which, meant, point in (("first", start, points[0]), ("last", end, points[-1])):
            gap = float(np.linalg.norm(meant - point))
            if gap > TOLERANCE * chords.sum():
                raise ModelError(
                    f"spline: its {which} point is {gap:.3g} m apart from the "
                    f"{'start' if which == 'first' else 'end'} of the beam at "
                    f"({', '.join(f'{x:.6g}' for x in meant)})"
                )
        line = CubicSpline(np.concatenate([[0.0], np.cumsum(np.sqrt(chords))]), points)
        return _measured(line, line.derivative())


def _measured(line: CubicSpline, rate: CubicSpline) -> Curve:
    """A line by its arc length: Gauss sums over short pieces, inverted by Newton's method."""
    count = SEGMENTS * (len(line.x) - 1)
    breaks = np.interp(np.arange(count + 1) / SEGMENTS, np.arange(len(line.x)), line.x)
    nodes, weights = np.polynomial.legendre.leggauss(POINTS)

    def length(a: Array, b: Array) -> Array:
        middle, half = (a + b)[:, None] / 2, (b - a)[:, None] / 2
        speed = np.linalg.norm(rate(middle + half * nodes), axis=-1)
        return np.asarray((half * speed) @ weights)

    sums = np.concatenate([[0.0], np.cumsum(length(breaks[:-1], breaks[1:]))])

    def at(s: Array) -> tuple[Array, Array]:
        s = np.clip(s, 0.0, sums[-1])
        k = np.clip(np.searchsorted(sums, s, side="right") - 1, 0, len(breaks) - 2)
        t = np.interp(s, sums, breaks)
        for _ in range(4):
            t -= (sums[k] + length(breaks[k], t) - s) / np.linalg.norm(rate(t), axis=-1)
        tangents = rate(t)
        return line(t), tangents / np.linalg.norm(tangents, axis=-1, keepdims=True)

    return Curve(float(sums[-1]), at)
