"""What the runs of the rubber beam gave: tables for the screen and the page, and a picture."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import matplotlib as mpl
from matplotlib import figure as drawing
from rich.console import Console
from rich.markup import escape
from rich.table import Table

from benchmarks import flexible_large
from benchmarks.flexible_figures import Figure
from benchmarks.provenance import signed

TARGETS = {"time": 0.1, "error": 0.2}
COLORS = ("#1b6ca8", "#c8553d", "#5a8f4e", "#e0a030", "#7a5aa8")
TEXT = """# Beams

A beam of rubber (1 m long, round, 1 cm of radius, E = 5 MPa, 1100 kg/m^3), hung at one end, falls
from the horizontal for 0.5 s. Both programs take the generalized-alpha method with the same damping
(rho_inf = 0.8), constraints of positions, steps of 1 ms and modified Newton steps, on one core, in
turns; the least time of the thread counts, of ours that of the whole call. Errors are the root mean
square distance of the tip at ten times, from the extrapolation of our finest meshes at the same
steps. Written by `make bench`.

"""
DEVIATIONS = """
Of 1000 elements the first 10 steps of 10 us are timed, of ours the next 190, as a call of 10 steps
is mostly its start: at 1 ms the Newton iterations of Exudyn fail and it shrinks its steps until the
time is out; at 100 elements it takes about three steps for each that is asked for. That belongs to
its figures. Errors below a few micrometers are those of the reference. The planar beams of Exudyn
know three or four coordinates of a node instead of six, and its cable neither shear nor rotary
inertia; "cardan, planar" is our beam with three (`derive(..., plane="y")`).
"""
REST = """
## Parts

Elements and the sparse solver by themselves, a structure at rest, the first use of a scene and very
many elements. Processes that begin with nothing compiled count with their imports; kernels, which
serve all models, are there.

"""
CAUSES = """
Of 100,000 elements times are those of the processor, of a step the rise over {steps} steps of 10
us. Most of a step is the solution by the factors, which reads them from memory in each direction;
then come the balances of elements, the matrix with its factors, poses, and passes over states of
600,000 numbers. That a solution is good follows from a bound that the factorization sums up, so
that none is multiplied out. Asking for factors ahead changed nothing. What is left of a start are
three factorizations (of the first accelerations, of multipliers, of the jerk) and the one of the
first step.

The 3-D cable of Exudyn has two vectors per node, no rotation, and resists no twist. A step of ours
with few elements is elements, linear algebra, the call from Python, copies from nodes to elements
and back, poses, norms and sums; `perf` splits it as it does on the page of
[profiles](profiles.md). Tried besides: extrapolating accelerations to the second order, which saves
corrections and costs finer meshes some; ending iterations where their error is a part of that of
the step, however large, which moves the tip. Neither is done.
"""


@dataclass(frozen=True)
class Point:
    """A run: program, elements, time of a step [s], error of the tip [m]."""

    program: str
    elements: int
    seconds: float
    error: float


@dataclass(frozen=True)
class Found:
    """Ours and Exudyn's in turns; time against error of all beams; what is reached besides."""

    compared: list[Point]
    curves: list[Point]
    figures: list[Figure]


def ratios(found: Found) -> Iterator[tuple[str, ...]]:
    """Rows: elements, times [us], their ratio, errors [mm], their ratio, what is reached."""
    for ours, theirs in zip(found.compared[::2], found.compared[1::2], strict=True):
        time, error = ours.seconds / theirs.seconds, ours.error / theirs.error
        known = not math.isnan(error)
        reached = time <= TARGETS["time"] and not error > TARGETS["error"]
        yield (
            str(ours.elements), f"{1e6 * ours.seconds:.1f}", f"{1e6 * theirs.seconds:.1f}",
            f"{time:.3f}", _millimeters(ours.error), _millimeters(theirs.error),
            f"{error:.3f}" if known else "",
            "no" if not reached else "yes" if known else "time",
        )  # fmt: skip


def _millimeters(error: float) -> str:
    return "" if math.isnan(error) else f"{1e3 * error:.2g}"


HEADINGS = (
    "elements", "cardan [us/step]", "Exudyn [us/step]", "ratio (0.1)", "cardan, tip [mm]",
    "Exudyn, tip [mm]", "ratio (0.2)", "reached",
)  # fmt: skip
FIGURES = ("figure", "to reach", "found", "reached")
CURVE = ("beam", "elements", "us/step", "tip [mm]")


def lines(found: Found) -> Iterator[tuple[str, ...]]:
    """Rows of all beams."""
    for point in sorted(found.curves, key=lambda p: (p.program, p.elements)):
        seconds = f"{1e6 * point.seconds:.1f}"
        yield point.program, str(point.elements), seconds, _millimeters(point.error)


def figures(found: Found) -> Iterator[tuple[str, ...]]:
    """Rows of what is reached without another program."""
    for row in found.figures:
        yield row.what, row.target, row.found, "yes" if row.reached else "no"


def show(found: Found) -> None:
    """Tables on a screen."""
    tables = ((HEADINGS, ratios(found)), (CURVE, lines(found)), (FIGURES, figures(found)))
    for headings, rows in tables:
        table = Table(*map(escape, headings), box=None)
        for row in rows:
            table.add_row(*row)
        Console(width=150).print(table, "")


def _table(headings: tuple[str, ...], rows: Iterator[tuple[str, ...]]) -> str:
    every = (headings, ("---",) * len(headings), *rows)
    return "".join(f"| {' | '.join(row)} |\n" for row in every)


def write(found: Found, folder: Path) -> None:
    """The page and its picture."""
    text = TEXT + _table(HEADINGS, ratios(found)) + DEVIATIONS
    text += "\n![error of the tip against time of a step](flexible.svg)\n\n"
    text += _table(CURVE, lines(found)) + REST + _table(FIGURES, figures(found))
    text += CAUSES.format(steps=flexible_large.STEPS)
    (folder / "flexible.md").write_text(signed(text), encoding="utf-8")
    with mpl.rc_context({"svg.hashsalt": "cardan", "svg.fonttype": "none", "font.size": 9}):
        figure = drawing.Figure(figsize=(7, 4.4), layout="constrained")
        axes = figure.add_subplot()
        programs = dict.fromkeys(point.program for point in found.curves)
        for program, color in zip(programs, COLORS, strict=False):
            own = [point for point in found.curves if point.program == program]
            axes.plot([1e3 * p.error for p in own], [1e6 * p.seconds for p in own], "o-",
                      color=color, ms=4, lw=1.2, label=program)  # fmt: skip
        axes.set(xscale="log", yscale="log", title="beam of rubber, 4 to 64 elements")
        axes.set(xlabel="error of the tip [mm]", ylabel="time of a step [us]")
        axes.invert_xaxis()
        axes.grid(alpha=0.25)
        axes.legend(frameon=False)
        figure.savefig(folder / "flexible.svg", metadata={"Date": None})
