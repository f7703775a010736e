"""What the runs of superelements gave: tables for the screen and the page."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

from rich.console import Console
from rich.markup import escape
from rich.table import Table

from benchmarks.provenance import signed

Row = tuple[str, ...]
# of balance and tangent [ns]; of the rigid one's time; errors at which times are compared [m]
MOST, RATIO, ERRORS = 3000.0, 2.0, (3e-6, 1e-6, 5e-7)


@dataclass(frozen=True)
class Call:
    """A function of an element: time of one [ns], and the worst error that a check found."""

    frame: str
    function: str
    operations: int
    lanes: bool
    nanoseconds: float
    error: float


@dataclass(frozen=True)
class Instances:
    """Times of one of several superelements [ns]."""

    count: int
    balance: float
    tangent: float
    step: float


@dataclass(frozen=True)
class Step:
    """A slider-crank: speeds, time of a step [us], that by the rigid one's, error [m]."""

    model: str
    speeds: int
    microseconds: float
    ratio: float
    error: float


@dataclass(frozen=True)
class Point:
    """A run of the slider-crank: time of a turn [s] and error of the middle of the rod [m]."""

    program: str
    size: str
    effort: str
    seconds: float
    error: float


@dataclass(frozen=True)
class Found:
    """All tables; apart: how far the limits of cables and of solids are from each other [m]."""

    calls: list[Call]
    instances: list[Instances]
    steps: list[Step]
    points: list[Point]
    apart: float


def _calls(found: Found) -> Iterator[Row]:
    yield "frame", "function", "operations", "", "ns (3000)", "error", "reached"
    for c in found.calls:
        where = "in lanes" if c.lanes else "alone"
        reached = "yes" if c.nanoseconds <= MOST else "no"
        time, error = f"{c.nanoseconds:.0f}", f"{c.error:.0e}"
        yield c.frame, c.function, str(c.operations), where, time, error, reached


def figures(found: Found) -> Iterator[tuple[str, str, str, str]]:
    """Figures to reach, for the table of all."""
    _, *rows = _calls(found)
    for frame, function, _, where, time, _, reached in rows:
        name = f"superelement, {frame} frame, {function}, {where}"
        yield name, f"≤ {MOST:.0f} ns", f"{time} ns", reached
    _, *rows = _steps(found)
    for model, _, _, ratio, _, reached in rows:
        if reached:
            yield f"slider-crank, {model}, by the rigid one", f"≤ {RATIO:.0f}", ratio, reached


def _instances(found: Found) -> Iterator[Row]:
    yield "superelements", "balance [ns]", "tangent [ns]", "step [us]", "step, against one alone"
    for one in found.instances:
        ratio = one.step / found.instances[0].step
        times = (f"{one.balance:.0f}", f"{one.tangent:.0f}", f"{1e-3 * one.step:.1f}")
        yield str(one.count), *times, f"{ratio:.2f}"


def _steps(found: Found) -> Iterator[Row]:
    yield "slider-crank", "speeds", "us/step", "ratio (2)", "error [um]", "reached"
    for s in found.steps:
        flexible = not math.isnan(s.error)
        reached = ("yes" if s.ratio <= RATIO else "no") if flexible else ""
        error = f"{1e6 * s.error:.2f}" if flexible else ""
        yield s.model, str(s.speeds), f"{s.microseconds:.1f}", f"{s.ratio:.2f}", error, reached


def _points(found: Found) -> Iterator[Row]:
    yield "program", "rod", "effort", "ms/turn", "error [um]"
    for p in found.points:
        yield p.program, p.size, p.effort, f"{1e3 * p.seconds:.2f}", f"{1e6 * p.error:.2f}"


def _equal(found: Found) -> Iterator[Row]:
    """Least time of a program within an error, and the peers' by ours."""
    yield "program", *(f"within {1e6 * error:.1f} um [ms]" for error in ERRORS), "ratios to ours"
    programs = list(dict.fromkeys(p.program for p in found.points))
    least = {
        program: [
            min((p.seconds for p in found.points if p.program == program and p.error <= most),
                default=math.inf)
            for most in ERRORS
        ]
        for program in programs
    }  # fmt: skip
    ours = [
        min(least[program][k] for program in programs if program.startswith("cardan"))
        for k in range(len(ERRORS))
    ]
    for program in programs:
        times = (f"{1e3 * t:.2f}" if t < math.inf else "not reached" for t in least[program])
        ratios = (
            f"{t / own:.1f}" if t < math.inf else "-"
            for t, own in zip(least[program], ours, strict=True)
        )
        yield program, *times, " / ".join(ratios)


TEXT = """# Superelements

Times are those of one thread, the least of several turns. Written by `make bench`.

## Functions of an element

A brick with two interfaces and 12 modes: 18 coordinates with its frame on an interface, 24 with the
mean frame. Errors are the worst of a check against energies and slopes.

"""
INSTANCES = """
## Many of them

Such bricks on one free hub, frames on the interfaces there. From 8 on they go side by side. A
step is one of generalized-alpha (0.1 ms). All times are those of one superelement, and without the
start of the run.

"""
CRANK = """
## A slider-crank

A rod of aluminum (0.3 m, 8 mm square, 24 hex20 cells, four modes) at 60 rad/s; the crank turns
freely. One turn of 1000 steps of generalized-alpha (rho_inf = 0.8), without the start of the run.
Errors are the root mean square distance of the middle of the rod, which bends by 0.14 mm, from a
solution with eight modes at a tight tolerance.

"""
RIGID = """
A rigid rod on nodes has the same kind of coordinates and the same solver. In joint coordinates the
rigid mechanism has code without tables; superelements do not have such a form. The frame on the
pin is the cheapest. It differs from the others by the
square of the deformation, which is its error here.

## Beside Exudyn

The same rod by Exudyn: its reduced-order floating frame with the same matrices and the same shapes
without rigid motions, and its planar cable (absolute nodal coordinates). All have generalized-alpha
with rho_inf = 0.8, Exudyn with modified Newton steps and by both of its solvers; ours also by Radau
at tolerances. Times are those of a turn without the start of the run. Errors of cables are against
refined cables, which are {apart:.1f} um from the solid.

"""


def tables(found: Found) -> list[tuple[str, Iterable[Row]]]:
    """Texts and the tables behind them."""
    return [
        (TEXT, _calls(found)),
        (INSTANCES, _instances(found)),
        (CRANK, _steps(found)),
        (RIGID.format(apart=1e6 * found.apart), _equal(found)),
        ("\nAll runs:\n\n", _points(found)),
    ]


def show(found: Found) -> None:
    """Tables on a screen."""
    for _, rows in tables(found):
        headings, *rest = rows
        table = Table(*map(escape, headings), box=None)
        for row in rest:
            table.add_row(*row)
        Console(width=150).print(table, "")


def write(found: Found, folder: Path) -> None:
    """The page."""
    text = ""
    for about, rows in tables(found):
        headings, *rest = rows
        every = (headings, ("---",) * len(headings), *rest)
        text += about + "".join(f"| {' | '.join(row)} |\n" for row in every)
    (folder / "superelements.md").write_text(signed(text), encoding="utf-8")
