"""Cycles as pictures and pages: one period of the motion."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from ...arguments import checked
from ...runtime.trajectory.trajectory import TrajectoryRecord
from ...view import page as pages
from ...view.page import Page
from ...view.plot import plot as plot_histories
from ...view.plot import plot_against
from .cycle_record import CycleRecord

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def motion(cycle: CycleRecord) -> TrajectoryRecord:
    """The motion over a period; with a symmetry over one lap."""
    return cycle.problem.motion(cycle.at)


@checked
def plot(
    cycle: CycleRecord,
    path: str | Path | None = None,
    names: Iterable[str] | None = None,
    *,
    against: str | None = None,
) -> Figure:
    """The motion over a period as a Matplotlib figure, written to ``path`` if given.

    ``cycle.plot("orbit.png", "elbow.u", against="elbow")`` is the orbit in the state space.

    Args:
        cycle: The cycle.
        path: Picture file; the ending says the format.
        names: What to draw, such as ``["elbow", "elbow.u"]``; by default all coordinates, all
            speeds and the energies over time, against another one all speeds.
        against: What is along the horizontal axis, such as ``"elbow"``; the time by default.

    Raises:
        ModelError: unknown names, no picture file. ModuleNotFoundError: no Matplotlib.
    """
    if against is None:
        return plot_histories(cycle.motion, path, names)
    return plot_against(cycle.motion, against, cycle.model.speeds if names is None else names, path)


@checked
def animate(
    cycle: CycleRecord,
    path: str | Path | None = None,
    *,
    show: str | Sequence[str] | None = None,
    plots: str | Sequence[str] | None = None,
    follow: str | None = None,
    traces: str | Sequence[str] = (),
    meshes: str | float | bool = "auto",
    page: str = "3d",
    fps: float = 60.0,
    title: str | None = None,
) -> Page:
    """A self-contained page that plays a period of the motion in any browser.

    Args:
        cycle: The cycle.
        path, show, plots, follow, traces, meshes, page, fps, title: As
            :meth:`.Trajectory.animate`.

    Returns:
        The page; ``.path`` is its file. Without a path it is opened, or shown in a notebook.

    Raises:
        ModelError, ArgumentError: as :meth:`.Trajectory.animate`.
    """
    return pages.animate(
        cycle.motion, path, show=show, plots=plots, follow=follow, traces=traces, meshes=meshes,
        page=page, fps=fps, title=title,
    )  # fmt: skip
