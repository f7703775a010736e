"""Paths of solutions: time of a point beside its error, from 6 to 96,000 unknowns.

Measures a cantilever that is bent far by a force at its tip (elastica), by the number of elements;
the full turn of a four-bar; and passive gaits of a walker. Times are those of the processor in one
process, the least of several, with the start of the path and without it. Writes
docs/performance/paths.md and prints its tables.
Times are reported, never asserted.

usage: paths.py [--quick]
"""

from __future__ import annotations

import argparse
import sys
import time
import warnings
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

# the zoo and the references stand in the folder above
sys.path.insert(0, str(Path(__file__).parents[1]))

import numpy as np
from rich.console import Console
from rich.table import Table
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import cardan as cd
from benchmarks.all_figures import save
from benchmarks.page import markdown
from benchmarks.provenance import signed
from cycle_scenes import step, walker
from mechanisms.change_points import TURN, linkage

FOLDER = Path(__file__).parents[2] / "docs" / "performance"
ELEMENTS, FEW = (16, 100, 1000, 16000), (16, 1000)
AIM, TIMES = 30e-3, 20.0  # a point of 1,000 elements [s], of 16,000 by that of 1,000
STIFF, MOST = 1e5, 10.0  # EA L^2 / EI, and P L^2 / EI
DOUBLING = 0.015088437941119985  # slope at which the period of gaits doubles, 22 digits
HEADINGS = ("path", "unknowns", "points", "systems", "start [ms]", "a point [ms]", "error")
TEXT = """# Paths

Time of a point of `model.continuation`, with all that is looked at there: Newton's corrections,
the tangent, stability, what lies between it and the last one. Written by
`tests/benchmarks/paths.py`. Times are those of the processor, the least of several paths, on a
machine that others used too; the start is the first equilibrium, before any point.

"""
NOTES = """
Errors: of the cantilever, P L^2 / EI = 10 and EA L^2 / EI = GA L^2 / EI = 1e5, the place of its
tip against the equations of a beam that stretches and shears, by SciPy at 1e-13; of the
four-bar the loop that it should close; of the walker the slope at which its period doubles. A
cantilever of {few:,} elements should take {most:.0f} ms, and one of {many:,} at most {times:.0f}
times that.
"""


@dataclass(frozen=True)
class Row:
    """A path: unknowns, points, linear systems, times [s] and error."""

    name: str
    unknowns: int
    points: int
    systems: int
    start: float
    whole: float
    error: float

    @property
    def point(self) -> float:
        """Time of a point [s]."""
        return (self.whole - self.start) / self.points

    @property
    def cells(self) -> tuple[str, ...]:
        """As text."""
        return (
            self.name, str(self.unknowns), str(self.points), str(self.systems),
            f"{1e3 * self.start:.3g}", f"{1e3 * self.point:.3g}", f"{self.error:.1e}",
        )  # fmt: skip


def cantilever(elements: int) -> cd.Scene:
    """A clamped beam of length 1 and EI = 1 under a force P at its tip."""
    scene = cd.Scene("cantilever", gravity=(0, 0, 0))
    load = scene.parameter("P", 0.0)
    section = cd.section.general(EA=STIFF, GA=STIFF, GJ=1, EI=1, rhoA=1)
    beam = scene.beam("beam", (0, 0, 0), (1, 0, 0), section, elements=elements)
    scene.joint("clamp", cd.Fixed(), scene.ground, beam.start)
    scene.force("load", cd.Force(beam.end, (0, 0, load)))
    for name, k in (("x", 0), ("z", 2)):
        scene.output(name, beam.end.position()[k], unit="m")
    return scene


def tip() -> tuple[float, float]:
    """Where it comes to, by the equations of a beam that stretches and shears, by shooting."""

    def slopes(_: float, y: Any) -> list[float]:
        _, _, angle, moment = y
        stretch, shear = 1 + MOST * np.sin(angle) / STIFF, MOST * np.cos(angle) / STIFF
        x = stretch * np.cos(angle) - shear * np.sin(angle)
        z = stretch * np.sin(angle) + shear * np.cos(angle)
        return [x, z, moment, -MOST * x]

    def end(moment: float) -> Any:
        run = solve_ivp(slopes, (0, 1), [0, 0, 0, moment], method="DOP853", rtol=1e-13, atol=1e-14)
        return run.y[:, -1]

    root = brentq(lambda moment: end(moment)[3], 0.1, MOST, xtol=1e-14)
    return tuple(end(root)[:2])


def measured(
    name: str, follow: Callable[[int], Any], error: Callable[[Any], float], rounds: int
) -> Row:
    """The path that a function follows, which takes the number of points at most."""
    spent = {300: list[float](), 2: list[float]()}
    # functions are compiled at first use
    follow(2)
    for _ in range(rounds):
        for points, times in spent.items():
            begin = time.process_time()
            path = follow(points)
            times.append(time.process_time() - begin)
            if points == 300:
                whole = path
    family, main = whole.main.solutions.family, whole.main
    assert whole.success, whole
    one, two = min(spent[300]), min(spent[2])
    start = two - (one - two) / (len(main) - 2) if len(main) > 2 else two
    return Row(name, len(family.weights), len(main), main.iterations, start, one, error(whole))


def rows(quick: bool) -> Iterator[Row]:
    """All paths."""
    rounds = 1 if quick else 3
    x, z = tip()

    def missed(path: Any) -> float:
        return float(np.hypot(path["x"][-1] - x, path["z"][-1] - z))

    for elements in FEW if quick else ELEMENTS:
        model = cd.compile(cantilever(elements))

        def bend(points: int, model: Any = model) -> Any:
            return model.continuation(P=(0, MOST), points=points)

        yield measured(f"cantilever, {elements} elements", bend, missed, rounds)
    turning = linkage(1.0, 3.0, 2.5, 3.0)

    def turn(points: int) -> Any:
        return turning.continuation(A=(0.5, 0.5 + TURN), of="positions", points=points)

    def gap(path: Any) -> float:
        gaps = (gap for k in range(len(path)) for gap in path[k].gaps.values())
        return max(float(np.max(np.abs(gap))) for gap in gaps)

    yield measured("four-bar, a turn", turn, gap, rounds)
    robot = walker()
    gait = step(robot, 0.2003, -0.1998)

    def walk(points: int) -> Any:
        return robot.continuation(slope=(0.009, 0.018), of="cycles", start=gait, points=points)

    def doubled(path: Any) -> float:
        return abs(path.point("period doubling 1").values["slope"] - DOUBLING)

    yield measured("walker of Garcia et al., gaits", walk, doubled, rounds)


def figures(paths: Sequence[Row]) -> Iterator[tuple[str, str, str, str]]:
    """Figures to reach, for the table of all."""
    points = {row.name: row.point for row in paths}
    few, many = (points.get(f"cantilever, {n} elements") for n in (1000, 16000))
    if few is not None:
        verdict = "yes" if few <= AIM else "no"
        measured_time = f"{1e3 * few:.1f} ms"
        yield "a point of a path, 1,000 elements", f"≤ {1e3 * AIM:.0f} ms", measured_time, verdict
    if few is not None and many is not None:
        verdict = "yes" if many <= TIMES * few else "no"
        name = "a point of 16,000 elements, by one of 1,000"
        yield name, f"≤ {TIMES:.0f}", f"{many / few:.1f}", verdict


def main() -> int:
    """Measure, write, print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="little of it; writes no page")
    quick = parser.parse_args().quick
    warnings.simplefilter("ignore", cd.SolveWarning)
    paths = list(rows(quick))
    lines = [row.cells for row in paths]
    table = Table(*HEADINGS)
    for line in lines:
        table.add_row(*line)
    Console().print(table)
    save("paths.md", figures(paths))
    if not quick:
        text = TEXT + "\n".join(markdown(HEADINGS, lines, 1)) + "\n"
        text += NOTES.format(few=1000, most=1e3 * AIM, many=16000, times=TIMES)
        (FOLDER / "paths.md").write_text(signed(text), "utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
