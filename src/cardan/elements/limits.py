"""Limits of the numbers of an element: checked where they are written, and where they change."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from ..errors import ModelError


@dataclass(frozen=True)
class Limit:
    """Limits of one quantity of a section, a material, a cable or a force element.

    Attributes:
        name: Of the quantity; of several entries each has these limits.
        message: What is said where it is something else; ``{value}`` stands for it, ``{other}`` for
            what it must not be below.
        least, most: Its range.
        open: The least value itself, or that of the other quantity, is not in it.
        other: Name of a quantity of which it must not be below a multiple; "" for none.
        times: Which multiple.
    """

    name: str
    message: str
    least: float = -math.inf
    most: float = math.inf
    open: bool = False
    other: str = ""
    times: float = 1.0


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
        values: Name -> number, expression or None, or a tuple of such.

    Raises:
        ModelError: one is.
    """
    for limit in limits:
        entries, least = values.get(limit.name), limit.least
        if limit.other:
            other = values.get(limit.other)
            if not isinstance(other, float):
                continue
            least = limit.times * other
        for value in entries if isinstance(entries, tuple) else (entries,):
            if not isinstance(value, float):
                continue
            if value < least or value > limit.most or (limit.open and value == least):
                message = limit.message.replace("{value}", f"{value:g}")
                raise ModelError(f"{who}: {message.replace('{other}', f'{least:g}')}")
