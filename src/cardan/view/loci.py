"""Eigenvalues, whirl and responses of linear models as pictures."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Complex
from .plot import CURVES, MARKS, done, empty

if TYPE_CHECKING:
    from matplotlib.figure import Figure

ROUNDED = 1e-10  # of the largest eigenvalue: real parts that are none
ROUND = 0.1  # whirl beyond this goes round


def plot_locus(
    title: str,
    label: str,
    over: Array,
    values: Complex,
    marks: Sequence[float],
    path: str | Path | None,
) -> Figure:
    """Draw eigenvalues in the complex plane, and their parts over what changes.

    Args:
        title, label: Headline, and what changes.
        over, values: Its values (n,), the followed eigenvalues (n, k).
        marks: Values at which stability changes.
        path: Picture file, or None.

    Returns:
        The Matplotlib figure.
    """
    figure = empty((11, 5.2))
    grid = figure.add_gridspec(2, 2)
    plane = figure.add_subplot(grid[:, 0])
    parts = figure.add_subplot(grid[0, 1]), figure.add_subplot(grid[1, 1])
    # rounding would fill an axis on which nothing else is
    least = ROUNDED * float(np.abs(values).max(initial=0.0))
    values = np.where(np.abs(values.real) > least, values, 1j * values.imag)
    for column in values.T:
        (line,) = plane.plot(column.real, column.imag, "-", linewidth=1.0)
        plane.plot(column.real[0], column.imag[0], "o", color=line.get_color(), markersize=4)
        plane.plot(column.real[-1], column.imag[-1], "s", color=line.get_color(), markersize=4)
        parts[0].plot(over, column.real, ".-", color=line.get_color(), markersize=3)
        parts[1].plot(over, np.abs(column.imag), ".-", color=line.get_color(), markersize=3)
    plane.axvline(0, color="black", linewidth=0.6)
    parts[0].axhline(0, color="black", linewidth=0.6)
    plane.set(xlabel="real part [1/s]", ylabel="imaginary part [rad/s]")
    plane.set_title(f"{label} from {over[0]:.4g} (o) to {over[-1]:.4g} (s)", fontsize="small")
    parts[0].set_ylabel("growth [1/s]")
    parts[1].set(xlabel=label, ylabel="frequency [rad/s]")
    for axis in parts:
        for place in marks:
            axis.axvline(place, color="crimson", linewidth=0.8, linestyle="--")
    for axis in (plane, *parts):
        axis.grid(alpha=0.3)
    return done(figure, title, path)


def plot_campbell(
    title: str,
    label: str,
    speed: Array,
    frequencies: Array,
    whirl: Array,
    unstable: NDArray[np.bool_],
    critical: Mapping[int, Sequence[float]],
    path: str | Path | None,
) -> Figure:
    """Draw frequencies over a speed, with lines of its multiples.

    Args:
        title, label: Headline, and what the speed is called.
        speed, frequencies: [rad/s] (n,) and (n, k), NaN where nothing oscillates.
        whirl: From -1, backward, to 1, forward (n, k).
        unstable: Which motions grow (n, k).
        critical: Multiple -> critical speeds.
        path: Picture file, or None.

    Returns:
        The Matplotlib figure.
    """
    figure = empty((9, 5.6))
    axis = figure.subplots()
    for column in frequencies.T:
        axis.plot(speed, column, "-", color="0.6", linewidth=0.9)
    kinds = {
        "forward": (whirl > ROUND, "^", "tab:blue"),
        "backward": (whirl < -ROUND, "v", "tab:orange"),
        "neither": (np.abs(whirl) <= ROUND, ".", "0.4"),
    }
    across = np.broadcast_to(speed[:, None], frequencies.shape)
    for name, (chosen, mark, color) in kinds.items():
        here = chosen & np.isfinite(frequencies)
        if here.any():
            axis.plot(across[here], frequencies[here], mark, color=color, markersize=4, label=name)
    if np.any(unstable):
        axis.plot(across[unstable], frequencies[unstable], "x", color="crimson", label="grows")
    top = float(np.nanmax(frequencies, initial=0.0)) * 1.05
    for order, places in critical.items():
        axis.plot(speed, order * np.abs(speed), "--", color="black", linewidth=0.8)
        end = min(float(np.abs(speed).max()), 0.98 * top / order)
        side = -end if np.abs(speed.min()) > np.abs(speed.max()) else end
        axis.annotate(f"{order}x", (side, order * end), ha="right", va="bottom")
        axis.plot(places, order * np.abs(places), "o", color="black", fillstyle="none")
    axis.set(xlabel=f"{label} [rad/s]", ylabel="frequency [rad/s]", ylim=(0, top or 1.0))
    axis.grid(alpha=0.3)
    axis.legend(fontsize="small")
    return done(figure, title, path)


def plot_response(
    title: str, omega: Array, responses: Mapping[str, Complex], path: str | Path | None
) -> Figure:
    """Draw frequency responses: sizes and phases over the angular frequency.

    Args:
        title: Headline.
        omega: [rad/s] (n,).
        responses: Name -> response (n,).
        path: Picture file, or None.

    Returns:
        The Matplotlib figure.
    """
    figure = empty((9, 5.6))
    size, phase = figure.subplots(2, 1, sharex=True)
    for k, (name, values) in enumerate(responses.items()):
        every = max(1, len(omega) // 12)
        style = {"label": name, "linewidth": 1.2, "marker": MARKS[k % len(MARKS)],
                 "markevery": every, "markersize": 4}  # fmt: skip
        size.plot(omega, np.abs(values), **style)
        phase.plot(omega, np.degrees(np.unwrap(np.angle(values))), **style)
    size.set(xscale="log", yscale="log", ylabel="size")
    phase.set(xscale="log", xlabel="frequency [rad/s]", ylabel="phase [degrees]")
    for axis in (size, phase):
        axis.grid(alpha=0.3, which="both")
    if 0 < len(responses) <= CURVES:
        size.legend(fontsize="small")
    return done(figure, title, path)
