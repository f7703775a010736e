"""Pictures of what was measured, the same bytes for the same numbers."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from benchmarks.cases import CASES, FORWARD
from benchmarks.measure import Found
from cardan.peers import PEERS, peer
from cardan.peers.comparison import LANES, OURS

SHADES = {OURS: "#1b6ca8", LANES: "#12355b", "pinocchio": "#c8553d", "casadi": "#e0a030",
          "mujoco": "#5a8f4e", "pydy": "#8a6aa8"}  # fmt: skip
MARKS = {OURS: "o", LANES: "s", "pinocchio": "^", "casadi": "D", "mujoco": "v", "pydy": "P"}
EPS = float(np.finfo(float).eps)


def label(program: str) -> str:
    return peer(program).name if program in PEERS else program


def write(found: Found, folder: Path) -> None:
    """All pictures as SVG."""
    folder.mkdir(parents=True, exist_ok=True)
    style = {"svg.hashsalt": "cardan", "svg.fonttype": "none", "font.size": 9}
    with mpl.rc_context(style):
        for name, draw in (("error", error), ("size", size), ("ratios", ratios)):
            figure = Figure(figsize=(8, 4.2), layout="constrained")
            draw(found, figure.add_subplot())
            figure.savefig(folder / f"{name}.svg", metadata={"Date": None})


def error(found: Found, axes: Any) -> None:
    """Speed against error of forward dynamics, a line from program to program per mechanism."""
    for program in SHADES:
        rows = [c.row(FORWARD, program) for c in found.comparisons.values()]
        points = [(1e9 * r.time.least, max(r.error or 0.0, EPS / 4)) for r in rows if r]
        if points:
            axes.scatter(*zip(*points, strict=True), s=26, color=SHADES[program],
                         marker=MARKS[program], label=label(program), zorder=3)  # fmt: skip
    for case, comparison in found.comparisons.items():
        ours = comparison.row(FORWARD, OURS)
        if ours:
            place = (1e9 * ours.time.least, max(ours.error or 0.0, EPS / 4))
            axes.annotate(case, place, (4, -9), textcoords="offset points", fontsize=6)
    axes.set(xscale="log", yscale="log", xlabel="forward dynamics [ns]",
             ylabel="largest error / largest value")  # fmt: skip
    axes.axhline(EPS, color="#999999", lw=0.8, ls=":")
    axes.grid(alpha=0.25)
    axes.legend(frameon=False)


def size(found: Found, axes: Any) -> None:
    """Cost against the number of bodies of a chain."""
    chains = [(case.size, case.name) for case in CASES if case.size]
    for program in SHADES:
        points = []
        for bodies, name in chains:
            row = (
                found.comparisons[name].row(FORWARD, program) if name in found.comparisons else None
            )
            if row:
                points.append((bodies, 1e9 * row.time.least))
        if program == LANES:
            long = [n for n in found.buildings if n.isdigit()]
            points += [(int(n), int(n) * found.buildings[n]["state"]) for n in long]
        if points:
            axes.plot(*zip(*points, strict=True), color=SHADES[program], marker=MARKS[program],
                      ms=4, lw=1.2, label=label(program))  # fmt: skip
    axes.set(xscale="log", yscale="log", xlabel="bodies of a chain", ylabel="forward dynamics [ns]")
    axes.grid(alpha=0.25)
    axes.legend(frameon=False)


def ratios(found: Found, axes: Any) -> None:
    """Time of every program over ours, per mechanism."""
    cases = [name for name, c in found.comparisons.items() if c.row(FORWARD, OURS)]
    programs = [program for program in SHADES if program not in (OURS, "pydy")]
    width = 0.8 / len(programs)
    for k, program in enumerate(programs):
        for place, case in enumerate(cases):
            comparison = found.comparisons[case]
            row, ours = comparison.row(FORWARD, program), comparison.row(FORWARD, OURS)
            if row and ours:
                height = row.time.least / ours.time.least
                axes.bar(place + (k - 1.5) * width, height, width, color=SHADES[program],
                         label=label(program) if place == 0 else None)  # fmt: skip
    axes.axhline(1, color=SHADES[OURS], lw=1.2, label=OURS)
    axes.set_xticks(range(len(cases)), cases, rotation=35, ha="right", fontsize=7)
    axes.set(yscale="log", ylabel="time over that of cardan, one call")
    axes.legend(frameon=False, fontsize=7, ncols=6, loc="lower center", bbox_to_anchor=(0.5, 1.0))
    axes.grid(alpha=0.25, axis="y")
