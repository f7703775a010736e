"""Positions of least strain energy: kinematics of mechanisms whose members give way.

What is driven has its values; among the positions that the constraints allow, the others take one
at which the energy of springs, bushings, bars, cables and beams is least. Loads, weights and masses
have no part in it. A mechanism with more freedoms than drivers has a position all the same, one
that is held too often has the position that strains it least, and as members stiffen positions tend
to those of rigid links, by one over the stiffness.

A path of minima is followed until it ends, where the energy ceases to have a minimum next to it (a
fold) or where the minimum becomes a saddle (a branch point). From there the way leads downhill to
another minimum: the structure snaps.

Source: M. Géradin, A. Cardona, Flexible Multibody Dynamics (2001), chapters 7 (mechanisms with
flexible members) and 9 (paths of equilibria).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from ...arrays import Array
from ...errors import ModelError, SolveError, counted
from ...records import dataclass
from ..systems.dynamic_system import DynamicSystem
from .continuation_step import Crossing, Place, by_rate, first
from .equilibrium import WAYS, downhill
from .load_path import Loading
from .newton import Search, equilibrium_search
from .path_following import EarlyEnd, follow
from .snap import Snap
from .stability_at_equilibrium import Stability, largest_motions, stand
from .static_problem import Load, Point, Problem

NEAR = 0.3  # of the reach: a minimum no farther from the start is taken without going downhill
BEYOND = 1e-6  # of a path: how far behind a fold the way downhill begins
SHORT_STEPS = 10  # a measure of short steps between two values
STEP = 1e-5  # of the values of the drivers, over which forces are differentiated


@dataclass(frozen=True, eq=False)
class LeastEnergy:
    """A position at which the strain energy is stationary under what is held.

    Attributes:
        s: Its place on a path, 0 to 1.
        point, load: The position with its forces, and what is held.
        stability: Inertia of the stiffness on what constraints and held values allow.
        energy: Of all strains [J].
        forces: Held coordinate -> force that holds it [N, N m]: the derivative of the
            energy by its value.
    """

    s: float
    point: Point
    load: Load
    stability: Stability
    energy: float
    forces: Mapping[str, float]


@dataclass(frozen=True, eq=False)
class EnergyPath:
    """Positions of least strain energy along a path.

    Attributes:
        rows: The positions.
        crossings: Where the energy ceases to be least, or begins to be.
        snaps: Jumps to other minima.
        failure: Why it ended early; "" where it did not.
        interrupted: Whether Ctrl-C ended it.
    """

    rows: list[LeastEnergy]
    crossings: list[Crossing]
    snaps: list[Snap]
    failure: str
    interrupted: bool = False


def least_energy(problem: Problem, load: Load, start: object) -> Search:
    """A position at which the strain energy is least, next to a start.

    Args:
        problem, load: Of a system of strains alone, and what is held.
        start: Coordinates by name or (nq,), None for the initial position.

    Raises:
        ModelError: nothing is strained, or loops that cannot be assembled.
        SolveError: no minimum was found.
    """
    system, begin = problem.system, problem.begin(load, start)
    _refuse_rigid(problem, begin, load)
    search = equilibrium_search(problem, begin, load, WAYS[:1])
    if not _is_near_minimum(problem, begin, search, load):
        other = equilibrium_search(problem, begin, load, ("creep",))
        search = other if other.converged or not search.converged else search
        if not search.converged:
            search = equilibrium_search(problem, begin, load, WAYS[1:3])
        search = downhill(problem, search, load) if search.converged else search
    if not search.converged:
        raise SolveError(_unreachable(system, search, load))
    stability = stand(problem, search.point, load)
    if stability.negative:
        raise SolveError(
            "no position of least strain energy next to the start: the search ends at a saddle, "
            f"from where the energy falls along {largest_motions(system, stability.direction)}. "
            "Start elsewhere (start=)"
        )
    return search


def _is_near_minimum(problem: Problem, begin: Point, search: Search, load: Load) -> bool:
    if not search.converged or stand(problem, search.point, load).negative:
        return False
    way = problem.step(begin, search.point)[0]
    return float(np.abs(way).max(initial=0.0)) <= NEAR * problem.system.reach


def _refuse_rigid(problem: Problem, begin: Point, load: Load) -> None:
    """Raises:
    ModelError: neither force nor stiffness of any strain.
    """
    at = replace(begin.at, lam=0 * begin.at.lam)
    bare = Point(at, 0 * begin.reaction_forces)
    stiffness = problem.system.tangents(at).K
    if not abs(stiffness).max() and not problem.residual(bare, load)[0].any():
        raise ModelError(
            f"by='strain_energy': nothing of '{problem.system.name}' is strained or stiff there. "
            "Springs, bushings, flexible hinges, taut cables and beams store strain energy; "
            "forces by expressions do not (SpringDamper, JointSpring say the same as elements). "
            "Without any, take by='constraints'"
        )


def _unreachable(system: DynamicSystem, search: Search, load: Load) -> str:
    """Message about values at which no position was found."""
    moving = largest_motions(system, search.motion)
    where = f", moving {moving} most," if moving else ""
    values = ", ".join(f"{name} = {value:.6g}" for name, value in load.locked.items())
    return (
        f"no position of least strain energy with {values or 'nothing held'}: the search left"
        f"{where} after {counted(search.iterations, 'iteration')}. The constraints may not reach "
        "these values, or nothing strained holds a part, such as a node of a slack cable. Give "
        "other values, or start= nearer"
    )


def position(problem: Problem, load: Load, place: Place) -> LeastEnergy:
    """The record of a place of a path."""
    system, point = problem.system, place.point
    tau = problem.locked_forces(point, load)[1]
    forces = {name: float(tau[system.place(name)[1]]) for name in load.locked}
    energy = system.strain_energy(point.at)
    return LeastEnergy(place.s, point, load, place.stability, energy, forces)


def path_of_least_energy(
    problem: Problem, way: Loading, start: object, snap: bool, show: object = None
) -> EnergyPath:
    """Positions of least strain energy at the stations of a path.

    Args:
        problem, way: Of a system of strains alone, and what drives it.
        start: Coordinates next to those of the first position.
        snap: Go on from the minimum downhill where a path of minima ends.
        show: Called with the part that is done.
    """
    load = way.at(0.0)
    search = least_energy(problem, load, start)
    here = first(problem, search, load)
    path = EnergyPath([position(problem, load, here)], [], [], "")
    rows: list[tuple[float, LeastEnergy]] = []

    def row(_: Search, place: Place) -> LeastEnergy:
        if callable(show):
            show(place.s)
        return position(problem, way.at(place.s), place)

    def leaves(place: Place) -> bool:
        return snap and place.stability.negative > 0

    failure, interrupted = "", False
    try:
        while True:
            end = follow(
                problem, way, here, SHORT_STEPS, row, rows, path.crossings, leaves, by_rate
            )
            if end is None:
                break
            there = _snapped(problem, way, end) if snap else None
            if there is None:
                failure = _lost(problem.system, way, end, snap)
                break
            path.snaps.append(_snap(problem, way, end, there))
            here = there
            if way.stations is not None and here.s in way.stations:
                rows.append((here.s, row(search, here)))
    except KeyboardInterrupt:
        failure, interrupted = "interrupted; what was computed is kept", True
    path.rows.extend(one for _, one in rows)
    return replace(path, failure=failure, interrupted=interrupted)


def _snapped(problem: Problem, way: Loading, end: EarlyEnd) -> Place | None:
    """The minimum downhill from the end of a path; None where there is none, or no path left."""
    last = end.last if end.limit is None else end.limit
    s = min(1.0, last.s + (0.0 if last.stability.negative and end.limit is None else BEYOND))
    load = way.at(s)
    begin = problem.under(last.point, load)
    search = equilibrium_search(problem, begin, load, ("creep",))
    if not search.converged:
        return None
    search = downhill(problem, search, load)
    place = replace(first(problem, search, load), s=s)
    moved = search.converged and not place.stability.negative
    # where the path ends for want of positions the way down leads nowhere
    return place if moved and s > end.last.s - BEYOND else None


def _snap(problem: Problem, way: Loading, end: EarlyEnd, there: Place) -> Snap:
    last = end.last if end.limit is None else end.limit
    energies = [problem.system.strain_energy(one.point.at) for one in (last, there)]
    return Snap(
        way.values(last.s), last.point.at.q, there.point.at.q, float(energies[0] - energies[1])
    )


def _lost(system: DynamicSystem, way: Loading, end: EarlyEnd, snap: bool) -> str:
    """Message about the end of a path."""
    last = end.last if end.limit is None else end.limit
    moving = largest_motions(system, last.stability.direction)
    where = ", ".join(
        f"'{name}' = {value:.6g} (of {way.values(1.0)[name]:g})"
        for name, value in way.values(last.s).items()
    )
    along = f" along {moving}" if moving else ""
    if end.limit is None:
        return (
            f"the sweep stops at {where}: no position next to the last one was found{along}. The "
            "constraints may not reach further, or the energy changes too fast: take more values"
        )
    if snap:
        return (
            f"the sweep stops at {where}: the minimum of the strain energy ends there{along}, and "
            "the way downhill leads to no other"
        )
    return (
        f"the sweep stops at {where}: the minimum of the strain energy ends there{along}, and a "
        "structure would snap to another one. snap=True goes on from that"
    )


def saddle_warning(system: DynamicSystem, way: Loading, path: EnergyPath) -> str:
    """Message about positions at which the energy is not least; "" without any."""
    lost = [one for one in path.crossings if one.of == "held" and one.lost]
    if not lost or path.snaps:
        return ""
    values = ("{}".format(", ".join(f"{n} = {v:.6g}" for n, v in way.values(one.s).items()))
              for one in (lost[0].before, lost[0].after))  # fmt: skip
    moving = largest_motions(system, lost[0].direction)
    return (
        f"from {' to '.join(values)} on the strain energy is not least: it falls along {moving}. "
        "The sweep keeps its branch of stationary positions (minimum tells which rows are "
        "minima); snap=True follows minima instead"
    )


def rates(problem: Problem, way: Loading, row: LeastEnergy, slopes: Mapping[str, float]) -> Array:
    """Speeds (nu,) of a path through a position.

    Args:
        problem, way: Of what, how it is driven.
        row: The position.
        slopes: Driver -> its rate.
    """
    system, values, sides = problem.system, way.values(row.s), []
    for sign in (1, -1):
        # forces depend on what is held through the position alone
        moved = {
            name: np.array([value + sign * STEP * slopes[name] * (way.kinds[name] != "locked")] * 2)
            for name, value in values.items()
        }
        load = replace(way, swept=moved, stations=None).at(0.0)
        sides.append(problem.residual(problem.under(row.point, load), load))
    force, gap = ((b - a) / (2 * STEP) for b, a in zip(*sides, strict=True))
    for k, name in enumerate(row.load.locked, start=len(system.rows)):
        if name in values:
            gap[k] = -slopes[name] / system.columns[system.place(name)[1]]
    try:
        K, G = problem.tangent(row.point, row.load)
        step = system.saddle.solve(K, G, -force, -gap)[0]
    except SolveError:
        # where a path turns back there is no rate
        return np.full(len(system.columns), np.nan)
    speeds: Array = step * system.columns
    return speeds
