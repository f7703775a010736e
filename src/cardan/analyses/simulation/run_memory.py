"""Memory of runs over elements: that of one run serves the next one of the same model."""

from __future__ import annotations

import numpy as np

from ...arrays import Array
from ...runtime.models.loaded_model import LoadedModel

MOST_BYTES = 1 << 30  # that stay with a model
MEMORY = "memory of a run over elements"


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
