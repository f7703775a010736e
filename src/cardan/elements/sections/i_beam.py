"""Two flanges and a web between them."""

from __future__ import annotations

from typing import ClassVar

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


@dataclass(frozen=True)
class IBeam(Section):
    """Two flanges along e2 and a web along e3; torsion and shear as of thin walls.

    Warping is left free: what a clamped end adds to the torsional stiffness is not there.

    Args:
        width: Of the flanges, along e2 [m].
        height: Over both flanges, along e3 [m].
        flange, web: Their thicknesses [m].
        shear: Shear correction factor, or two along e2 and e3. By default that of Cowper along the
            web, and that of two rectangles along the flanges.
        rhoI: Moments of inertia per length about e2 and e3 [kg m], one or two, 0 or more; those of
            the shape by default.

    Raises:
        ModelError: a number that is not positive, flanges that leave no web, or a web wider than
            they.

    Source: S. P. Timoshenko, Strength of Materials II, chapter 6 (torsion); G. R. Cowper, The shear
        coefficient in Timoshenko's beam theory, 1966.
    """

    kind: ClassVar[str] = "i_beam"
    units: ClassVar[Units] = {
        **{"width": "m", "height": "m", "flange": "m", "web": "m", "shear": "", "rhoI": "kg*m"}
    }
    width: Value
    height: Value
    flange: Value
    web: Value
    shear: Pair = None
    rhoI: Pair = None

    def stiffness(self, data: Data, material: Data) -> SectionProperties:
        w, h, flange, web = (data[name] for name in ("width", "height", "flange", "web"))
        inner = h - 2 * flange
        flanges = 2 * w * flange
        area = flanges + inner * web
        second = ((w * h**3 - (w - web) * inner**3) / 12, (flanges * w**2 + inner * web**3) / 12)
        torsion = (flanges * flange**2 + (h - flange) * web**3) / 3
        # between the middles of the flanges
        nu, m, n = material["nu"], flanges / ((h - flange) * web), w / (h - flange)
        along_web = (
            10 * (1 + nu) * (1 + 3 * m) ** 2
            / (
                12 + 72 * m + 150 * m**2 + 90 * m**3
                + nu * (11 + 66 * m + 135 * m**2 + 90 * m**3)
                + 30 * n**2 * (m + m**2)
                + 5 * nu * n**2 * (8 * m + 9 * m**2)
            )
        )  # fmt: skip
        along_flanges = rectangle_shear(nu) * flanges / area
        shear = corrections(data, along_flanges, along_web)
        return made_of(area, second, torsion, shear, material)

    def relations(self) -> tuple[Limit, ...]:
        flanges = "two flanges, {other} m together, leave no web in a height of {value} m"
        web = "the web of {other} m is wider than the flanges of {value} m"
        return (
            Limit("height", flanges, open=True, other="flange", times=2.0),
            Limit("width", web, other="web"),
        )

    def outline(self, values: Numbers) -> Outline:
        e2, e3, web = values["width"] / 2, values["height"] / 2, values["web"] / 2
        inner = e3 - values["flange"]
        right = [(e2, -e3), (e2, -inner), (web, -inner), (web, inner), (e2, inner), (e2, e3)]
        left = [(-x, -y) for x, y in right]
        return Outline(e2, e3, contour=(*right, *left))
