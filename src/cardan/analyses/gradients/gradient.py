"""Gradients of costs of motions, by one sweep backward, whatever they are by."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import field

import numpy as np
from numpy.typing import ArrayLike

from ...arguments import Count, Inputs, Seed, checked
from ...arrays import Array
from ...errors import ArgumentError, SolveWarning, warn
from ...records import dataclass
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.trajectory.solver_info import EVENT
from ...runtime.trajectory.trajectory import TrajectoryRecord
from ...schema.cost import Cost
from ..ensembles.sampling import Plan
from ..simulation.alpha_methods import Alpha, GeneralizedAlpha
from ..simulation.driving import RunSetup, chosen, driven, reported, run_setup, runner_of
from ..simulation.settings import DERIVATIVE_RTOL, Values
from ..simulation.spare_runners import put_aside
from .adjoint import Sweep
from .checkpoints import MEMORY, Block, StepStore
from .differentiable import check_complete, exact_method, refuse, row_behind
from .jumps import Jumps, event_instants
from .over_runs import OneRun, Variation, over_runs
from .start import named_start
from .unknowns import InputSlopes, Slope, Unknowns, unknowns


@dataclass(frozen=True)
class Gradient:
    """A cost of a motion and its gradient; ``value, slope = gradient`` takes both.

    Attributes:
        value: The cost; of several runs (runs,).
        slope: Gradient by name: a number, or an array of the size of what it is by. Of ``"q0"`` and
            ``"x0"`` along the speeds: (nu,) and (2 nu + nz,). Of several runs (runs, ...).
        motion: The motion; of several runs a tuple of those that were done. None where its rows did
            not fit into memory.
        note: Where they did not: how often steps were repeated, in words; of several runs one line
            for each of them.
    """

    value: float | Array
    slope: Mapping[str, Slope]
    motion: TrajectoryRecord | tuple[TrajectoryRecord | None, ...] | None = field(repr=False)
    note: str = ""

    def __iter__(self) -> Iterator[object]:
        return iter((self.value, self.slope))


@checked
def gradient(
    model: LoadedModel,
    t: float | Sequence[float],
    cost: Cost,
    *,
    wrt: str | Sequence[str] = ("x0", "p"),
    x0: ArrayLike | None = None,
    q: Values | ArrayLike | None = None,
    u: Values | ArrayLike | None = None,
    z: Values | ArrayLike | None = None,
    events: Mapping[str, object] | None = None,
    method: str | GeneralizedAlpha | Alpha = "auto",
    rtol: float = DERIVATIVE_RTOL,
    atol: float | None = None,
    step: float | None = None,
    max_step: float | None = None,
    inputs: Inputs | None = None,
    parameters: Values | None = None,
    vary: Plan | Mapping[str, object] | None = None,
    runs: Count | None = None,
    seed: Seed = 0,
    memory: float = MEMORY,
    progress: bool | Callable[[float], None] | None = None,
) -> Gradient:
    """The gradient of a cost of a motion, through its events, by any number of unknowns.

    ``value, slope = model.gradient(2.0, cd.cost(final="(hand.x - 0.4)^2"), wrt=("q0", "m"))``

    Args:
        model: The compiled model.
        t: End time (from 0), or ``(start, end)`` [s].
        cost: The cost, see :func:`cardan.cost`.
        wrt: ``"x0"``, ``"q0"``, ``"u0"``, ``"z0"``: the start; ``"q0.elbow"``, ``"u0.elbow"``: of a
            joint, along its speeds; ``"p"``: all parameters; names of parameters and inputs. Of an
            input ``(times, values)`` the gradient is by the values.
        x0, q, u, z, events, rtol, atol, step, max_step, inputs, parameters, progress: As
            :meth:`simulate` takes them.
        vary, runs, seed: What differs between several runs, as :meth:`ensemble` takes it; then x0,
            q, u, z, parameters and inputs may have values per run too.
        memory: Bytes for the rows of the steps. Where they do not fit, checkpoints are made and
            steps are repeated, to the same bits; ``note`` of the result says how often.
        method: As :meth:`simulate` takes it, but Rosenbrock; ``"auto"`` takes DOP853, of
            elements Radau.

    Returns:
        A :class:`cardan.Gradient`: ``value``, ``slope`` by name, ``motion``. Of Runge-Kutta methods
        it is exact for the steps that were taken; of others it is that of the exact motion beside
        the computed one. Either way its error is that of the motion. After Ctrl-C several runs have
        NaN where they were not done, and warn.

    Raises:
        ModelError, ArgumentError: as :meth:`simulate`, and a method or an input whose derivative is
            not known; memory= that holds nothing. SolveError: the run ends early, or has no
            derivative: two events at one time, an event that happens by a touch.
    """
    _check_times(t)
    named_inputs = dict(inputs or {})
    state = {"x0": x0, "q": q, "u": u, "z": z}
    if vary is not None or runs is not None:

        def single(run: OneRun) -> Gradient:
            return gradient(
                run.model, t, cost, wrt=wrt, q=run.q, u=run.u, z=run.z, events=events,
                method=method, rtol=rtol, atol=atol, step=step, max_step=max_step,
                inputs=run.inputs, memory=memory, progress=False,
            )  # fmt: skip

        several = Variation(vary, runs, seed), t, state, named_inputs, parameters
        return _stacked(*over_runs(model, *several, single, progress))
    if method == "auto":
        method = exact_method(model)
    options = (method, rtol, atol, step, max_step)
    setup = run_setup(model, (t, None), state, events, options, inputs, parameters)
    names = unknowns(setup.model, wrt, {str(k): v for k, v in named_inputs.items()})
    refuse(setup.model, setup.how, setup.input_signals, names)
    runner = runner_of(setup.model, chosen(setup.how, None), setup.input_signals, setup.event_table)
    result = _driven_and_swept(setup, StepStore(runner, memory), progress, cost, names, state)
    put_aside(runner)
    return result


def _check_times(t: float | Sequence[float]) -> None:
    """Refuse output times, which a cost knows nothing of."""
    if np.size(t) > 2:
        raise ArgumentError(
            f"gradient: t has {np.size(t)} times: give the end, or (start, end). A cost is one of "
            "the end and of the entire way; changes at times come from simulate(sensitivity=)"
        )


def _driven_and_swept(
    setup: RunSetup,
    store: StepStore,
    progress: bool | Callable[[float], None] | None,
    cost: Cost,
    names: Unknowns,
    state: Mapping[str, object],
) -> Gradient:
    """The motion, and the gradient by a sweep back over it."""
    motion = driven(store.runner, setup.over, setup.begin, progress, dense=False, store=store)
    if motion.status == "interrupted":
        raise KeyboardInterrupt
    check_complete(motion, store.runner)
    return _swept(setup, store, reported(motion, False), cost, names, state)


def _stacked(gradients: Sequence[Gradient], runs: int) -> Gradient:
    """Gradients of several runs as one, NaN for those that Ctrl-C came before."""
    done = len(gradients)
    if done < runs:
        warn(f"gradient: interrupted when {done} of {runs} runs were done", SolveWarning)

    def column(values: Sequence[Slope]) -> Array:
        result = np.full((runs, *np.shape(values[0])), np.nan)
        result[:done] = values
        return result

    slopes = {name: column([one.slope[name] for one in gradients]) for name in gradients[0].slope}
    motions = tuple(x.motion for x in gradients if not isinstance(x.motion, tuple))
    values, note = (
        column([float(one.value) for one in gradients]),
        "\n".join(one.note for one in gradients if one.note),
    )
    return Gradient(values, slopes, motions, note)


def _swept(
    setup: RunSetup,
    store: StepStore,
    motion: TrajectoryRecord,
    cost: Cost,
    names: Unknowns,
    state: Mapping[str, object],
) -> Gradient:
    """The gradient by a sweep over the steps of a motion."""
    model, runner = setup.model, store.runner
    sweep = Sweep.of(runner, cost, names.parameters)
    jumps = Jumps(sweep, cost, setup.event_table, setup.over.start)
    value, final_rate = _final(sweep, motion, cost)
    halted = motion.solver_info.status == EVENT
    for block in store.backward(motion):
        _sweep_block(block, sweep, jumps, final_rate if halted and block.last else None)
    sweep.arrived()
    # what was not named at the start followed from what was
    modes = store.start[1 + runner.n + model.nr :][: model.ns]
    begin = named_start(setup, sweep, state, modes, names, names.parameters)
    start, by_r, by_p = begin.backward(sweep.lam)
    if by_r.size:
        sweep.add_inputs(setup.over.start, by_r)
    if by_p.size:
        sweep.by_p += by_p
    slopes = InputSlopes(model, sweep.by_r, sweep.by_coefficients)
    by_name = names.slopes(start, sweep.by_p, setup.input_signals, slopes)
    return Gradient(value + sweep.cost, by_name, motion if store.complete else None, store.note)


def _sweep_block(block: Block, sweep: Sweep, jumps: Jumps, final_rate: float | None) -> None:
    """Sweep over steps and events of a block, the last one first.

    Args:
        block: The steps.
        sweep, jumps: What sweeps.
        final_rate: Derivative of the final cost by the time, where the last event ends the run.
    """
    model, rows = sweep.model, block.rows
    instants = event_instants(block.log, jumps.events, model.nx, model.ns)
    end = len(rows)
    # backward: the steps behind an event, the event, and so on to the start
    for number, at in enumerate(reversed(instants)):
        last = final_rate is not None and number == 0
        # the row behind what happened, at the same time as that before it
        first = row_behind(rows[:, 0], end, at)
        if not last:
            sweep.over(rows[first:end])
            end = first
        jumps.pull(at, final_rate if last else None)
    sweep.over(rows[:end])


def _final(sweep: Sweep, motion: TrajectoryRecord, cost: Cost) -> tuple[float, float]:
    """The final cost, whose gradient the sweep begins with, and its derivative by the time."""
    if cost.final is None:
        return 0.0, 0.0
    return sweep.begin(cost.final, float(motion.t[-1]), motion.x[-1], motion.event_log.s[-1])
