"""Runs of a model at fixed tolerances, one after the other from states that differ a little."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Mapping
from copy import copy
from dataclasses import replace
from typing import final

import numpy as np

from ...arrays import Array
from ...errors import SolveError
from ...records import dataclass
from ...runtime.calls.loaded_function import LoadedFunction
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.trajectory.trajectory import TrajectoryRecord
from ...schema.blocks import ORDER, SLOT
from ..simulation import run_record as abi
from ..simulation.discontinuities import jumps, stops_of
from ..simulation.driving import driven, runner_of
from ..simulation.events import EventTable
from ..simulation.outcome import explain
from ..simulation.run import Runner
from ..simulation.settings import Settings, Start
from ..simulation.signals import Signals, signals
from ..simulation.times import Span

FEW = 6  # calls with parameters of their own, behind which a model is bound to them
STEPS = 16  # of a run, behind which its events are looked at


@dataclass(frozen=True, eq=False)
class Passage:
    """An event on a run.

    Attributes:
        t: When [s].
        fired: Mask of the events (ne,).
        x, s: State (nx,) and modes (ns,) before it.
        x_after, s_after: Behind it.
    """

    t: float
    fired: Array
    x: Array
    s: Array
    x_after: Array
    s_after: Array


@dataclass(frozen=True, eq=False)
class Course:
    """The steps of a run.

    Attributes:
        rows: t, y, inputs and modes at their ends (count, width), before and behind events.
        log: Rows of the log of events.
        passage: What ended it; None where time did.
        t, x, s: Time [s], state (nx,) and modes (ns,) at its end, behind that.
    """

    rows: Array
    log: Array
    passage: Passage | None
    t: float
    x: Array
    s: Array


@final
class Flow:
    """Runs of a model with its parameters and inputs.

    Attributes:
        event_table: What may happen.
    """

    def __init__(
        self,
        model: LoadedModel,
        how: Settings,
        inputs: Mapping[str, object],
        event_table: EventTable,
    ) -> None:
        """Args:
        model: The model, with its parameters.
        how: How to step.
        inputs: Constants or functions by name.
        event_table: What may happen; terminal events end nothing here.
        """
        self._base, self._how, self.event_table = model, how, _going_on(event_table)
        self._parameters: dict[str, float] | None = None
        self._ends = model.nq, model.nq + model.nu, model.nx
        self._named_inputs = dict(inputs)
        self._inputs: Signals = signals(model.manifest.inputs, inputs, None, (0.0, 0.0))
        self._runner: Runner = runner_of(model, how, self._inputs, self.event_table)
        self._runner.want(None, dense=False)
        self._begun = bytes(self._runner.record)
        self._functions = _called(self._runner)
        self._prepared: dict[str, Array] = {}
        self._calls = 0
        self._bound: LoadedModel | None = model

    def changed(self, values: Mapping[str, float]) -> Flow:
        """The same with other parameters and inputs; what runs is shared."""
        inputs = {
            **self._named_inputs,
            **{n: v for n, v in values.items() if n in self._base.inputs},
        }
        parameters = {n: v for n, v in values.items() if n not in self._base.inputs}
        if self._base.manifest.absolute:
            # tables of elements are those of one set of parameters
            model = self._base.with_parameters(parameters)
            return Flow(model, self._how, inputs, self.event_table)
        other = copy(self)
        other._parameters = parameters or None
        other._calls, other._bound = 0, None if parameters else self._base
        other._inputs = signals(self._base.manifest.inputs, inputs, None, (0.0, 0.0))
        p = self._base._parameters.changed(parameters)
        other._prepared = {name: one.prepared(p) for name, one in self._functions.items()}
        return other

    @property
    def model(self) -> LoadedModel:
        """The model, with its parameters."""
        if self._bound is None:
            self._bound = self._base.with_parameters(self._parameters or {})
        return self._bound

    def _called(self) -> tuple[LoadedModel, dict[str, float] | None]:
        """What answers a call, and its parameters: the first calls of a model take long."""
        self._calls += 1
        if self._calls > FEW or self._bound is not None:
            return self.model, None
        return self._base, self._parameters

    def event_values(self, x: Array, s: Array, t: float) -> Array:
        """Numbers (ne,) of the events of the model, which pass 0."""
        q, u, z = self.parts_of(x)
        function = self._functions.get("events")
        if function is None:
            model, more = self._called()
            return np.asarray(model.events(q, u, z=z, s=s, t=t, r=self.inputs(t), parameters=more))
        # the function itself, with the parameters that runs have prepared
        blocks: list[Array | None] = [None] * len(ORDER)
        w = self._prepared.get("events", function.w)
        values = {"t": np.array([t]), "q": q, "u": u, "z": z, "s": s, "r": self.inputs(t), "w": w}
        for name, block in values.items():
            blocks[SLOT[name]] = np.ascontiguousarray(block)
        numbers = np.empty((1, function.caller.size))
        status, _ = function.caller.call(blocks, [0] * len(ORDER), numbers)
        if status:
            raise SolveError(f"cycle: events cannot be evaluated at t = {t:.6g} s")
        return np.asarray(numbers[0])

    def parts_of(self, x: Array) -> tuple[Array, Array, Array]:
        """q, u and z of a state."""
        nq, end, _ = self._ends
        return x[:nq], x[nq:end], x[end:]

    def rates(self, x: Array, s: Array, t: float) -> Array:
        """xdot (nx,), or those of several states (k, nx)."""
        model, more = self._called()
        return np.asarray(model.rhs(t, x, self.inputs(t), s=s, parameters=more))

    def mass_matrix(self, q: Array, t: float) -> Array:
        """Mass matrix (nu, nu), or those of several positions (k, nu, nu)."""
        model, more = self._called()
        return np.asarray(model.mass_matrix(q, r=self.inputs(t), t=t, parameters=more))

    def end(self, x: Array, s: Array, t: float, end: float) -> tuple[Array, Array]:
        """State (nx,) and modes (ns,) at the end of a run.

        Raises:
            SolveError: the run breaks down.
        """
        self._run(x, s, t, end, lambda _: False)
        return self._state(), self._runner.views["s"].copy()

    def closed(self, x: Array, s: Array, t: float) -> Array:
        """The state (nx,) on the constraints from which a run from a state goes.

        Raises:
            SolveError: the constraints cannot be fulfilled next to it.
        """
        if not self._runner.closing.rows:
            return x
        answer = self._begin(x, s, t, t + 1.0)
        if answer not in (abi.DONE, abi.MORE):
            raise SolveError(explain(self._runner, answer, Span(t, t + 1.0))[1])
        return self._state()

    def passage(
        self, x: Array, s: Array, t: float, end: float, match: Callable[[Passage], bool]
    ) -> Passage | None:
        """The first event on a run that matches; None if there is none.

        Raises:
            SolveError: the run breaks down.
        """
        matches = list[Passage]()

        def stop(log: Array) -> bool:
            matches.extend(one for one in map(self._passage, log) if match(one))
            return bool(matches)

        self._run(x, s, t, end, stop)
        return matches[0] if matches else None

    def course(
        self, x: Array, s: Array, t: float, end: float, match: Callable[[Passage], bool] | None
    ) -> Course | None:
        """The steps of a run to a time, or to the first event that matches; None if none does.

        Raises:
            SolveError: the run breaks down.
        """
        rows, log, matches = list[Array](), list[Array](), list[Passage]()

        def stop(entries: Array) -> bool:
            for row in entries:
                log.append(row)
                passage = self._passage(row)
                if match is not None and match(passage):
                    matches.append(passage)
                    return True
            return False

        self._run(x, s, t, end, stop, rows)
        if match is not None and not matches:
            return None
        table, entries = np.concatenate(rows), np.array(log) if log else self._runner.log[:0]
        if not matches:
            modes = self._runner.views["s"].copy()
            return Course(table, entries, None, end, self._state(), modes)
        (last,) = matches
        # those beyond the event belong to no lap
        table = table[table[:, 0] <= last.t]
        return Course(table, entries, last, last.t, last.x_after, last.s_after)

    @property
    def runner(self) -> Runner:
        """What ran, as the last run left it: those with other parameters share it."""
        return self._runner

    def motion(self, x: Array, s: Array, t: float, end: float) -> TrajectoryRecord:
        """The run as a motion."""
        runner = runner_of(self.model, self._how, self._inputs, self.event_table)
        runner.views["s"][:] = s
        return driven(runner, Span(t, end), Start(x, ()), False)

    def inputs(self, t: float) -> Array:
        """Inputs (nr,) at a time, functions left out."""
        return self._inputs.first(t)

    def _state(self) -> Array:
        return self._runner.views["y"][: self._ends[-1]].copy()

    def _begin(self, x: Array, s: Array, t: float, end: float) -> int:
        """Set the state at the start of a run. Returns the answer of the kernels."""
        runner, run = self._runner, self._runner.record
        ctypes.memmove(ctypes.addressof(run), self._begun, len(self._begun))
        for name, w in self._prepared.items():
            setattr(run, f"{name}_w", w.ctypes.data)
        runner.memory.fill(0.0)
        runner.signals = self._inputs
        runner.adjust()
        runner.views["s"][:] = s
        jumping = self.model if jumps(self._base) else self._base
        return runner.start(t, x, stops_of(jumping, self._inputs, t, end)) or abi.MORE

    def _run(
        self,
        x: Array,
        s: Array,
        t: float,
        end: float,
        stop: Callable[[Array], bool],
        rows: list[Array] | None = None,
    ) -> None:
        """Go from a state to a time, or until the log of events says that it is enough.

        Args:
            x, s, t, end: From which state and time to when.
            stop: Whether new rows of the log end it.
            rows: Takes the rows of its steps; None where nobody wants them.
        """
        runner, run = self._runner, self._runner.record
        answer, enough = self._begin(x, s, t, end), False
        while answer in (abi.MORE, abi.FULL):
            if rows is not None:
                rows.append(runner.rows[: run.count].copy())
            run.count = 0
            answer = runner.drive(STEPS)
            runner.check()
            runner.check_interrupt()
            enough = stop(runner.drained())
            if enough:
                break
        if rows is not None:
            rows.append(runner.rows[: run.count].copy())
        if not enough and answer != abi.DONE:
            raise SolveError(explain(runner, answer, Span(t, end))[1])

    def _passage(self, row: Array) -> Passage:
        """A row of the log of events."""
        first, width = 1 + len(self.event_table.rows), self._ends[-1]
        before, after = first + width, first + width + self._base.ns
        x, s, x_after = row[first:before], row[before:after], row[after : after + width]
        return Passage(float(row[0]), row[1:first] != 0, x, s, x_after, row[after + width :])


def _called(runner: Runner) -> dict[str, LoadedFunction]:
    """Functions of the model that a run calls, by their names in its record."""
    names = (
        *runner.closing.functions, *runner.settings.method.needs, *runner.event_table.functions
    )  # fmt: skip
    functions = dict(zip(("rhs", "power"), runner.functions, strict=False))
    return functions | dict(zip(names, [*runner.closers, *runner.needed], strict=True))


def _going_on(event_table: EventTable) -> EventTable:
    """The table with terminal events that are noted alone."""
    kinds = tuple(abi.MARK if kind == abi.HALT else kind for kind in event_table.kinds)
    return replace(event_table, kinds=kinds)
