"""Torque of a central field of gravity on bodies of finite extent."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import ClassVar

from ....ir.matrix import Matrix
from ....records import dataclass
from ...formulas import Lines
from ...limits import Limit, not_negative
from ...quantity import Bodies, Place, Units, Value
from ..force import Places, constant
from .fields import Central, Pull
from .gravitation import REACH, Gravitation, Turn

POTENTIAL = "V = -(mu / (2 * rho ** 3) * (trace(J) - 3 * dot(r, J @ r) / rho ** 2))"


@dataclass(frozen=True)
class GravityGradient(Gravitation):
    """The ``torque = 3 mu / r^5 r x I r`` of a central field on bodies, and the force with it.

    These are the terms of second order in size / r; those of order 0 are :class:`CentralGravity`,
    which acts besides where the place of the bodies is not prescribed. Torque and force have the
    potential -mu (tr I - 3 e I e) / (2 r^3), e = r / r: energy and angular momentum about the
    center are kept. Of a beam it is what the extent of its sections adds: along the line
    :class:`CentralGravity` pulls every point by itself.

    Args:
        center: Frame or body at whose origin the field has its center.
        mu: Constant of gravitation times mass of what pulls [m^3/s^2].
        bodies: A body or a beam, or several; left out: all with mass but the body of the center.
        force: False leaves the force away, which changes orbits by (size / r)^2 only; the torque
            then works on the system without a potential.

    Raises:
        ModelError: mu below 0, what is not a body, or force neither True nor False.

    Source: P. C. Hughes, Spacecraft Attitude Dynamics, 1986, sections 8.1 and 9.1.
    """

    kind: ClassVar[str] = "gravity_gradient"
    units: ClassVar[Units] = {"mu": "m^3/s^2"}
    center: Place
    mu: Value
    bodies: Bodies = ()
    force: bool = True

    def limits(self) -> tuple[Limit, ...]:
        return not_negative("mu", requirement="0 or more [m^3/s^2]")

    @property
    def has_potential(self) -> bool:
        return self.force

    @property
    def option(self) -> str:
        return "" if self.force else "torque"

    def pull(self, r: Matrix, data: Mapping[str, Matrix], turn: Turn) -> Pull:
        pull = Central(data["mu"][0]).on_inertia(r, data["inertia"])
        return pull if self.force else replace(pull, force=Matrix.zeros(r.graph, 3))

    def torque_about_center(self, r: Matrix, pull: Pull) -> Matrix:
        # with its force it has none
        return super().torque_about_center(r, pull) if self.force else pull.torque

    def formulas(self, at: Places) -> Lines:
        torque = "M_body = 3 * mu / rho ** 5 * skew(r) @ J @ r"
        center: Lines = (("on the center", "M_center = -M_body"),)
        field: Lines = (
            *REACH,
            ("inertia I about the center of mass in ground axes", "J = R_body @ I @ R_body.T"),
        )
        if not self.force:
            return (*field, ("torque", torque), *center)
        fixed = constant(at.data["mu"])
        return (
            *field,
            ("force at the center of mass",
             "F_body = -(3 * mu / (2 * rho ** 5) * ((trace(J) - 5 * dot(r, J @ r) / rho ** 2) * r"
             " + 2 * J @ r))"),
            ("torque, and moment of the force about the origin of the body",
             f"{torque} + skew(R_body @ c) @ F_body"),
            ("force on the center", "F_center = -F_body"),
            *((("potential energy", POTENTIAL),) * fixed),
        )  # fmt: skip
