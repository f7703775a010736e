"""Surfaces as pictures in perspective."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ..superelements.coarsening import coarsened
from .plot import done, empty
from .surfaces import DISPLACEMENT, DrawnSurface

if TYPE_CHECKING:
    from matplotlib.figure import Figure

MOST_TRIANGLES = 20_000  # that are drawn within seconds
MOST_LINES, MOST_POINTS = 20_000, 5_000
GRAY = "0.75"


def plot_surface(title: str, surface: DrawnSurface, path: str | Path | None) -> Figure:
    """Draw a surface in its first row, colored, and its undeformed outline.

    Returns:
        The Matplotlib figure.
    """
    figure = empty((8, 6))
    from matplotlib import colormaps
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Normalize
    from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection

    axes = figure.add_subplot(projection="3d")
    moved = surface.places(0)
    values = surface.values(0) if surface.kind else np.full(len(moved), np.nan)
    palette = colormaps["viridis"].with_extremes(bad=GRAY)
    colors = ScalarMappable(Normalize(0.0, surface.largest), palette)
    masked = np.ma.masked_invalid(values)
    if len(surface.triangles):
        rows = coarsened(surface.points, surface.triangles, MOST_TRIANGLES)
        paint = colors.to_rgba(masked[rows].mean(axis=1))
        # the color of the faces hides what rounding leaves between them
        axes.add_collection3d(Poly3DCollection(moved[rows], facecolors=paint, edgecolors=paint,
                                               linewidths=0.2, shade=False))  # fmt: skip
    else:
        ends = surface.lines[:MOST_LINES]
        if len(ends):
            paint = colors.to_rgba(masked[ends].mean(axis=1))
            axes.add_collection3d(Line3DCollection(moved[ends], colors=paint, linewidths=2.0))
        some = np.arange(0, len(moved), max(1, -(-len(moved) // MOST_POINTS)))
        axes.scatter(*moved[some].T, c=colors.to_rgba(masked[some]), s=8, depthshade=False)
    edges = surface.outline[:MOST_LINES]
    if len(edges):
        still = surface.places(0, deformed=False)[edges]
        axes.add_collection3d(Line3DCollection(still, colors="0.5", linewidths=0.6))
    every = np.vstack([moved, surface.places(0, deformed=False)])
    low, extent = every.min(axis=0), np.ptp(every, axis=0)
    # what is flat is drawn in a box that is not
    extent = np.maximum(extent, 0.1 * extent.max() or 1.0)
    middle = (low + every.max(axis=0)) / 2
    for k, letter in enumerate("xyz"):
        getattr(axes, f"set_{letter}lim")(middle[k] - extent[k] / 2, middle[k] + extent[k] / 2)
        getattr(axes, f"set_{letter}label")(f"{letter} [m]")
    axes.set_box_aspect(extent)
    if surface.kind:
        unit = "m" if surface.kind == DISPLACEMENT else "Pa"
        figure.colorbar(colors, ax=axes, label=f"{surface.colored_by} [{unit}]", shrink=0.7)
    return done(figure, title, path)
