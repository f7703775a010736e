"""Paths and their branches as a picture: unstable parts are thin and dashed."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from scipy.interpolate import CubicSpline

from ...arguments import checked
from ...arrays import Array
from .record import BranchRecord, ContinuationRecord
from .special_points import BRANCH, EVENT, FOLD, HOPF

if TYPE_CHECKING:
    from matplotlib.figure import Figure

DENSE = 20  # drawn points of a step
SAME = 1e-4  # distance of points that are one, as a part of the picture
MARKERS = {FOLD: "v", BRANCH: "D", HOPF: "o", EVENT: "|"}
OTHER = "s"  # other changes of stability


@checked
def plot(path: ContinuationRecord, along: str, up: str, file: str | Path | None = None) -> Figure:
    """Draw a path and its branches as a Matplotlib figure, written to ``file`` if given.

    Unstable solutions are thin and dashed, all else are lines; special points carry their names.

    Args:
        path: The path.
        along, up: Names of the histories on the axes, such as ``"P"`` and ``"elbow"``.
        file: Picture file; the ending says the format.

    Raises:
        ModelError: unknown names, or a file that is not a picture.
        ModuleNotFoundError: Matplotlib is not installed (extra ``plot``).
    """
    from ...view.plot import done, empty

    figure = empty((8, 5.4))
    axis = figure.subplots()
    for number, branch in enumerate(path.branches.values()):
        for x, y, stable in _curves(branch, along, up):
            style, width = ("-", 1.8) if stable else ("--", 1.0)
            axis.plot(x, y, style, color=f"C{number % 10}", linewidth=width)
    size, labels = np.maximum(axis.dataLim.size, 1e-300), list[Array]()
    for point in (point for branch in path.branches.values() for point in branch.points):
        at = np.array([point[along], point[up]])
        # where branches meet the first one names the point
        if any((np.abs(at - label) < SAME * size).all() for label in labels):
            continue
        labels.append(at)
        axis.plot(*at, MARKERS.get(point.kind, OTHER), color="black", markersize=5)
        axis.annotate(
            point.name, (at[0], at[1]), (4, 4), textcoords="offset points", fontsize=8,
            parse_math=False,
        )  # fmt: skip
    axis.set_xlabel(along, parse_math=False)
    axis.set_ylabel(up, parse_math=False)
    axis.grid(alpha=0.3)
    return done(figure, path.model.name, file)


def _curves(branch: BranchRecord, along: str, up: str) -> list[tuple[Array, Array, bool]]:
    """Stretches between changes of stability as smooth curves."""
    columns = branch[along], branch[up], branch.stable
    rows = [(k, *entries) for k, entries in enumerate(zip(*columns, strict=True))]
    marks = [(p.special.after + p.special.part, p[along], p[up], None) for p in branch.points]
    entries = sorted([*rows, *marks], key=lambda entry: entry[0])
    table = np.array([entry[1:3] for entry in entries], dtype=np.float64)
    size = np.maximum(np.ptp(table, axis=0), 1e-300)
    lengths = np.linalg.norm(np.diff(table / size, axis=0), axis=1)
    distinct = np.concatenate([[True], lengths > 1e-9])
    s, table = np.concatenate([[0.0], np.cumsum(lengths)])[distinct], table[distinct]
    stable = [entry[3] for entry, one in zip(entries, distinct, strict=True) if one]
    if len(s) < 3:
        return [(table[:, 0], table[:, 1], stable[0] is None or bool(stable[0]))]
    curve, last, styles = CubicSpline(s, table), True, list[bool]()
    for k in range(len(s) - 1):
        flags = [one for one in stable[k : k + 2] if one is not None]
        last = bool(flags[0]) if flags else last
        styles.append(last)
    # one curve from change to change: dashes do not begin anew at every step
    changes = [k for k in range(1, len(styles)) if styles[k] != styles[k - 1]]
    curves = list[tuple[Array, Array, bool]]()
    for first, end in pairwise([0, *changes, len(styles)]):
        x, y = curve(np.linspace(s[first], s[end], DENSE * (end - first))).T
        curves.append((x, y, styles[first]))
    return curves
