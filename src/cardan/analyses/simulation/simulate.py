"""Motion of a compiled model over time."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from numpy.typing import ArrayLike

from ...arguments import Inputs, checked
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.trajectory.trajectory import TrajectoryRecord
from ...schema.integrators import INTEGRATORS
from ..gradients.sensitivities import differentiated
from .alpha_methods import Alpha, GeneralizedAlpha
from .driving import chosen, driven, reported, run_setup, runner_of
from .events import EventTable
from .files.run_file import RunFile, run_file
from .method_choice import Case, Limited, abandoned
from .settings import Settings, Start, Values, default_rtol
from .signals import Signals
from .spare_runners import put_aside
from .times import Span


@checked
def simulate(
    model: LoadedModel,
    t: float | ArrayLike | None = None,
    *,
    t_eval: ArrayLike | None = None,
    x0: ArrayLike | None = None,
    q: Values | ArrayLike | None = None,
    u: Values | ArrayLike | None = None,
    z: Values | ArrayLike | None = None,
    events: Mapping[str, object] | None = None,
    method: str | GeneralizedAlpha | Alpha = "auto",
    rtol: float | None = None,
    atol: float | None = None,
    step: float | None = None,
    max_step: float | None = None,
    inputs: Inputs | None = None,
    parameters: Values | None = None,
    sample: float | None = None,
    checkpoint: str | Path | None = None,
    every: float = 10.0,
    check: bool = False,
    sensitivity: str | Sequence[str] = (),
    progress: bool | Callable[[float], None] | None = None,
) -> TrajectoryRecord:
    """Integrate the equations of motion.

    Args:
        model: The compiled model.
        t: End time (from 0), ``(start, end)`` (backward too), or an array of output times [s].
            With an end or a pair the result is dense; ``t_eval`` takes an array of two times.
        x0: Initial state (nx,); else
        q, u: initial coordinates and speeds, ``{"elbow": 0.3, "base": [1, 0, 0, 0, 0, 0, 1]}``
            or arrays (nq,), (nu,). What is not named comes from q0 and u0 of its joint, else 0;
            of a system with loops it is assembled next to that, see ``model.assemble``.
        z: Initial internal states of elements, ``{"motor.current": 0.1}`` or an array (nz,).
        events: Name -> what to watch, besides the events of the model: ``f(t, x)`` or
            ``("elbow", 0.5)``. The run ends where that passes zero, or the coordinate, speed or
            internal state the value; ``(what, "mark")`` notes it; ``"down"``, ``"up"`` is the way.
        method: Name of an integrator, such as ``"DOP853"``, ``"RK45"``, ``"RKMK853"``,
            ``"Radau"``, ``"Rosenbrock"`` (adaptive), ``"RK4"``, ``"EnergyMidpoint"``,
            ``"EnergyMomentum"`` (fixed step), or a :class:`cardan.GeneralizedAlpha`; ``"auto"``
            takes what the scene and the first steps ask for, and says why.
        rtol, atol: Tolerances of a step: ``rtol |x| + atol``, root mean square over the state; of
            generalized-alpha and Radau on nodes (rtol + atol) times the extent, of angles 1, and of
            speeds in Radau that over the step. Unless given rtol is 1e-6, with sensitivity= 1e-9 as
            for gradients and fits, and atol is 1e-3 rtol, at most 1e-9.
        step: Step of fixed methods and of generalized-alpha, first one of others [s].
        max_step: Largest step of an adaptive method [s]; with input functions 1/1000 of the span.
        inputs: Name -> constant, ``(times, values)`` (straight lines between, a time twice is a
            jump; of a prescribed motion a cubic spline, through three a parabola), ``f(t, x)`` or
            ``f(t)``; names of several -> a :class:`cardan.CFunction`.
        parameters: Values of parameters by name, as ``model.with_parameters`` takes them.
        sample: Time between calls of ``f(t, x)`` [s], held in between; else called at every stage.
        checkpoint: A file that keeps what is computed, ``every`` so many seconds; the same call
            goes on from there, to the bit.
        check: Raise instead of warn, see below and ``docs/integrators.md``.
        sensitivity: Starts, parameters and inputs by name, as :meth:`gradient` takes them: the
            motion has ``motion.sensitivity["m"]``, what it changes by them.
        progress: True, False or a function of the fraction done; None: a bar in long runs.

    Returns:
        The motion and its ``events``. After a breakdown or Ctrl-C: what was computed, with
        ``status``, ``message`` and a :class:`~cardan.errors.SolveWarning`. Energy, momentum or
        closure off by more than a hundred times what the tolerance is worth give one too.

    Raises:
        ModelError: an unknown name, an empty span, options that do not fit. ArgumentError: wrong
            shapes. FunctionError: yours failed; ``motion`` is what was computed. SolveError: a
            number that is not finite; with ``check``, an early end.
    """
    state = {"x0": x0, "q": q, "u": u, "z": z}
    options = (method, default_rtol(rtol, sensitivity), atol, step, max_step)
    setup = run_setup(model, (t, t_eval), state, events, options, inputs, parameters, sample)
    if sensitivity:
        return differentiated(setup, sensitivity, state, inputs, checkpoint, check, progress)
    with run_file(checkpoint, every, *setup.run) as file:
        return reported(_settled(*setup.run, setup.case, progress, file), check)


def _settled(
    model: LoadedModel,
    how: Settings,
    input_signals: Signals,
    event_table: EventTable,
    over: Span,
    begin: Start,
    case: Case | None,
    progress: bool | Callable[[float], None] | None,
    file: RunFile | None,
) -> TrajectoryRecord:
    """The motion by the method asked for, or by that which its first steps ask for."""
    first = chosen(how, case)
    if file is not None and file.method not in ("", first.method.name):
        # that was settled before the run was left
        first = replace(how, method=INTEGRATORS[file.method], reason=file.reason)
        case = None
    try:
        runner = runner_of(model, first, input_signals, event_table)
        motion = driven(runner, over, begin, progress, case, file)
        if case is None or not abandoned(case, first.method.name, motion.status):
            put_aside(runner)
            return motion
        raise Limited(case)
    except Limited as found:
        if file is not None:
            file.begin()
        runner = runner_of(model, chosen(how, found.case), input_signals, event_table)
        return driven(runner, over, begin, progress, None, file)
