"""Runners between two runs: the memory and the record of one serve the next one like it."""

from __future__ import annotations

import ctypes

from ...runtime.models.loaded_model import LoadedModel
from .events import EventTable
from .run import Runner
from .run_state import leave_memory
from .settings import Settings
from .signals import Signals

SMALL = 1 << 20  # bytes of its state that a runner may hold between two runs
ROOM = 1 << 22  # and of the room for its rows


def spare(
    model: LoadedModel, settings: Settings, input_signals: Signals, event_table: EventTable
) -> Runner | None:
    """A runner that an earlier run has left, as good as new; None if there is none.

    Args: as :class:`.run.Runner` takes them.
    """
    if input_signals.tabulated or input_signals.functions or event_table.rows:
        return None
    # nobody else has it meanwhile
    runner: Runner | None = model._derived.pop((Runner, settings.method.name), None)
    if runner is None or runner.settings.method != settings.method:
        return None
    runner.settings, runner.signals, runner.event_table = settings, input_signals, event_table
    rewind(runner)
    return runner


def rewind(runner: Runner) -> None:
    """Make a runner as good as new: its memory and its record serve another run."""
    record, runner.closing = runner.begun
    ctypes.memmove(ctypes.addressof(runner.record), record, len(record))
    runner.memory.fill(0.0)
    runner.error = None
    runner.adjust()


def put_aside(runner: Runner) -> None:
    """Leave a runner to the next run like the one that is over, if it is small."""
    input_signals, run = runner.signals, runner.record
    has_inputs = (
        input_signals.tabulated
        or input_signals.functions
        or runner.event_table.rows
        or runner.interpreted
    )
    if not has_inputs and not run.mesh and runner.memory.nbytes < SMALL:
        if runner.rows.nbytes + runner.dense_room.nbytes > ROOM:
            runner.rows, runner.dense_room = runner.rows[:0].copy(), runner.dense_room[:0].copy()
        runner.spreads = runner.dense_room[:0]
        runner.model._derived[Runner, runner.settings.method.name] = runner
    else:
        if run.mesh:
            leave_memory(runner.model, runner.memory)
        # which refers to the runner: both would stay until cycles are looked for
        runner.sweep = None
