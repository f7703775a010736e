"""The numbers of the record of a run that a file holds, and the record that is made of them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, fields, replace
from pathlib import Path
from typing import Any

from ..errors import ModelError
from . import record as abi
from .plain import PlainRunner
from .plain_record import Progress
from .run import Runner, Saved

# of the record: what belongs to a process, or to the room that rows have there
PASSING = {
    *("capacity", "count", "log_capacity", "log_count", "stop_count", "next_stop"),
    *("time_count", "next_time", "budget", "stop"),
}


def record_of(runner: Runner | PlainRunner) -> dict[str, float]:
    """The numbers of the record that a run goes on from."""
    run = runner.record
    if isinstance(run, Progress):
        return asdict(run)
    return {name: getattr(run, name) for name in fields_of_runs()}


def fields_of_runs() -> list[str]:
    """Fields of the record that are numbers, and belong to the run."""
    numbers = [name for kind, names in abi.FIELDS if kind != abi.POINTER for name in names.split()]
    return [name for name in numbers if name not in PASSING]


def saved_of(
    runner: Runner | PlainRunner, numbers: Mapping[str, Any], memory: Any, ticks: bytes, path: Path
) -> Saved:
    """The checkpoint as the run takes it.

    Args:
        runner: Of the same model and method.
        numbers, memory, ticks: As :func:`record_of` and ``runner.save()`` gave them.
        path: The file they come from, for messages.

    Raises:
        ModelError: another version of cardan wrote them.
    """
    run = runner.record
    known = [f.name for f in fields(run)] if isinstance(run, Progress) else fields_of_runs()
    whole = runner.save()
    if set(numbers) != set(known) or len(whole.memory) != memory.nbytes:
        raise ModelError(f"{path} was written by another version of cardan; start the run anew")
    record: Any
    if isinstance(run, Progress):
        record = replace(run, **numbers)
    else:
        other = abi.Run.from_buffer_copy(whole.record)
        for name, value in numbers.items():
            setattr(other, name, value)
        record = bytes(other)
    if len(ticks) != len(whole.ticks):
        raise ModelError(f"{path}: its samples are not those of the model")
    return Saved(record, memory.tobytes(), whole.owner, ticks)
