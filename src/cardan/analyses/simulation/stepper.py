"""Motion step by step, under the caller's control."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import final

import numpy as np
from numpy.typing import ArrayLike

from ...arguments import checked
from ...arrays import Array
from ...errors import FunctionError, ModelError, SolveError, brief, near
from ...runtime.calls.argument_values import numbers
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.trajectory.event_log import Event, EventLog
from . import run_record as abi
from .alpha_methods import Alpha, GeneralizedAlpha
from .driving import case_of, chosen, runner_of
from .events import check_start, event_table_of
from .outcome import explain
from .run import Runner
from .run_state import Saved
from .settings import Settings, Values, blocks, settings, start
from .short_runs import Options, ShortRuns, fit, put_back, short_runs
from .signals import signals
from .starts.start import closed_start
from .times import Span


@final
class Stepper:
    """A run that goes on by as much as the caller says, such as beside hardware or a controller.

    Made by ``model.stepper(...)``::

        stepper = model.stepper(q={"elbow": 0.3}, rtol=1e-9)
        while stepper.t < 1.0:
            stepper.step(0.01, inputs={"torque": control(stepper.state)})
    """

    def __init__(self, runner: Runner, how: Settings, over: str = "") -> None:
        self._runner, self._model, self._how = runner, runner.model, how
        self._names = [str(row.name) for row in runner.model.manifest.inputs]
        self._log = runner.drained()
        self._over = over
        # steps of one length count from the first of them: sums would drift from the grid
        self._grid = self.t, 0.0, 0

    def _start(self, begin: Array, t: float) -> None:
        runner = self._runner
        answer = runner.start(t, begin, [t + 1.0])
        if answer < 0:
            raise SolveError(explain(runner, answer, Span(t, t + 1.0))[1])

    @property
    def t(self) -> float:
        """Time [s]."""
        return float(self._runner.record.t)

    @property
    def state(self) -> Array:
        """State [q, u, z] (nx,), a copy."""
        return self._runner.views["y"][: self._model.nx].copy()

    @property
    def modes(self) -> dict[str, float]:
        """Discrete states of elements, by name."""
        return dict(zip(self._model.mode_names, self._runner.views["s"].tolist(), strict=True))

    @property
    def events(self) -> tuple[Event, ...]:
        """Events of the last step, without samples."""
        return EventLog(rows=self._runner.event_table.rows, log=self._log).events(self._model.nx)

    @property
    def ticks(self) -> tuple[Event, ...]:
        """Samples of controllers in the last step."""
        event_log = EventLog(rows=self._runner.event_table.rows, log=self._log)
        return event_log.events(self._model.nx, ticks=True)

    @property
    def inputs(self) -> dict[str, float]:
        """Inputs in force, by name."""
        return dict(zip(self._names, self._runner.views["r"].tolist(), strict=True))

    @property
    def work(self) -> dict[str, float]:
        """Energy that every source has given since the start [J]."""
        work_done = self._runner.views["y"][self._model.nx :].tolist()
        return dict(zip(self._runner.sources, work_done, strict=True))

    def __repr__(self) -> str:
        run = self._runner.record
        method = self._runner.settings.method.name
        return f"Stepper('{self._model.name}', {method}, t = {run.t:g} s, {run.steps} steps)"

    @checked
    def step(self, dt: float, inputs: Mapping[str, float] | None = None) -> Array:
        """Go on by ``dt`` and say where that leads.

        Args:
            dt: Time to pass [s]; an adaptive method takes as many steps as it needs. Every step
                goes in the same direction, backward for negative numbers. Events change what
                they change on the way; one that ends the run ends the step, see :attr:`t`.
            inputs: New values of inputs; they hold until they are changed again.

        Returns:
            State [q, u, z] (nx,), a copy.

        Raises:
            ModelError: an unknown input, no time, or backward over events that change something.
            SolveError: the motion broke down; the stepper is where it still was good. Or an event
                has ended it. FunctionError: a function of ``events=`` raised; the stepper is where
                it was before the step.
        """
        if not (math.isfinite(dt) and dt != 0):
            raise ModelError(f"dt={dt:g}: a step takes some time [s]")
        if self._over:
            raise SolveError(f"{self._over}; restore an earlier state, or start anew")
        self._set(inputs or {})
        start, end = self.t, self._end(dt)
        self._runner.event_table.forward(start, end)
        # what the caller watches may raise behind a step: go back to before it
        before = self._runner.save() if self._runner.event_table.watches else None
        try:
            answer = self._runner.advance(end)
        except FunctionError:
            if before is not None:
                self._runner.restore(before)
            raise
        self._log = self._runner.event_rows
        run = self._runner.record
        if answer == abi.EVENT:
            self._over = explain(self._runner, answer, Span(start, end))[1]
        elif answer != abi.DONE or run.t != end:
            raise SolveError(explain(self._runner, answer, Span(run.t_start, end))[1])
        return self.state

    def _end(self, dt: float) -> float:
        """The end of a step from here: on the grid of those before it, if it is as long."""
        begin, step, count = self._grid
        if step != dt or begin + count * step != self.t:
            begin, count = self.t, 0
        self._grid = begin, dt, count + 1
        return begin + (count + 1) * dt

    def _set(self, inputs: Mapping[str, float]) -> None:
        for name, value in inputs.items():
            if name not in self._names:
                raise ModelError(f"inputs: there is no input '{name}'.{near(name, self._names)}")
            if not math.isfinite(value):
                raise SolveError(f"inputs: '{name}' is {value}. Every input must be finite")
            self._runner.views["r"][self._names.index(name)] = value

    @checked
    def save(self, path: str | Path | None = None) -> Saved:
        """A checkpoint; :meth:`restore` goes back to it bit for bit.

        Args:
            path: A file to write it to as well: ``model.resume(path)`` goes on from there, in
                another process on a machine of the same kind too.

        Raises:
            ModelError: no such directory, or a method with choices of its own.
        """
        saved = replace(self._runner.save(), over=self._over)
        # here as there the steps to come count from this time
        self._grid = self.t, 0.0, 0
        if path is not None:
            from .files.checkpoint import write

            write(self._runner, self._how, saved, Path(path))
        return saved

    @checked
    def restore(self, saved: Saved) -> None:
        """Go back to a checkpoint of this stepper.

        Raises:
            ModelError: it belongs to another one.
        """
        self._runner.restore(saved)
        self._log, self._over = self._log[:0], saved.over
        self._grid = self.t, 0.0, 0


@checked
def stepper(
    model: LoadedModel,
    *,
    t: float = 0.0,
    x0: ArrayLike | None = None,
    q: Values | ArrayLike | None = None,
    u: Values | ArrayLike | None = None,
    z: Values | ArrayLike | None = None,
    events: Mapping[str, object] | None = None,
    method: str | GeneralizedAlpha | Alpha = "auto",
    rtol: float = 1e-6,
    atol: float | None = None,
    step: float | None = None,
    max_step: float | None = None,
    inputs: Mapping[str, object] | None = None,
) -> Stepper:
    """A stepper at a start.

    Args:
        model: The compiled model.
        t: Time at the start [s].
        x0, q, u, z, events, method, rtol, atol, max_step: As for ``simulate``.
        step: Step of RK4; first step of DOP853 [s].
        inputs: Constants by name; later values go to :meth:`Stepper.step`.

    Raises:
        ModelError, ArgumentError, SolveError: as for ``simulate``.
    """
    how: Settings = settings(method, rtol, atol, step, max_step, None)
    for name, value in (inputs or {}).items():
        if callable(value) or isinstance(value, tuple | list):
            raise ModelError(
                f"inputs: '{name}': a stepper takes numbers; new ones go to step(dt, inputs=...)"
            )
    input_signals = signals(model.manifest.inputs, inputs, None, (t, t))
    begin = start(model, x0, q, u, z)
    begin = closed_start(model, begin, *blocks(x0, q, u), t, input_signals.constants)
    check_start(model, begin.x, t, input_signals.constants)
    event_table = event_table_of(model, events)
    if method == "auto":
        how = chosen(how, case_of(model, rtol, None, input_signals, event_table))
    runner = runner_of(model, how, input_signals, event_table)
    runner.loosen(begin.closure_tol)
    runner.want(None, dense=False)
    instance = Stepper(runner, how)
    instance._start(begin.x, t)
    return instance


@checked
def resume(
    model: LoadedModel, path: str | Path, *, events: Mapping[str, object] | None = None
) -> Stepper:
    """The stepper of a checkpoint that :meth:`Stepper.save` wrote; it goes on bit for bit.

    Args:
        model: The model it was made with, at the same parameters.
        path: The file.
        events: As the stepper was made with: functions are not in the file.

    Raises:
        ModelError: no checkpoint of this model, or of other events.
    """
    from .files.checkpoint import read

    if not isinstance(path, str | Path):
        raise ModelError(f"resume({brief(path)}): name the file that stepper.save(path) wrote")
    return Stepper(*read(model, Path(path), events))


@checked
def step(
    model: LoadedModel,
    x: ArrayLike,
    dt: float,
    *,
    t: float = 0.0,
    events: Mapping[str, object] | None = None,
    method: str | GeneralizedAlpha | Alpha = "auto",
    rtol: float = 1e-6,
    atol: float | None = None,
    step: float | None = None,
    max_step: float | None = None,
    inputs: Mapping[str, object] | None = None,
) -> Array:
    """The states that a time dt leads to.

    Args:
        model: The compiled model.
        x: States [q, u, z] (..., nx).
        dt: Time to pass [s], negative to go back; one compiled run per state, all of them in one
            call of the kernels where the model has no events.
        t: Time at the start [s].
        events, method, rtol, atol, step, max_step, inputs: As ``stepper`` takes them.

    Returns:
        (..., nx).

    Raises:
        ModelError, ArgumentError, SolveError: as :func:`stepper` and :meth:`Stepper.step`.
    """
    states = numbers("x", x)
    one = partial(
        stepper, model, t=t, events=events, method=method, rtol=rtol, atol=atol, step=step,
        max_step=max_step, inputs=inputs,
    )  # fmt: skip
    options = Options(method, rtol, atol, step, max_step)
    runs = None
    if events is None and inputs is None and fit(model, states, t, dt):
        runs = short_runs(model, options)
    if runs is not None:
        return _short(runs, options, states, t, dt, one)
    result = np.empty_like(states)
    for place in np.ndindex(states.shape[:-1]):
        result[place] = one(x0=states[place]).step(dt)
    return result


def _short(
    runs: ShortRuns,
    options: Options,
    states: Array,
    t: float,
    dt: float,
    one: Callable[..., Stepper],
) -> Array:
    """The states (..., nx) that short runs lead to, else a stepper, which says why not."""
    model = runs.model
    try:
        runs.aim(t, t + dt)
        if states.ndim == 1:
            end = runs.one(states)
            return one(x0=states).step(dt) if end is None else end
        rows = runs.states(states)
        ends = np.empty_like(rows)
        at = runs.many(rows, ends, 0)
        while at < len(rows):
            ends[at] = one(x0=rows[at]).step(dt)
            at = runs.many(rows, ends, at + 1)
        return ends.reshape(states.shape)
    finally:
        put_back(model, options, runs)
