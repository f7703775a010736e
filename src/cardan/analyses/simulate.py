"""Motion of a compiled model over time."""

from __future__ import annotations

import time
import warnings
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import CompilerMissing, ModelError, SolveError, SolveWarning
from ..runtime.closing import Closing
from ..runtime.compiled import CompiledModel
from ..runtime.conduct import Conduct
from ..runtime.dense import Dense
from ..runtime.events import Happened
from ..runtime.interpreted import CURE
from ..runtime.trajectory import Trajectory
from . import record as abi
from .alpha import GeneralizedAlpha
from .choice import JACOBIAN, Case, Limited, choose, reconsider, remark
from .closed_start import closed_start
from .happenings import NOTHING, Happenings, check_start, happenings
from .integrators import INTEGRATORS
from .outcome import explain
from .plain import PlainRunner, check_plain
from .progress import showing
from .run import Runner
from .settings import Settings, Start, Values, blocks, settings, start
from .signals import Signals, signals
from .spared import spared
from .times import Span, span

Array = NDArray[np.float64]


def simulate(
    model: CompiledModel,
    t: float | ArrayLike,
    *,
    x0: ArrayLike | None = None,
    q: Values | ArrayLike | None = None,
    u: Values | ArrayLike | None = None,
    z: Values | ArrayLike | None = None,
    events: Mapping[str, Any] | None = None,
    method: str | GeneralizedAlpha = "auto",
    rtol: float = 1e-6,
    atol: float = 1e-9,
    step: float | None = None,
    max_step: float | None = None,
    inputs: Mapping[str, Any] | None = None,
    sample: float | None = None,
    check: bool = False,
    progress: bool | Callable[[float], None] | None = None,
) -> Trajectory:
    """Integrate the equations of motion.

    Args:
        model: The compiled model.
        t: End time (from 0), ``(start, end)`` (backward too), or an array of output times [s].
            With an end or a pair the result is dense: every step is kept, with what is between.
        x0: Initial state (nx,); or by names:
        q, u: Initial coordinates and speeds, ``{"elbow": 0.3, "base": [1, 0, 0, 0, 0, 0, 1]}``
            or arrays (nq,), (nu,). What is not named comes from q0 and u0 of its joint, else 0;
            of a system with circuits it is assembled next to that, see ``model.assemble``.
        z: Initial internal states of elements, ``{"motor.current": 0.1}`` or an array (nz,).
        events: Name -> what to watch, besides the events of the model: ``f(t, x)`` or
            ``("elbow", 0.5)``. The run ends where that passes zero, or the coordinate, speed or
            internal state the value; ``(what, "mark")`` only notes it. ``"down"`` or ``"up"`` as
            a further word says which way, along the run.
        method: Name of an integrator, such as ``"DOP853"``, ``"RK45"``, ``"RKMK853"``,
            ``"Radau"``, ``"Rosenbrock"`` (adaptive), ``"RK4"``, ``"EnergyMidpoint"`` (fixed step),
            or a :class:`cardan.GeneralizedAlpha`; ``"auto"`` takes what the scene and the first
            steps ask for, and says why.
        rtol, atol: Tolerances for the error of a step: rtol |x| + atol in every entry of the
            state, root mean square over them.
        step: Step of a fixed method, first step of an adaptive one [s].
        max_step: Largest step of an adaptive method [s].
        inputs: Name -> constant, ``(times, values)`` (straight lines between; a time twice is a
            jump; a cubic spline where the input prescribes a motion) or ``f(t, x)``.
        sample: Time between two calls of the ``f(t, x)`` [s]; their values are held in between, as
            a digital controller does. Without it they are called at every stage of every step.
        check: Raise instead of warn when the run does not reach its end.
        progress: True, False or a function of the fraction done; None: a bar on a terminal once
            the run takes longer than a second.

    Returns:
        The motion; ``motion.events`` says what happened. If the run breaks down or is interrupted
        (Ctrl-C): what was computed, with ``status``, ``message`` and a
        :class:`~cardan.errors.SolveWarning`.

    Raises:
        ModelError: an unknown name, an empty span, options that do not fit.
        ArgumentError: wrong shapes.
        SolveError: a number that is not finite; with ``check``, an early end.
    """
    over = span(t)
    begin = start(model, x0, q, u, z)
    may = happenings(model, events)
    may.forward(over.start, over.end)
    how = settings(method, rtol, atol, step, max_step, over.length)
    given = signals(model.manifest["inputs"], inputs, sample, (over.start, over.end))
    begin = closed_start(model, begin, *blocks(x0, q, u), over.start, given.first(over.start))
    check_start(model, begin.x, over.start, given.first(over.start))
    case = case_of(model, rtol, over, given, may) if method == "auto" else None
    try:
        runner = runner_of(model, chosen(how, case), given, may)
        motion = driven(runner, over, begin, progress, case)
    except Limited as found:
        how = chosen(how, found.case)
        motion = driven(runner_of(model, how, given, may), over, begin, progress)
    if not motion.success:
        if check:
            raise SolveError(motion.message)
        warnings.warn(motion.message, SolveWarning, stacklevel=3)
    return motion


def case_of(model: CompiledModel, rtol: float, over: Span, given: Signals, may: Happenings) -> Case:
    """What ``method="auto"`` chooses from."""
    periods = [float(tick["period"]) for tick in may.ticks]
    if given.functions and given.sample is not None:
        periods.append(given.sample)
    return Case(
        rtol=rtol,
        period=min(periods, default=None),
        length=over.length,
        derived=JACOBIAN in model.manifest["available"],
        asked=bool(given.functions),
    )


def chosen(how: Settings, case: Case | None) -> Settings:
    """Settings with the method of a choice, if there is one."""
    if case is None:
        return how
    rule = choose(case)
    return replace(how, method=INTEGRATORS[rule.method], reason=rule.why)


def runner_of(
    model: CompiledModel, how: Settings, given: Signals, may: Happenings = NOTHING
) -> Runner | PlainRunner:
    """What runs a model: compiled integrators, or SciPy's where there is no compiler."""
    if how.method.suited is not None:
        method, words = how.method.suited(model, how.method)
        how = replace(how, method=method, words=f"{words}, {how.words}")
    how = spared(model, how)
    available = model.manifest["available"]
    power = "power" in available
    needs = [(f"method '{how.method.name}'", name) for name in how.method.needs]
    needs += [("a run with events", name) for name in may.functions]
    for what, name in needs:
        if name not in available:
            raise ModelError(
                f"{what} needs the function '{name}', which model "
                f"'{model.name}' lacks: cd.compile(..., functions=[..., '{name}'])"
            )
    called = ["rhs", *(["power"] if power else []), *Closing.of(model).functions]
    called += [name for _, name in needs]
    compiled = _integrators(model)
    if not compiled:
        check_plain(how)
    # side by side, as both must be compiled
    model.prepare(*called)
    if all(model._function(name).address for name in called) and compiled:
        return Runner(model, how, given, power, may)
    words = f"{how.words}, in NumPy as there is no C compiler: {CURE}"
    return PlainRunner(model, replace(how, words=words), given, power, may)


def _integrators(model: CompiledModel) -> bool:
    """Whether the integrators exist as C here: not without a compiler."""
    try:
        model._kernels()
    except CompilerMissing:
        return False
    return True


def driven(
    runner: Runner | PlainRunner,
    over: Span,
    begin: Start,
    progress: bool | Callable[[float], None] | None,
    case: Case | None = None,
) -> Trajectory:
    """Drive the run to its end and collect what came out.

    Raises:
        Limited: another method would be chosen, and less than half of the run is done.
    """
    run, how, rows, spreads = runner.record, runner.settings, list[Array](), list[Array]()
    given = runner.signals
    runner.loosen(begin.slack)
    logs: list[Array] = []
    runner.want(over.times, dense=over.times is None)
    clock = time.perf_counter()
    with showing(progress, runner.model.name) as show, runner.interruptible():
        stops = [*given.corners(over.start, over.end), over.end]
        answer = runner.start(over.start, begin.x, stops)
        for said in runner.slices() if answer >= 0 else ():
            answer = said
            if answer != abi.MORE:
                rows.append(runner.rows[: run.count].copy())
                spreads.append(runner.spreads[: run.count].copy())
                logs.append(runner.drained())
                run.count = 0
            done = abs(run.t - over.start) / over.length
            if case is not None and done < 0.5:
                reconsider(case, runner, over, begin.x)
            show(min(1.0, done))
    milliseconds = 1e3 * (time.perf_counter() - clock)
    width = 1 + runner.n + run.nr + runner.model.ns + run.nlam
    table = np.concatenate(rows) if rows else np.empty((0, width))
    if not len(table):
        table = _first_row(runner, over, begin)
    status, message = explain(runner, answer, over)
    statistics = {
        "steps": run.steps,
        "rejections": run.rejections,
        "evaluations": run.evaluations,
        "looked": run.looked,
        "limited": run.limited,
        "jacobians": run.jacobians,
        "factorizations": run.factorizations,
        "projections": run.projections,
        "passed": run.passed,
        "events": run.occurred,
        "milliseconds": milliseconds,
    }
    defaulted = (*begin.defaulted, *given.defaulted)
    initial = begin.named(runner.model)
    initial |= {n: float(table[0, 1 + runner.n + k]) for k, n in enumerate(runner.model.inputs)}
    conduct = Conduct(
        how.method.name,
        how.words,
        initial,
        defaulted,
        status,
        message,
        dict(statistics),
        remark(how.method.name, run, JACOBIAN in runner.model.manifest["available"]) or how.reason,
    )
    log = np.concatenate([*logs, runner.drained()])
    return _trajectory(runner, table, spreads if over.times is None else None, log, conduct)


def _first_row(runner: Runner | PlainRunner, over: Span, begin: Start) -> Array:
    """The start alone, for a run that broke down there."""
    rest = np.zeros(runner.n - len(begin.x))
    modes, none = runner.model._layout.start("s"), np.zeros(runner.record.nlam)
    known = [np.array([over.start]), begin.x, rest, runner.signals.constants, modes, none]
    return np.concatenate(known)[None, :]


def _trajectory(
    runner: Runner | PlainRunner,
    table: Array,
    spreads: list[Array] | None,
    log: Array,
    conduct: Conduct,
) -> Trajectory:
    model, n, end = runner.model, runner.n, 1 + runner.n + runner.model.nr
    t, y, r = table[:, 0].copy(), table[:, 1 : 1 + n], table[:, 1 + n : end].copy()
    s, lam = table[:, end : end + model.ns], table[:, end + model.ns :]
    quaternions = tuple(model.manifest["quaternions"])
    dense = None
    if spreads and len(t) > 1:
        charted = runner.settings.method.charted
        dense = Dense(t, y, np.concatenate(spreads)[1:], quaternions, charted)
    return Trajectory(
        t=t,
        x=y[:, : model.nx].copy(),
        r=r,
        given=y[:, model.nx :].copy(),
        sources=runner.sources if runner.powered else None,
        manifest=model.manifest,
        conduct=conduct,
        model=model,
        dense=dense,
        inputs_at=runner.signals.recorded(t, r).at,
        ledger=runner.ledger,
        stored={"multipliers": lam.copy()} if runner.record.nlam else {},
        happened=Happened(s.copy(), runner.may.rows, log),
    )
