"""Runners between two runs: the memory and the record of one serve the next one like it."""

from __future__ import annotations

import ctypes

from ...runtime.models.loaded_model import LoadedModel
from .events import Happenings
from .run import Runner
from .settings import Settings
from .signals import Signals

SMALL = 1 << 20  # bytes that a runner may hold between two runs


def spare(model: LoadedModel, settings: Settings, given: Signals, may: Happenings) -> Runner | None:
    """A runner that an earlier run has left, as good as new; None if there is none.

    Args: as :class:`.run.Runner` takes them.
    """
    if given.pieces or given.functions or may.rows:
        return None
    # nobody else has it meanwhile
    runner: Runner | None = model._derived.pop((Runner, settings.method.name), None)
    if runner is None or runner.settings.method is not settings.method:
        return None
    record, runner.closing = runner.begun
    ctypes.memmove(ctypes.addressof(runner.record), record, len(record))
    runner.memory.fill(0.0)
    runner.settings, runner.signals, runner.may, runner.error = settings, given, may, None
    runner.adjust()
    return runner


def put_aside(runner: Runner) -> None:
    """Leave a runner to the next run like the one that is over, if it is small."""
    given, run = runner.signals, runner.record
    asked = given.pieces or given.functions or runner.may.rows or runner.interpreted
    if not asked and not run.mesh and runner.memory.nbytes < SMALL:
        runner.rows, runner.spreads = runner.rows[:0].copy(), runner.spreads[:0].copy()
        runner.model._derived[Runner, runner.settings.method.name] = runner
