"""Correction by the flattening of a planet to its gravity."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

from ....ir.arithmetic import norm
from ....ir.matrix import Matrix
from ....records import dataclass
from ...limits import Limit, not_negative
from ...quantity import RATIO, Bodies, Direction, Place, Units, Value
from .fields import Oblate, Pull
from .gravitation import Gravitation, Turn


@dataclass(frozen=True)
class J2(Gravitation):
    """Zonal term J2 of a planet, added to its :class:`CentralGravity`.

    The potential per mass is mu J2 R^2 / (2 r^3) (3 sin^2 l - 1) at the latitude l.

    Args:
        center: Frame or body at whose origin the planet has its center.
        mu: Constant of gravitation times mass of the planet [m^3/s^2].
        j2: Its coefficient J2; 1.08263e-3 for the earth.
        radius: Its radius at the equator [m].
        pole: Its axis, in axes of ``center``.
        bodies: A body or a beam, or several; left out: all with mass but the body of the center.
        gradient: Add what it does to bodies because they are not points, torque and force.

    Raises:
        ModelError: mu or radius below 0, a pole that is not a direction, what is not a body, or
            gradient neither True nor False.

    Source: P. C. Hughes, Spacecraft Attitude Dynamics, 1986, chapter 8.
    """

    kind: ClassVar[str] = "j2"
    units: ClassVar[Units] = {"mu": "m^3/s^2", "j2": "", "radius": "m", "pole": RATIO}
    center: Place
    mu: Value
    j2: Value
    radius: Value
    pole: Direction = "z"
    bodies: Bodies = ()
    gradient: bool = False

    def limits(self) -> tuple[Limit, ...]:
        return not_negative("mu", requirement="0 or more [m^3/s^2]") + not_negative("radius")

    @property
    def option(self) -> str:
        return "gradient" if self.gradient else ""

    def pull(self, r: Matrix, data: Mapping[str, Matrix], turn: Turn) -> Pull:
        mu, j2, radius = (data[name][0] for name in ("mu", "j2", "radius"))
        pole = data["pole"] / norm(*data["pole"])
        field = Oblate(mu * j2 * radius * radius * 0.5, turn(pole))
        pull = field.on_mass(r, data["mass"][0])
        return pull + field.on_inertia(r, data["inertia"]) if self.gradient else pull

    def torque_about_center(self, r: Matrix, pull: Pull) -> Matrix:
        return pull.torque + r.cross(pull.force)
