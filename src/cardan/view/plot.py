"""Histories over time as a picture."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..runtime.trajectory import Trajectory

POINTS = 1500
CURVES = 12  # a panel with more names them no longer


def plot(motion: Trajectory, path: Path | None, names: Iterable[str] | None) -> Any:
    """Draw histories; see :meth:`cardan.runtime.trajectory.Trajectory.plot`.

    Returns:
        The Matplotlib figure.
    """
    try:
        from matplotlib.figure import Figure
    except ModuleNotFoundError as missing:
        raise ModuleNotFoundError(
            "motion.plot needs Matplotlib: pip install 'cardan[plot]'"
        ) from missing
    motion = _smooth(motion)
    panels = _everything(motion) if names is None else _chosen(motion, list(names))
    figure = Figure(figsize=(9, 2.4 * len(panels) + 0.6), layout="constrained")
    axes = np.atleast_1d(figure.subplots(len(panels), 1, sharex=True))
    for axis, (label, curves) in zip(axes, panels, strict=True):
        for name, values in curves.items():
            axis.plot(motion.t, values, label=name, linewidth=1.2)
        axis.set_ylabel(label)
        axis.grid(alpha=0.3)
        if 0 < len(curves) <= CURVES:
            axis.legend(fontsize="small", ncols=2, loc="upper right")
    axes[-1].set_xlabel("t [s]")
    figure.suptitle(str(motion.manifest["name"]))
    if path is not None:
        path.parent.mkdir(parents=True, exist_ok=True)
        figure.savefig(path, dpi=130)
    return figure


def _smooth(motion: Trajectory) -> Trajectory:
    """The motion with points between its rows, where it knows them: curves, not polygons."""
    if motion.dense is None or len(motion.t) >= POINTS:
        return motion
    between = np.linspace(motion.t[0], motion.t[-1], POINTS)
    times = np.unique(np.concatenate([motion.t, between]))
    return motion.resample(times if motion.t[-1] >= motion.t[0] else times[::-1])


Panels = list[tuple[str, dict[str, NDArray[np.float64]]]]


def _everything(motion: Trajectory) -> Panels:
    """Coordinates by unit, speeds by unit, energies."""
    panels: Panels = []
    for key, values in (("coordinates", motion.q), ("speeds", motion.u)):
        by_unit: dict[str, dict[str, NDArray[np.float64]]] = {}
        for k, row in enumerate(motion.manifest[key]):
            by_unit.setdefault(str(row["unit"]), {})[str(row["name"])] = values[:, k]
        panels += [(f"[{unit}]" if unit else "", curves) for unit, curves in by_unit.items()]
    available = motion.model is not None and "energy" in motion.model.manifest["available"]
    if available or "kinetic" in motion.stored:
        panels.append(("energy [J]", dict(motion.energy._asdict())))
    return panels


def _chosen(motion: Trajectory, names: list[str]) -> Panels:
    """One panel for every name asked for; a block of several entries shares one."""
    panels: Panels = []
    for name in names:
        values = np.asarray(motion[name])
        if values.ndim == 1:
            panels.append((name, {name: values}))
        else:
            columns = {f"{name}[{k}]": values[:, k] for k in range(values.shape[1])}
            panels.append((name, columns))
    return panels
