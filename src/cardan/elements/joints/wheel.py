"""A rigid wheel on a plane."""

from __future__ import annotations

from typing import ClassVar

from ...ir.arithmetic import Scalar
from ...ir.matrix import Matrix
from ...records import dataclass
from ..limits import Limit, not_negative, positive
from ..quantity import RATIO, Direction, Units, Value
from .joint import Component
from .rolling import Rolling


@dataclass(frozen=True)
class Wheel(Rolling):
    """A wheel with a rounded tread that rolls on a plane of the parent: part of a torus.

    q = [x, y, yaw, lean, spin]: the point of contact in the plane [m], the heading, the
    inclination about the heading (0: upright) and the angle about the axle [rad]; u are their
    rates. The child's origin is the center of the wheel. With the normal z the wheel heads along
    x and its axle is y where all are 0; for another normal they are the two directions that make a
    right-handed triad with it (y, z for "x"; z, x for "y").

    Args:
        radius: From the center to the middle of the tread [m], positive.
        crown: Radius of the cross section of the tread [m], from 0 (a sharp edge) to the radius
            (a ball).
        normal: Direction in the parent frame out of the plane, on the side of the wheel: "x", "y",
            "z", "-x", ... or three numbers or expressions (of any length but 0).
        lateral_slip: Whether the wheel may slide sideways; else only rolling is left.

    Raises:
        ModelError: the normal is zero, NaN or not a direction; the radius is not positive; the
            crown is negative or larger than the radius.

    Source: J. I. Neimark, N. A. Fufaev, Dynamics of Nonholonomic Systems, 1972, chapter 2.
    """

    kind: ClassVar[str] = "wheel"
    title: ClassVar[str] = "wheel"
    units: ClassVar[Units] = {"radius": "m", "crown": "m", "normal": RATIO}
    radius: Value
    crown: Value = 0.0
    normal: Direction = "z"
    lateral_slip: bool = False

    def limits(self) -> tuple[Limit, ...]:
        crown = "crown is {other}; give a length from 0 to the radius {value}"
        return (
            *positive("radius", requirement="a number above 0 [m]"),
            *not_negative("crown", requirement="a length from 0 to the radius [m]"),
            Limit("radius", crown, other="crown"),
        )

    def radii(self, data: dict[str, Matrix]) -> tuple[Scalar, Scalar]:
        radius, crown = data["radius"][0], data["crown"][0]
        return radius - crown, crown

    @property
    def slips(self) -> tuple[Component, ...]:
        rolling = (Component("longitudinal", "m/s"),)
        return rolling if self.lateral_slip else (*rolling, Component("lateral", "m/s"))
