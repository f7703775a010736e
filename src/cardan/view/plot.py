"""Histories over time as a picture."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..arguments import checked
from ..atomic_file import folder, replaced
from ..errors import ModelError, brief, listed, near
from ..runtime.trajectory.histories import units_of
from ..runtime.trajectory.trajectory import TrajectoryRecord

if TYPE_CHECKING:
    from matplotlib.figure import Figure

POINTS = 1500
CURVES = 12  # a panel with more names them no longer
MARKS = "os^vD<>Pp*Xh"
Curve = NDArray[np.float64]
Panels = list[tuple[str, dict[str, Curve]]]


@checked
def plot(
    motion: TrajectoryRecord, path: str | Path | None = None, names: Iterable[str] | None = None
) -> Figure:
    """Histories over time as a Matplotlib figure, written to ``path`` if given.

    Args:
        motion: The motion.
        path: Picture file; the ending says the format.
        names: What to draw, such as ``["elbow", "elbow.u"]``; all coordinates, all speeds and the
            energies by default.

    Raises:
        ModelError: unknown names, no picture file. ModuleNotFoundError: no Matplotlib.
    """
    chosen = None if names is None else checked_names(names)
    motion = _smooth(motion)
    panels = _everything(motion) if chosen is None else _chosen(motion, chosen)
    stepwise = {str(row.name) for row in motion.manifest.s}
    return _figure(str(motion.manifest.name), "t [s]", motion.t, panels, path, stepwise)


def plot_against(
    motion: TrajectoryRecord, against: str, names: Iterable[str], path: str | Path | None
) -> Figure:
    """Draw entries of a motion against another one, one panel each: orbits in the state space.

    Args:
        motion: The motion.
        against: What is along the axis: a history of one number.
        names: What to draw.
        path: Picture file, or None.

    Raises:
        ModelError: unknown names, no picture file. ModuleNotFoundError: no Matplotlib.
    """
    chosen, motion = checked_names(names), _smooth(motion)
    over = np.asarray(motion[against])
    if over.ndim != 1:
        raise ModelError(f"plot: against='{against}' has several numbers; name one of them")
    unit = units_of(motion).get(against)
    label = f"{against} [{unit}]" if unit else against
    return _figure(str(motion.manifest.name), label, over, _chosen(motion, chosen), path)


def plot_over(
    title: str, label: str, over: Curve, curves: dict[str, Curve], path: str | Path | None
) -> Figure:
    """Draw curves over a coordinate, one panel each.

    Args:
        title, label: Headline and what is along the axis.
        over: Along the axis (n,).
        curves: Name -> values (n,) or (n, k).
        path: Picture file, or None.

    Returns:
        The Matplotlib figure.
    """
    panels = [(name, _columns(name, np.asarray(values))) for name, values in curves.items()]
    return _figure(title, label, over, panels, path)


def checked_names(names: object) -> list[str]:
    """Names of histories to draw; one alone stands for itself.

    Raises:
        ModelError: they are not names, or there are none.
    """
    entries = listed("plot: names", names, "elbow")
    if not entries:
        raise ModelError("plot: names is empty; leave it out to draw everything")
    return entries


def plot_points(title: str, points: Curve, path: str | Path | None) -> Figure:
    """Draw places (n, 3) from three sides.

    Returns:
        The Matplotlib figure.
    """
    figure = empty((12, 4.4))
    for axis, (i, j) in zip(figure.subplots(1, 3), ((0, 1), (0, 2), (1, 2)), strict=True):
        axis.plot(points[:, i], points[:, j], ".", markersize=2)
        axis.set_xlabel(f"{'xyz'[i]} [m]")
        axis.set_ylabel(f"{'xyz'[j]} [m]")
        axis.set_aspect("equal", adjustable="datalim")
        axis.grid(alpha=0.3)
    return done(figure, title, path)


def plot_lines(
    title: str, label: str, other: str, lines: dict[str, Any], path: str | Path | None
) -> Any:
    """Draw lines through points on logarithmic axes.

    Args:
        title: Headline.
        label, other: What is along the axes.
        lines: Name -> (values along, values up).
        path: Picture file, or None.

    Returns:
        The Matplotlib figure.
    """
    figure = empty((9, 5.4))
    axis = figure.subplots()
    for k, (name, (along, up)) in enumerate(lines.items()):
        axis.plot(along, up, MARKS[k % len(MARKS)] + "-", label=name, linewidth=1.2, markersize=4)
    axis.set(xlabel=label, ylabel=other)
    axis.grid(alpha=0.3)
    # logarithmic axes need a number to begin with
    if any(len(along) for along, _ in lines.values()):
        axis.set(xscale="log", yscale="log")
        axis.legend(fontsize="small", ncols=2)
    return done(figure, title, path)


def _figure(
    title: str,
    label: str,
    over: Curve,
    panels: Panels,
    path: str | Path | None,
    stepwise: Collection[str] = (),
) -> Figure:
    """Panels below each other, written to a file if there is one; what is held as stairs."""
    figure = empty((9, 2.4 * len(panels) + 0.6))
    axes = np.atleast_1d(figure.subplots(len(panels), 1, sharex=True))
    for axis, (name, curves) in zip(axes, panels, strict=True):
        for curve, values in curves.items():
            style = "steps-post" if curve in stepwise else "default"
            axis.plot(over, values, label=curve, linewidth=1.2, drawstyle=style)
        axis.set_ylabel(name)
        axis.grid(alpha=0.3)
        if 0 < len(curves) <= CURVES:
            axis.legend(fontsize="small", ncols=2, loc="upper right")
    axes[-1].set_xlabel(label)
    return done(figure, title, path)


def empty(size: tuple[float, float]) -> Figure:
    """An empty figure.

    Raises:
        ModuleNotFoundError: Matplotlib is not installed.
    """
    try:
        from matplotlib.figure import Figure
    except ModuleNotFoundError as missing:
        raise ModuleNotFoundError("plot needs Matplotlib: pip install 'cardan[plot]'") from missing
    return Figure(figsize=size, layout="constrained")


def done(figure: Figure, title: str, path: str | Path | None) -> Figure:
    """The figure with its headline, written to a file if there is one.

    Raises:
        ModelError: no path, or one whose ending says no format.
    """
    # a title is a name, and a dollar sign in it none of a formula
    figure.suptitle(title, parse_math=False)
    if path is None:
        return figure
    if not isinstance(path, str | PathLike):
        raise ModelError(
            f"plot({brief(path)}): the first argument is the picture file; give names="
        )
    file, formats = Path(path), figure.canvas.get_supported_filetypes()
    ending = file.suffix[1:].lower()
    if ending and ending not in formats:
        raise ModelError(f"plot: '{file}' has no ending of a picture.{near(ending, formats)}")
    folder(file)
    with replaced(file) as new:
        figure.savefig(new, dpi=130, format=ending or None)
    return figure


def _smooth(motion: TrajectoryRecord) -> TrajectoryRecord:
    """The motion with points between its rows, where it knows them: curves, not polygons."""
    # without the model, energies are known at the rows of the file alone
    if motion.dense is None or motion.model is None or len(motion.t) >= POINTS:
        return motion
    dense_times = np.linspace(motion.t[0], motion.t[-1], POINTS)
    times = np.unique(np.concatenate([motion.t, dense_times]))
    return motion.resample(times if motion.t[-1] >= motion.t[0] else times[::-1])


def _everything(motion: TrajectoryRecord) -> Panels:
    """Coordinates by unit, speeds by unit, energies."""
    panels: Panels = []
    for letter, values in (("q", motion.q), ("u", motion.u)):
        by_unit: dict[str, dict[str, NDArray[np.float64]]] = {}
        for k, row in enumerate(motion.manifest.block(letter)):
            by_unit.setdefault(row.unit, {})[row.name] = values[:, k]
        panels += [(f"[{unit}]" if unit else "", curves) for unit, curves in by_unit.items()]
    available = motion.model is not None and "energy" in motion.model.manifest.available
    if available or "kinetic" in motion.stored:
        panels.append(("energy [J]", dict(motion.energy._asdict())))
    return panels


def _chosen(motion: TrajectoryRecord, names: list[str]) -> Panels:
    """One panel for every name asked for; a block of several entries shares one."""
    units = units_of(motion)
    labels = {name: f"{name} [{units[name]}]" if units.get(name) else name for name in names}
    return [(label, _columns(name, np.asarray(motion[name]))) for name, label in labels.items()]


def _columns(name: str, values: Curve) -> dict[str, Curve]:
    if values.ndim == 1:
        return {name: values}
    return {f"{name}[{k}]": values[:, k] for k in range(values.shape[1])}
