"""Where paths of cycles start: at a cycle, at a Hopf point of equilibria, at a period doubling."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from ...arrays import Array
from ...errors import ModelError, SolveError, brief
from ...runtime.models.loaded_model import LoadedModel
from ..continuation.family import row
from ..continuation.follow import Place, Reach, place
from ..continuation.path_request import PathRequest
from ..continuation.record import SpecialPointRecord
from ..continuation.singular_point import half_branches, singular_point
from ..continuation.special_points import HOPF, Test
from ..simulation.settings import settings
from ..statics.equilibrium import read
from ..statics.load_path import Loading, loading
from ..statics.statics import sweepable
from ..systems import dynamic_system_of
from .cycle_family import CycleFamily, CyclePoint
from .cycle_problem import CycleProblem, CycleState
from .cycle_record import CycleRecord
from .section import section_of
from .shooting import Phase, Shooting, solve

DOUBLING = "period doubling"
EARLY = 0.1  # of a range, within which its first cycle lies
SMALLER = 8  # times that the first step becomes shorter
NEWTON, CONVERGED = 12, 1e-7  # corrections, the last of which is that small beside the step
CURE = (
    "start= takes the cycle that model.cycle(...) returns, or a special point at which some begin"
)


def family_and_place(model: LoadedModel, request: PathRequest) -> tuple[CycleFamily, Place, Test]:
    """The family of a path, its first place, and where it ends.

    Raises:
        ModelError: nothing to start from, unknown names. SolveError: no cycle at the start.
    """
    if request.q is not None or request.locked:
        raise ModelError(f"continuation of cycles: q= and locked= are of equilibria; {CURE}")
    begin = request.start
    if _model_of(begin) not in (None, model._objects):
        raise ModelError(f"continuation of cycles: start= is of another model than '{model.name}'")
    if isinstance(begin, CycleRecord):
        problem, way = _problem_and_way(begin.problem, begin.model, request)
        family, at = _at_range_start(problem, way, begin.at)
        first = place(family, family.point(at, 0.0), family.along_parameter)
    elif isinstance(begin, SpecialPointRecord) and isinstance(begin.solution, CycleRecord):
        family, first = _from_doubling(begin, begin.solution, request)
    elif isinstance(begin, SpecialPointRecord) and begin.kind == HOPF:
        family, first = _from_equilibrium(model, begin, request)
    else:
        raise ModelError(f"continuation: start={brief(begin)}: {CURE}")
    named = ", ".join(f"{name} = {value:.10g}" for name, value in family.way.values(1.0).items())
    return family, first, Test(named, lambda at: at.point.s - 1.0, ends=True)


def _model_of(begin: object) -> object:
    """The compiled code of what a path starts from, with any parameters; None of something else."""
    if isinstance(begin, SpecialPointRecord):
        return begin.branch.model._objects
    return begin.model._objects if isinstance(begin, CycleRecord) else None


def _problem_and_way(
    problem: CycleProblem, model: LoadedModel, request: PathRequest
) -> tuple[CycleProblem, Loading]:
    """The problem with what stays, and what is swept."""
    model = model.with_parameters(dict(request.parameters)) if request.parameters else model
    system = dynamic_system_of(model)
    kinds = {name: kind for name, kind in sweepable(model).items() if kind != "t"}
    base = read(system, {}, None, None, problem.t)
    way = loading(system, kinds, base, request.swept, {}, "continuation")
    if way.stations is not None:
        raise ModelError("continuation: give (start, end) of what is swept, and no values within")
    inputs = {**problem.inputs, **(request.inputs or {})}
    return replace(problem, model=model, system=system, inputs=inputs, _flows={}), way


def _at_range_start(
    problem: CycleProblem, way: Loading, at: CycleState
) -> tuple[CycleFamily, CycleState]:
    """The family, and the cycle at the start of the range.

    Raises:
        SolveError: there is none next to the cycle that is started from.
    """
    at = replace(at, values=way.values(0.0))
    at, phase = _peak(problem, at) if problem.free_period else (at, None)
    solution = solve(Shooting(problem, phase), at)
    if not solution.converged:
        values = ", ".join(f"{name} = {value:.6g}" for name, value in way.values(0.0).items())
        raise SolveError(
            f"continuation of cycles: no cycle was reached at {values}, where the range starts; "
            "start it where the cycle of start= is"
        )
    return CycleFamily.of(problem, way, phase), solution.at


def _peak(problem: CycleProblem, at: CycleState) -> tuple[CycleState, Phase]:
    """The place of a cycle at which the coordinate that moves most turns back, as the phase.

    Along a path a plane across the flow of one cycle may come to lie along that of another one.
    """
    system, nu = problem.system, problem.model.nu
    motion = problem.motion(at)
    steps = np.array([problem.step(at.x, x) for x in motion.x])
    k = int(np.ptp(steps[:, :nu], axis=0).argmax())
    speed = problem.model.speeds[k]
    section = section_of(problem.model, ((speed, 0.0), "down"), None, 1)
    crossings = replace(problem, section=section, _flows={}).flow(at.values)
    rates = steps[:, nu + k] + problem.model.parts_of(at.x)[1][k] / problem.units[nu + k]
    turns = rates.min() < 0 < rates.max() and system.increments[k] in system.coordinates
    passage = None
    if turns:
        end = problem.t + 2 * at.period
        match = section.counter(problem.t, 0.0)
        passage = crossings.passage(at.x, at.s, problem.t, end, match)
    if passage is None:
        rate = problem.rate(at)
        return at, Phase(at.x, rate / np.linalg.norm(rate))
    return replace(at, x=passage.x, s=passage.s), Phase(
        passage.x, np.eye(len(problem.units))[nu + k]
    )


def doubled(family: CycleFamily, point: CyclePoint) -> tuple[CycleFamily, Place]:
    """The cycles of twice the laps that begin at a period doubling, and the first of them.

    Raises:
        SolveError: they were not told from the others.
    """
    problem = replace(family.problem, laps=2 * family.problem.laps, _flows={})
    twice = CycleFamily.of(problem, family.way, family.shooting.phase)
    at = replace(point.at, period=2 * point.at.period)
    halves = half_branches(singular_point(twice, CyclePoint(point.s, at), 1))
    if not halves:
        raise SolveError("continuation of cycles: those of twice the period were not found")
    # the others are the path that it leaves
    along = row(family, place(family, point, family.along_parameter).tangent)[0]
    cosines = [abs(float(half.tangent @ along)) for half in halves]
    half = halves[int(np.argmin(cosines))]
    return twice, place(twice, half.point, half.direction)


def _from_doubling(
    begin: SpecialPointRecord, cycle: CycleRecord, request: PathRequest
) -> tuple[CycleFamily, Place]:
    """The same for what a path sweeps.

    Raises:
        ModelError: it is not what was swept before.
    """
    before = begin.branch.solutions.family
    assert isinstance(before, CycleFamily)
    problem, way = _problem_and_way(cycle.problem, cycle.model, request)
    if begin.kind != DOUBLING or set(way.swept) != set(before.way.swept):
        raise ModelError(
            f"continuation of cycles: start={begin.name!r}: paths begin at period doublings, along "
            f"what was swept before: {', '.join(before.way.swept)}"
        )
    family = CycleFamily.of(problem, way, before.shooting.phase)
    s = _place_of(way, begin.values)
    return doubled(family, family.point(begin.special.place.point.at, s))


def _place_of(way: Loading, values: Mapping[str, float]) -> float:
    """The place of swept values on a way."""
    (name, ends), *_ = way.swept.items()
    return float((values[name] - ends[0]) / (ends[-1] - ends[0]))


def _from_equilibrium(
    model: LoadedModel, begin: SpecialPointRecord, request: PathRequest
) -> tuple[CycleFamily, Place]:
    """The small cycles around an equilibrium that begin at a Hopf point.

    Raises:
        SolveError: there are none.
    """
    moment = begin.special.place.point.point.at
    changed = model.with_parameters(dict(moment.parameters)) if moment.parameters else model
    system, frequency = dynamic_system_of(changed), begin.frequency
    units = np.concatenate(
        [system.columns, frequency * system.columns, np.ones(len(system.internals))]
    )
    inputs = dict(zip(system.inputs, moment.r.tolist(), strict=True))
    how = settings("DOP853", 1e-13, 1e-15, None, None, None)
    problem = CycleProblem(
        changed,
        system,
        how,
        inputs,
        moment.t,
        100 * 2 * np.pi / frequency,
        None,
        None,
        None,
        1,
        units,
    )
    problem, way = _problem_and_way(problem, changed, request)
    problem = replace(problem, inputs={n: v for n, v in inputs.items() if n not in way.swept})
    s = _place_of(way, begin.values)
    x = np.concatenate([moment.q, moment.u, moment.z])
    at = CycleState(x, moment.s, 2 * np.pi / frequency, way.values(s))
    nu, n = len(system.columns), len(units)
    DP = Shooting(problem, Phase(x, np.zeros(n))).jacobian(at)[:n, :n]
    plane = np.linalg.svd(DP)[2][-2:]
    k = int(np.linalg.norm(plane[:, :nu], axis=0).argmax())
    # where the coordinate that moves most turns back
    away: Array = plane[1, nu + k] * plane[0] - plane[0, nu + k] * plane[1]
    family = CycleFamily.of(problem, way, Phase(x, np.eye(n)[nu + k]))
    tangent = np.concatenate([away, np.zeros(2)])
    return family, _first_of(family, CyclePoint(s, at), tangent)


def _first_of(family: CycleFamily, rest: CyclePoint, tangent: Array) -> Place:
    """The first cycle of a path that begins at rest, so small that it is found.

    What is swept may change much faster than the motion grows: no more than a part of its range.

    Args:
        family: Of which.
        rest: The state that small cycles go around.
        tangent: The increment (N,) to them.

    Raises:
        SolveError: there is none.
    """
    tangent = tangent / np.sqrt(np.sum(family.weights * tangent**2))
    step = Reach().first
    for _ in range(SMALLER):
        try:
            point = _at_distance(family, rest, step * tangent)
            size = abs(point.s - rest.s)
        except SolveError:
            size = np.inf
        if size <= EARLY:
            return place(family, point, tangent)
        step *= 0.25
    raise SolveError("continuation of cycles: those that begin here were not found")


def _at_distance(family: CycleFamily, rest: CyclePoint, dz: Array) -> CyclePoint:
    """The cycle an increment away, up to what lies across it: by Newton's method.

    Raises:
        SolveError: it does not converge.
    """
    point, across = family.moved(rest, dz), row(family, dz / np.linalg.norm(dz))
    none = np.zeros((len(dz) - 1, 0))
    size, before = np.inf, np.inf
    for _ in range(NEWTON):
        bordered = family.jacobian(point, rough=True).bordered(across, none)
        correction = bordered.solve(-family.residual(point), np.zeros(1))[0]
        point, before = family.moved(point, correction), size
        size = float(np.linalg.norm(correction))
        if size < CONVERGED * float(np.linalg.norm(dz)):
            return point
        if not size < before:
            break
    raise SolveError("continuation of cycles: the corrections do not converge")
