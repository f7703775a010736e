"""The state of a run, as a copy of all that its steps read."""

from __future__ import annotations

from typing import Any

from ...records import dataclass


@dataclass(frozen=True)
class Saved:
    """A checkpoint of a run.

    Attributes:
        record, memory: Of the run, to the bit.
        owner: Whose they are.
        ticks: When the next samples are due.
        over: What ended it, in words; "" if it may go on.
        segments: Segment of every tabulated input.
    """

    record: Any
    memory: bytes
    owner: int
    ticks: bytes = b""
    over: str = ""
    segments: tuple[int, ...] = ()
