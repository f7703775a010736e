"""Measurements over the fitted motion as a picture."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ...arguments import checked
from .record import FitRecord

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@checked
def plot(fit: FitRecord, path: str | Path | None = None) -> Figure:
    """Measured samples over the fitted motion, and residuals beside them, as a Matplotlib figure.

    Args:
        fit: The fit.
        path: Picture file; the ending says the format.

    Raises:
        ModelError: no picture file. ModuleNotFoundError: no Matplotlib.
    """
    from ...view.plot import done, empty

    figure = empty((11, 2.4 * len(fit.measured) + 0.6))
    axes = figure.subplots(len(fit.measured), 2, sharex=True, squeeze=False, width_ratios=(2, 1))
    for (curves, misfit), (name, values) in zip(axes, fit.measured.items(), strict=True):
        residuals = fit.residuals[name]
        present = np.isfinite(residuals)
        curves.plot(fit.t, values, ".", markersize=3, label="measured", color="C1")
        computed = values[present] - residuals[present]
        curves.plot(fit.t[present], computed, linewidth=1.2, label="fitted", color="C0")
        misfit.plot(fit.t, residuals, ".", markersize=3, color="C1")
        misfit.axhline(0.0, linewidth=0.8, color="C0")
        curves.set_ylabel(name, parse_math=False)
        for axis in (curves, misfit):
            axis.grid(alpha=0.3)
    axes[0, 0].legend(fontsize="small", ncols=2, loc="upper right")
    axes[0, 1].set_title("measured less fitted", fontsize="small")
    for axis in axes[-1]:
        axis.set_xlabel("t [s]")
    return done(figure, f"{fit.model.name}: {fit.message}", path)
