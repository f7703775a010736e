"""A beam of rubber by cardan and by Exudyn: time of a step and error of the tip, in one run; then
elements, solver, first use and very many elements.

Writes docs/performance/flexible.md with its picture and prints its tables. Times are reported,
never asserted; a program that is missing ends it.

usage: flexible_runs.py [--quick]
"""

from __future__ import annotations

import argparse
import sys
from importlib.util import find_spec
from pathlib import Path

# the benchmarks stand in the folder above
sys.path.insert(0, str(Path(__file__).parents[1]))

import numpy as np
from numpy.typing import NDArray

import cardan as cd
from benchmarks import flexible_exudyn as exudyn
from benchmarks import flexible_page as page
from benchmarks import flexible_problem as problem
from benchmarks.all_figures import save
from benchmarks.flexible_figures import figures
from benchmarks.flexible_page import Found, Point

Array = NDArray[np.float64]
FOLDER = Path(__file__).parents[2] / "docs" / "performance"
# elements and rounds; of many elements a few short steps are timed: Exudyn's Newton iterations fail
# beyond them, and its steps shrink without end
SIZES, QUICK = {10: 5, 100: 3, 1000: 2}, {10: 2, 100: 1}
CURVE, FINE = (4, 8, 16, 32, 64), (128, 256)
STEPS = round(problem.END / problem.STEP)
MANY, FEW, SHORT, TIMES = 300, 10, 1e-5, 20
MISSING = 3


def error(found: Array, exact: Array) -> float:
    """Root mean square distance of the tip from where it should be [m]."""
    return float(np.sqrt(((found - exact) ** 2).sum(axis=1).mean()))


def reference() -> Array:
    """The tip of ever finer meshes: what halving leaves falls by four, at least."""
    coarse, fine = (problem.run(cd.compile(problem.scene(n)), STEPS)[1] for n in FINE)
    return np.asarray(fine + (fine - coarse) / 3)


def _more(model: cd.CompiledModel, steps: int, end: float) -> tuple[float, Array]:
    """What TIMES as many steps take longer, per step: the start of a run is not a step."""
    few, tip = problem.run(model, steps, end)
    many, _ = problem.run(model, TIMES * steps, TIMES * end)
    return (TIMES * many - few) / (TIMES - 1), tip


def compared(sizes: dict[int, int], exact: Array) -> list[Point]:
    """Ours and Exudyn's spatial beam turn by turn, the least time of each."""
    points = []
    for n, rounds in sizes.items():
        model = cd.compile(problem.scene(n))
        steps, end = (FEW, FEW * SHORT) if n > MANY else (STEPS, problem.END)
        problem.run(model, steps, end)
        ours = _more if n > MANY else problem.run
        turns = [
            (ours(model, steps, end), exudyn.run(exudyn.spatial, n, steps, end))
            for _ in range(rounds)
        ]
        for k, name in enumerate(("cardan", "Exudyn")):
            least, tip = min((turn[k] for turn in turns), key=lambda pair: pair[0])
            missed = error(tip, exact) if steps == STEPS else float("nan")
            points.append(Point(name, n, least, missed))
    return points


def curves(exact: Array, elements: tuple[int, ...]) -> list[Point]:
    """Time against error of all beams."""
    points = []
    for n in elements:
        model = cd.compile(problem.scene(n))
        problem.run(model, STEPS)
        flat = cd.compile(cd.derive(problem.scene(n, flat=True), "absolute", plane="y"))
        problem.run(flat, STEPS)
        ours = {"cardan": model, "cardan, planar": flat}
        found = {
            name: min((problem.run(one, STEPS) for _ in range(3)), key=lambda p: p[0])
            for name, one in ours.items()
        }
        for name, build in exudyn.BEAMS.items():
            found[f"Exudyn, {name}"] = min(
                (exudyn.run(build, n, STEPS) for _ in range(2)), key=lambda p: p[0]
            )
        points += [Point(name, n, t, error(tip, exact)) for name, (t, tip) in found.items()]
    return points


def main() -> int:
    """Measure, write, print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="small meshes; writes no page")
    quick = parser.parse_args().quick
    if find_spec("exudyn") is None:
        print("flexible_runs: Exudyn is missing: pip install 'cardan[bench]'", file=sys.stderr)
        return MISSING
    exact = reference()
    found = Found(
        compared(QUICK if quick else SIZES, exact),
        curves(exact, CURVE[:2] if quick else CURVE),
        list(figures(quick)),
    )
    page.show(found)
    save("flexible.md", page.figures(found))
    if not quick:
        page.write(found, FOLDER)
    return 0


if __name__ == "__main__":
    sys.exit(main())
