"""One run of a compiled integrator: its memory, its record, the loop that drives it."""

from __future__ import annotations

import ctypes
import math
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...arrays import Array
from ...errors import ModelError, SolveError
from ...processes import on_interrupt
from ...runtime.calls.interpreted import called_back
from ...runtime.models.constraint_projection import Closing, columns_of
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.models.named_rotations import bounded
from ...runtime.trajectory.closure_errors import Ledger
from ...schema.records import Run, Signal, Tick
from . import run_record as abi
from .discontinuities import FEW, jumps, stops_of
from .events import NOTHING, EventTable
from .input_functions import CEntry, InputFunctions
from .run_record import INPUTS, WATCH, Numbers
from .run_state import Saved, memory_of
from .settings import Settings
from .signals import Signals

SOME_STEPS = 1 << 20
SLICE = 0.01  # seconds between two looks at signals and progress
ROWS = 2048
MOST_PASSES = 256  # steps over singular positions that are noted
LOG, ROOM = 256, 32  # rows of the log of events, and more per event


class Runner:
    """A run from a state over segments of time.

    Everything the C works on lies in ``record`` and ``memory``: a copy of both is a checkpoint.
    """

    def __init__(
        self,
        model: LoadedModel,
        settings: Settings,
        input_signals: Signals,
        power: bool = True,
        event_table: EventTable = NOTHING,
    ) -> None:
        """Allocate.

        Args:
            model: Whose ``rhs`` and ``power`` are called.
            settings: How to step.
            input_signals: The inputs.
            power: Integrate the power of the sources too.
            event_table: What may happen.
        """
        self.model, self.settings = model, settings
        self.signals, self.event_table = input_signals, event_table
        self.library = abi.kernels(model._kernels())
        self.functions = [model._function(name) for name in ("rhs", "power")[: 1 + power]]
        self.powered = power
        self.closing = Closing.of(model)
        if model.manifest.absolute and settings.method.multipliers:
            self.closing = self.closing.unwatched()
        self.closers = [model._function(name) for name in self.closing.functions]
        self.needed = [
            model._function(name) for name in (*settings.method.needs, *event_table.functions)
        ]
        outputs = self.functions[-1].outputs if power else []
        self.sources: tuple[str, ...] = tuple(outputs[0].entries or ()) if outputs else ()
        self.n = model.nx + len(self.sources)
        self.error: BaseException | None = None
        self.in_c: InputFunctions | None = None
        # what the last gradient has made for it, see adjoint.py
        self.sweep: object = None
        self.called = [*self.functions, *self.closers, *self.needed]
        self.interpreted = any(function.interpreted for function in self.called)
        self._references: list[Any] = []
        self.passes = np.zeros((MOST_PASSES if self.closing.rates else 0, 3))
        self.method = abi.method(self.library, settings.method.kernel)
        self.dense_room = self.spreads = np.empty((0, self.method.dense_rows, self.n))
        self._modes, self._rows_at, self._spreads_at = model._layout.start("s"), 0, 0
        self.rows = np.empty((0, 0))
        self.record = Run()
        self._size()
        self._allocate()
        self._connect()
        self.begun = bytes(self.record), self.closing

    def _size(self) -> None:
        """Fill in how long everything is."""
        model, run = self.model, self.record
        for name in ("init", "step", "dense", "length", "stages", "dense_rows"):
            setattr(run, name, getattr(self.method, name))
        run.nq, run.nu, run.nx, run.n, run.nr = model.nq, model.nu, model.nx, self.n, model.nr
        run.nz, run.ns = model.nz, model.ns
        run.ne, run.watched = self.event_table.model, self.event_table.watched
        run.positions, run.rates = self.closing.positions, self.closing.rates
        run.size = self.closing.size
        run.nlam = model.nlam if self.settings.method.multipliers else 0
        run.charted = self.settings.method.charted and len(model.manifest.quaternions) > 0
        run.jumps = jumps(model)
        run.on_grid = not self.settings.method.adaptive
        names = (*self.closing.functions, *self.settings.method.needs, *self.event_table.functions)
        for name, function in zip(names, [*self.closers, *self.needed], strict=True):
            setattr(run, name, function.address)
            setattr(run, f"{name}_w", self._pointer(function.w))
        run.columns = self._pointer(columns_of(model, run.size))
        method = self.settings.method
        run.options = self._pointer(np.array([*method.options, method.adaptive], dtype=np.float64))
        if model.manifest.absolute:
            run.mesh = model._source.mesh(model)

    def loosen(self, tolerance: float) -> None:
        """Let residuals up to a slack, without units, count as none."""
        self.closing = self.closing.loosened(tolerance)
        self.record.size = self.closing.size

    def _allocate(self) -> None:
        """One block of numbers for everything but output rows."""
        run = self.record
        parts = sum(len(body.parts) for body in self.model.manifest.bodies)
        rooms = max(self.model.nu, 6 * parts), max(function.work_size for function in self.called)
        self.memory = memory_of(self.model, self.library.cardan_run_length(run, *rooms))
        first = self.memory.ctypes.data
        # the system gives pages of zeros when they are touched: a method need not touch all
        self.library.cardan_run_place(run, first, *rooms)
        run.times = None
        starts = [
            (getattr(run, name) - first) // self.memory.itemsize for name in abi.MEMORY_BLOCKS
        ]
        arrays = np.split(self.memory, starts[1:])
        self.views: dict[str, Array] = dict(zip(abi.MEMORY_BLOCKS, arrays, strict=True))

    def _connect(self) -> None:
        """Fill in functions and tolerances."""
        model, run = self.model, self.record
        run.rhs, run.rhs_w = self.functions[0].address, self._pointer(self.functions[0].w)
        if self.sources:
            run.power, run.power_w = self.functions[1].address, self._pointer(self.functions[1].w)
        quaternions = np.array(model.manifest.quaternions, dtype=np.intp)
        run.quaternions, run.quaternion_count = self._pointer(quaternions), len(quaternions)
        limited = np.array(bounded(model.manifest), dtype=np.intp)
        run.bounded, run.bounded_count = self._pointer(limited), len(limited)
        run.culprit = -1
        run.passes, run.pass_capacity = self._pointer(self.passes), len(self.passes)
        self.adjust()
        self._connect_signals()
        self._connect_events()

    def adjust(self) -> None:
        """Fill in what may differ from run to run."""
        run, settings = self.record, self.settings
        run.rtol, run.atol = settings.rtol, settings.atol
        run.max_step, run.h = settings.max_step, settings.step
        self.views["r"][:] = self.signals.constants
        self.views["s"][:] = self._modes

    def _connect_signals(self) -> None:
        run, tabulated = self.record, self.signals.tabulated
        table = (Signal * max(1, len(tabulated)))()
        self.tabulated = [table[k] for k in range(len(tabulated))]
        for row, signal in zip(table, tabulated, strict=False):
            row.input, row.pieces, row.where = signal.input, len(signal.coefficients), 0
            row.breaks = self._pointer(np.ascontiguousarray(signal.breaks))
            row.coefficients = self._pointer(np.ascontiguousarray(signal.coefficients))
        self._references.append(table)
        run.signals, run.signal_count = ctypes.addressof(table), len(tabulated)
        if self.signals.functions:
            self._connect_functions()

    def _connect_functions(self) -> None:
        """Inputs that functions compute: those in Python are asked before those in C."""
        run, functions = self.record, self.signals.functions
        self.in_python = {k: f for k, f in functions.items() if not isinstance(f, CEntry)}
        call = INPUTS(self._ask)
        self._references.append(call)
        python = ctypes.cast(call, ctypes.c_void_p).value if self.in_python else None
        run.inputs, run.sampled = python, self.signals.sample is not None
        if len(self.in_python) < len(functions):
            self.in_c = InputFunctions(self.model, functions, ctypes.addressof(run), python)
            run.inputs = abi.address(self.library, "cardan_input_functions_at")
            run.input_context = self.in_c.address

    def _connect_events(self) -> None:
        run, ticks = self.record, self.event_table.ticks
        run.kinds = self._pointer(np.array(self.event_table.kinds, dtype=np.intp))
        self.ticks = (Tick * max(1, len(ticks)))()
        for row, tick in zip(self.ticks, ticks, strict=False):
            row.event, row.period, row.phase = tick.event, tick.period, tick.phase
        run.ticks, run.tick_count = ctypes.addressof(self.ticks), len(ticks)
        width = 1 + len(self.event_table.rows) + 2 * (self.model.nx + self.model.ns)
        run.log_capacity = LOG + ROOM * len(self.event_table.rows) if self.event_table.rows else 0
        self.log = np.empty((run.log_capacity, width))
        run.log = self.log.ctypes.data
        if self.event_table.watches:
            call = WATCH(self._look)
            self._references.append(call)
            run.watch = ctypes.cast(call, ctypes.c_void_p).value

    def _pointer(self, array: NDArray[Any]) -> int:
        """Address of an array that must live as long as this."""
        self._references.append(array)
        return array.ctypes.data

    def _ask(self, context: object, t: float, x: Numbers, r: Numbers) -> int:
        """Evaluate the input functions; called from C."""
        try:
            state = np.ctypeslib.as_array(x, (self.model.nx,)).copy()
            for k, function in self.in_python.items():
                r[k] = float(function(t, state))
        except BaseException as error:
            # it must not cross the C frames: the drive raises it again
            self.error = error
            return 1
        return 0

    def _look(self, t: float, x: Numbers, values: Numbers) -> int:
        """Evaluate what the caller watches; called from C."""
        try:
            state = np.ctypeslib.as_array(x, (self.model.nx,)).copy()
            for k, value in enumerate(self.event_table.watch(t, state)):
                values[k] = value
        except BaseException as error:
            self.error = error
            return 1
        return 0

    @property
    def ledger(self) -> Ledger | None:
        """Closure errors of the loops; None without constraints."""
        return self.closing.ledger(self.views["ledger"])

    def start(self, t: float, x: Array, stops: Sequence[float]) -> int:
        """Set the state and evaluate there. Returns the answer of the kernels."""
        self.record.t = t
        self.views["y"][: self.model.nx] = x
        self.aim(stops)
        return self._answer(self.library.cardan_run_start)

    def aim(self, stops: Sequence[float]) -> None:
        """Set the times at which steps must end; the last one is the end."""
        self.stops = np.array(stops, dtype=np.float64)
        self.event_table.distinguish_ticks(max(map(abs, (self.record.t, *stops))))
        self.record.stops = self.stops.ctypes.data
        self.record.stop_count, self.record.next_stop = len(self.stops), 0

    def want(self, times: Array | None, dense: bool, most: int = ROWS, later: bool = False) -> None:
        """Say which rows to write: at ``times``, or at every step.

        Args:
            times: Output times, in the direction of the run.
            dense, later: Keep the dense output of every step, or what it is made of.
            most: Rows of steps until somebody takes them.

        Raises:
            SolveError: there is no memory for the rows.
        """
        run = self.record
        run.capacity = most if times is None else len(times)
        width = 1 + self.n + self.model.nr + self.model.ns + run.nlam
        try:
            if self.rows.shape != (run.capacity, width):
                self.rows = np.empty((run.capacity, width))
                self._rows_at = self.rows.ctypes.data
        except MemoryError:
            raise SolveError(
                f"there is no memory for {run.capacity} rows of {width} numbers. Give fewer "
                "output times"
            ) from None
        run.rows = self._rows_at
        if times is not None:
            self._times = np.ascontiguousarray(times)
            run.times, run.time_count = self._times.ctypes.data, len(times)
        rows = self.method.source_rows + 1 if later else self.method.dense_rows
        run.later = ctypes.addressof(self.method) if later else None
        if dense and (len(self.dense_room) < most or self.dense_room.shape[1] != rows):
            self.dense_room = np.empty((most, rows, self.n))
            self._spreads_at = self.dense_room.ctypes.data
        self.spreads = self.dense_room[: most if dense else 0]
        run.spreads = self._spreads_at if dense else None

    def drive(self, budget: int) -> int:
        """Go on for at most ``budget`` steps. Returns the answer of the kernels."""
        self.record.budget = budget
        return self._answer(self.library.cardan_run_drive)

    def _answer(self, kernel: Callable[[Run], int]) -> int:
        """Status that a kernel returned.

        Raises:
            BaseException: what a function of the caller or of the model raised on the way.
        """
        if not self.interpreted:
            answer = int(kernel(self.record))
        else:
            try:
                with called_back(self._halt):
                    answer = int(kernel(self.record))
            except BaseException as error:
                self.error, answer = error, abi.STOPPED
                self.record.stop = 0
        self.check()
        return answer

    def _halt(self) -> None:
        """End the run after the present step."""
        self.record.stop = 1

    def advance(self, end: float) -> int:
        """Go on to a time, in any direction. Returns the answer of the kernels."""
        run = self.record
        run.h = math.copysign(run.h, end - run.t)
        self.aim(stops_of(self.model, self.signals, run.t, end, FEW))
        run.t_start = run.t
        # inputs may have jumped: the derivative at the start is new
        answer = self._answer(self.library.cardan_segment) or abi.MORE
        logs = []
        while answer in (abi.MORE, abi.FULL):
            run.count = 0
            answer = self.drive(SOME_STEPS)
            logs.append(self.drained())
        self.event_rows = np.concatenate(logs) if logs else self.log[:0]
        self.check()
        self.check_interrupt()
        return answer

    def drained(self) -> Array:
        """Event rows since the last call, as in ``EventLog.log``."""
        taken = self.log[: self.record.log_count].copy()
        self.record.log_count = 0
        return taken

    def save(self) -> Saved:
        """A checkpoint."""
        segments = tuple(row.where for row in self.tabulated)
        return Saved(
            bytes(self.record), self.memory.tobytes(), id(self), bytes(self.ticks), "", segments
        )

    def restore(self, saved: Saved) -> None:
        """Go back to a checkpoint of this run, from where it goes to another time.

        Raises:
            ModelError: it belongs to another one.
        """
        stops = self.record.stops
        self.resume(saved)
        # the stops were those of a step that is over
        run = self.record
        run.stops, run.stop_count, run.next_stop = stops, 1, 0

    def resume(self, saved: Saved) -> None:
        """Go back to a checkpoint in the middle of this run, from where it takes the same steps.

        Raises:
            ModelError: it belongs to another one.
        """
        run, memory = self.record, self.memory
        if saved.owner != id(self) or len(saved.memory) != memory.nbytes:
            raise ModelError("this checkpoint was made by another stepper")
        ctypes.memmove(ctypes.addressof(run), saved.record, ctypes.sizeof(run))
        memory[:] = np.frombuffer(saved.memory)
        ctypes.memmove(self.ticks, saved.ticks, ctypes.sizeof(self.ticks))
        for row, segment in zip(self.tabulated, saved.segments, strict=False):
            row.where = segment

    def check(self) -> None:
        """Raise what an input function raised."""
        if self.error is not None and not isinstance(self.error, KeyboardInterrupt):
            error, self.error = self.error, None
            raise error

    def check_interrupt(self) -> None:
        """Raise KeyboardInterrupt if Ctrl-C ended the last call of a kernel."""
        if isinstance(self.error, KeyboardInterrupt):
            error, self.error = self.error, None
            raise error

    def slices(self) -> Iterator[int]:
        """Drive to the end in slices of about 10 ms; yields the answer of each."""
        budget, answer = 64, abi.MORE
        while answer in (abi.MORE, abi.FULL):
            before = time.perf_counter()
            answer = self.drive(budget)
            spent = max(time.perf_counter() - before, 1e-6)
            if answer == abi.MORE:
                budget = max(1, min(8 * budget, round(budget * SLICE / spent)))
            yield answer

    def interruptible(self) -> AbstractContextManager[bool]:
        """Let Ctrl-C stop the run between two steps instead of raising."""
        return on_interrupt(self._halt)
