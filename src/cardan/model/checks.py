"""Checks of single statements of a model, made where they are written."""

from __future__ import annotations

import math
import warnings
from collections.abc import Container, Sequence
from numbers import Real
from typing import Any

from ..errors import ModelError

LONGEST_NAME = 200


def name(what: str, text: Any) -> str:
    """A usable name.

    Raises:
        ModelError: not text, empty, too long or with characters that cannot be printed.
    """
    if not isinstance(text, str) or not text.strip():
        raise ModelError(f"{what}: a name must be text that is not empty, not {text!r}")
    if len(text) > LONGEST_NAME or not text.isprintable():
        raise ModelError(
            f"{what} {text[:40]!r}: a name has at most {LONGEST_NAME} printable characters"
        )
    return text


def new(what: str, text: str, known: Container[str]) -> None:
    """A usable name that is not taken.

    Raises:
        ModelError: it is taken or not usable.
    """
    name(what, text)
    if text in known:
        raise ModelError(f"{what} '{text}': the name is taken; names of this sort must differ")


def number(who: str, value: Any) -> float:
    """A finite number.

    Raises:
        ModelError: it is not.
    """
    try:
        result = float(value)
    except (TypeError, ValueError) as problem:
        raise ModelError(f"{who}: a number is wanted, not {value!r}") from problem
    except OverflowError as problem:
        raise ModelError(f"{who}: the number is too large for the machine") from problem
    if not math.isfinite(result):
        raise ModelError(f"{who}: must be finite, not {result}")
    return result


def is_number(value: Any) -> bool:
    """True for real numbers of Python, NumPy and SymPy, fractions too; arrays are none."""
    if isinstance(value, Real):
        return True
    return type(value).__module__ == "numpy" and getattr(value, "ndim", 1) == 0


def initial(
    who: str, what: str, value: float | Sequence[float] | None, count: int
) -> tuple[float, ...] | None:
    """Initial values of a joint, one per component.

    Raises:
        ModelError: a wrong number of them.
    """
    if value is None:
        return None
    entries = (value,) if is_number(value) else tuple(value)  # type: ignore[arg-type]
    if len(entries) != count:
        raise ModelError(f"{who}: {what} has {len(entries)} entries, but {count} are wanted")
    return tuple(number(f"{who}: {what}", entry) for entry in entries)


def mass(body: str, value: Any, inertia: Sequence[Any]) -> None:
    """Mass and inertia given as numbers can be those of a body.

    Raises:
        ModelError: negative or NaN mass, NaN inertia.
    """
    if value is not None and is_number(value) and number(f"body '{body}': mass", value) < 0:
        raise ModelError(f"body '{body}': mass is {value} kg; it must not be negative")
    if all(is_number(entry) for entry in inertia):
        numbers = [number(f"body '{body}': inertia", entry) for entry in inertia]
        if any(numbers):
            problem = unphysical(numbers)
            if problem:
                warnings.warn(f"body '{body}': {problem}", stacklevel=4)


def unphysical(inertia: Sequence[float]) -> str:
    """Why a tensor xx xy xz yy yz zz is that of no mass distribution; "" where it may be one.

    The principal moments a <= b <= c of a body satisfy 0 <= a and c <= a + b. With the trace s,
    both hold exactly when s/2 - I is positive semidefinite.

    Source: Wensing, Kim and Slotine, Linear matrix inequalities for physically consistent inertial
    parameter identification, 2018.
    """
    scale = max(abs(entry) for entry in inertia)
    if scale == 0:
        return ""
    xx, xy, xz, yy, yz, zz = (entry / scale for entry in inertia)
    half = (xx + yy + zz) / 2
    # s/2 - I; all its principal minors must not be negative, apart from rounding in files
    a, b, c, d, e, f = half - xx, -xy, -xz, half - yy, -yz, half - zz
    minors = [a, d, f, a * d - b * b, a * f - c * c, d * f - e * e]
    minors.append(a * (d * f - e * e) - b * (b * f - c * e) + c * (b * e - c * d))
    if min(minors) >= -1e-6:
        return ""
    return (
        "its inertia violates the triangle inequality (no body has principal moments of which one "
        "exceeds the sum of the others); check the entries and their unit"
    )
