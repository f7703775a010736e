"""A box with walls of one thickness."""

from __future__ import annotations

from typing import ClassVar

from ...ir.arithmetic import Scalar
from ...records import dataclass
from ..limits import Limit
from ..quantity import Pair, Units, Value
from .section import Data, Numbers, Outline, Section, SectionProperties, corrections, made_of


@dataclass(frozen=True)
class HollowRectangle(Section):
    """A box with walls of one thickness; torsion and shear as of thin walls.

    Args:
        width, height: Outer measures along e2 and e3 [m].
        thickness: Of the walls [m].
        shear: Shear correction factor, or two along e2 and e3; that of Cowper by default.
        rhoI: Moments of inertia per length about e2 and e3 [kg m], one or two, 0 or more; those of
            the shape by default.

    Raises:
        ModelError: a number that is not positive, or walls that leave no room between them.

    Source: R. Bredt, Kritische Bemerkungen zur Drehungselastizität, 1896 (torsion); G. R. Cowper,
        The shear coefficient in Timoshenko's beam theory, 1966.
    """

    kind: ClassVar[str] = "hollow_rectangle"
    units: ClassVar[Units] = {
        "width": "m",
        "height": "m",
        "thickness": "m",
        "shear": "",
        "rhoI": "kg*m",
    }
    width: Value
    height: Value
    thickness: Value
    shear: Pair = None
    rhoI: Pair = None

    def stiffness(self, data: Data, material: Data) -> SectionProperties:
        w, h, t = data["width"], data["height"], data["thickness"]
        inner_w, inner_h = w - 2 * t, h - 2 * t
        second = ((w * h**3 - inner_w * inner_h**3) / 12, (h * w**3 - inner_h * inner_w**3) / 12)
        # between the middles of the walls
        mid_w, mid_h = w - t, h - t
        torsion = 2 * t * (mid_w * mid_h) ** 2 / (mid_w + mid_h)
        nu = material["nu"]
        shear = corrections(data, _shear(mid_h, mid_w, nu), _shear(mid_w, mid_h, nu))
        return made_of(w * h - inner_w * inner_h, second, torsion, shear, material)

    def relations(self) -> tuple[Limit, ...]:
        message = (
            "two walls, {other} m together, leave no room in a hollow_rectangle of {value} m; a "
            "full one is a rectangle"
        )
        return tuple(
            Limit(side, message, open=True, other="thickness", times=2.0)
            for side in ("width", "height")
        )

    def outline(self, values: Numbers) -> Outline:
        return Outline(values["width"] / 2, values["height"] / 2)


def _shear(across: Scalar, along: Scalar, nu: Scalar) -> Scalar:
    """Factor for shear along one side of a box with walls of one thickness."""
    n = across / along
    m = n
    return (
        10 * (1 + nu) * (1 + 3 * m) ** 2
        / (
            12 + 72 * m + 150 * m**2 + 90 * m**3
            + nu * (11 + 66 * m + 135 * m**2 + 90 * m**3)
            + 10 * n**2 * ((3 + nu) * m + 3 * m**2)
        )
    )  # fmt: skip
