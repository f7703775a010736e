"""Work-precision pictures, the same bytes for the same numbers."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import matplotlib as mpl
from matplotlib.figure import Figure

from benchmarks.motion.contest import Outcome, fronts
from benchmarks.motion.programs import PROGRAMS

COLORS = ("#1b6ca8", "#5a8f4e", "#c8553d", "#e0a030", "#8a6aa8", "#6b6b6b")
SHADES = {p.name: color for p, color in zip(PROGRAMS, COLORS, strict=True)}
MARKS, LINES = "osD^vPX", ("-", "--", ":", "-.")
FLOOR = 1e-16


def write(outcomes: dict[str, Outcome], folder: Path) -> None:
    """One SVG per problem."""
    folder.mkdir(parents=True, exist_ok=True)
    with mpl.rc_context({"svg.hashsalt": "cardan", "svg.fonttype": "none", "font.size": 9}):
        for name, outcome in outcomes.items():
            figure = Figure(figsize=(8, 4.6), layout="constrained")
            draw(outcome, figure.add_subplot())
            figure.savefig(folder / f"{name}.svg", metadata={"Date": None})


def draw(outcome: Outcome, axes: Any) -> None:
    """Time against error, a line per program and method."""
    seen: dict[str, int] = {}
    for program, method, points in fronts(outcome):
        k = seen[program] = seen.get(program, -1) + 1
        errors, seconds = zip(*points, strict=True)
        axes.plot([max(e, FLOOR) for e in errors], [1e3 * s for s in seconds],
                  color=SHADES[program], marker=MARKS[k % len(MARKS)], ms=4,
                  ls=LINES[k % len(LINES)], lw=1.2, label=f"{program}: {method}")  # fmt: skip
    axes.set(xscale="log", yscale="log", ylabel="time of the motion [ms]",
             xlabel=f"error at the end [{outcome.problem.unit}]",
             title=f"{outcome.problem.title}, {outcome.problem.end:g} s")  # fmt: skip
    # few digits left, many right
    axes.invert_xaxis()
    axes.grid(alpha=0.25)
    if seen:
        axes.legend(frameon=False, fontsize=7, loc="center left", bbox_to_anchor=(1.0, 0.5))
