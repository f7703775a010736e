"""Gradients of costs of motions, by one sweep backward whatever they are by."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from ...arguments import Inputs, checked
from ...arrays import Array
from ...errors import ModelError, SolveError
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.trajectory.solver_info import EVENT, FINISHED
from ...runtime.trajectory.trajectory import TrajectoryRecord
from ..simulation.run import Runner
from ..simulation.settings import Values
from ..simulation.simulate import RunSetup, chosen, driven, reported, run_setup, runner_of
from .adjoint import Sweep
from .cost import Cost
from .jumps import Happening, Jumps, happenings
from .start import by_named_start
from .steps import TABLES
from .unknowns import InputSlopes, Slope, Unknowns, unknowns


@dataclass(frozen=True)
class Gradient:
    """A cost of a motion and its gradient; ``value, slope = gradient`` takes both.

    Attributes:
        value: The cost.
        slope: Gradient by name: a number, or an array of the size of what it is by. Of ``"q0"`` and
            ``"x0"`` along the speeds: (nu,) and (2 nu + nz,).
        motion: The motion.
    """

    value: float
    slope: Mapping[str, Slope]
    motion: TrajectoryRecord = field(repr=False)

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
    method: str = "auto",
    rtol: float = 1e-9,
    atol: float | None = None,
    step: float | None = None,
    max_step: float | None = None,
    inputs: Inputs | None = None,
    parameters: Values | None = None,
    progress: bool | Callable[[float], None] | None = None,
) -> Gradient:
    """The gradient of a cost of a motion, through its events, by whatever many unknowns.

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
        method: ``"DOP853"``, ``"RK45"`` or ``"RK4"``; ``"auto"`` takes the first of them.

    Returns:
        A :class:`cardan.Gradient`: ``value``, ``slope`` by name, ``motion``. It is exact for the
        steps that were taken: its error is that of the motion.

    Raises:
        ModelError, ArgumentError: as :meth:`simulate`, and a method or an input whose derivative is
            not known. SolveError: the run ends early, or has no derivative: two events at one time,
            an event that happens by a touch.
    """
    given = dict(inputs or {})
    state = {"x0": x0, "q": q, "u": u, "z": z}
    method = "DOP853" if method == "auto" else method
    options = (method, rtol, atol, step, max_step)
    setup = run_setup(model, (t, None), state, events, options, inputs, parameters)
    names = unknowns(setup.model, wrt, {str(k): v for k, v in given.items()})
    _refuse(setup)
    runner = runner_of(setup.model, chosen(setup.how, None), setup.input_signals, setup.event_table)
    motion = driven(runner, setup.over, setup.begin, progress, dense=False)
    if motion.solver_info.status not in (FINISHED, EVENT):
        raise SolveError(f"gradient: the motion is not complete: {motion.message}")
    if motion.solver_info.statistics.get("passed"):
        raise SolveError(
            "gradient: the motion passes a place where branches meet, at which it has no "
            "derivative. Change the start or the parameters a little"
        )
    return _swept(setup, runner, reported(motion, False), cost, names, state)


def _refuse(setup: RunSetup) -> None:
    """Refuse what has no gradient.

    Raises:
        ModelError: with the cure.
    """
    model, method = setup.model, setup.how.method.name
    if model.manifest.absolute:
        raise ModelError(
            f"gradient: '{model.name}' has finite elements, through whose steps there is no sweep "
            "yet. Take differences of simulate at a tight tolerance"
        )
    if method not in TABLES:
        why = (
            "the Jacobian stands in its steps, which would need second derivatives. Take "
            if method == "Rosenbrock"
            else "there is no sweep through its steps. Take "
        )
        raise ModelError(f"gradient: method '{method}': {why}{', '.join(TABLES)}")
    if setup.input_signals.functions:
        names = [model.inputs[k] for k in setup.input_signals.functions]
        raise ModelError(
            f"gradient: input '{names[0]}' is a function, whose derivative is not known. Give it "
            "as (times, values), or write it into the scene as a force"
        )


def _swept(
    setup: RunSetup,
    runner: Runner,
    motion: TrajectoryRecord,
    cost: Cost,
    names: Unknowns,
    state: Mapping[str, object],
) -> Gradient:
    """The gradient by a sweep over the steps of a motion."""
    model, log = setup.model, motion.event_log
    sweep = Sweep(runner, cost, names.parameters)
    jumps = Jumps(sweep, cost, setup.event_table, setup.over.start)
    happened = happenings(log.log, setup.event_table, model.nx, model.ns)
    value, final_rate = _final(sweep, motion, cost)
    rows = np.hstack(
        [motion.t[:, None], motion.x, motion.work_done, motion.r, log.s.reshape(len(motion.t), -1)]
    )
    end = len(rows)
    halted = motion.solver_info.status == EVENT
    for number, at in enumerate(reversed(happened)):
        last = halted and number == 0
        # the row behind what happened, at the same time as that before it
        first = _row_behind(motion.t, end, at)
        if not last:
            sweep.over(rows[first:end])
            end = first
        jumps.pull(at, final_rate if last else None)
    sweep.over(rows[:end])
    start = by_named_start(setup, sweep, state, log.s[0])
    slopes = InputSlopes(model, sweep.by_r, sweep.by_pieces)
    by_name = names.slopes(start, sweep.by_p, setup.input_signals, slopes)
    return Gradient(value + sweep.cost, by_name, motion)


def _row_behind(t: Array, end: int, at: Happening) -> int:
    """The first row behind what happened: the last one at its time."""
    return int(np.searchsorted(t[:end], at.t, side="right")) - 1


def _final(sweep: Sweep, motion: TrajectoryRecord, cost: Cost) -> tuple[float, float]:
    """The final cost, whose gradient the sweep begins with, and its derivative by the time."""
    if cost.final is None:
        return 0.0, 0.0
    return sweep.begin(cost.final, float(motion.t[-1]), motion.x[-1], motion.event_log.s[-1])
