"""The task of an ensemble and one block of it: the same on every thread and machine."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field, replace

import numpy as np
from numpy.typing import NDArray

from ...arrays import Array
from ...records import dataclass
from ...runtime.calls.parameters import Parameters
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.trajectory.solver_info import EVENT, FINISHED
from ...runtime.trajectory.trajectory import TrajectoryRecord
from ...schema.functions import FUNCTIONS
from ..simulation.events import EventTable
from ..simulation.settings import Settings
from ..simulation.signals import Signals
from ..simulation.times import Span
from .lane_runner import Ends, LaneRunner, suits
from .reductions import Histories, Parts, Reduction
from .sensitivity import SensitivityRequest
from .single_runs import SensitiveMotion, Single, motion, setup_of
from .variations import Varied

# histories beside those of states, inputs and outputs
ENERGIES = ("kinetic energy", "potential energy", "energy")


@dataclass(frozen=True)
class Sizes:
    """Sizes of the answers of an ensemble.

    Attributes:
        runs: How many there are.
        nx: Entries of a state.
        times: Output times.
        reductions: Reductions by name.
    """

    runs: int
    nx: int
    times: int
    reductions: Mapping[str, Reduction]


@dataclass(frozen=True)
class Job:
    """An ensemble, or some runs of it.

    Attributes:
        model: The compiled model.
        how: The method and its tolerances.
        input_signals: Inputs that all runs share.
        event_table: What may happen.
        over: Start, end and output times.
        varied: What the runs differ by.
        reductions: Reductions by name.
        width: Lanes side by side.
        build: What decides about the last bit, as :func:`build_key` says.
        sensitivity: What the runs are differentiated by; None without.
    """

    model: LoadedModel
    how: Settings
    input_signals: Signals
    event_table: EventTable
    over: Span
    varied: Varied
    reductions: Mapping[str, Reduction]
    width: int = 1
    build: str = ""
    sensitivity: SensitivityRequest | None = None

    @property
    def sizes(self) -> Sizes:
        """Sizes of the answers."""
        times = 0 if self.over.times is None else len(self.over.times)
        return Sizes(self.varied.runs, self.model.nx, times, self.reductions)

    @property
    def in_lanes(self) -> bool:
        """True when the loop in C can do the runs, side by side."""
        arguments = self.model, self.how, self.input_signals, self.event_table
        return self.sensitivity is None and suits(*arguments)

    def runner(self) -> LaneRunner | Single:
        """The runner of one thread."""
        arguments = self.model, self.how, self.input_signals, self.event_table
        if self.in_lanes:
            return LaneRunner(*arguments, self.over, self.width)
        return Single(*arguments, self.over, self.sensitivity)

    def motion(self, k: int, times: Array | None) -> TrajectoryRecord:
        """One run as a trajectory, at times or dense."""
        over, part = replace(self.over, times=times), self.varied.part(k, k + 1)
        arguments = self.model, self.how, self.input_signals, self.event_table
        if self.sensitivity is None or times is not None:
            return motion(*arguments, over, part)[0]
        return SensitiveMotion(setup_of(*arguments, over, part), part, self.sensitivity).motion()


@dataclass(frozen=True)
class BlockResult:
    """Result of a block of runs.

    Attributes:
        first: Number of its first run.
        x: Where they end (count, nx).
        status: Words (count,).
        numbers: (count, 4): where it ended [s], steps, rejections, evaluations.
        messages: Of runs that did not reach their end, or miss far more than their tolerance is
            worth, by number of the run.
        parts: Of every reduction.
        warnings: Messages of warnings, by number of the run.
    """

    first: int
    x: Array
    status: NDArray[np.str_]
    numbers: Array
    messages: dict[int, str]
    parts: dict[str, Parts] = field(repr=False)
    warnings: dict[int, list[str]] = field(default_factory=dict, repr=False)

    @property
    def last(self) -> int:
        """Number of the run behind its last one."""
        return self.first + len(self.x)


def compute(job: Job, runner: LaneRunner | Single, first: int, last: int) -> BlockResult:
    """Runs from ``first`` to before ``last``."""
    part = job.varied.part(first, last)
    ends = runner.run(part)
    block = histories(job, part, ends)
    parts = {name: reduction.part(block) for name, reduction in job.reductions.items()}
    return BlockResult(
        first,
        ends.x,
        np.array(ends.status),
        ends.numbers,
        {first + k: text for k, text in ends.messages.items()},
        parts,
        {first + k: texts for k, texts in ends.warnings.items()},
    )


def histories(job: Job, part: Varied, ends: Ends) -> Histories:
    """Histories of a block, for the reductions."""
    model = job.model
    t = np.empty(0) if job.over.times is None else job.over.times
    x = ends.rows[:, :, 1 : 1 + model.nx]
    r = ends.rows[:, :, 1 + model.nx : 1 + model.nx + model.nr]
    columns = {name: x[:, :, k] for k, name in enumerate(entries(model))}
    columns |= {name: r[:, :, k] for k, name in enumerate(model.inputs)}
    outputs = [row.name for row in model.manifest.outputs]
    histories: dict[str, Array] = {}

    def of(name: str) -> Array:
        if name in columns:
            return columns[name]
        if name in outputs and name not in histories:
            values = _values(model, part, ends.rows, "outputs")
            histories.update((n, values[:, :, k]) for k, n in enumerate(outputs))
        if name not in histories:
            values = _values(model, part, ends.rows, "energy")
            histories.update((n, values[:, :, k]) for k, n in enumerate(ENERGIES))
        return histories[name]

    status = np.array([ends.motions.get(k, text) for k, text in enumerate(ends.status)])
    return Histories(t, x, status == FINISHED, status == EVENT, of, ends.sensitivity)


def _values(model: LoadedModel, part: Varied, rows: Array, function: str) -> Array:
    """Outputs or energies (runs, nt, n) along runs; NaN where a run had ended."""
    there = np.logical_and.reduce(np.isfinite(rows[:, :, : 1 + model.nx]), axis=2)
    run, parameters, p = np.nonzero(there)[0], None, part.block("p")
    if part.varies_parameters and model.manifest.absolute and len(run):
        # tables of elements are filled for one set of parameters
        models = {
            k: model._with(Parameters(model.manifest, p[k])) for k in dict.fromkeys(run.tolist())
        }
        every = [_at_rows(one, rows[k, there[k]], function) for k, one in models.items()]
        values = np.concatenate(every)
    else:
        if part.varies_parameters:
            changed = [c.name for c in part.columns if c.block == "p"]
            names = list(model.parameters)
            parameters = {name: p[run, names.index(name)] for name in changed}
        values = _at_rows(model, rows[there], function, parameters)
    result = np.full((*there.shape, values.shape[1]), np.nan)
    result[there] = values
    return result


def _at_rows(
    model: LoadedModel, rows: Array, function: str, parameters: Mapping[str, Array] | None = None
) -> Array:
    """Outputs or energies (rows, n) at some rows."""
    sizes = np.cumsum([1, model.nq, model.nu, model.nz, model.nr, model.ns])
    t, q, u, z, r, s, _ = np.split(rows, sizes, axis=1)
    reads = FUNCTIONS[function].arguments
    blocks = {k: v for k, v in (("r", r), ("z", z), ("s", s)) if v.shape[1] and k in reads}
    values = getattr(model, function)(q, u, t=t[:, 0], parameters=parameters, **blocks)
    if function == "energy":
        values = np.stack([values.kinetic, values.potential, values.total], axis=-1)
    result: Array = values
    return result


def histories_of(model: LoadedModel) -> list[str]:
    """Names that reductions may speak of."""
    outputs = [row.name for row in model.manifest.outputs]
    names = [*entries(model), *model.inputs, *outputs]
    energies = ENERGIES if "energy" in model.manifest.available else ()
    return [*names, *(name for name in energies if name not in names)]


def entries(model: LoadedModel) -> tuple[str, ...]:
    """Names of the entries of a state."""
    return (*model.coordinates, *model.speeds, *model.internals)
