"""Do the units of an expression fit where it is used?

Only declared units are judged: decimals, numbers in sums, symbols without a unit, coordinates and
the time fit anywhere, so that ``-2.0 * q`` may be a torque and ``m * 0.3**2`` an inertia.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ..errors import ModelError
from .units import NONE, Dimension, unit

Known = Mapping[str, "str | None"]


def check(expression: Any, wanted: str, units: Known, name: str) -> None:
    """The expression is measured in the unit that is wanted.

    Args:
        expression: A SymPy expression.
        wanted: Unit of the place it is used in; "" takes anything.
        units: Unit of every symbol by name; None where it fits anywhere.
        name: Of the place, for the message.

    Raises:
        ModelError: it is not, or it adds what cannot be added.
    """
    found = dimension(expression, units, name)
    if wanted and found is not None and found != unit(wanted).dimension:
        raise ModelError(
            f"'{name}': {expression} is measured in {written(found)}, "
            f"but {wanted} is wanted; check the unit= of its parameters"
        )


def dimension(expression: Any, units: Known, name: str) -> Dimension | None:
    """Exponents of the base units; None where anything fits.

    Raises:
        ModelError: a sum of different dimensions.
    """
    if expression.is_Symbol:
        text = units.get(expression.name)
        return None if text is None else unit(text).dimension
    if expression.is_Number or expression.is_NumberSymbol:
        return None
    if expression.is_Add:
        return _sum(expression, units, name)
    if expression.is_Mul:
        return _product(expression, units, name)
    if expression.is_Pow:
        base, exponent = expression.as_base_exp()
        found = dimension(base, units, name)
        if found is None or not exponent.is_Number:
            return None
        return _scaled(found, float(exponent))
    for argument in expression.args:
        if getattr(argument, "is_Boolean", False) is not True and hasattr(argument, "is_Add"):
            dimension(argument, units, name)
    return None


def _sum(expression: Any, units: Known, name: str) -> Dimension | None:
    found = None
    for term in expression.args:
        own = dimension(term, units, name)
        if own is None:
            continue
        if found is not None and own != found:
            raise ModelError(
                f"'{name}': {expression} adds {written(found)} and {written(own)}; "
                "check the unit= of its parameters"
            )
        found = own
    return found


def _product(expression: Any, units: Known, name: str) -> Dimension | None:
    total: Dimension = NONE
    for factor in expression.args:
        if factor.is_Rational or factor.is_NumberSymbol:
            continue
        # a decimal may be a measured thing, such as the length in m * 0.3**2
        if factor.is_Float:
            return None
        found = dimension(factor, units, name)
        if found is None:
            return None
        a, b, c, d, e = (x + y for x, y in zip(total, found, strict=True))
        total = (a, b, c, d, e)
    return total


def _scaled(found: Dimension, power: float) -> Dimension:
    a, b, c, d, e = (x * power for x in found)
    return a, b, c, d, e


def written(found: Dimension) -> str:
    """A dimension in base units."""
    parts = [
        name if power == 1 else f"{name}^{power:g}"
        for name, power in zip(("kg", "m", "s", "A", "K"), found, strict=True)
        if power
    ]
    return " ".join(parts) or "a number without unit"
