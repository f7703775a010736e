"""Starts of paths of cycles: at a cycle, at rest, at a period doubling."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ...errors import ModelError, SolveError, brief
from ...runtime.models.loaded_model import LoadedModel
from ..continuation.family import along_parameter, row
from ..continuation.follow import Place, place
from ..continuation.record import SpecialPointRecord
from ..continuation.singular_point import half_branches, singular_point
from ..continuation.solutions import PathRequest
from ..continuation.special_points import HOPF, Test
from ..linear.mode_shapes import Mode
from ..statics.load_path import Loading
from .cycle_family import CycleFamily, CyclePoint, place_of, problem_and_way
from .cycle_problem import CycleProblem, CycleState
from .cycle_record import CycleRecord
from .energy_level import ENERGY
from .section import section_of
from .shooting import Phase, Shooting, solve
from .small_cycles import from_equilibrium, from_mode

DOUBLING = "period doubling"
ENERGIES = 9  # from that of a cycle to another one
CURE = (
    "start= takes the cycle that model.cycle(...) returns, a special point at which some begin, or "
    "a mode, model.modes()[0]"
)


def family_and_place(model: LoadedModel, request: PathRequest) -> tuple[CycleFamily, Place, Test]:
    """The family of a path, its first place, and where it ends.

    Raises:
        ModelError: nothing to start from, unknown names. SolveError: no cycle at the start.
    """
    if request.q is not None or request.locked or request.u:
        raise ModelError(f"continuation of cycles: q=, u= and locked= are of equilibria; {CURE}")
    begin = request.start
    if _model_of(begin) not in (None, model._objects):
        raise ModelError(f"continuation of cycles: start= is of another model than '{model.name}'")
    if isinstance(begin, CycleRecord):
        problem, way = problem_and_way(_with_energy(begin.problem, begin.at), begin.model, request)
        family, at = _at_range_start(problem, way, begin.at)
        first = place(family, family.point(at, 0.0), along_parameter(family))
    elif isinstance(begin, SpecialPointRecord) and isinstance(begin.solution, CycleRecord):
        family, first = _from_doubling(begin, begin.solution, request)
    elif isinstance(begin, SpecialPointRecord) and begin.kind == HOPF:
        family, first = from_equilibrium(model, begin, request)
    elif isinstance(begin, Mode):
        family, first = from_mode(begin, request)
    else:
        raise ModelError(f"continuation: start={brief(begin)}: {CURE}")
    named = ", ".join(f"{name} = {value:.10g}" for name, value in family.way.values(1.0).items())
    return family, first, Test.at(named, 1.0, family)


def _model_of(begin: object) -> object:
    """The compiled code of what a path starts from, with any parameters; None of something else."""
    if isinstance(begin, SpecialPointRecord):
        return begin.branch.model._objects
    if isinstance(begin, Mode):
        return begin.modes.model._objects
    return begin.model._objects if isinstance(begin, CycleRecord) else None


def _with_energy(problem: CycleProblem, at: CycleState) -> CycleProblem:
    """The problem with the energy of a cycle, where energy is kept."""
    level = problem.level
    if level is None:
        return problem
    return replace(problem, level=replace(level, value=level.target(at.values)))


def _at_range_start(
    problem: CycleProblem, way: Loading, at: CycleState
) -> tuple[CycleFamily, CycleState]:
    """The family, and the cycle at the start of the range.

    Raises:
        SolveError: there is none next to the cycle that is started from.
    """
    at = replace(at, values=way.values(0.0))
    at, phase = _peak(problem, at) if problem.free_period else (at, None)
    shooting = Shooting(problem, phase)
    if problem.level is not None and ENERGY in way.swept:
        at = _at_energy(shooting, at, problem.level.value)
    solution = solve(shooting, at)
    if not solution.converged:
        values = ", ".join(f"{name} = {value:.6g}" for name, value in way.values(0.0).items())
        raise SolveError(
            f"continuation of cycles: no cycle was reached at {values}, where the range starts; "
            "start it where the cycle of start= is"
        )
    return CycleFamily.of(problem, way, phase), solution.at


def _at_energy(shooting: Shooting, at: CycleState, energy: float) -> CycleState:
    """A start near to the cycle with the energy that is wanted, by those in between."""
    last = at.values[ENERGY]
    for share in np.linspace(0, 1, ENERGIES)[1:-1]:
        values = {**at.values, ENERGY: energy + float(share) * (last - energy)}
        at = solve(shooting, replace(at, values=values)).at
    return replace(at, values={**at.values, ENERGY: last})


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
    along = row(family, place(family, point, along_parameter(family)).tangent)[0]
    half = min(halves, key=lambda half: abs(float(half.tangent @ along)))
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
    problem, way = problem_and_way(cycle.problem, cycle.model, request)
    if begin.kind != DOUBLING or set(way.swept) != set(before.way.swept):
        raise ModelError(
            f"continuation of cycles: start={begin.name!r}: paths begin at period doublings, along "
            f"what was swept before: {', '.join(before.way.swept)}"
        )
    family = CycleFamily.of(problem, way, before.shooting.phase)
    s = place_of(way, begin.values)
    return doubled(family, family.point(begin.special.place.point.at, s))
