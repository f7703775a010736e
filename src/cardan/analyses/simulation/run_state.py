"""The state of a run, as a copy of all that its steps read, and the memory that runs share."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...arrays import Array
from ...records import dataclass
from ...runtime.models.loaded_model import LoadedModel

MOST_BYTES = 1 << 30  # that stay with a model
MEMORY = "memory of a run over elements"


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


def memory_of(model: LoadedModel, count: int) -> Array:
    """Zeros (count,): where an earlier run has left its memory, in the pages that it was given.

    To get half a gigabyte from the system takes longer than to factor 100,000 elements.
    """
    memory: Array | None = model._derived.pop(MEMORY, None)
    if memory is None or len(memory) != count:
        return np.zeros(count)
    memory.fill(0.0)
    return memory


def leave_memory(model: LoadedModel, memory: Array) -> None:
    """Leave the memory of a run that is over to the next one; nobody else has it."""
    if memory.nbytes <= MOST_BYTES:
        model._derived[MEMORY] = memory
