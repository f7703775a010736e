"""The gravity of a point or of a spherical planet."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

from ....ir.matrix import Matrix
from ....records import dataclass
from ...formulas import Lines
from ...limits import Limit, not_negative
from ...quantity import Bodies, Place, Units, Value
from ..force import Places, constant
from .fields import Central, Pull
from .gravitation import ATTRACTION, REACH, Gravitation, Turn


@dataclass(frozen=True)
class CentralGravity(Gravitation):
    """The pull mu m / r^2 of a point or of a spherical planet on mass centers of bodies and beams.

    On each body, fixed ones included, ``force = -mu m r / r^3`` acts at its center of mass, and its
    opposite at the center of the field: where that is on a body that moves, both attract each
    other. A beam is pulled all along, at the mass center of every section. The uniform gravity of
    the scene acts besides; ``gravity=(0, 0, 0)`` leaves it out. What the extent of bodies adds is a
    :class:`GravityGradient`.

    Args:
        center: Frame or body at whose origin the field has its center.
        mu: Constant of gravitation times mass of what pulls [m^3/s^2].
        bodies: A body or a beam, or several; left out: all with mass but the body of the center.

    Raises:
        ModelError: mu below 0, or what is not a body.

    Source: R. E. Roberson and R. Schwertassek, Dynamics of Multibody Systems, 1988, section 12.2.
    """

    kind: ClassVar[str] = "central_gravity"
    units: ClassVar[Units] = {"mu": "m^3/s^2"}
    center: Place
    mu: Value
    bodies: Bodies = ()

    def limits(self) -> tuple[Limit, ...]:
        return not_negative("mu", requirement="0 or more [m^3/s^2]")

    def pull(self, r: Matrix, data: Mapping[str, Matrix], turn: Turn) -> Pull:
        return Central(data["mu"][0]).on_mass(r, data["mass"][0])

    def formulas(self, at: Places) -> Lines:
        fixed = constant(at.data["mu"])
        return (
            *REACH,
            ("force at the center of mass, m the mass", "F_body = -(mu * m / rho ** 3 * r)"),
            *ATTRACTION,
            *((("potential energy", "V = -(mu * m / rho)"),) * fixed),
        )
