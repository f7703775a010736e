"""What a program is in a contest of motions."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from benchmarks.motion.problem import Array, Task


@dataclass(frozen=True)
class Entry:
    """A program with a method and a setting, ready to be timed.

    Attributes:
        program: Its name.
        method: As it calls it.
        setting: Tolerance, or number of steps where it takes steps of one size.
        run: Computes the whole motion; our coordinates (nq,) at its end.
    """

    program: str
    method: str
    setting: float
    run: Callable[[], Array] = field(repr=False)


@dataclass(frozen=True)
class Program:
    """Something that computes motions.

    Attributes:
        name: As people call it.
        missing: Why it is not here and what to do, "" where it is.
        refusal: Why it does not compute a task, "" where it does.
        entries: Its runs of a task, everything that can be prepared done.
    """

    name: str
    missing: Callable[[], str] = field(repr=False)
    refusal: Callable[[Task], str] = field(repr=False)
    entries: Callable[[Task], list[Entry]] = field(repr=False)


def willing(task: Task) -> str:
    """The refusal of a program that takes everything."""
    return ""


def present() -> str:
    """What is missing of something that is always here."""
    return ""
