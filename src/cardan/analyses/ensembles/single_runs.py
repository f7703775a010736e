"""Runs one after the other, each as ``simulate`` makes it: loops, events, Python on the way."""

from __future__ import annotations

import numpy as np

from ...arrays import Array
from ...errors import CardanError, FunctionError, collected_warnings
from ...runtime.calls.parameters import Parameters
from ...runtime.models.constraint_projection import Closing
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.trajectory.trajectory import TrajectoryRecord
from ..simulation.driving import driven, runner_of
from ..simulation.events import EventTable
from ..simulation.method_choice import Case
from ..simulation.run import Runner
from ..simulation.settings import Settings, Start, start
from ..simulation.signals import Signals
from ..simulation.starts.start import closed_start
from ..simulation.times import Span
from .lane_runner import NUMBERS, Ends
from .variations import Varied

PARTS = (0.0, 0.13, 0.29, 0.41, 0.57, 0.71, 0.86, 1.0)


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
    runner = runner_of(model, how, run_signals, event_table)
    return driven(runner, over, begin, False, case), runner


def on_the_way(over: Span) -> Array:
    """Some times of a run, both ends among them, at no even distances."""
    times = over.start + (over.end - over.start) * np.array(PARTS)
    times[-1] = over.end
    return times


class Single:
    """Used as a :class:`.crew.Crew` is."""

    def __init__(
        self,
        model: LoadedModel,
        how: Settings,
        input_signals: Signals,
        event_table: EventTable,
        over: Span,
    ) -> None:
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
        for k in range(count):
            if self.stopped:
                break
            try:
                one = part.part(k, k + 1)
                with collected_warnings() as texts:
                    trajectory, runner = motion(
                        self.model, self.how, self.input_signals, self.event_table, over, one
                    )
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
            self._store(ends, k, trajectory, runner)
        return ends

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
