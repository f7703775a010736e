"""What the rows and tables of a saved run may hold, entry by entry."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

LARGEST = 2**53  # in size of an integer that is a number as well
KINDS = ("mode", "impact", "tick", "end", "mark", "halt")
COUNTED = ("steps", "rejections", "evaluations", "milliseconds")

Check = Callable[[Any], bool]


def text(value: Any) -> bool:
    """A text that can be printed and written."""
    return isinstance(value, str) and not any("\ud800" <= letter <= "\udfff" for letter in value)


def number(value: Any) -> bool:
    whole = isinstance(value, int) and not isinstance(value, bool) and abs(value) < LARGEST
    return whole or isinstance(value, float)


def count(value: Any) -> bool:
    return isinstance(value, int) and not isinstance(value, bool) and 0 <= value < LARGEST


def flag(value: Any) -> bool:
    return isinstance(value, bool)


def listed(entry: Check, length: int | None = None) -> Check:
    return lambda value: (
        isinstance(value, list)
        and (length is None or len(value) == length)
        and all(map(entry, value))
    )


def row_of(**entries: Check) -> Check:
    """A row with these entries; of those that begin with ``maybe_`` it may have none, or null."""

    def good(value: Any) -> bool:
        if not isinstance(value, Mapping):
            return False
        for name, entry in entries.items():
            key = name.removeprefix("maybe_")
            if value.get(key) is None:
                if key == name:
                    return False
            elif not entry(value[key]):
                return False
        return True

    return good


def named_numbers(value: Any) -> bool:
    return isinstance(value, dict) and all(map(text, value)) and all(map(number, value.values()))


NAMED = row_of(name=text, maybe_unit=text)
PAIR = listed(count, 2)
PLANE = row_of(spread=listed(listed(number, 3), 6), home=listed(number, 4))
VECTOR = listed(number, 3)
ROWS: dict[str, Check] = {
    **dict.fromkeys(("coordinates", "speeds", "inputs", "z", "s", "outputs"), NAMED),
    "multipliers": row_of(
        name=text, unit=text, level=lambda value: value in ("position", "velocity")
    ),
    "joints": row_of(
        name=text,
        kind=text,
        maybe_q=PAIR,
        maybe_u=PAIR,
        maybe_coupled=row_of(leader=text),
        maybe_prescribed=flag,
        maybe_solved=row_of(q=listed(text), u=listed(text)),
    ),
    "bodies": row_of(name=text, parent=text, parts=listed(text)),
    "frames": row_of(name=text, body=text, maybe_node=PAIR, maybe_plane=PLANE),
    "beams": row_of(
        name=text,
        start=text,
        end=text,
        q=PAIR,
        outline=lambda value: (
            isinstance(value, list)
            and len(value) == 3
            and all(map(number, value[:2]))
            and isinstance(value[2], bool | int)
        ),
        maybe_plane=PLANE,
    ),
    "shapes": row_of(
        kind=text,
        frame=text,
        position=VECTOR,
        maybe_rotation=listed(VECTOR, 3),
        maybe_color=listed(number),
        maybe_axis=lambda value: value in ("x", "y", "z"),
        **{f"maybe_{size}": number for size in ("radius", "length", "x", "y", "z")},
    ),
    "quaternions": count,
    "available": text,
}
SIZES = {
    "box": ("x", "y", "z"),
    "sphere": ("radius",),
    **dict.fromkeys(("cylinder", "capsule"), ("radius", "length")),
}
CONDUCT = row_of(
    **dict.fromkeys(
        ("method", "settings", "status", "message", "maybe_reason", "maybe_warning"), text
    ),
    initial=named_numbers,
    defaulted=listed(text),
    statistics=lambda value: named_numbers(value) and set(COUNTED) <= set(value),
)
HAPPENING = row_of(
    name=text,
    element=text,
    kind=lambda value: value in KINDS,
    maybe_decides=listed(number, 2),
)
SIGNALS = row_of(constants=listed(number), pieces=listed(count), asked=listed(count), held=flag)
