"""Units at the boundary: text to a factor and a dimension. Inside, everything is SI."""

from __future__ import annotations

import math
import re
from functools import lru_cache

from ..errors import ModelError, brief, near
from ..records import dataclass

# exponents of kg, m, s, A, K
Dimension = tuple[float, float, float, float, float]
NONE: Dimension = (0, 0, 0, 0, 0)


@dataclass(frozen=True)
class Unit:
    """A unit: ``value [SI] = factor * value [unit]``.

    Attributes:
        factor: To SI.
        dimension: Exponents of kg, m, s, A, K.
        si: The SI unit in words, radians kept, such as ``N m/rad``.
    """

    factor: float
    dimension: Dimension
    si: str


_LENGTH: Dimension = (0, 1, 0, 0, 0)
_MASS: Dimension = (1, 0, 0, 0, 0)
_TIME: Dimension = (0, 0, 1, 0, 0)
_FORCE: Dimension = (1, 1, -2, 0, 0)
_ENERGY: Dimension = (1, 2, -2, 0, 0)
_POWER: Dimension = (1, 2, -3, 0, 0)
_PRESSURE: Dimension = (1, -1, -2, 0, 0)
_RATE: Dimension = (0, 0, -1, 0, 0)

UNITS: dict[str, Unit] = {
    "1": Unit(1.0, NONE, ""),
    "m": Unit(1.0, _LENGTH, "m"),
    "mm": Unit(1e-3, _LENGTH, "m"),
    "cm": Unit(1e-2, _LENGTH, "m"),
    "km": Unit(1e3, _LENGTH, "m"),
    "um": Unit(1e-6, _LENGTH, "m"),
    "in": Unit(0.0254, _LENGTH, "m"),
    "ft": Unit(0.3048, _LENGTH, "m"),
    "kg": Unit(1.0, _MASS, "kg"),
    "g": Unit(1e-3, _MASS, "kg"),
    "mg": Unit(1e-6, _MASS, "kg"),
    "t": Unit(1e3, _MASS, "kg"),
    "lb": Unit(0.45359237, _MASS, "kg"),
    "s": Unit(1.0, _TIME, "s"),
    "ms": Unit(1e-3, _TIME, "s"),
    "us": Unit(1e-6, _TIME, "s"),
    "min": Unit(60.0, _TIME, "s"),
    "h": Unit(3600.0, _TIME, "s"),
    "rad": Unit(1.0, NONE, "rad"),
    "mrad": Unit(1e-3, NONE, "rad"),
    "deg": Unit(math.pi / 180, NONE, "rad"),
    "rev": Unit(2 * math.pi, NONE, "rad"),
    "rpm": Unit(math.pi / 30, _RATE, "rad/s"),
    "Hz": Unit(1.0, _RATE, "1/s"),
    "N": Unit(1.0, _FORCE, "N"),
    "mN": Unit(1e-3, _FORCE, "N"),
    "kN": Unit(1e3, _FORCE, "N"),
    "MN": Unit(1e6, _FORCE, "N"),
    "lbf": Unit(4.4482216152605, _FORCE, "N"),
    "J": Unit(1.0, _ENERGY, "J"),
    "kJ": Unit(1e3, _ENERGY, "J"),
    "W": Unit(1.0, _POWER, "W"),
    "kW": Unit(1e3, _POWER, "W"),
    "Pa": Unit(1.0, _PRESSURE, "Pa"),
    "kPa": Unit(1e3, _PRESSURE, "Pa"),
    "MPa": Unit(1e6, _PRESSURE, "Pa"),
    "GPa": Unit(1e9, _PRESSURE, "Pa"),
    "bar": Unit(1e5, _PRESSURE, "Pa"),
    "A": Unit(1.0, (0, 0, 0, 1, 0), "A"),
    "mA": Unit(1e-3, (0, 0, 0, 1, 0), "A"),
    "V": Unit(1.0, (1, 2, -3, -1, 0), "V"),
    "K": Unit(1.0, (0, 0, 0, 0, 1), "K"),
}


def unit(text: str) -> Unit:
    """The unit a text names, such as ``"mm"``, ``"kg m^2"``, ``"N*m/rad"``, ``"kg·m²"``.

    Everything after a ``/`` up to the next ``*`` or space is divided by.

    Raises:
        ModelError: no text, or a part of it is unknown.
    """
    if not isinstance(text, str):
        raise ModelError(f"unit {brief(text)}: a unit is text such as 'kg m^2'")
    return _unit(text)


@lru_cache(maxsize=256)
def _unit(text: str) -> Unit:
    parts = re.split(r"\s*([*/·]|\s)\s*", text.strip().replace("**", "^")) if text.strip() else []
    factor, dimension, sign = 1.0, NONE, 1
    names: list[str] = []
    for part in parts:
        if part.strip() in ("", "*", "·", "/"):
            sign = -1 if part.strip() == "/" else 1
            continue
        base, power = _factor(part, text)
        exponent = sign * power
        factor *= base.factor**exponent
        a, b = dimension, base.dimension
        dimension = tuple(x + exponent * y for x, y in zip(a, b, strict=True))  # type: ignore[assignment]
        names += _named(base.si, sign, power)
        sign = 1
    return Unit(factor, dimension, _joined(names))


def _factor(part: str, text: str) -> tuple[Unit, int]:
    """A named unit and its power."""
    match = re.fullmatch(r"([A-Za-z]+|1)(?:\^?(-?\d+)|([²³]))?", part)
    name = match.group(1) if match else part
    if match is None or name not in UNITS:
        raise ModelError(f"unit {brief(text)}: '{name}' is unknown." + near(name, UNITS))
    power = int(match.group(2) or {"²": 2, "³": 3}.get(match.group(3) or "", 1))
    if abs(power) > 12:
        raise ModelError(f"unit {brief(text)}: powers go up to 12")
    return UNITS[name], power


def _named(si: str, sign: int, power: int) -> list[str]:
    """Parts of an SI text such as ``rad/s``, raised; each with a space or a stroke before it."""
    above, *below = si.split("/")
    parts = [(name, sign) for name in above.split() if name != "1"]
    parts += [(name, -sign) for name in below]
    raised = "" if power == 1 else f"^{power}"
    return [(" " if side > 0 else "/") + name + raised for name, side in parts]


def _joined(names: list[str]) -> str:
    text = "".join(names).strip()
    return "1" + text if text.startswith("/") else text
