"""Limits of the numbers of an element: checked where they are written, and where they change."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from ..errors import ModelError


@dataclass(frozen=True)
class Limit:
    """Limits of one number of an element.

    Attributes:
        name: Of the quantity.
        message: What is said where it is something else; ``{value}`` stands for it, ``{other}`` for
            the number of the other quantity.
        least, most: Its range.
        open: The least value itself, or that of the other quantity, is not in it.
        other: Name of a quantity that it must not be below; "" for none.
    """

    name: str
    message: str
    least: float = -math.inf
    most: float = math.inf
    open: bool = False
    other: str = ""


def not_negative(*names: str, requirement: str = "0 or more") -> tuple[Limit, ...]:
    """Quantities from 0 on."""
    return tuple(Limit(name, f"{name} is {{value}}; give {requirement}", 0.0) for name in names)


def positive(*names: str, requirement: str = "more than 0") -> tuple[Limit, ...]:
    """Quantities above 0."""
    return tuple(
        Limit(name, f"{name} is {{value}}; give {requirement}", 0.0, open=True) for name in names
    )


def judge(who: str, limits: Sequence[Limit], values: Mapping[str, Any]) -> None:
    """Refuse numbers out of their limits; expressions are judged when they get their numbers.

    Args:
        who: Whose they are, for messages.
        limits: Of the element.
        values: Name -> number, expression or None.

    Raises:
        ModelError: one is.
    """
    for limit in limits:
        value, other = values.get(limit.name), values.get(limit.other)
        if not isinstance(value, float) or (limit.other and not isinstance(other, float)):
            continue
        least = other if limit.other else limit.least
        assert least is not None
        if value < least or value > limit.most or (limit.open and value == least):
            message = limit.message.replace("{value}", f"{value:g}").replace(
                "{other}", f"{least:g}"
            )
            raise ModelError(f"{who}: {message}")
