"""Checks of what a user wrote, at the moment of writing.

Numbers come back as floats and expressions as they are: anything with free symbols is an
expression, so that SymPy is not needed to recognize one.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from ..errors import ModelError, brief

# directions by their letters
AXES = {
    sign + letter: tuple(float(sign + "1") * (k == i) + 0.0 for i in range(3))
    for k, letter in enumerate("xyz")
    for sign in ("", "-", "+")
}
TOO_DEEP = (
    "is nested too deeply to be read; say it in fewer levels, such as with inputs or parameters "
    "in between"
)


def is_expression(value: object) -> bool:
    """True for a symbolic expression, which is judged when it gets its numbers.

    Raises:
        ModelError: it is nested too deeply for SymPy itself.
    """
    if not hasattr(type(value), "free_symbols"):
        return False
    try:
        return not getattr(value, "is_number", False)
    except RecursionError:
        raise ModelError(f"an expression {TOO_DEEP}") from None


def number(owner: str, name: str, value: Any) -> Any:
    """A finite number as float, or an expression.

    Raises:
        ModelError: text, None, complex, NaN or infinite values.
    """
    if is_expression(value) and not hasattr(value, "tolist"):
        return value
    boolean = isinstance(value, bool) or getattr(getattr(value, "dtype", None), "kind", "") == "b"
    if not boolean and not isinstance(value, str | bytes | None):
        try:
            result = float(value)
        except (TypeError, ValueError, OverflowError):
            result = math.nan
        if math.isfinite(result):
            return result
    raise ModelError(
        f"{owner}: {name} is {brief(value)}; give a finite number, a parameter or an expression"
    )


def positive(owner: str, name: str, value: object) -> Any:
    """A positive number as float, or an expression.

    Raises:
        ModelError: anything else.
    """
    value_checked = number(owner, name, value)
    if not is_expression(value_checked) and value_checked <= 0:
        raise ModelError(f"{owner}: {name} is {value_checked}; give a number above 0")
    return value_checked


def vector(owner: str, name: str, value: object, length: int | None = None) -> tuple[Any, ...]:
    """Numbers or expressions in order, from any sequence, array or column matrix.

    Raises:
        ModelError: wrong length, or an entry that is not a number.
    """
    value = value.tolist() if hasattr(value, "tolist") else value
    if isinstance(value, str | bytes) or not isinstance(value, Sequence):
        raise ModelError(
            f"{owner}: {name} is {brief(value)}; give {length or 'a sequence of'} numbers, "
            f"such as {tuple(range(length or 2))}"
        )
    entries = [x[0] if isinstance(x, Sequence) and len(x) == 1 else x for x in value]
    if length is not None and len(entries) != length:
        raise ModelError(f"{owner}: {name} has {len(entries)} entries; give {length}")
    return tuple(number(owner, f"{name}[{i}]", x) for i, x in enumerate(entries))


def axis(owner: str, name: str, value: object) -> tuple[Any, ...]:
    """A direction: one of "x" "y" "z" "-x" "-y" "-z", or three numbers or expressions.

    Raises:
        ModelError: an unknown letter, a wrong length, NaN, or the zero vector.
    """
    if isinstance(value, str):
        if value not in AXES:
            raise ModelError(
                f"{owner}: {name} {brief(value)} is not a direction; give 'x', 'y', 'z', "
                "'-x', '-y', '-z' "
                "or three numbers"
            )
        return AXES[value]
    entries = vector(owner, name, value, 3)
    if any(is_expression(x) for x in entries):
        return entries
    largest = max(abs(x) for x in entries)
    if largest == 0:
        raise ModelError(
            f"{owner}: {name} is the zero vector and has no direction; give for example 'z'"
        )
    # squares of far larger or smaller numbers are infinite or vanish
    return entries if 1e-100 < largest < 1e100 else tuple(x / largest for x in entries)


def parallel(a: tuple[Any, ...], b: tuple[Any, ...]) -> bool:
    """True where two directions given in numbers are parallel to rounding."""
    if any(is_expression(x) for x in (*a, *b)):
        return False
    x, y = ([float(v) / math.hypot(*map(float, n)) for v in n] for n in (a, b))
    cross = (x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0])
    return math.hypot(*cross) < 1e-12
