"""Pages of single positions, and of positions over a load or a driver."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TypeAlias

import numpy as np

from ..arguments import checked
from ..arrays import Array
from ..errors import ArgumentError, ModelError, near
from ..runtime.trajectory.trajectory import TrajectoryRecord
from ..view.drawing import Abscissa, reaction_frames
from ..view.page import Page, page_of
from .continuation.record import BranchRecord, ContinuationRecord
from .mechanisms.assembly import AssemblyRecord
from .mechanisms.sweep import SweepRecord
from .statics.equilibrium import EquilibriumRecord
from .statics.static_path import StaticPathRecord

Positions: TypeAlias = (
    AssemblyRecord
    | BranchRecord
    | ContinuationRecord
    | EquilibriumRecord
    | StaticPathRecord
    | SweepRecord
)


@checked
def animate(
    result: AssemblyRecord
    | EquilibriumRecord
    | StaticPathRecord
    | SweepRecord
    | ContinuationRecord
    | BranchRecord,
    path: str | Path | None = None,
    *,
    show: str | Sequence[str] | None = None,
    plots: str | Sequence[str] | None = None,
    follow: str | None = None,
    traces: str | Sequence[str] = (),
    meshes: str | float | bool = "auto",
    page: str = "3d",
    title: str | None = None,
    branch: str = "main",
) -> Page:
    """A self-contained page of the positions, over the load or the driver where there are several.

    Args:
        result: The positions.
        branch: Of a continuation: the name of a branch.
        path, show, follow, traces, meshes, page, title: As :meth:`.Trajectory.animate`.
        plots: Names of histories below the picture, as ``result[name]``.

    Returns:
        The page; ``.path`` is its file. Without a path it is opened, or shown in a notebook.

    Raises:
        ModelError, ArgumentError: as :meth:`.Trajectory.animate`; or there are no positions, or
            histories of a single one.
    """
    if isinstance(result, ContinuationRecord):
        result = _branch(result, branch)
    rows, abscissa = _rows(result, "reactions" in (show or ()))
    if not rows:
        raise ArgumentError("animate: there are no positions to show")
    if plots and len(abscissa.values) == 1:
        raise ArgumentError("animate: plots= draws histories, which a single position has not")
    return page_of(
        rows, path, abscissa=abscissa, histories=result, show=show, plots=plots, follow=follow,
        traces=traces, meshes=meshes, page=page, title=title,
    )  # fmt: skip


def _branch(path: ContinuationRecord, name: str) -> BranchRecord:
    """A branch by its name.

    Raises:
        ModelError: there is none.
    """
    if name not in path.branches:
        raise ModelError(f"animate: there is no branch '{name}'.{near(name, path.branches)}")
    return path.branches[name]


def _rows(result: Positions, reactions: bool) -> tuple[list[TrajectoryRecord], Abscissa]:
    """A motion for every row, each with its own parameters, and what the rows stand for.

    Args:
        result: The positions.
        reactions: Whether those of equilibria are needed.
    """
    if isinstance(result, StaticPathRecord):
        name = next(iter(result.values), "s")
        values = result.values.get(name, result.s)
        # a path may turn back: then its own length counts
        if _turns_back(values):
            name, values = "s", result.s
        return [_of_equilibrium(row, reactions) for row in result.rows], Abscissa(
            np.asarray(values), name, ""
        )
    if isinstance(result, BranchRecord):
        name = next(iter(result.values))
        values = np.asarray(result.values[name])
        if _turns_back(values):
            name, values = "point", np.arange(len(result), dtype=np.float64)
        rows = [result[k] for k in range(len(result))]
        return [_of_solution(row, reactions) for row in rows], Abscissa(values, name, "")
    if isinstance(result, SweepRecord):
        drivers, model = result.drivers, result.model
        name = next(iter(drivers))
        x = np.concatenate([result.q, result.u], axis=1)
        swept = TrajectoryRecord.of_states(model, result.t, x, result.r, "sweep")
        units = {row.name: row.unit for row in model.manifest.coordinates}
        unit = "s" if name == "t" else units.get(name, "")
        values = np.asarray(drivers[name], dtype=np.float64)
        # so may a driver: then the rows are counted
        if _turns_back(values):
            name, unit, values = "row", "", np.arange(len(values), dtype=np.float64)
        return [swept], Abscissa(values, name, unit)
    assert isinstance(result, AssemblyRecord | EquilibriumRecord)
    return [_of_solution(result, reactions)], Abscissa(np.array([result.t]))


def _of_solution(one: object, reactions: bool) -> TrajectoryRecord:
    """A position or an equilibrium as a motion of one row.

    Raises:
        ModelError: it is a motion.
    """
    if isinstance(one, EquilibriumRecord):
        return _of_equilibrium(one, reactions)
    if not isinstance(one, AssemblyRecord):
        raise ModelError("animate: path[k].motion.animate() shows one of these motions")
    r = np.atleast_2d(one.r)
    return TrajectoryRecord.of_states(one.model, np.array([one.t]), one.x[None], r, "assembly")


def _turns_back(values: Array) -> bool:
    """True if values neither rise nor fall from row to row."""
    steps = np.diff(values)
    return bool(np.any(steps <= 0) and np.any(steps >= 0))


def _of_equilibrium(equilibrium: EquilibriumRecord, reactions: bool) -> TrajectoryRecord:
    """An equilibrium as a motion of one row."""
    model, t = equilibrium.model, np.array([equilibrium.t])
    motion = TrajectoryRecord.of_states(
        model,
        t,
        equilibrium.x[None],
        np.atleast_2d(equilibrium.load.r),
        equilibrium.message,
        equilibrium.point.at.s[None],
    )
    # with the forces that hold prescribed displacements
    for name in reaction_frames(model.manifest) if reactions else ():
        motion.stored[f"reaction {name}"] = equilibrium.reaction(name)[None]
    return motion
