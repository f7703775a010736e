"""A full circle."""

from __future__ import annotations

import math
from typing import ClassVar

from ...records import dataclass
from ..limits import Limit
from ..quantity import Pair, Units, Value
from .section import Data, Numbers, Outline, Section, SectionProperties, corrections, made_of


@dataclass(frozen=True)
class Circle(Section):
    """A full circle.

    Args:
        radius: [m].
        shear: Shear correction factor, or two along e2 and e3; that of Cowper by default.
        rhoI: Moments of inertia per length about e2 and e3 [kg m], one or two, 0 or more; those of
            the shape by default.

    Raises:
        ModelError: a number that is not positive.

    Source: G. R. Cowper, The shear coefficient in Timoshenko's beam theory, 1966.
    """

    kind: ClassVar[str] = "circle"
    units: ClassVar[Units] = {"radius": "m", "shear": "", "rhoI": "kg*m"}
    radius: Value
    shear: Pair = None
    rhoI: Pair = None

    def stiffness(self, data: Data, material: Data) -> SectionProperties:
        nu, square = material["nu"], data["radius"] ** 2
        second = math.pi / 4 * square**2
        k = 6 * (1 + nu) / (7 + 6 * nu)
        shear = corrections(data, k, k)
        return made_of(math.pi * square, (second, second), 2 * second, shear, material)

    def relations(self) -> tuple[Limit, ...]:
        return ()

    def outline(self, values: Numbers) -> Outline:
        return Outline(values["radius"], values["radius"], round=True)
