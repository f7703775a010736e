"""Assembly: positions at which all loops close and targets are met, and consistent speeds."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike

from ...arguments import Count, Seed, checked
from ...arrays import Array
from ...errors import ArgumentError, ModelError
from ...runtime.calls.argument_values import numbers
from ...runtime.calls.evaluation import State
from ...runtime.models.initial import start_of
from ...runtime.models.loaded_model import LoadedModel
from .assembly import AssemblyRecord
from .assembly_diagnosis import actual_value, explain
from .branches import branches
from .consistent_rates import accelerations, speeds
from .mechanism import Mechanism, refuse_nodes
from .nearest_position import COST_TOL, choose, nearest
from .position_solver import Solution, missed
from .rounded_loops import closure_tolerance, rounded
from .searches import search
from .targets import Target, read

SAME = 1e-6  # positions nearer than this, without units, are one
STARTS = 16


@checked
def assemble_by_constraints(
    model: LoadedModel,
    targets: Mapping[str, object] | None = None,
    *,
    u: Mapping[str, object] | None = None,
    udot: Mapping[str, object] | None = None,
    weights: Mapping[str, float] | None = None,
    locked: Iterable[str] | None = None,
    branch: Mapping[str, object] | None = None,
    start: Mapping[str, ArrayLike] | ArrayLike | None = None,
    starts: Count = STARTS,
    seed: Seed = 0,
    t: float = 0.0,
    r: State | None = None,
) -> AssemblyRecord:
    """A position at which all loops close, next to a start, with some of it given.

    Args:
        model: The compiled model; without loops this is inverse kinematics.
        targets: Coordinate or joint -> value, frame -> its position (3,) or pose (4, 4) in the
            ground. All are held exactly but for those in ``weights``.
        u, udot: Given speeds and accelerations by name; the other speeds are those of least kinetic
            energy, the other accelerations those under the forces of the scene.
        weights: Target -> weight; such targets are met as well as the rest allows: the weighted sum
            of squares is least, lengths in sizes of the mechanism, angles in radians.
        locked: Names of the targets that are held, instead of all without a weight.
        branch: Coordinate -> ``"+"``, ``"-"`` or ``(low, high)``: which of several positions.
        start: Coordinates to start from, by name or (nq,); the position next to them is chosen.
        starts: Searches: the first from ``start``, the others from random coordinates.
        seed: Of the random ones.
        t, r: Time [s] and inputs, where something is prescribed.

    Raises:
        ModelError: the loops cannot be assembled, inconsistent targets, no position
            on the branch, unknown names.
        ArgumentError, SolveError: values of a wrong shape, or not finite.

    Warns:
        SolveWarning: two positions are equally near to the start; or Ctrl-C ended the searches
            once one had met the targets.
    """
    refuse_nodes(model, "assemble")
    m = Mechanism(model, t, r)
    goals, requested_branches = (
        read(m, targets or {}, weights, locked),
        branches(model, branch or {}),
    )
    if starts < 1:
        raise ModelError(f"starts={starts}: at least one search is needed")
    begin = _begin(model, start)
    angles = np.array([row.unit == "rad" for row in model.manifest.coordinates], dtype=bool)
    for goal in goals:
        # of angles that differ by full turns the one that was named
        if goal.kind == "coordinate":
            turns = np.round((goal.value - begin[goal.place]) / (2 * np.pi))
            begin[goal.place] += 2 * np.pi * turns * angles[goal.place]
    candidates = search(m, goals, begin, starts, seed)
    met = [one for one in candidates if one.met]
    if not met:
        candidates = rounded(m, goals, begin, starts, seed)
        met = [one for one in candidates if one.met]
    if not met:
        explain(m, goals, candidates, lambda n, some: search(n, some, begin, min(starts, 6), seed))
    different = _different(m, met)
    chosen = choose(m, different, requested_branches, begin)
    if not requested_branches and all(goal.weight is None for goal in goals):
        chosen = nearest(m, goals, begin, chosen)
    many = chosen.freedoms > sum(len(t.value) for t in goals if t.weight is not None)
    solutions = None if many and not any(t.weight is not None for t in goals) else len(different)
    return finish(m, goals, chosen, u or {}, udot or {}, solutions, len(candidates))


def _begin(model: LoadedModel, start: object) -> Array:
    """Coordinates to start from."""
    named = start if isinstance(start, Mapping) else {}
    if start is not None and not isinstance(start, Mapping):
        q = numbers("start", start)
        if q.shape != (model.nq,):
            raise ArgumentError(
                f"start has shape {q.shape}, expected ({model.nq},): {', '.join(model.coordinates)}"
            )
        named = dict(zip(model.coordinates, q.tolist(), strict=True))
    return start_of(model, named, {})[0][: model.nq]


def _different(m: Mechanism, solutions: Sequence[Solution]) -> list[Solution]:
    """Positions that are not the same up to whole turns; of equal ones the first."""
    different: list[Solution] = []
    for one in solutions:
        away = (
            np.abs(m.difference(k.q, m.nearest(one.q, k.q))).max(initial=0.0) for k in different
        )
        if not any(distance < SAME for distance in away):
            different.append(one)
    return different


def finish(
    m: Mechanism,
    targets: Sequence[Target],
    chosen: Solution,
    u: Mapping[str, object],
    udot: Mapping[str, object],
    solutions: int | None,
    starts: int,
) -> AssemblyRecord:
    """The record, with consistent speeds and accelerations."""
    model, q = m.model, chosen.q
    m.closure_tol = m.closure_tol or closure_tolerance(m, q)
    start_speeds = start_of(model, {}, {})[0][model.nq : model.nx - model.nz]
    velocities, rates = speeds(m, q, u, start_speeds), None
    if "forward_dynamics" in model.manifest.available:
        rates = accelerations(m, q, velocities, udot)
    elif udot:
        raise ModelError(
            "udot= needs the function 'forward_dynamics': compile(..., functions=[...])"
        )
    # weighted targets that the nearest position does not reach
    away = {t.name: t for t in targets if np.abs(missed(m, [t], q)).max() > COST_TOL}
    return AssemblyRecord(
        model=model,
        t=m.t,
        r=m.inputs,
        q=q,
        u=velocities,
        udot=rates,
        gaps=m.gaps(q),
        unreached={
            name: f"asked {t.description}, {actual_value(m, t, q)}" for name, t in away.items()
        },
        freedoms=chosen.freedoms,
        solutions=solutions,
        starts=starts,
    )
