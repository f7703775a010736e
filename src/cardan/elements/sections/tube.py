"""A hollow circle."""

from __future__ import annotations

import math
from typing import ClassVar

from ...records import dataclass
from ..limits import Limit
from ..quantity import Pair, Units, Value
from .section import Data, Numbers, Outline, Section, SectionProperties, corrections, made_of


@dataclass(frozen=True)
class Tube(Section):
    """A hollow circle.

    Args:
        outer, inner: Its radii [m].
        shear: Shear correction factor, or two along e2 and e3; that of Cowper by default.
        rhoI: Moments of inertia per length about e2 and e3 [kg m], one or two, 0 or more; those of
            the shape by default.

    Raises:
        ModelError: a number that is not positive, or an inner radius that is not smaller.

    Source: G. R. Cowper, The shear coefficient in Timoshenko's beam theory, 1966.
    """

    kind: ClassVar[str] = "tube"
    units: ClassVar[Units] = {"outer": "m", "inner": "m", "shear": "", "rhoI": "kg*m"}
    outer: Value
    inner: Value
    shear: Pair = None
    rhoI: Pair = None

    def stiffness(self, data: Data, material: Data) -> SectionProperties:
        nu, outer, inner = material["nu"], data["outer"] ** 2, data["inner"] ** 2
        second = math.pi / 4 * (outer**2 - inner**2)
        # with m = inner / outer
        square = (outer + inner) ** 2
        k = 6 * (1 + nu) * square / ((7 + 6 * nu) * square + (20 + 12 * nu) * (outer * inner))
        shear = corrections(data, k, k)
        return made_of(math.pi * (outer - inner), (second, second), 2 * second, shear, material)

    def relations(self) -> tuple[Limit, ...]:
        message = "the inner radius {other} m of the tube is not below the outer {value} m"
        return (Limit("outer", message, open=True, other="inner"),)

    def outline(self, values: Numbers) -> Outline:
        return Outline(values["outer"], values["outer"], round=True)
