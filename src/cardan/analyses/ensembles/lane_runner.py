"""Runs of one model by one thread, in compiled C: in lanes, or one after the other.

Nothing here allocates per run: a block of runs is handed to ``kernels/lanes/ensemble.c``, whose
answers
are copies of run records. The GIL is released all the while.
"""

from __future__ import annotations

import ctypes
from dataclasses import field
from typing import Any

import numpy as np

from ...arrays import Array, Integers
from ...records import dataclass
from ...runtime.calls import lanes as widths
from ...runtime.calls.interpreted import called_back
from ...runtime.calls.samples import build
from ...runtime.models.constraint_projection import Closing
from ...runtime.models.loaded_model import LoadedModel
from ...schema.records import PER_LANE, Driver, Lane, Run, RunPointer, SimdSteps
from ..simulation import run_record as abi
from ..simulation.discontinuities import FUNCTION
from ..simulation.events import EventTable
from ..simulation.outcome import explain
from ..simulation.run import Runner
from ..simulation.settings import Settings
from ..simulation.signals import Signals
from ..simulation.times import Span
from . import lane_records as records
from .variations import Varied

# what is counted of every run
NUMBERS = ("t", "steps", "rejections", "evaluations")
NOT_RUN = -1000  # answer of a run that has not begun
UNITS = 8  # bytes of a number


@dataclass(frozen=True)
class Ends:
    """Final states of a block of runs.

    Attributes:
        x: Last states (count, nx).
        rows: At the output times (count, nt, 1 + nx + nr + ns or more): t, x, r, s; NaN where a run
            had ended before.
        status: Words, (count,).
        messages: Of the runs that did not reach their end, or miss far more than their tolerance is
            worth, by index in the block.
        numbers: (count, 4), of :data:`NUMBERS`: where it ended [s], ...
        warnings: Messages of warnings, by index in the block.
        sensitivity: At the output times, by name (count, nt, nx, ...); NaN as in rows, and where
            there is none.
        motions: Status of the motion alone, by index in the block, where it is another one.
    """

    x: Array
    rows: Array
    status: list[str]
    messages: dict[int, str]
    numbers: Array
    warnings: dict[int, list[str]] = field(default_factory=dict)
    sensitivity: dict[str, Array] = field(default_factory=dict)
    motions: dict[int, str] = field(default_factory=dict)


def suits(
    model: LoadedModel, how: Settings, input_signals: Signals, event_table: EventTable
) -> bool:
    """True when the loop in C can do the runs: trees without elements in tables, no functions of
    the caller on the way.
    """
    if (
        input_signals.functions
        or event_table.watches
        or event_table.ticks
        or Closing.of(model).rows
        # tables of elements are filled for one set of parameters, and go side by side themselves
        or model.manifest.absolute
    ):
        return False
    if FUNCTION in model.saved:
        return False
    # what a method makes of itself for a model is asked for every run
    return not how.method.conditions


def width_of(
    model: LoadedModel,
    how: Settings,
    event_table: EventTable,
    per_run_parameters: bool,
    seconds: float,
) -> int:
    """Lanes side by side: 1 without vectors, with events, or where building takes longer.

    Args:
        per_run_parameters: Every run has parameters of its own.
        seconds: What all runs would take one after the other.
    """
    function = model._function("rhs")
    batch = function.caller.batch
    if event_table.rows or not how.method.lanes or batch.recipe is None or widths.width() == 1:
        return 1
    if batch.ready(per_run_parameters) is None and seconds < batch.cost:
        return 1
    return build(model, function, per_run_parameters)


class LaneRunner:
    """A thread's records, one per lane."""

    def __init__(
        self,
        model: LoadedModel,
        how: Settings,
        input_signals: Signals,
        event_table: EventTable,
        over: Span,
        width: int,
    ) -> None:
        """Allocate.

        Args:
            model: A model that :func:`suits`.
            how: The method and its tolerances.
            input_signals: Inputs that are the same for all runs.
            event_table: Events of the model.
            over: Start and end; ``times`` are the output times.
            width: Lanes, as :func:`width_of` says.
        """
        self.model, self.how, self.over, self.width = model, how, over, width
        self.runners = [Runner(model, how, input_signals, False, event_table) for _ in range(width)]
        self.times = np.empty(0) if over.times is None else np.ascontiguousarray(over.times)
        stops = [*input_signals.corners(over.start, over.end), over.end]
        for runner in self.runners:
            runner.aim(stops)
            run = runner.record
            run.t, run.times, run.time_count = over.start, self.times.ctypes.data, len(self.times)
            run.capacity = len(self.times)
        # stages, trials and dense output are written before they are read
        start = self.runners[0].record.r - self.runners[0].memory.ctypes.data
        left = [runner.memory[start // UNITS :] for runner in self.runners]
        self._references: list[Any] = [memory.copy() for memory in left]
        size = ctypes.sizeof(Run)
        # a lane that finishes is reset to this copy and takes the next run
        fresh = [ctypes.create_string_buffer(bytes(r.record), size) for r in self.runners]
        self.lanes = (Lane * width)()
        for k, (lane, record, memory) in enumerate(
            zip(self.lanes, fresh, self._references, strict=True)
        ):
            lane.run, lane.memory = ctypes.addressof(self.runners[k].record), left[k].ctypes.data
            lane.fresh, lane.fresh_memory = ctypes.addressof(record), memory.ctypes.data
        self._references += fresh
        self.driver = Driver()
        self.driver.lanes, self.driver.lane_count = ctypes.addressof(self.lanes), width
        self.driver.memory_length = len(left[0])
        self.driver.timed = bool(input_signals.tabulated)
        self.drive = records.driver(model._kernels())

    def stop(self) -> None:
        """End soon, from any thread: runs under way are given up."""
        self.driver.stop = 1

    def run(self, part: Varied) -> Ends:
        """All runs of a block."""
        count, run = part.runs, self.runners[0].record
        x0 = part.states()
        r, p = part.block("r"), part.block("p") if part.varies_parameters else None
        x, answers = np.empty_like(x0), np.full(count, NOT_RUN, dtype=np.intp)
        width = 1 + run.n + run.nr + run.ns + run.nlam
        rows = np.full((count, len(self.times), width), np.nan)
        # memory that nobody writes to is never touched
        zeros = np.zeros(count * ctypes.sizeof(Run), np.uint8)
        ends = (Run * count).from_buffer(zeros.data)
        numbers = np.zeros((count, len(NUMBERS)))
        d = self.driver
        references = self._prepared_parameters(p)
        d.x0, d.r, d.count = x0.ctypes.data, r.ctypes.data, count
        d.rows = rows.ctypes.data if len(self.times) else None
        d.numbers = numbers.ctypes.data
        d.x, d.ends, d.answers = x.ctypes.data, ctypes.addressof(ends), answers.ctypes.data
        simd = self._simd_record(p is not None) if self.width > 1 else None
        d.simd = ctypes.addressof(simd[0]) if simd else None
        if self.runners[0].interpreted:
            with called_back(self.stop):
                self.drive(d)
        else:
            self.drive(d)
        del references, simd
        return self._ends(x, rows, answers, numbers, ends)

    def _prepared_parameters(self, p: Array | None) -> list[Any]:
        """Prepared parameters of every run for every function that is called."""
        d = self.driver
        d.pointers, d.pointer_count, d.w, d.w_size = None, 0, None, 0
        if p is None:
            return []
        pointers = [
            (name.removesuffix("_w"), getattr(Run, name).offset)
            for name in (field[0] for field in Run._fields_)
            if name.endswith("_w") and getattr(self.runners[0].record, name)
        ]
        pointer_table, references = (RunPointer * len(pointers))(), []
        for row, (name, offset) in zip(pointer_table, pointers, strict=True):
            w = np.ascontiguousarray(self.model._function(name).prepared(p))
            references.append(w)
            row.offset, row.base, row.stride = offset, w.ctypes.data, w.shape[1]
            if name == "rhs":
                d.w, d.w_size = w.ctypes.data, w.shape[1]
        d.pointers, d.pointer_count = ctypes.addressof(pointer_table), len(pointer_table)
        return [pointer_table, *references]

    def _simd_record(self, per_run_parameters: bool) -> tuple[Any, ...]:
        """The record of lanes, and what keeps its memory; ``pointer_table``: parameters per run."""
        function, width, run = self.model._function("rhs"), self.width, self.runners[0].record
        built = function.caller.batch.ready(per_run_parameters)
        assert built is not None
        library = records.trials(self.model._objects.reproducible, width)
        a = SimdSteps()
        method, n = records.method(library, self.how.method.kernel), run.n
        a.rhs, a.n, a.nq, a.nu, a.nr = built.address, n, run.nq, run.nu, run.nr
        a.trial_step, a.dense, a.worst = method.trial_step, method.dense, method.worst
        self.driver.attempt = abi.address(library, "cardan_simd_try")
        self.driver.move = abi.address(library, "cardan_simd_move")
        a.quaternions, a.quaternion_count = run.quaternions, run.quaternion_count
        a.rtol, a.atol, a.max_step = run.rtol, run.atol, run.max_step
        a.order = self.how.method.order
        # one allocation, interleaved: entry k of all lanes is contiguous, as vectors load it
        sizes = dict.fromkeys(PER_LANE, 1)
        sizes |= dict.fromkeys(("y", "trial", "next"), n)
        sizes |= {"k": run.stages * n, "interpolant": run.dense_rows * n, "r": run.nr, "s": run.ns}
        sizes |= {"zeros": len(self.runners[0].views["zeros"]), "work": function.work_size}
        sizes |= {"w": len(function.w) if per_run_parameters else 0}
        memory = records.aligned(width * sum(sizes.values()), width)
        start = 0
        for name, size in sizes.items():
            setattr(a, name, memory.ctypes.data + UNITS * width * start)
            start += size
        if not per_run_parameters:
            a.w = function.w.ctypes.data
        return a, memory, built, library

    def _ends(
        self, x: Array, rows: Array, answers: Integers, numbers: Array, ends: ctypes.Array[Run]
    ) -> Ends:
        """Answers in words and numbers."""
        begun = answers != NOT_RUN
        x[~begun] = numbers[~begun, 0] = np.nan
        status, messages = ["finished"] * len(x), {}
        for k in np.flatnonzero(answers != abi.DONE).tolist():
            status[k] = "not_run"
            if begun[k]:
                status[k], messages[k] = self._explain(ends[k], int(answers[k]))
        return Ends(x, rows, status, messages, numbers)

    def _explain(self, end: Run, answer: int) -> tuple[str, str]:
        """The status of a run and a sentence about it."""
        runner = self.runners[0]
        usual = bytes(runner.record)
        ctypes.memmove(ctypes.addressof(runner.record), bytes(end), len(usual))
        try:
            return explain(runner, answer, self.over)
        finally:
            ctypes.memmove(ctypes.addressof(runner.record), usual, len(usual))
