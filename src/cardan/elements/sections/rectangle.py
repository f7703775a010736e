"""A full rectangle."""

from __future__ import annotations

import math
from typing import ClassVar

from ...ir.arithmetic import Scalar
from ...records import dataclass
from ..limits import Limit
from ..quantity import Pair, Units, Value
from .section import (
    Data,
    Numbers,
    Outline,
    Section,
    SectionProperties,
    corrections,
    made_of,
    rectangle_shear,
)

# sum of 1/n^5 over odd n: 31/32 zeta(5)
FIFTH = 1.0045237627951382
LEADING = 192 / math.pi**5


@dataclass(frozen=True)
class Rectangle(Section):
    """A full rectangle.

    Args:
        width: Along e2 [m].
        height: Along e3, the direction of ``up`` [m].
        shear: Shear correction factor, or two along e2 and e3; that of Cowper by default.
        rhoI: Moments of inertia per length about e2 and e3 [kg m], one or two, 0 or more; those of
            the shape by default.

    Raises:
        ModelError: a number that is not positive.

    Source: S. P. Timoshenko and J. N. Goodier, Theory of Elasticity, section 109 (torsion); G. R.
        Cowper, The shear coefficient in Timoshenko's beam theory, 1966.
    """

    kind: ClassVar[str] = "rectangle"
    units: ClassVar[Units] = {"width": "m", "height": "m", "shear": "", "rhoI": "kg*m"}
    width: Value
    height: Value
    shear: Pair = None
    rhoI: Pair = None

    def stiffness(self, data: Data, material: Data) -> SectionProperties:
        width, height = data["width"], data["height"]
        area = width * height
        second = (area * height**2 / 12, area * width**2 / 12)
        k = rectangle_shear(material["nu"])
        return made_of(area, second, torsion(width, height), corrections(data, k, k), material)

    def relations(self) -> tuple[Limit, ...]:
        return ()

    def outline(self, values: Numbers) -> Outline:
        return Outline(values["width"] / 2, values["height"] / 2)


def torsion(a: Scalar, b: Scalar) -> Scalar:
    """Torsion constant of a rectangle, to rounding.

    With tanh x = 1 - 2/(exp 2x + 1) the series falls as exp(-n pi): four terms are enough.
    """
    long, short = a.apply("max", b), a.apply("min", b)
    slope = math.pi * long / short
    series = sum(
        (2 / n**5 / ((n * slope).apply("exp") + 1) for n in (3, 5, 7)), 2 / (slope.apply("exp") + 1)
    )
    return long * short**3 / 3 * (1 - LEADING * short / long * (FIFTH - series))
