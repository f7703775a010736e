"""The numbers of the record of a run that a file holds, and the record that is made of them.

Sizes, and everything else that follows from the model and the settings, are in no file: they come
from the run that goes on. What is in the file is what a run changes; numbers that the kernels use
as places or counts are refused outside of their range.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from ....errors import ModelError
from ....schema.records import Run
from ....version import written_by
from .. import run_record as abi
from ..run import Runner
from ..run_state import Saved

MOST = 1 << 53  # of what is counted
FLAGS = ("fresh", "begun", "is_dense", "event_pending")
COUNTS = (
    *("in_segment", "rejected", "ranks", "at_once", "occurred", "pass_part", "pass_parts"),
    *("steps", "rejections", "evaluations", "projections", "passed"),
    *("looked", "limited", "jacobians", "factorizations"),
)
TIMES = ("t", "t_old", "t_start", "segment", "h")
REALS = (
    *("until", "early", "late", "moment", "error_before", "correction", "size"),
    *("rank_margin", "best_rank_margin", "pass_start", "pass_length"),
)
POINTS = 10  # MOST_POINTS of kernels/events/gauss.h
STATUS = 1 << 31


def limits(runner: Runner) -> dict[str, tuple[int, int]]:
    """Least and largest value of every whole number of the record that belongs to a run."""
    run = runner.record
    return {
        **dict.fromkeys(COUNTS, (0, MOST)),
        "culprit": (-1, run.n + len(runner.event_table.rows) - 1),
        "open_row": (-1, run.positions + run.rates - 1),
        "model_status": (-STATUS, STATUS),
        **dict.fromkeys(FLAGS, (0, 1)),
        "row_open": (0, 2),
        "constraint_rank": (0, run.rates),
        "pass_points": (0, POINTS),
    }


def record_of(runner: Runner) -> dict[str, float]:
    """The numbers of the record that a run goes on from."""
    run = runner.record
    return {name: getattr(run, name) for name in (*limits(runner), *TIMES, *REALS)}


def saved_of(
    runner: Runner, numbers: Mapping[str, Any], memory: Any, ticks: Any, path: Path, writer: object
) -> Saved:
    """The checkpoint as the run takes it.

    Args:
        runner: Of the same model and method.
        numbers: As :func:`record_of` gave them.
        memory: Of the run.
        ticks: As :func:`ticks_of` gave them.
        path: The file they come from, for messages.
        writer: The cardan that wrote it.

    Raises:
        ModelError: another version of cardan wrote them, or they are of no run of this model.
    """
    current = runner.save()
    if getattr(memory, "dtype", None) != np.float64:
        raise impossible(path, "its memory holds no numbers")
    names = set(numbers) if isinstance(numbers, Mapping) else set()
    if names != set(record_of(runner)) or memory.nbytes != len(current.memory):
        raise ModelError(
            f"{path} was written by {written_by(writer)}, whose runs go on from other numbers; "
            "start the run anew"
        )
    checked(numbers, limits(runner), path)
    run = Run.from_buffer_copy(current.record)
    for name, value in numbers.items():
        setattr(run, name, value)
    _fits_itself(run, path)
    if run.on_grid and abs(run.h) != runner.settings.step:
        raise impossible(path, f"its step is {run.h:g} s")
    due = _ticks(runner, ticks, float(numbers["t"]), path)
    return Saved(bytes(run), memory.tobytes(), current.owner, due)


def checked(numbers: Mapping[str, Any], ranges: Mapping[str, tuple[int, int]], path: Path) -> None:
    """Look at the types and ranges of numbers.

    Args:
        numbers: From a file.
        ranges: Least and largest value of those that are whole; the others are real.
        path: The file.

    Raises:
        ModelError: a number is none, or lies outside.
    """
    for name, value in numbers.items():
        least, most = ranges.get(name, (0, 0))
        if name in ranges:
            right = type(value) is int and least <= value <= most
        else:
            right = (type(value) in (int, float) and abs(value) < 1e308) or value == math.inf
        if name in TIMES:
            right = right and math.isfinite(value)
        if not right:
            raise impossible(path, f"'{name}' is {value!r:.40}")


def impossible(path: Path, what: str) -> ModelError:
    """The error for a file with contents that no run writes."""
    return ModelError(f"{path} is damaged or was changed: {what}. Start the run anew")


def _fits_itself(run: Run, path: Path) -> None:
    """Check that numbers of a record that belong together fit each other."""
    if run.event_pending and not run.ne + run.watched:
        raise impossible(path, "an event happens that the model does not have")
    if not run.constraint_jacobian and (run.pass_length != 0 or run.pass_parts != 0):
        raise impossible(path, "it passes a singular position without constraints")
    if run.pass_part > run.pass_parts or (run.pass_parts > 0 and not run.pass_points >= 1):
        raise impossible(path, "it is in no part of a step over a singular position")
    forth = run.t - run.t_old
    if forth != 0 and run.h != 0 and (forth > 0) != (run.h > 0):
        raise impossible(path, "its next step leads back")


def ticks_of(runner: Runner) -> list[list[float]]:
    """Number and time of the next sample of every tick."""
    count = runner.record.tick_count
    return [[row.count, row.next] for row in list(runner.ticks)[:count]]


def _ticks(runner: Runner, pairs: Any, t: float, path: Path) -> bytes:
    """The ticks of a run with what a file says about the next ones."""
    rows = type(runner.ticks).from_buffer_copy(bytes(runner.ticks))
    count = runner.record.tick_count
    right = isinstance(pairs, list) and len(pairs) == count
    if not right or not all(isinstance(pair, list) and len(pair) == 2 for pair in pairs):
        raise impossible(path, "its samples are not those of the model")
    for row, (number, due) in zip(rows, pairs, strict=False):
        checked({"count": number, "next": due}, {"count": (-MOST, MOST)}, path)
        tolerance = 1e-8 * row.period
        regular = abs(row.phase + number * row.period - due) <= tolerance
        if not (regular and t <= due <= t + row.period + tolerance):
            raise impossible(path, f"its next sample is due at {due:g} s")
        row.count, row.next = number, due
    return bytes(rows)


def sound(runner: Runner, path: Path) -> None:
    """Look at the places that restored memory holds, such as rows in a factored matrix.

    Raises:
        ModelError: some of them are outside.
    """
    if not abi.sound(runner.library, runner.method, runner.record):
        raise impossible(path, "its memory is not that of a run")
