"""Rows that a run has written, and the motion made of them.

What lies between the steps of DOP853 takes three evaluations a step, a fifth of all, and many a
motion is never asked there. A run whose derivative depends on nothing that is over by then (no
functions as inputs or signals, no events, no loops to close) keeps the derivatives of its steps
instead: of them the kernels make, to the last bit, what the run would have made.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from ...arrays import Array
from ...errors import SolveError
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.trajectory.dense_output import Dense, LaterDense
from ...runtime.trajectory.event_log import EventLog
from ...runtime.trajectory.solver_info import NamedValues, SolverInfo
from ...runtime.trajectory.trajectory import TrajectoryRecord
from .events import NOTHING
from .method_choice import JACOBIAN, remark
from .run import Runner
from .settings import Settings, Start
from .signals import Signals
from .spare_runners import put_aside, spare
from .times import Span

CHUNK = 4096  # steps between two looks at signals
# of the record, for Trajectory.statistics
COUNTED = (
    *("steps", "rejections", "evaluations", "looked", "limited"),
    *("jacobians", "factorizations", "projections", "passed"),
)


class Recorder:
    """Rows that a run has written, copied out of its buffers."""

    def __init__(self, runner: Runner) -> None:
        self.runner = runner
        self.rows, self.spreads, self.logs = list[Array](), list[Array](), list[Array]()
        self._written = 0

    def take(self) -> None:
        """Copy what is new, and give the room back."""
        run = self.runner.record
        self.rows.append(self.runner.rows[: run.count].copy())
        self.spreads.append(self.runner.spreads[: run.count].copy())
        self.logs.append(self.runner.drained())
        run.count = 0

    def fresh(self) -> tuple[Array, Array, Array]:
        """Rows, dense output and log since the last call of this."""
        new = [parts[self._written :] for parts in (self.rows, self.spreads, self.logs)]
        self._written = len(self.rows)
        rows, spreads, logs = (np.concatenate(parts) for parts in new)
        return rows, spreads, logs

    def halt(self, over: Span) -> tuple[str, str]:
        """Give back most of the memory that rows have taken, which is full.

        Arrays are put together beside the rows they are made of: the first third of them may fit.

        Returns:
            Status and message.

        Raises:
            SolveError: there is no room for any of it.
        """
        third = len(self.rows) // 3
        for parts in (self.rows, self.spreads, self.logs):
            del parts[third:]
        self.runner.record.count = 0
        self.runner.drained()
        cure = "Ask for output times, such as simulate(np.linspace(0, 10, 1001)), to keep fewer"
        cure = cure if over.times is None else "Ask for fewer output times"
        if not any(map(len, self.rows)):
            raise SolveError(f"there is no memory for the rows of this run. {cure}")
        last = next(rows for rows in reversed(self.rows) if len(rows))
        at = f"at t = {last[-1, 0]:.6g} s of {over.end:g} s"
        return "too_large", f"stopped {at}: memory is full of what lies behind that. {cure}"

    def motion(
        self, over: Span, begin: Start, outcome: tuple[str, str], milliseconds: float
    ) -> TrajectoryRecord:
        """The motion so far.

        Args:
            over: What was asked for.
            begin: Where it began.
            outcome: Status and message.
            milliseconds: What it took.
        """
        self.logs.append(self.runner.drained())
        log = _joined(self.logs)
        table = _joined(self.rows) if self.rows else np.empty((0, 0))
        has_spreads = over.times is None and any(map(len, self.spreads))
        spreads = _joined(self.spreads) if has_spreads else None
        if not len(table):
            table, spreads = self._first_row(over, begin), None
        event_log = EventLog(np.empty((0, 0)), self.runner.event_table.rows, log)
        if spreads is not None and len(log):
            table, spreads = self._quiet(table, spreads, event_log.quiet)
        solver_info = self._solver_info(
            begin, table, outcome, event_log.counts | {"milliseconds": milliseconds}
        )
        return self._trajectory(table, spreads, solver_info, event_log)

    def _quiet(self, table: Array, spreads: Array, quiet: Array) -> tuple[Array, Array]:
        """One row where modes alone changed without an event: with the modes behind.

        Args:
            table: Rows t, y, r, s, multipliers.
            spreads: Dense output of the step that led to each row.
            quiet: When that was.
        """
        modes = 1 + self.runner.n + self.runner.model.nr
        same = (table[1:, :modes] == table[:-1, :modes]).all(axis=1) & np.isin(table[1:, 0], quiet)
        behind = 1 + np.flatnonzero(same & (self.runner.record.nlam == 0))
        if not len(behind):
            return table, spreads
        table[behind - 1, modes:] = table[behind, modes:]
        return np.delete(table, behind, axis=0), np.delete(spreads, behind, axis=0)

    def _first_row(self, over: Span, begin: Start) -> Array:
        """The start alone, for a run that broke down there."""
        runner = self.runner
        ledger = np.zeros(runner.n - len(begin.x))
        modes, none = runner.model._layout.start("s"), np.zeros(runner.record.nlam)
        parts = [np.array([over.start]), begin.x, ledger, runner.signals.constants, modes, none]
        return np.concatenate(parts)[None, :]

    def _solver_info(
        self, begin: Start, table: Array, outcome: tuple[str, str], more: Mapping[str, float]
    ) -> SolverInfo:
        runner, run, how = self.runner, self.runner.record, self.runner.settings
        counts: dict[str, Any] = {name: getattr(run, name) for name in COUNTED}
        model, first = runner.model, 1 + runner.n
        names = (model.coordinates, model.speeds, model.internals, model.inputs)
        inputs = table[0, first : first + len(model.inputs)]
        return SolverInfo(
            method=how.method.name,
            settings=how.description,
            initial=NamedValues(names, np.concatenate([begin.x, inputs])),
            defaulted=tuple(begin.defaulted) + tuple(runner.signals.defaulted),
            status=outcome[0],
            message=outcome[1],
            statistics={**counts, **more},
            reason=remark(how.method.name, run, JACOBIAN in model.manifest.available) or how.reason,
        )

    def _trajectory(
        self, table: Array, spreads: Array | None, solver_info: SolverInfo, event_log: EventLog
    ) -> TrajectoryRecord:
        runner, model = self.runner, self.runner.model
        n, end = runner.n, 1 + runner.n + model.nr
        t, y, r = table[:, 0].copy(), table[:, 1 : 1 + n], table[:, 1 + n : end].copy()
        s, lam = table[:, end : end + model.ns], table[:, end + model.ns :]
        dense = None
        if spreads is not None and len(t) > 1:
            dense = dense_of(runner, t, y, spreads[1:])
        return TrajectoryRecord(
            t=t,
            x=y[:, : model.nx].copy(),
            r=r,
            work_done=y[:, model.nx :].copy(),
            sources=runner.sources if runner.powered else None,
            manifest=model.manifest,
            solver_info=solver_info,
            model=model,
            dense=dense,
            inputs_at=runner.signals.recorded(t, r),
            ledger=runner.ledger,
            stored={"multipliers": lam.copy()} if runner.record.nlam else {},
            event_log=EventLog(s.copy(), event_log.rows, event_log.log),
        )


def _joined(parts: Sequence[Array]) -> Array:
    """Arrays one behind the other; one alone is not copied."""
    filled = [part for part in parts if len(part)]
    return np.concatenate(filled) if len(filled) > 1 else [*filled, *parts][0]


def can_wait(runner: Runner) -> bool:
    """True when the dense output of a run may be made behind its end."""
    inputs, run = runner.signals, runner.record
    changing = inputs.tabulated or inputs.functions or runner.event_table.rows or run.jumps
    closed = run.positions + run.rates > 0
    return bool(runner.method.sources) and not (
        changing or closed or run.mesh or runner.interpreted
    )


def dense_of(runner: Runner, t: Array, y: Array, spreads: Array) -> Dense:
    """The dense output of a run, or what makes it.

    Args:
        runner: That of the run.
        t: Ends of the steps (n + 1).
        y: Values there (n + 1, size).
        spreads: Of every step (n, rows, size), or what was kept of it.
    """
    settings, model = runner.settings, runner.model
    quaternions, charted = tuple(model.manifest.quaternions), settings.method.charted
    if not runner.record.later:
        return Dense(t, y, spreads, quaternions, charted)
    make = partial(_dense_rows, model, settings, runner.signals, runner.powered, t, y, spreads)
    return LaterDense(t, y, make, quaternions, charted)


def _dense_rows(
    model: LoadedModel,
    settings: Settings,
    inputs: Signals,
    powered: bool,
    t: Array,
    y: Array,
    sources: Array,
) -> Array:
    """The rows (n, rows, size) of all steps.

    Raises:
        SolveError: the model breaks down between the ends of a step.
    """
    runner = spare(model, settings, inputs, NOTHING)
    runner = runner or Runner(model, settings, inputs, powered, NOTHING)
    runner.want(None, dense=True, later=True)
    y = np.ascontiguousarray(y)
    rows = np.empty((len(sources), runner.method.dense_rows, runner.n))
    for first in range(0, len(sources), CHUNK):
        last = min(first + CHUNK, len(sources))
        ends, values, steps = t[first : last + 1], y[first : last + 1], sources[first:last]
        addresses = (x.ctypes.data for x in (ends, values, steps, rows[first:last]))
        status = runner.library.cardan_dense_later(runner.record, last - first, *addresses)
        if status != 0:
            raise SolveError(
                f"model '{model.name}' cannot be evaluated between the steps of its run: status "
                f"{runner.record.model_status}. Ask for output times, such as "
                "simulate(np.linspace(0, 10, 1001))"
            )
    put_aside(runner)
    return rows
