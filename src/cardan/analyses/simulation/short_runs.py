"""Runs over one and the same time from state after state: one call of the kernels for all of them.

Memory and record of such runs stay with the model for the next call; two threads never have the
same. A run that does not come to its end is left to the stepper, which says why.
"""

from __future__ import annotations

import ctypes
import math
import time
from typing import NamedTuple, final

import numpy as np

from ...arrays import Array
from ...runtime.calls import abi
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.models.named_rotations import check_units
from ...runtime.verification.rotations import unit
from ...schema.records import Run
from ...schema.short_run_records import ShortRuns as Record
from . import run_record
from .alpha_methods import Alpha, GeneralizedAlpha
from .discontinuities import FEW, stops_of
from .driving import case_of, chosen, runner_of
from .events import event_table_of
from .run import SLICE, Runner
from .settings import Start, settings, start
from .signals import signals
from .starts.start import closed_start

AHEAD = 1.0  # of a start that does not know how far the run goes [s]
FIRST = 16  # states before the time of one is known
AT_ONCE = 1 << 12  # steps of one call of the kernels: Ctrl-C is heard between two


class Options(NamedTuple):
    """Options of a step, as ``model.step`` takes them."""

    method: str | GeneralizedAlpha | Alpha
    rtol: float
    atol: float | None
    step: float | None
    max_step: float | None


@final
class ShortRuns:
    """Runs of a model without events, with inputs at their defaults.

    Args:
        runner: Nobody else has it.
    """

    def __init__(self, runner: Runner) -> None:
        self._runner, self.model = runner, runner.model
        model, record = runner.model, Record()
        runner.want(None, dense=False)
        runner.record.budget = AT_ONCE
        self._begun = Run.from_buffer_copy(runner.record)
        self._record, self._run = record, runner.library.cardan_short_runs_go
        # of one state, whose addresses are looked up once
        self._x, self._end, self._stop = np.zeros(model.nx), np.zeros(model.nx), np.zeros(1)
        self._inputs, self._modes = runner.signals.constants.copy(), model._layout.start("s")
        record.run, record.begun = ctypes.addressof(runner.record), ctypes.addressof(self._begun)
        record.length = runner.memory.size
        record.r, record.s = self._inputs.ctypes.data, self._modes.ctypes.data
        self._places = self._x.ctypes.data, self._end.ctypes.data, self._stop.ctypes.data
        manifest = model.manifest
        always = any(not row.switched for row in manifest.multipliers)
        self._closes = always or bool(model._layout.followers["q"])
        self._turns = bool(manifest.quaternions)

    def aim(self, t: float, end: float) -> None:
        """Say from when to when."""
        record, model = self._record, self.model
        record.t, record.far = t, t + AHEAD
        self._stops = self._stop
        self._stop[0] = end
        record.stops, record.stop_count = self._places[2], 1
        if self._begun.jumps:
            self._stops = np.array(stops_of(model, self._runner.signals, t, end, FEW))
            record.stops, record.stop_count = self._stops.ctypes.data, len(self._stops)

    def one(self, x: Array) -> Array | None:
        """The state (nx,) at the end from one at the start; None where it is not reached."""
        record = self._record
        self._x[:] = self._closed(x) if self._closes else x
        if self._turns and not self._closes:
            self._x[:] = self._normalized(x)
        record.x, record.ends, record.count = self._places[0], self._places[1], 1
        return self._end.copy() if self._answer() == run_record.DONE else None

    def many(self, x: Array, ends: Array, first: int) -> int:
        """Fill in states (count, nx) at the end from row ``first`` on.

        Returns:
            The first row that is not reached, or the number of rows.
        """
        count, width = len(x), x.strides[0]
        if self._closes:
            # loops are closed one after the other
            for k in range(first, count):
                end = self.one(x[k])
                if end is None:
                    return k
                ends[k] = end
            return count
        record, size, at = self._record, FIRST, first
        while at < count:
            # pieces of some milliseconds, between which Ctrl-C is heard
            record.x, record.ends = x.ctypes.data + at * width, ends.ctypes.data + at * width
            record.count = min(size, count - at)
            before = time.perf_counter()
            answer = self._answer()
            at += int(record.done)
            if answer != run_record.DONE:
                return at
            spent = max(time.perf_counter() - before, 1e-6)
            size = max(1, min(8 * size, round(size * SLICE / spent)))
        return count

    def _answer(self) -> int:
        """Last answer of the kernels for the states that the record names."""
        record, run, more = self._record, self._run, run_record.MORE
        # an interrupted call has left a run under way
        record.going = 0
        while (answer := int(run(record))) == more:
            pass
        return answer

    def _normalized(self, x: Array) -> Array:
        """States (..., nx) with quaternions of length 1.

        Raises:
            SolveError: the length of one is another.
        """
        model, nq = self.model, self.model.nq
        check_units(model.manifest, x[..., :nq])
        q = unit(x[..., :nq], model.manifest.quaternions)
        return np.concatenate([q, x[..., nq:]], axis=-1)

    def _closed(self, x: Array) -> Array:
        """The state (nx,) at which loops are closed, as runs start there."""
        model, inputs = self.model, self._inputs
        begin: Start = start(model, x, None, None)
        begin = closed_start(model, begin, x, x, float(self._record.t), inputs)
        _, self._runner.closing = self._runner.begun
        self._runner.loosen(begin.closure_tol)
        self._begun.size = self._runner.record.size
        return begin.x

    def states(self, x: Array) -> Array:
        """States (count, nx), contiguous, at which runs begin, but for loops."""
        x = np.ascontiguousarray(x.reshape(-1, x.shape[-1]))
        return np.ascontiguousarray(self._normalized(x)) if self._turns and not self._closes else x


def short_runs(model: LoadedModel, options: Options) -> ShortRuns | None:
    """Runs that an earlier call has left, or new ones; None where the model needs a stepper.

    Raises:
        ModelError: as the stepper does.
    """
    runs: ShortRuns | None = None
    try:
        # nobody else has them meanwhile
        runs = model._derived.pop((ShortRuns, options), None)
    except TypeError:
        return None
    if runs is not None or model.manifest.absolute or model.manifest.events or model.manifest.ticks:
        return runs
    how = settings(*options, None)
    event_table = event_table_of(model, None)
    input_signals = signals(model.manifest.inputs, None, None, (0.0, 0.0))
    if options.method == "auto":
        how = chosen(how, case_of(model, options.rtol, None, input_signals, event_table))
    runner = runner_of(model, how, input_signals, event_table)
    return None if runner.interpreted else ShortRuns(runner)


def put_back(model: LoadedModel, options: Options, runs: ShortRuns) -> None:
    """Leave runs to the next call."""
    model._derived[ShortRuns, options] = runs


def fit(model: LoadedModel, states: Array, t: float, dt: float) -> bool:
    """True if states (..., nx) and times are such that runs can begin."""
    return (
        states.ndim > 0
        and states.shape[-1] == model.nx
        and states.size > 0
        and math.isfinite(t)
        and math.isfinite(dt)
        and dt != 0
        and abi.first_bad(states) < 0
    )
