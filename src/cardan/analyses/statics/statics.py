"""Static loading: a system followed through loads that change.

What stops it is a limit point or a bifurcation, and is told so: the last position is kept. Where
the path goes on though it is no longer stable, that is told too.

Source: M. A. Crisfield, Non-linear Finite Element Analysis of Solids and Structures 1 (1991),
section 9.5 (automatic increments).
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...arguments import Count, LockedValues, checked
from ...arrays import Array
from ...errors import ModelError, SolveError, SolveWarning, warn
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.trajectory.solver_info import FINISHED
from ..systems import dynamic_system_of
from ..systems.dynamic_system import DynamicSystem
from .arc import follow_by_length
from .continuation_step import Crossing, Place, first
from .equilibrium import WAYS, EquilibriumRecord, missed, read, record
from .load_path import TIME, Loading, loading
from .newton import Search
from .path_following import follow
from .settling import settled
from .stability_at_equilibrium import largest_motions, lockable
from .static_path import StaticPathRecord
from .static_problem import Problem

STEPS = 10


@checked
def statics(
    model: Any,
    swept: Mapping[str, object] | None = None,
    *,
    steps: Count = STEPS,
    q: Mapping[str, ArrayLike] | ArrayLike | None = None,
    locked: LockedValues | None = None,
    inputs: Mapping[str, float] | None = None,
    parameters: Mapping[str, float] | None = None,
    t: float = 0.0,
    arc: bool = False,
    check: bool = False,
    **named: object,
) -> StaticPathRecord:
    """Equilibria under loads that change: ``model.statics(P=(0, 10))``.

    Args:
        model: The compiled model.
        swept, named: Parameter or input (or ``t``) -> (start, end), in steps of the program's
            choice, or values (n,), each of which becomes a row. Several go together.
        steps: Rows of a range, more where the way is hard.
        q: Coordinates to start from, by name or (nq,).
        locked: Coordinate -> value that it keeps, or what is swept: displacements are prescribed.
        inputs, parameters: Values by name that stay, else those of the model.
        t: Time [s], where something is prescribed.
        arc: Follow the path by its length, through limit loads, where the load turns back;
            :func:`cardan.analyses.continuation.continuation.continuation` also tells branches.
        check: Raise where the end is not reached, instead of warning.

    Returns:
        The path as far as it goes, or came before Ctrl-C. Where it became unstable a warning says
        so, between which loads; ``crossings`` and ``critical()`` tell the places.

    Raises:
        ModelError: unknown names, nothing swept. ArgumentError: values of a wrong shape.
        SolveError: no equilibrium at the start; with ``check``, none further on.
    """
    system = dynamic_system_of(model)
    if not isinstance(steps, int) or steps < 1:
        raise ModelError(f"statics: steps={steps!r}: a number of steps, at least 1")
    if not isinstance(locked, Mapping | None) or not isinstance(swept, Mapping | None):
        raise ModelError("statics: locked= and what is swept go by name, such as P=(0, 10)")
    moved = {n: v for n, v in (locked or {}).items() if np.ndim(v) > 0}
    still = {n: v for n, v in (locked or {}).items() if n not in moved}
    base = read(system, still, inputs, parameters, t)
    way = loading(system, sweepable(model), base, {**(swept or {}), **named}, moved, "statics")
    if arc and way.stations is not None:
        raise ModelError("statics: with arc=True give (start, end) of what is swept")
    rows, crossed = list[tuple[float, EquilibriumRecord]](), list[Crossing]()
    try:
        failure = _stopped_or_done(model, Problem(system), way, q, steps, arc, rows, crossed)
        status = "singular" if failure else FINISHED
    except KeyboardInterrupt:
        if not rows:
            raise
        status = "interrupted"
        failure = f"interrupted behind {_said(way, rows[-1][0])}; what was computed is kept"
    changed = _changed(system, way, crossed)
    path = StaticPathRecord.of(way, rows, crossed, status, failure)
    if failure and check:
        raise SolveError(failure)
    for said in filter(None, (changed, failure)):
        warn(said, SolveWarning)
    return path


def sweepable(model: Any) -> dict[str, str]:
    """Quantities that can be swept."""
    return {
        **dict.fromkeys(model.parameters, "parameter"),
        **dict.fromkeys(model.inputs, "input"),
        TIME: "t",
    }


def _stopped_or_done(
    model: LoadedModel,
    problem: Problem,
    way: Loading,
    q: object,
    steps: int,
    arc: bool,
    rows: list[tuple[float, EquilibriumRecord]],
    crossed: list[Crossing],
) -> str:
    """Note equilibria of the path and critical loads; why it ended early."""
    load = way.at(0.0)
    start = settled(problem, problem.begin(load, q), load, WAYS)
    if not start.converged:
        raise SolveError(
            f"statics, at the start ({_said(way, 0.0)}): {missed(problem.system, start, load)}"
        )

    def row(search: Search, place: Place) -> EquilibriumRecord:
        return record(model, problem, search, way.at(place.s), place.stability)

    begin = first(problem, start, load)
    rows.append((begin.s, row(start, begin)))
    if arc:
        return follow_by_length(model, problem, way, start, row, rows, crossed)
    end = follow(problem, way, begin, steps, row, rows, crossed)
    return "" if end is None else _stopped(problem.system, way, end.last, end.search, end.limit)


def _said(way: Loading, s: float) -> str:
    return ", ".join(f"{name} = {value:.6g}" for name, value in way.values(s).items())


def _stopped(
    system: DynamicSystem, way: Loading, last: Place, search: Search, limit: Place | None
) -> str:
    """Message about the end of a path, with reason and remedy."""
    moving = largest_motions(system, search.motion)
    where = f", along {moving}" if moving else ""
    # the reason is read off the stability of the last equilibrium
    beyond, end = _said(way, last.s), _said(way, 1.0)
    ended = f"no equilibrium next to the last one beyond {beyond} (asked: {end})"
    # a singular stiffness: a rigid-body motion that nothing restrains
    if last.stability.free_motions:
        free = " and ".join(last.stability.free_motions)
        name = lockable(system, search.motion, way.base.locked)
        cure = f", or lock it: locked={{'{name}': value}}" if name else ""
        return f"{ended}: nothing holds {free} there. Begin where loads or springs hold it{cure}"
    if limit is not None:
        return (
            f"{ended}: the stiffness gives way{where} at the limit point {_said(way, limit.s)}, "
            "the largest load that equilibria lead to. The path up to there is kept"
            f"{_onward(system, way, limit.stability.direction)}"
        )
    if not np.isfinite(last.stability.least):
        # nothing is left to have a stiffness
        modes = system.labels(last.point.at.s).items()
        by = ", ".join(f"'{name}' ({label})" for name, label in modes)
        along = f" along {moving}" if moving else ""
        return (
            f"{ended}: all motion is held there by {by or 'constraints'}, which bear no more"
            f"{along}. The path up to there is kept; from there on it moves: simulate()"
        )
    return (
        f"{ended}: the stiffness gives way there{where} (lowest eigenvalue "
        f"{last.stability.least:.3g} J): a limit point, a bifurcation, or the "
        "end of what the mechanism can reach. The path up to there is kept"
        f"{_onward(system, way, last.stability.direction)}"
    )


def _onward(system: DynamicSystem, way: Loading, motion: Array) -> str:
    """Advice on how to continue a path of loads, or of prescribed displacements."""
    prescribed = [name for name, kind in way.kinds.items() if kind == "locked"]
    name = lockable(system, motion, (*way.base.locked, *prescribed))
    if not name:
        return ""
    what = "another displacement leads" if prescribed else "prescribed displacements lead"
    return f"; {what} on: locked={{'{name}': (start, end)}}"


def _changed(system: DynamicSystem, way: Loading, crossed: list[Crossing]) -> str:
    """Message about changes of stability on a path that goes on; "" where there are none."""
    changed = [crossing for crossing in crossed if crossing.of == "held"]
    if not changed:
        return ""
    change = next((crossing for crossing in changed if crossing.lost), changed[0])
    said = [_change(system, way, change)]
    remaining = [crossing for crossing in changed if crossing is not change]
    if remaining:
        spans = "; ".join(_span(way, crossing) for crossing in remaining)
        said.append(f"Stability changes also between {spans}.")
    return " ".join([*said, "path.critical() finds the load" + ("s" if remaining else "")])


def _change(system: DynamicSystem, way: Loading, crossing: Crossing) -> str:
    """A change of stability, as sentences."""
    span = f"from a load between {_span(way, crossing)} on"
    moving = largest_motions(system, crossing.direction)
    frequency = crossing.stability_at(crossing.after).frequency
    sides = (crossing.side(place) for place in (crossing.before, crossing.after))
    if not crossing.lost:
        many = "{} instead of {}".format(*reversed([*sides]))
        return f"it stands more stably {span}: unstable in {many} directions along {moving}."
    if frequency:
        return (
            f"unstable {span}: forces that follow the motion feed an oscillation of "
            f"{frequency:.6g} rad/s, which grows (flutter). The path goes on as it began."
        )
    return (
        f"unstable {span}: the stiffness gives way along {moving}. The path goes on as it began, "
        "where the system would leave it; a small load aside, or a shape that is not perfect, "
        "leads onto the branch that it takes."
    )


def _span(way: Loading, crossing: Crossing) -> str:
    return f"{_said(way, crossing.before.s)} and {_said(way, crossing.after.s)}"
