"""Rows of the manifest: entries of blocks of numbers, multipliers, limits, events."""

from __future__ import annotations

from collections.abc import Mapping

from .fields import (
    NOTHING,
    Record,
    count,
    either,
    field,
    flag,
    number,
    one_of,
    positive,
    table,
    text,
)

EVENTS = ("mode", "impact", "tick", "end", "mark", "halt")


class Entry(Record):
    """An entry of a block of numbers, such as r or z."""

    name: str = field(text)
    unit: str = field(text, run="")
    default: float = field(number, run=0.0)


class CoordinateRow(Entry):
    """An entry of q."""

    joint: str | None = field(text, run=None)
    reach: float | None = field(
        number,
        "regular where the coordinate is smaller in size; absent without bound",
        default=None,
    )


class SpeedRow(Entry):
    """An entry of u."""

    default: float = field(number, default=0.0)
    joint: str | None = field(text, "absent where speeds were chosen by the user", default=None)
    of: str = field(
        text, "coordinate whose derivative the speed is, where the names do not say it", default=""
    )


class ModeRow(Entry):
    """An entry of s."""

    unit: str = field(text, default="")
    labels: Mapping[str, str] = field(table(text), "texts by the values", default=NOTHING)


class ParameterRow(Entry):
    """An entry of p."""

    declared: bool = field(flag, "declared by the user as a parameter", default=False)


class ForceRow(Record):
    """A number of the force of an element."""

    element: str = field(text)
    name: str = field(text, "<element>.force, or one of its components")
    unit: str = field(text)


class OutputRow(Entry):
    """An output of the user."""

    default: float = field(number, default=0.0)


class LimitRow(Record):
    """Limits of a multiple of a parameter, which is a number of an element."""

    parameter: str = field(text, "what the limit is of")
    element: str = field(text, "the element it belongs to, in words")
    message: str = field(text, "what is said about other values; {value} and {other} are numbers")
    least: float | str | None = field(
        either(number, text), "least value, or the parameter that has it", default=None
    )
    most: float | None = field(number, default=None)
    open: bool = field(flag, "whether the least value itself is refused", default=False)
    below: bool = field(flag, "whether the most value itself is refused", default=False)
    nonzero: bool = field(flag, "whether 0 is refused", default=False)
    scale: float = field(number, "the limit is of this multiple of the parameter", default=1.0)
    times: float = field(number, "multiple of the parameter that has the least value", default=1.0)


class MultiplierRow(Record):
    """An entry of lam."""

    name: str = field(text)
    unit: str = field(text)
    joint: str = field(text, "joint or constraint", run="")
    level: str = field(one_of("position", "velocity"))
    switched: bool = field(flag, "whether a mode says if it holds", default=False)


class EventRow(Record):
    """An event, in the order of the block e."""

    name: str = field(text)
    element: str = field(text)
    kind: str = field(one_of(*EVENTS))
    about: str = field(text, default="")
    unit: str = field(text, default="")
    beyond: str = field(text, "what is said about a start behind it", default="")
    decides: Mapping[str, float] = field(
        table(number),
        "mode -> value from which it is not an event but the first decision about that mode",
        default=NOTHING,
    )


class TickRow(Record):
    """When an event at known times happens."""

    event: int = field(count)
    period: float = field(positive, "[s]")
    phase: float = field(number, "[s]")
