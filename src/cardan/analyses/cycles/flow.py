"""Runs of a model at fixed tolerances, one after the other from states that differ a little."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import final

import numpy as np

from ...arrays import Array
from ...errors import SolveError
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.trajectory.trajectory import TrajectoryRecord
from ..simulation import run_record as abi
from ..simulation.discontinuities import stops_of
from ..simulation.events import EventTable
from ..simulation.outcome import explain
from ..simulation.run import Runner
from ..simulation.settings import Settings, Start
from ..simulation.signals import Signals, signals
from ..simulation.simulate import driven, runner_of
from ..simulation.times import Span

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


@final
class Flow:
    """Runs of a model with its parameters and inputs.

    Attributes:
        model: The model, with its parameters.
        event_table: What may happen.
    """

    def __init__(
        self,
        model: LoadedModel,
        how: Settings,
        inputs: Mapping[str, object] | None,
        event_table: EventTable,
    ) -> None:
        """Args:
        model: The model, with its parameters.
        how: How to step.
        inputs: Constants or functions by name.
        event_table: What may happen; terminal events end nothing here.
        """
        self.model, self.event_table = model, _going_on(event_table)
        self._inputs: Signals = signals(model.manifest.inputs, inputs, None, (0.0, 0.0))
        self._runner: Runner = runner_of(model, how, self._inputs, self.event_table)
        self._runner.want(None, dense=False)
        self._begun = bytes(self._runner.record)

    def end(self, x: Array, s: Array, t: float, end: float) -> tuple[Array, Array]:
        """State (nx,) and modes (ns,) at the end of a run.

        Raises:
            SolveError: the run breaks down.
        """
        self._run(x, s, t, end, lambda _: False)
        return self._state(), self._runner.views["s"].copy()

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

    def motion(self, x: Array, s: Array, t: float, end: float) -> TrajectoryRecord:
        """The run as a motion."""
        how = self._runner.settings
        runner = runner_of(self.model, how, self._inputs, self.event_table)
        runner.views["s"][:] = s
        return driven(runner, Span(t, end), Start(x, ()), False)

    def inputs(self, t: float) -> Array:
        """Inputs (nr,) at a time, functions left out."""
        return self._inputs.first(t)

    def _state(self) -> Array:
        return self._runner.views["y"][: self.model.nx].copy()

    def _run(self, x: Array, s: Array, t: float, end: float, stop: Callable[[Array], bool]) -> None:
        """Go from a state to a time, or until the log of events says that it is enough."""
        runner, run = self._runner, self._runner.record
        ctypes.memmove(ctypes.addressof(run), self._begun, len(self._begun))
        runner.memory.fill(0.0)
        runner.adjust()
        runner.views["s"][:] = s
        answer = runner.start(t, x, stops_of(self.model, self._inputs, t, end)) or abi.MORE
        while answer in (abi.MORE, abi.FULL):
            run.count = 0
            answer = runner.drive(STEPS)
            runner.check()
            runner.check_interrupt()
            if stop(runner.drained()):
                return
        if answer != abi.DONE:
            raise SolveError(explain(runner, answer, Span(t, end))[1])

    def _passage(self, row: Array) -> Passage:
        """A row of the log of events."""
        nx, first = self.model.nx, 1 + len(self.event_table.rows)
        x, s, x_after, s_after = np.split(row[first:], np.cumsum([nx, self.model.ns, nx]).tolist())
        return Passage(float(row[0]), row[1:first] != 0, x, s, x_after, s_after)


def _going_on(event_table: EventTable) -> EventTable:
    """The table with terminal events that are noted alone."""
    kinds = tuple(abi.MARK if kind == abi.HALT else kind for kind in event_table.kinds)
    return replace(event_table, kinds=kinds)
