"""A thin disk that rolls on a plane."""

from __future__ import annotations

from typing import ClassVar

from ...ir.arithmetic import Scalar
from ...ir.matrix import Matrix
from ...records import dataclass
from ..limits import Limit, positive
from ..quantity import RATIO, Direction, Units, Value
from .joint import Component
from .rolling import Rolling


@dataclass(frozen=True)
class RollingDisk(Rolling):
    """A disk with a sharp edge on a plane of the parent: a rolling coin, or a knife edge.

    q = [x, y, yaw, lean, spin]: the point of contact in the plane [m], the heading, the
    inclination about the heading (0: upright) and the angle about the axle [rad]; u are their
    rates. The child's origin is the center of the disk. With the normal z the disk heads along x
    and its axle is y where all are 0; for another normal they are the two directions that make a
    right-handed triad with it (y, z for "x"; z, x for "y").

    Args:
        radius: Radius of the disk [m], positive.
        normal: Direction in the parent frame out of the plane, on the side of the disk: "x", "y",
            "z", "-x", ... or three numbers or expressions (of any length but 0).
        knife_edge: Only sliding sideways is excluded, as of a skate; else the disk rolls.

    Raises:
        ModelError: the normal is zero, NaN or not a direction; the radius is not positive.

    Source: J. I. Neimark, N. A. Fufaev, Dynamics of Nonholonomic Systems, 1972, chapter 2.
    """

    kind: ClassVar[str] = "rolling_disk"
    title: ClassVar[str] = "rolling disk"
    units: ClassVar[Units] = {"radius": "m", "normal": RATIO}
    radius: Value
    normal: Direction = "z"
    knife_edge: bool = False

    def limits(self) -> tuple[Limit, ...]:
        return positive("radius", requirement="a number above 0 [m]")

    def radii(self, data: dict[str, Matrix]) -> tuple[Scalar, Scalar]:
        radius = data["radius"][0]
        return radius, radius * 0.0

    @property
    def slips(self) -> tuple[Component, ...]:
        lateral = (Component("lateral", "m/s"),)
        return lateral if self.knife_edge else (Component("longitudinal", "m/s"), *lateral)
