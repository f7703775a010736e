"""Runs from their arguments to the motion: their setup, their runner, its way to the end."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Protocol

from ...arguments import Inputs
from ...errors import FunctionError, ModelError, SolveError, SolveWarning, warn
from ...processes import collector_paused
from ...records import dataclass
from ...runtime.calls.interpreted import CURE
from ...runtime.models.constraint_projection import Closing
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.trajectory.trajectory import TrajectoryRecord
from ...schema.functions import OF_ELEMENTS
from ...schema.integrators import INTEGRATORS
from ...schema.manifest import Manifest
from . import run_record as abi
from .alpha_methods import Alpha, GeneralizedAlpha
from .discontinuities import stops_of
from .energy_accounting import excess
from .events import NOTHING, EventTable, check_start, event_table_of
from .files.run_file import RunFile
from .linear_limits import excesses
from .method_choice import JACOBIAN, Case, choose, reconsider
from .method_requirements import suited
from .outcome import explain
from .progress import showing
from .recorder import Recorder, can_wait
from .run import ROWS, Runner
from .settings import Settings, Start, Values, blocks, settings, start, watched
from .signals import Signals, signals
from .spare_runners import spare
from .starts.start import closed_start
from .starts.strain_limits import folded
from .times import Span, span

# method, rtol, atol, step and max_step
Options = tuple[str | GeneralizedAlpha | Alpha, float, float | None, float | None, float | None]
Terms = tuple[Span, EventTable, Signals, Settings, Case | None]
LARGE = 1600  # pairs of speeds, as in a chain of 40: more are derived for minutes


class RowStore(Protocol):
    """What looks after the rows of a run, where not all of them stay.

    Attributes:
        capacity: Rows until they are taken.
    """

    @property
    def capacity(self) -> int: ...

    def begin(self, recorder: Recorder) -> None:
        """The run has begun."""

    def look(self, recorder: Recorder, answer: int) -> None:
        """Rows were taken, after the kernels gave an answer."""


@dataclass(frozen=True)
class RunSetup:
    """A run that is about to begin.

    Attributes:
        model, how, input_signals, event_table, over, begin: What runs, from when to when.
        case: Facts for the choice of the method, where nobody chose one.
    """

    model: LoadedModel
    how: Settings
    input_signals: Signals
    event_table: EventTable
    over: Span
    begin: Start
    case: Case | None

    @property
    def run(self) -> tuple[LoadedModel, Settings, Signals, EventTable, Span, Start]:
        """Everything but the case."""
        return (
            *(self.model, self.how, self.input_signals, self.event_table),
            *(self.over, self.begin),
        )


@collector_paused()
def run_setup(
    model: LoadedModel,
    times: tuple[object, object],
    state: Mapping[str, object] | None,
    events: Mapping[str, object] | None,
    options: Options,
    inputs: Inputs | None,
    parameters: Values | None,
    sample: float | None = None,
) -> RunSetup:
    """The run that arguments of :func:`simulate` speak of.

    Args:
        model, events, inputs, parameters, sample: As there.
        times: t and t_eval.
        state: x0, q, u and z by name; None of several runs, each of which has its own.
        options: method, rtol, atol, step and max_step.
    """
    model = model if parameters is None else model.with_parameters(parameters)
    plain = events is None and inputs is None and sample is None and times[1] is None
    if plain and type(times[0]) in (int, float):
        over, event_table, input_signals, how, case = _request(model, times[0], options)
    else:
        over, event_table, input_signals, how, case = _terms(
            model, times, events, options, inputs, sample
        )
    begin = start(model, *(state[name] if state else None for name in ("x0", "q", "u", "z")))
    if state is not None:
        begin = beginning(model, begin, state, over.start, input_signals)
    return RunSetup(model, how, input_signals, event_table, over, begin, case)


def _terms(
    model: LoadedModel,
    times: tuple[object, object],
    events: Mapping[str, object] | None,
    options: Options,
    inputs: Inputs | None,
    sample: float | None,
) -> Terms:
    """What a run is to do, whatever its start."""
    method, rtol, atol, step, max_step = options
    over = span(*times)
    event_table = event_table_of(model, events)
    event_table.forward(over.start, over.end)
    input_signals = signals(model.manifest.inputs, inputs, sample, (over.start, over.end))
    how = settings(method, rtol, atol, step, max_step, over.length)
    how = watched(how, input_signals, over.length, max_step)
    case = case_of(model, rtol, over, input_signals, event_table) if method == "auto" else None
    return over, event_table, input_signals, how, case


def _request(model: LoadedModel, end: object, options: Options) -> Terms:
    """The same of a run to an end with nothing besides: asked for again it is at hand.

    The model keeps the last one, if there is nothing in it that a run changes.
    """
    key = (end, *options)
    latest = model._derived.get(Terms)
    if latest is not None and latest[0] == key:
        terms: Terms = latest[1]
        return terms
    terms = _terms(model, (end, None), None, options, None, None)
    if not model.manifest.events and not model.manifest.ticks:
        terms[2].constants.flags.writeable = False
        model._derived[Terms] = key, terms
    return terms


def beginning(
    model: LoadedModel, begin: Start, state: Mapping[str, object], t: float, input_signals: Signals
) -> Start:
    """The start of a run at which loops are closed, of one by what was named: x0, q and u."""
    r = input_signals.first(t)
    begin = closed_start(model, begin, *blocks(state["x0"], state["q"], state["u"]), t, r)
    check_start(model, begin.x, t, r)
    return begin


def case_of(
    model: LoadedModel,
    rtol: float,
    over: Span | None,
    input_signals: Signals,
    event_table: EventTable,
) -> Case:
    """Facts from which ``method="auto"`` chooses, for a run of some length, or of none known."""
    periods = [float(tick.period) for tick in event_table.ticks]
    if input_signals.functions and input_signals.sample is not None:
        periods.append(input_signals.sample)
    return Case(
        rtol=rtol,
        period=min(periods, default=None),
        length=None if over is None else over.length,
        derived=JACOBIAN in model.manifest.available,
        input_functions=bool(input_signals.functions),
        elements=model.manifest.absolute,
        flexible=bool(model.manifest.beams or model.manifest.superelements),
    )


def chosen(how: Settings, case: Case | None) -> Settings:
    """Settings with the method of a choice, if there is one."""
    if case is None:
        return how
    rule = choose(case)
    return how.by(INTEGRATORS[rule.method], rule.why)


def runner_of(
    model: LoadedModel, how: Settings, input_signals: Signals, event_table: EventTable = NOTHING
) -> Runner:
    """The runner of a model.

    Raises:
        ModelError: the model lacks a function that the method or its events need.
    """
    method, description = suited(model, how.method)
    if method is not how.method or description:
        listed = [text for text in (description, how.description) if text]
        how = replace(how, method=method, description=", ".join(listed))
    how = _without_costly(model, how)
    # an idle runner with the same settings saves allocating and connecting one
    left = spare(model, how, input_signals, event_table)
    if left is not None:
        return left
    available = model.manifest.available
    power = "power" in available
    needs = [(f"method '{how.method.name}'", name) for name in how.method.needs]
    needs += [("a run with events", name) for name in event_table.functions]
    for what, name in needs:
        if name not in available:
            cure = f"cd.compile(..., functions=[..., '{name}'])"
            cure = model.manifest.absent.get(name, cure)
            if model.manifest.absolute and name not in OF_ELEMENTS:
                cure = "absolute coordinates offer none; method='GeneralizedAlpha' needs none"
            raise ModelError(
                f"{what} needs the function '{name}', which model '{model.name}' lacks: {cure}"
            )
    called = ["rhs", *(["power"] if power else []), *Closing.of(model).functions]
    called += [name for _, name in needs]
    # side by side, as all must be compiled; by energy is told what the run cannot account for
    model.prepare(*called, *(["energy"] if power and "energy" in available else []))
    runner = Runner(model, how, input_signals, power, event_table)
    if runner.interpreted:
        description = f"{how.description}, the model in Python as there is no C compiler: {CURE}"
        runner.settings = replace(how, description=description)
    return runner


def driven(
    runner: Runner,
    over: Span,
    begin: Start,
    progress: bool | Callable[[float], None] | None,
    case: Case | None = None,
    file: RunFile | None = None,
    dense: bool = True,
    store: RowStore | None = None,
) -> TrajectoryRecord:
    """Drive the run to its end and collect what came out.

    Args:
        store: What looks after the rows, where not all of them stay.

    Raises:
        Limited: another method would be chosen, and less than half of the run is done.
        FunctionError: a function of the caller raised; it has the motion until then.
        SolveError: there is no memory for its rows.
    """
    recorder, problem, full = Recorder(runner), None, False
    runner.loosen(begin.closure_tol)
    most = ROWS if store is None else store.capacity
    inside = dense and over.times is None
    later = inside and store is None and can_wait(runner)
    runner.want(over.times, dense=inside, most=most, later=later)
    clock = time.perf_counter()
    with showing(progress, runner.model.name) as show, runner.interruptible():
        try:
            answer = _loop(runner, over, begin, recorder, show, case, file, store)
        except FunctionError as raised:
            answer, problem = abi.INPUT, raised
            recorder.take()
        except MemoryError:
            # told below, where what was half done has gone
            answer, full = abi.SIZE, True
    milliseconds = 1e3 * (time.perf_counter() - clock)
    outcome = ("function_failed", str(problem)) if problem else explain(runner, answer, over)
    if file is not None and answer == abi.STOPPED:
        outcome = outcome[0], f"{outcome[1]} in {file.path}, and the same call goes on from there"
    motion = None
    # out of memory: drop rows until what was computed fits
    while motion is None:
        outcome = recorder.halt(over) if full else outcome
        try:
            motion = recorder.motion(over, begin, outcome, milliseconds)
        except MemoryError:
            full = True
    # of runs that serve a search nobody asks what became of the energy
    missed = excess(motion, runner.settings, begin.closure_tol, runner.library) if dense else ""
    motion = (
        replace(motion, solver_info=replace(motion.solver_info, warning=missed))
        if missed
        else motion
    )
    if problem is not None:
        problem.motion = motion
        raise problem
    return motion


def _loop(
    runner: Runner,
    over: Span,
    begin: Start,
    recorder: Recorder,
    show: Callable[[float], None],
    case: Case | None,
    file: RunFile | None,
    store: RowStore | None,
) -> int:
    """Go on until the run is over. Returns the last answer of the kernels."""
    stops = stops_of(runner.model, runner.signals, over.start, over.end, more=over.stops)
    answer = runner.start(over.start, begin.x, stops)
    if store is not None and answer >= 0 and answer != abi.STOPPED:
        store.begin(recorder)
    if file is not None and answer >= 0:
        answer_saved = file.go_on(runner, recorder)
        if answer_saved in (abi.DONE, abi.EVENT):
            return answer_saved
    for said in runner.slices() if answer >= 0 and answer != abi.STOPPED else ():
        answer = said
        if answer != abi.MORE:
            recorder.take()
            if store is not None:
                store.look(recorder, answer)
        if file is not None:
            file.note(runner, recorder, answer)
        done = abs(runner.record.t - over.start) / over.length
        if case is not None and done < 0.5:
            reconsider(case, runner, over, begin.x)
        show(min(1.0, done))
    return answer


def speed_pairs(manifest: Manifest) -> int:
    """Pairs of speeds of which one moves what the other moves: entries of M that are not 0."""
    size = {row.child: row.u[1] for row in manifest.joints if row.u is not None}
    parent = {row.child: row.parent for row in manifest.joints}
    count = 0
    for body, speeds in size.items():
        count += speeds * speeds
        above, visited = parent.get(body), {body}
        while above is not None and above not in visited:
            visited.add(above)
            count += 2 * speeds * size.get(above, 0)
            above = parent.get(above)
    return count


def _without_costly(model: LoadedModel, how: Settings) -> Settings:
    """Settings of a method that differences what a large model would derive for minutes."""
    costly = [name for name in how.method.differenced if name in how.method.needs]
    if not costly or speed_pairs(model.manifest) <= LARGE:
        return how
    needs = tuple(name for name in how.method.needs if name not in costly)
    description = f"{how.description}, {' and '.join(costly)} by differences as the model is large"
    return replace(how, method=replace(how.method, needs=needs), description=description)


def reported(motion: TrajectoryRecord, check: bool) -> TrajectoryRecord:
    """The motion, with warnings of an early end and of what it cannot account for."""
    said = [] if motion.success else [motion.message]
    said += [motion.solver_info.warning] if motion.solver_info.warning else []
    bent = folded(motion.model, motion.x) if said and motion.model else ""
    said = [f"{text}. {bent}" if bent else text for text in said]
    if said and check:
        raise SolveError("; ".join(said))
    for text in said:
        warn(text, SolveWarning)
    # which is no matter of the tolerance
    for text in excesses(motion):
        warn(text, SolveWarning)
    return motion
