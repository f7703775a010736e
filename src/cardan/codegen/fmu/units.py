"""Units of an FMU: exponents of the SI base units, and what people read angles in."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable

from ...scene.units import unit
from .xml import Element

BASES = ("kg", "m", "s", "A", "K")
DEGREES = 180 / math.pi
# unit -> what is shown instead
DISPLAYED = {"rad": "deg", "rad/s": "deg/s", "rad/s^2": "deg/s^2"}
_RADIANS = re.compile(r"(^|[ /*])rad(?:\^(-?\d+))?(?=$|[ /*])")


def definitions(units: Iterable[str]) -> list[Element]:
    """``Unit`` elements, one for each unit, in the order of the names."""
    return [_definition(name) for name in sorted(set(units))]


def _definition(name: str) -> Element:
    exponents = dict(zip(BASES, unit(name).dimension, strict=True))
    base = {base: str(round(power)) for base, power in exponents.items() if power}
    radians = _radians(unit(name).si)
    if radians:
        base["rad"] = str(radians)
    children = [Element("BaseUnit", base)]
    if name in DISPLAYED:
        children.append(Element("DisplayUnit", {"name": DISPLAYED[name], "factor": repr(DEGREES)}))
    return Element("Unit", {"name": name}, children)


def _radians(text: str) -> int:
    """The power of the radian in a unit."""
    return sum(
        int(match[2] or 1) * (-1 if match[1] == "/" else 1) for match in _RADIANS.finditer(text)
    )
