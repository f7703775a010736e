"""Small cycles around a state of rest: at a Hopf point, and of a mode of what keeps its energy.

Source: A. M. Lyapunov, The General Problem of the Stability of Motion (1892): every mode whose
frequency is not a multiple of another one's continues as a family of cycles, by their energy.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ...arrays import Array
from ...errors import ModelError, SolveError, brief
from ...runtime.models.loaded_model import LoadedModel
from ..continuation.family import row
from ..continuation.follow import Place, Reach, place
from ..continuation.record import SpecialPointRecord
from ..continuation.solutions import PathRequest
from ..linear.mode_shapes import Mode
from ..simulation.settings import settings
from ..systems import dynamic_system_of
from ..systems.dynamic_system import Moment
from .cycle_family import CycleFamily, CyclePoint, place_of, problem_and_way
from .cycle_problem import CycleProblem, CycleState
from .energy_level import ENERGY, EnergyLevel
from .shooting import Phase, Shooting

EARLY = 0.1  # of a range, within which its first cycle lies
SMALLER = 8  # times that the first step becomes shorter
SIZES = 8  # units of cycles that are tried, each a tenth of those before
NEWTON, CONVERGED = 12, 1e-7  # corrections, the last of which is that small beside the step
PERIODS = 100  # within which a lap ends
UNDAMPED = 1e-9  # decay, as a part of the frequency, that is rounding
LOST = 1e-8  # of the energy: what a lap changes


def _problem_around(
    model: LoadedModel, moment: Moment, frequency: float, size: Array
) -> CycleProblem:
    """Cycles next to a state, in units of a motion.

    Args:
        model: Whose.
        moment: The state of rest.
        frequency: Of small cycles [rad/s].
        size: Of the motion, by speeds (nu,).
    """
    changed = model.with_parameters(dict(moment.parameters)) if moment.parameters else model
    system = dynamic_system_of(changed)
    units = np.concatenate([size, frequency * size, np.ones(len(system.internals))])
    inputs = dict(zip(system.inputs, moment.r.tolist(), strict=True))
    how = settings("DOP853", 1e-13, 1e-15, None, None, None)
    longest = PERIODS * 2 * np.pi / frequency
    return CycleProblem(
        changed, system, how, inputs, moment.t, longest, None, None, None, 1, units
    )  # fmt: skip


def from_equilibrium(
    model: LoadedModel, begin: SpecialPointRecord, request: PathRequest
) -> tuple[CycleFamily, Place]:
    """The small cycles around an equilibrium that begin at a Hopf point.

    Raises:
        SolveError: there are none.
    """
    columns = dynamic_system_of(model).columns
    # the first cycle is a part of the units: smaller ones until there is one of that size
    for k in range(SIZES - 1):
        try:
            return _of_size(model, begin, request, 0.1**k * columns)
        except SolveError:
            continue
    return _of_size(model, begin, request, 0.1 ** (SIZES - 1) * columns)


def _of_size(
    model: LoadedModel, begin: SpecialPointRecord, request: PathRequest, size: Array
) -> tuple[CycleFamily, Place]:
    """The same for motions of a size, by speeds (nu,).

    Raises:
        SolveError: there are none of that size.
    """
    moment: Moment = begin.special.place.point.point.at
    frequency = begin.frequency
    problem = _problem_around(model, moment, frequency, size)
    problem, way = problem_and_way(problem, problem.model, request)
    free = {n: v for n, v in problem.inputs.items() if n not in way.swept}
    problem = replace(problem, inputs=free)
    s, n, nu = place_of(way, begin.values), len(problem.units), len(size)
    x = np.concatenate([moment.q, moment.u, moment.z])
    at = CycleState(x, moment.s, 2 * np.pi / frequency, way.values(s))
    DP = Shooting(problem, Phase(x, np.zeros(n))).jacobian(at)[:n, :n]
    plane = np.linalg.svd(DP)[2][-2:]
    k = int(np.linalg.norm(plane[:, :nu], axis=0).argmax())
    # where the coordinate that moves most turns back
    away: Array = plane[1, nu + k] * plane[0] - plane[0, nu + k] * plane[1]
    family = CycleFamily.of(problem, way, Phase(x, np.eye(n)[nu + k]))
    tangent = np.concatenate([away, np.zeros(2)])
    return family, _first_of(family, CyclePoint(s, at), tangent)


def from_mode(mode: Mode, request: PathRequest) -> tuple[CycleFamily, Place]:
    """The small cycles that a mode is, of a system that keeps its energy.

    Raises:
        ModelError: something else than the energy is swept, it is not kept, or the mode does not
            oscillate. SolveError: no cycles were found.
    """
    modes, k = mode.modes, mode.number
    model, moment, frequency = modes.model, modes.at, float(modes.values[k].imag)
    _refuse(mode, request)
    highest = float(np.max(np.asarray(request.swept[ENERGY], dtype=np.float64)))
    if not highest > 0:
        raise ModelError(f"continuation of cycles: energy={request.swept[ENERGY]}: it is positive")
    columns, shape = dynamic_system_of(model).columns, np.asarray(modes.shapes[:, k], np.complex128)
    first = int(np.abs(shape / columns).argmax())
    shape = shape * shape[first].conjugate() / abs(shape[first])
    # modal mass is 1: the amplitude at the highest energy, if forces were linear
    largest = np.sqrt(2 * highest) / frequency * abs(shape[first]) / columns[first]
    problem = _problem_around(model, moment, frequency, largest * columns)
    x = np.concatenate([moment.q, moment.u, moment.z])
    problem = replace(problem, level=EnergyLevel(x, moment.s, highest, 0.0))
    problem, way = problem_and_way(problem, problem.model, request)
    s, nu, n = place_of(way, {ENERGY: 0.0}), len(columns), len(problem.units)
    at = CycleState(x, moment.s, 2 * np.pi / frequency, way.values(s))
    swing = np.concatenate([shape.real, (1j * frequency * shape).real]) / problem.units
    family = CycleFamily.of(problem, way, Phase(x, np.eye(n)[nu + first]))
    start = _first_of(family, CyclePoint(s, at), np.concatenate([swing, np.zeros(2)]))
    _refuse_losses(problem, start.point.at)
    return family, start


def _refuse(mode: Mode, request: PathRequest) -> None:
    """Refuse modes that are not families of cycles.

    Raises:
        ModelError: for each reason.
    """
    modes, k = mode.modes, mode.number
    model, value = modes.model, complex(modes.values[k])
    said = f"continuation of cycles: start= mode {k} of '{model.name}'"
    if set(request.swept) != {ENERGY} or ENERGY in (*model.parameters, *model.inputs):
        raise ModelError(
            f"{said}: cycles of a mode go by their energy: energy=(0, 1) [J] is what is swept, and "
            "no name of a parameter"
        )
    if request.parameters or request.inputs:
        raise ModelError(f"{said}: give parameters= and inputs to model.modes(...)")
    if not value.imag > 0:
        raise ModelError(f"{said}: it does not oscillate")
    if abs(value.real) > UNDAMPED * abs(value) or model.nz or model.ns:
        raise ModelError(
            f"{said}: only motions that keep their energy are families of cycles, without damping, "
            "internal states and modes of elements"
        )
    if "mass_matrix" not in model.manifest.available:
        raise ModelError(f"{said}: energies need its mass matrix, functions=('mass_matrix', ...)")


def _refuse_losses(problem: CycleProblem, at: CycleState) -> None:
    """Refuse forces that do not keep the energy.

    Raises:
        ModelError: a lap changes it.
    """
    motion = problem.motion(at)
    times = np.linspace(motion.t[0], motion.t[-1], 8)
    energies = [problem.energy(replace(at, x=x)) for x in motion.at(times)]
    if np.ptp(energies) > LOST * max(energies):
        raise ModelError(
            f"continuation of cycles: '{problem.model.name}' does not keep its energy: over a lap "
            f"it changes between {brief(min(energies))} J and {brief(max(energies))} J"
        )


def _first_of(family: CycleFamily, around: CyclePoint, tangent: Array) -> Place:
    """The first cycle of a path that begins at rest, so small that it is found.

    What is swept may change much faster than the motion grows: no more than a part of its range.

    Args:
        family: Of which.
        around: The state that small cycles go around.
        tangent: The increment (N,) to them.

    Raises:
        SolveError: there is none.
    """
    tangent = tangent / np.sqrt(np.sum(family.weights * tangent**2))
    step = Reach().first
    for _ in range(SMALLER):
        try:
            point = _at_distance(family, around, step * tangent)
            size = abs(point.s - around.s)
        except SolveError:
            size = np.inf
        if size <= EARLY:
            return place(family, point, tangent)
        step *= 0.25
    raise SolveError("continuation of cycles: those that begin here were not found")


def _at_distance(family: CycleFamily, around: CyclePoint, dz: Array) -> CyclePoint:
    """The cycle an increment away, up to what lies across it: by Newton's method.

    Raises:
        SolveError: it does not converge.
    """
    point, across = family.moved(around, dz), row(family, dz / np.linalg.norm(dz))
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
