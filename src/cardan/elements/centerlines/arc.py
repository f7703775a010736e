"""A circular arc."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

import numpy as np

from ...arrays import Array
from ...errors import ModelError
from ...records import dataclass
from ..quantity import Quantity, Value
from ..validation import vector
from .centerline import TOLERANCE, Centerline, Curve


@dataclass(frozen=True)
class Arc(Centerline):
    """A circular arc from the start of the beam to its end.

    Args:
        center: Of the circle (3) [m], in ground axes: the arc is the shorter one about it.
        through: A point between the ends (3) [m] instead: any arc below a full circle.

    Raises:
        ModelError: not three finite components, or not exactly one of the two.
    """

    kind: ClassVar[str] = "arc"
    center: Value | None = None
    through: Value | None = None

    def __post_init__(self) -> None:
        options = [name for name in ("center", "through") if getattr(self, name) is not None]
        if len(options) != 1:
            raise ModelError(
                "arc: give either center= or through=, a point between the ends; "
                f"{'both are' if options else 'neither is'} given"
            )
        value = vector("arc", options[0], getattr(self, options[0]), 3)
        object.__setattr__(self, options[0], value)

    def quantities(self) -> dict[str, Quantity]:
        name = "through" if self.center is None else "center"
        return {name: Quantity(getattr(self, name), "m")}

    def curve(self, start: Array, end: Array, data: Mapping[str, Array]) -> Curve:
        if "center" in data:
            center, out, side, angle = _about(start, end, data["center"])
        else:
            center, out, side, angle = _through(start, end, data["through"])
        radius = float(np.linalg.norm(start - center))

        def at(s: Array) -> tuple[Array, Array]:
            phi = (s / radius)[:, None]
            cos, sin = np.cos(phi), np.sin(phi)
            return center + radius * (cos * out + sin * side), cos * side - sin * out

        return Curve(radius * angle, at)


def _about(start: Array, end: Array, center: Array) -> tuple[Array, Array, Array, float]:
    """Center, directions to the start and along the arc there, and the angle of the shorter arc."""
    a, b = start - center, end - center
    one, other = float(np.linalg.norm(a)), float(np.linalg.norm(b))
    if abs(one - other) > TOLERANCE * max(one, other) or one == 0:
        raise ModelError(
            f"arc: the start is {one:.9g} m from the center, the end {other:.9g} m: no circle "
            "about it meets both"
        )
    normal = np.cross(a, b)
    if np.linalg.norm(normal) < 1e-9 * one * other:
        raise ModelError(
            "arc: start, center and end lie on one line, which leaves the plane of the arc open; "
            "give through= instead"
        )
    return center, *_axes(a, normal), float(np.arctan2(np.linalg.norm(normal), a @ b))


def _through(start: Array, end: Array, point: Array) -> tuple[Array, Array, Array, float]:
    """The same of the arc through a third point, from the circle around the triangle."""
    a, b = point - start, end - start
    normal = np.cross(a, b)
    square = float(normal @ normal)
    if square <= (1e-9 * float(np.linalg.norm(a) * np.linalg.norm(b))) ** 2:
        raise ModelError(
            "arc: start, through= and end lie on one line; leave out line= for a straight beam"
        )
    center = start + (np.cross(normal, a) * (b @ b) + np.cross(b, normal) * (a @ a)) / (2 * square)
    out, side = _axes(start - center, normal)
    # the way to the end runs through the point: both angles are taken about its direction
    angle = float(np.arctan2((end - center) @ side, (end - center) @ out)) % (2 * np.pi)
    return center, out, side, angle


def _axes(arm: Array, normal: Array) -> tuple[Array, Array]:
    """Unit vectors along an arm and across it, in the plane of a normal."""
    out = arm / np.linalg.norm(arm)
    side = np.cross(normal, out)
    return out, side / np.linalg.norm(side)
