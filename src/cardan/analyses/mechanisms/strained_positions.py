"""Records of positions of least strain energy."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ...arrays import Array
from ...errors import ModelError, SolveWarning, brief, near, warn
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.trajectory.solver_info import FINISHED
from ..simulation.progress import Show
from ..statics.continuation_step import first
from ..statics.equilibrium import read
from ..statics.load_path import TIME, Loading
from ..statics.static_problem import Load, Problem
from ..statics.strain_energy import (
    EnergyPath,
    LeastEnergy,
    least_energy,
    path_of_least_energy,
    position,
    rates,
    saddle_warning,
)
from ..systems import dynamic_system_of
from ..systems.dynamic_system import DynamicSystem
from .assembly import AssemblyRecord
from .mechanism import Mechanism
from .sweep import SweepRecord, driver_slopes, driver_values

INTERRUPTED, SINGULAR = "interrupted", "singular"
MOST_NAMED = 3  # motions that nothing resists


def _prescribed_load(
    system: DynamicSystem, named: Mapping[str, object], t: float, r: object
) -> Load:
    """What is held, checked: coordinates with numbers."""
    for name in named:
        if name not in system.places:
            raise ModelError(
                f"by='strain_energy': '{name}' is not a coordinate that can be held; frames and "
                f"joints with several coordinates are not either.{near(name, system.places)}"
            )
    return read(system, named, r, None, t)


def assemble_by_strain_energy(
    model: LoadedModel, targets: Mapping[str, object], start: object, t: float, r: object
) -> AssemblyRecord:
    """The position of least strain energy next to a start, with coordinates held.

    Args:
        model: The compiled model.
        targets, start, t, r: As ``assemble`` takes them.
    """
    system = dynamic_system_of(model, strain=True)
    problem, load = Problem(system), _prescribed_load(system, targets, t, r)
    search = least_energy(problem, load, start)
    place = first(problem, search, load)
    solution = position(problem, load, place)
    _warn_of_freedoms(system, solution)
    q = search.point.at.q
    return AssemblyRecord(
        model=model,
        t=load.t,
        r=load.r,
        q=q,
        u=np.zeros(model.nu),
        udot=None,
        gaps={} if model.manifest.absolute else Mechanism(model, load.t, load.r).gaps(q),
        unreached={},
        freedoms=len(place.stability.free_motions),
        solutions=None,
        starts=1,
        energy=solution.energy,
        holding_forces=solution.forces,
    )


def _warn_of_freedoms(system: DynamicSystem, solution: LeastEnergy) -> None:
    """Warn of motions along which the energy does not change."""
    free = list(dict.fromkeys(solution.stability.free_motions))
    if free:
        named = " and ".join(free[:MOST_NAMED]) + " and more" * (len(free) > MOST_NAMED)
        warn(
            f"by='strain_energy': nothing that is strained resists {named} of '{system.name}', "
            "where the position is one of many. Hold a coordinate of it, or add a spring",
            SolveWarning,
        )


def sweep_by_strain_energy(
    model: LoadedModel,
    driver: object,
    values: object,
    locked: object,
    start: object,
    rate: float,
    t: float,
    r: object,
    snap: bool,
    show: Show,
) -> SweepRecord:
    """Positions of least strain energy over values of drivers, each next to the one before.

    Args:
        model: The compiled model.
        driver, values, locked, start, rate, t, r, snap: As ``sweep`` takes them.
        show: Called with the part that is done.
    """
    system = dynamic_system_of(model, strain=True)
    kinds = dict.fromkeys(system.places, "locked") | dict.fromkeys(model.inputs, "input")
    kinds |= dict.fromkeys(model.parameters, "parameter") | {TIME: "t"}
    drivers = driver_values(driver, values, [*kinds], model)
    if not isinstance(locked, Mapping | None):
        raise ModelError(f"sweep: locked={brief(locked)}: give coordinates with their values")
    prescribed = tuple(name for name in drivers if kinds[name] == "locked")
    base = _prescribed_load(system, dict(locked or {}), t, r)
    twice = {n: np.repeat(c, 2) if len(c) == 1 else c for n, c in drivers.items()}
    count = len(next(iter(drivers.values())))
    stations = np.linspace(0, 1, count) if count > 1 else np.zeros(1)
    constant = Load(base.t, base.r, base.parameters, base.locked, prescribed=prescribed)
    way = Loading(system, constant, twice, {name: kinds[name] for name in drivers}, stations)
    problem = Problem(system)
    path = path_of_least_energy(problem, way, start, snap, show)
    _warn_of_freedoms(system, path.rows[0])
    message = saddle_warning(system, way, path)
    if message:
        warn(message, SolveWarning)
    slopes = rate * driver_slopes(np.stack([*drivers.values()], axis=1))
    return _record(model, problem, way, path, drivers, slopes)


def _record(
    model: LoadedModel,
    problem: Problem,
    way: Loading,
    path: EnergyPath,
    drivers: Mapping[str, Array],
    slopes: Array,
) -> SweepRecord:
    rows = path.rows
    count = len(rows)
    speeds = [
        rates(problem, way, row, dict(zip(drivers, slope.tolist(), strict=True)))
        for row, slope in zip(rows, slopes, strict=False)
    ]
    names = list(rows[0].forces)
    status = SINGULAR if path.failure else FINISHED
    return SweepRecord(
        model,
        {name: column[:count] for name, column in drivers.items()},
        t=np.array([row.load.t for row in rows]),
        r=np.array([row.load.r for row in rows]).reshape(count, model.nr),
        q=np.array([row.point.at.q for row in rows]),
        u=np.array(speeds),
        udot=np.zeros((count, 0)),
        quality=np.array([row.stability.least for row in rows]),
        status=INTERRUPTED if path.interrupted else status,
        message=path.failure or "reached all values",
        energy=np.array([row.energy for row in rows]),
        holding_forces={n: np.array([row.forces[n] for row in rows]) for n in names},
        n_negative=np.array([row.stability.negative for row in rows], dtype=np.intp),
        snaps=tuple(path.snaps),
    )
