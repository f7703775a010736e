"""Runs one after the other, each as ``simulate`` makes it: loops, events, Python on the way."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ...arrays import Array
from ...errors import CardanError, FunctionError, SolveError, collected_warnings
from ...runtime.calls.parameters import Parameters
from ...runtime.models.constraint_projection import Closing
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.trajectory.trajectory import TrajectoryRecord
from ..gradients.sensitivities import SensitiveRuns, Sensitivities, columns_by_name
from ..simulation.driving import RunSetup, driven, runner_of
from ..simulation.events import EventTable, check_start
from ..simulation.method_choice import Case
from ..simulation.run import Runner
from ..simulation.settings import Settings, Start, start
from ..simulation.signals import Signals
from ..simulation.starts.start import closed_start
from ..simulation.times import Span
from .lane_runner import NUMBERS, Ends
from .sensitivity import NO_DERIVATIVE, SensitivityRequest
from .variations import Varied

PARTS = (0.0, 0.13, 0.29, 0.41, 0.57, 0.71, 0.86, 1.0)


def setup_of(
    model: LoadedModel,
    how: Settings,
    input_signals: Signals,
    event_table: EventTable,
    over: Span,
    part: Varied,
) -> RunSetup:
    """The only run of a part before it begins.

    Raises:
        ModelError: its loops cannot be assembled, or it begins beyond a stop.
    """
    if part.varies_parameters:
        model = model._with(Parameters(model.manifest, part.block("p")[0]))
    constants = part.block("r")[0]
    run_signals = Signals(
        constants,
        input_signals.tabulated,
        input_signals.functions,
        input_signals.sample,
        input_signals.defaulted,
    )
    named = part.named("q", 0), part.named("u", 0)
    if model.manifest.absolute:
        # what is not named goes where its own parameters and what is named carry it
        begin = start(model, None, *named, part.named("z", 0))
    else:
        begin = Start(part.states()[0], ())
    if Closing.of(model).rows or model.manifest.absolute:
        begin = closed_start(model, begin, *named, over.start, run_signals.first(over.start))
    check_start(model, begin.x, over.start, run_signals.first(over.start))
    return RunSetup(model, how, run_signals, event_table, over, begin, None)


def motion(
    model: LoadedModel,
    how: Settings,
    input_signals: Signals,
    event_table: EventTable,
    over: Span,
    part: Varied,
    case: Case | None = None,
) -> tuple[TrajectoryRecord, Runner]:
    """The only run of a part, and what made it.

    Raises:
        ModelError: its loops cannot be assembled.
        FunctionError: a function of the caller raised.
        Limited: with ``case``: another method would be chosen.
    """
    setup = setup_of(model, how, input_signals, event_table, over, part)
    runner = runner_of(setup.model, how, setup.input_signals, event_table)
    return driven(runner, over, setup.begin, False, case), runner


def on_the_way(over: Span) -> Array:
    """Some times of a run, both ends among them, at no even distances."""
    times = over.start + (over.end - over.start) * np.array(PARTS)
    times[-1] = over.end
    return times


class SensitiveMotion:
    """One run of an ensemble with its sensitivities."""

    def __init__(self, setup: RunSetup, part: Varied, request: SensitivityRequest) -> None:
        """Args:
        setup: The run.
        part: What it starts from.
        request: What it is differentiated by.

        Raises:
            ModelError: what has no derivative.
        """
        self._setup = replace(setup, over=replace(setup.over, times=None))
        self._state = {"x0": None, **{letter: part.named(letter, 0) for letter in "quz"}}
        self._runs = SensitiveRuns(self._setup, request.names, request.tables)
        self.runner = self._runs.runner

    def drive(self) -> TrajectoryRecord:
        """The motion alone, dense."""
        return self._runs.drive(self._setup.over, self._setup.begin)

    def sensitivities(self, motion: TrajectoryRecord) -> Sensitivities:
        """What it changes by.

        Raises:
            SolveError: it is not complete, or has no derivative.
        """
        return self._runs.along(motion, self._setup.over, self._setup.begin, self._state)

    def motion(self) -> TrajectoryRecord:
        """The motion, with its sensitivities where it has any."""
        motion = self.drive()
        try:
            return replace(motion, sensitivity=self.sensitivities(motion))
        except SolveError:
            return motion


class Single:
    """Used as a :class:`.crew.Crew` is."""

    def __init__(
        self,
        model: LoadedModel,
        how: Settings,
        input_signals: Signals,
        event_table: EventTable,
        over: Span,
        sensitivity: SensitivityRequest | None = None,
    ) -> None:
        self.sensitivity = sensitivity
        self.model, self.how, self.input_signals, self.event_table, self.over = (
            model,
            how,
            input_signals,
            event_table,
            over,
        )
        self.stopped = False

    def stop(self) -> None:
        """End soon, from any thread."""
        self.stopped = True

    def run(self, part: Varied) -> Ends:
        """All runs of a block."""
        count, nx, nr, ns = part.runs, self.model.nx, self.model.nr, self.model.ns
        times = np.empty(0) if self.over.times is None else self.over.times
        # some rows on the way say what energy there is to account for
        over = Span(self.over.start, self.over.end, on_the_way(self.over))
        over = self.over if self.over.times is not None else over
        ends = Ends(
            np.full((count, nx), np.nan),
            np.full((count, len(times), 1 + nx + nr + ns), np.nan),
            ["not_run"] * count,
            {},
            np.zeros((count, len(NUMBERS))),
        )
        ends.numbers[:, 0] = np.nan
        if self.sensitivity is not None:
            columns = columns_by_name(self.model, self.sensitivity.unknowns(self.model))
            for name, size in columns.items():
                shape = (count, len(times), nx, *(() if size is None else (size,)))
                ends.sensitivity[name] = np.full(shape, np.nan)
        for k in range(count):
            if self.stopped:
                break
            try:
                one = part.part(k, k + 1)
                with collected_warnings() as texts:
                    setup = setup_of(
                        self.model, self.how, self.input_signals, self.event_table, over, one
                    )
                    if self.sensitivity is None:
                        runner = runner_of(
                            setup.model, self.how, setup.input_signals, self.event_table
                        )
                        trajectory = driven(runner, over, setup.begin, False)
            except FunctionError:
                # the function is at fault, not this run
                raise
            except CardanError as problem:
                # such as loops that do not close with the parameters of this run
                ends.status[k], ends.messages[k] = "not_begun", f"not begun: {problem}"
                continue
            finally:
                if texts:
                    ends.warnings[k] = texts
            if self.sensitivity is None:
                self._store(ends, k, trajectory, runner)
            else:
                self._differentiate(ends, k, SensitiveMotion(setup, one, self.sensitivity))
        return ends

    def _differentiate(self, ends: Ends, k: int, run: SensitiveMotion) -> None:
        """Drive a run and store its result, and what that changes by."""
        times = self.over.times
        assert times is not None
        with collected_warnings() as texts:
            dense = run.drive()
        if texts:
            ends.warnings[k] = [*ends.warnings.get(k, []), *texts]
        # those beyond its end have no row
        sign = 1.0 if self.over.end >= self.over.start else -1.0
        inside = times[sign * (times - dense.t[-1]) <= 0]
        self._store(ends, k, dense.resample(inside), run.runner)
        if not dense.success:
            return
        try:
            changes = run.sensitivities(dense).at(inside)
        except SolveError as problem:
            # reductions take its states as they are
            ends.motions[k] = ends.status[k]
            ends.status[k], ends.messages[k] = NO_DERIVATIVE, str(problem)
            return
        for name, values in changes.items():
            ends.sensitivity[name][k, : len(inside)] = values

    def _store(self, ends: Ends, k: int, trajectory: TrajectoryRecord, runner: Runner) -> None:
        """Store the result of one run."""
        nx, rows = self.model.nx, len(trajectory)
        ends.x[k] = runner.views["y"][:nx]
        ends.status[k] = trajectory.status
        if not trajectory.success or trajectory.solver_info.warning:
            said = [trajectory.message] if not trajectory.success else []
            said += [trajectory.solver_info.warning] if trajectory.solver_info.warning else []
            ends.messages[k] = "; ".join(said)
        ends.numbers[k] = runner.record.t, *(trajectory.statistics[name] for name in NUMBERS[1:])
        if ends.rows.shape[1]:
            parts = [trajectory.t[:, None], trajectory.x, trajectory.r, trajectory.s]
            ends.rows[k, :rows] = np.concatenate(parts, axis=1)
