"""Do the units of an expression fit where it is used?

Only declared units are judged: decimals, numbers in sums, symbols without a unit, coordinates and
the time fit anywhere, so that ``-2.0 * q`` may be a torque and ``m * 0.3**2`` an inertia.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from ..errors import ModelError
from .units import NONE, Dimension, unit

if TYPE_CHECKING:
    import sympy

Units = Mapping[str, "str | None"]


def check(expression: object, expected: str, units: Units, name: str) -> None:
    """The expression is measured in the unit that is wanted.

    Args:
        expression: A SymPy expression.
        expected: Unit of the place it is used in; "" takes anything.
        units: Unit of every symbol by name; None where it fits anywhere.
        name: Of the place, for the message.

    Raises:
        ModelError: it is not, or it adds what cannot be added.
    """
    actual = dimension(expression, units, name)
    if expected and actual is not None and actual != unit(expected).dimension:
        raise ModelError(
            f"'{name}': {expression} is measured in {written(actual)}, "
            f"but {expected} is wanted; check the unit= of its parameters"
        )


def dimension(expression: sympy.Expr, units: Units, name: str) -> Dimension | None:
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
        base_dimension = dimension(base, units, name)
        if base_dimension is None or not exponent.is_Number:
            return None
        return _scaled(base_dimension, float(exponent))
    for argument in expression.args:
        if getattr(argument, "is_Boolean", False) is not True and hasattr(argument, "is_Add"):
            dimension(argument, units, name)
    return None


def _sum(expression: sympy.Expr, units: Units, name: str) -> Dimension | None:
    common = None
    for term in expression.args:
        term_dimension = dimension(term, units, name)
        if term_dimension is None:
            continue
        if common is not None and term_dimension != common:
            raise ModelError(
                f"'{name}': {expression} adds {written(common)} and {written(term_dimension)}; "
                "check the unit= of its parameters"
            )
        common = term_dimension
    return common


def _product(expression: sympy.Expr, units: Units, name: str) -> Dimension | None:
    total: Dimension = NONE
    for factor in expression.args:
        if factor.is_Rational or factor.is_NumberSymbol:
            continue
        # a decimal may be a measured thing, such as the length in m * 0.3**2
        if factor.is_Float:
            return None
        factor_dimension = dimension(factor, units, name)
        if factor_dimension is None:
            return None
        a, b, c, d, e = (x + y for x, y in zip(total, factor_dimension, strict=True))
        total = (a, b, c, d, e)
    return total


def _scaled(base: Dimension, power: float) -> Dimension:
    a, b, c, d, e = (x * power for x in base)
    return a, b, c, d, e


def written(exponents: Dimension) -> str:
    """A dimension in base units."""
    parts = [
        name if power == 1 else f"{name}^{power:g}"
        for name, power in zip(("kg", "m", "s", "A", "K"), exponents, strict=True)
        if power
    ]
    return " ".join(parts) or "a number without unit"
