"""Superelements: their functions, many of them, a slider-crank beside a rigid one and Exudyn's.

Writes docs/performance/superelements.md and prints its tables. Times are reported, never asserted;
a program that is missing ends it.

usage: superelement_runs.py [--quick]
"""

from __future__ import annotations

import argparse
import sys
import tempfile
import time
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import partial
from importlib.util import find_spec
from itertools import product
from pathlib import Path
from typing import Any

# the benchmarks stand in the folder above
sys.path.insert(0, str(Path(__file__).parents[1]))

import numpy as np
from numpy.typing import NDArray

import cardan as cd
from benchmarks import flexible
from benchmarks import superelement_exudyn as exudyn
from benchmarks import superelement_page as page
from benchmarks import superelement_problem as problem
from benchmarks.all_figures import save
from benchmarks.superelement_page import Call, Found, Instances, Point, Step
from cardan.codegen import generate
from cardan.runtime.calls import lanes
from cardan.runtime.models.finite_elements.table_loading import LANE_THRESHOLD

Array = NDArray[np.float64]
FOLDER = Path(__file__).parents[2] / "docs" / "performance"
FUNCTIONS = ("balance", "balance_tangent")
COUNTS = (1, 10, 100)
STEPS, QUICK = (240, 500, 1000, 2000), (240, 500)
TOLERANCES = (1e-4, 3e-5, 1e-5, 1e-6)
# beyond the rows of a run whose balance is looked at
SEVERAL, FEW, SHORT, CALLS = 900, 300, 1e-4, 200
MISSING = 3
ALPHA = cd.GeneralizedAlpha(problem.RHO_INF, index=3)


@dataclass(frozen=True)
class Case:
    """What is timed: a call for a whole turn or for its start alone, and where the middle was."""

    program: str
    size: str
    effort: str
    call: Callable[[bool], tuple[float, Array]]


@dataclass(frozen=True)
class State:
    """A boom somewhere: its data, coordinates, speeds and accelerations."""

    p: tuple[float, ...]
    q: Array
    u: Array
    udot: Array


def calls(rounds: int, count: int = 64) -> Iterator[Call]:
    """Functions of an element with two interfaces and 12 modes, alone and in lanes."""
    for frame in ("root", "mean"):
        scene = problem.booms(frame)
        worst = float(cd.compile(scene).verify(seed=1).worst)
        for name, width in product(FUNCTIONS, (1, lanes.width())):
            operations, spent = _call(scene, name, width, count, rounds)
            yield Call(frame, name, operations, width > 1, spent, worst)


def _call(scene: cd.Scene, name: str, width: int, count: int, rounds: int) -> tuple[int, float]:
    """Operations of a function of the boom, and its time among some others [ns]."""
    kinds = cd.derive(scene, "absolute").kinds
    function = next(kind for kind in kinds if kind.element == "superelement").functions[name]
    rng, sizes = np.random.default_rng(1), {b.name: len(b.entries) for b in function.inputs}
    q = 1e-2 * rng.normal(size=sizes["q"])
    q[0] = 1.0
    q[:4] /= np.linalg.norm(q[:4])
    data = (*np.eye(3).ravel().tolist(), 0.1, 0.2, 0.3, 0.0, 0.0, -9.81)
    state = State(data, q, rng.normal(size=sizes["u"]), rng.normal(size=sizes["u"]))
    made = generate(function)
    with tempfile.TemporaryDirectory(prefix="cardan-superelements-") as folder:
        text = Path(folder) / f"{made.name}.c"
        text.write_text(made.text, encoding="utf-8")
        spent = flexible.timed(text, state, function, made.entry, width, count, rounds)
    return sum(made.entry["operations"].values()), spent


def instances(rounds: int, counts: tuple[int, ...]) -> Iterator[Instances]:
    """What one of several on one hub costs."""
    for count in counts:
        model = cd.compile(problem.booms("root", count))
        width = lanes.width() if count >= LANE_THRESHOLD else 1
        every = width * -(-count // width)

        def spin(steps: int, model: Any = model) -> float:
            begin = time.thread_time()
            motion = model.simulate(
                (0.0, steps * SHORT), u={"free": [0, 0, 1, 0, 0, 0]}, method=ALPHA, step=SHORT
            )
            assert motion.success, motion
            return time.thread_time() - begin

        spin(1)
        turns = [(spin(SEVERAL), spin(FEW)) for _ in range(rounds)]
        least = difference(turns) / (SEVERAL - FEW)
        # lanes that are left over are computed too
        times = [
            _call(problem.booms("root"), name, width, every, CALLS)[1] * every / count
            for name in FUNCTIONS
        ]
        yield Instances(count, times[0], times[1], 1e9 * least / count)


def difference(turns: Iterable[tuple[float, float]]) -> float:
    """Of the least long time and the least short one [s]: what disturbs one turn counts once."""
    longer, shorter = zip(*turns, strict=True)
    return float(min(longer) - min(shorter))


def _ours(model: Any, flexible: bool, options: dict[str, Any]) -> Callable[[bool], Any]:
    """Calls of a model; of an adaptive method the start is a run that ends at once."""
    start = options.get("step", 1e-9)

    def call(whole: bool) -> tuple[float, Any]:
        taken, motion = problem.run(model, problem.TURN if whole else start, **options)
        return taken, problem.middle(motion) if whole and flexible else motion

    return call


def _models() -> dict[str, Any]:
    """Models of the slider-crank by their names in the tables."""
    rigid = problem.slider_crank(None)
    return {
        "rigid, on nodes": cd.compile(cd.derive(rigid, "absolute")),
        "rigid, in joint coordinates": cd.compile(problem.slider_crank(None)),
        "superelement, frame on the pin": cd.compile(problem.slider_crank("pin")),
        "superelement, chord frame": cd.compile(problem.slider_crank("chord")),
        "superelement, mean frame": cd.compile(problem.slider_crank("mean")),
    }


def steps_of(models: dict[str, Any], rounds: int, exact: Array) -> Iterator[Step]:
    """Time of a step of the same size, turn by turn."""
    n = 1000
    options = {"method": ALPHA, "step": problem.TURN / n}
    cases = {
        name: _ours(model, not name.startswith("rigid"), options) for name, model in models.items()
    }
    spent: dict[str, list[tuple[float, float]]] = {name: [] for name in cases}
    for call in cases.values():
        call(True)
    for _ in range(rounds):
        for name, call in cases.items():
            spent[name].append((call(True)[0], call(False)[0]))
    base = difference(spent["rigid, on nodes"])
    for name, call in cases.items():
        middle = call(True)[1]
        miss = float("nan") if name.startswith("rigid") else distance(middle, exact)
        least = difference(spent[name])
        yield Step(name, models[name].nu, 1e6 * least / n, least / base, miss)


def distance(found: Array, exact: Array) -> float:
    """Root mean square distance of the middle from where it should be [m]."""
    return float(np.sqrt(((found - exact) ** 2).sum(axis=1).mean()))


def reference() -> Array:
    """The middle of the rod with twice the modes, at a tight tolerance."""
    model = cd.compile(problem.slider_crank("chord", 2 * problem.MODES))
    return problem.middle(problem.run(model, method="Radau", rtol=1e-8, atol=1e-11)[1])


def cable_reference() -> Array:
    """The middle of ever finer cables, whose theory of beams is another one."""
    coarse, fine = (exudyn.run(exudyn.cable, 16, n)[1] for n in (2000, 4000))
    return np.asarray(fine + (fine - coarse) / 3)


def cases(models: dict[str, Any], steps: tuple[int, ...]) -> Iterator[Case]:
    """All that is compared: ours by two methods, Exudyn's by steps."""
    for frame in ("chord frame", "frame on the pin"):
        model, size = models[f"superelement, {frame}"], f"{problem.MODES} modes"
        for n in steps:
            options: dict[str, Any] = {"method": ALPHA, "step": problem.TURN / n}
            yield Case(f"cardan, {frame}", size, f"{n} steps", _ours(model, True, options))
        for rtol in TOLERANCES:
            options = {"method": "Radau", "rtol": rtol, "atol": 1e-2 * rtol}
            yield Case(f"cardan, {frame}", size, f"Radau {rtol:.0e}", _ours(model, True, options))
    for n in steps:
        for name, build, sizes, word in (
            ("Exudyn, reduced FFRF", exudyn.floating_frame, (problem.MODES,), "modes"),
            ("Exudyn, ANCF cable", exudyn.cable, (2, 4, 8), "elements"),
        ):
            for size_ in sizes:
                for sparse in (False, True):
                    yield Case(
                        name,
                        f"{size_} {word}",
                        f"{n} steps" + ", sparse" * sparse,
                        partial(_theirs, build, size_, n, sparse),
                    )


def _theirs(build: Any, size: int, steps: int, sparse: bool, whole: bool) -> tuple[float, Array]:
    return exudyn.run(build, size, steps, sparse, whole)


def curves(models: dict[str, Any], steps: tuple[int, ...], rounds: int) -> Iterator[Point]:
    """Time of a turn, without its start, beside the error of the middle; turn by turn."""
    every, exact, of_cables = list(cases(models, steps)), reference(), cable_reference()
    spent: list[list[tuple[float, float]]] = [[] for _ in every]
    for _ in range(rounds):
        for times, case in zip(spent, every, strict=True):
            times.append((case.call(True)[0], case.call(False)[0]))
    for times, case in zip(spent, every, strict=True):
        target = of_cables if "cable" in case.program else exact
        miss = distance(case.call(True)[1], target)
        yield Point(case.program, case.size, case.effort, difference(times), miss)


def main() -> int:
    """Measure, write, print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="little of it; writes no page")
    quick = parser.parse_args().quick
    if find_spec("exudyn") is None:
        print("superelement_runs: Exudyn is missing: pip install 'cardan[bench]'", file=sys.stderr)
        return MISSING
    rounds, models, exact = 2 if quick else 5, _models(), reference()
    found = Found(
        list(calls(CALLS)),
        list(instances(rounds, COUNTS[:2] if quick else COUNTS)),
        list(steps_of(models, rounds, exact)),
        list(curves(models, QUICK if quick else STEPS, 1 if quick else 3)),
        distance(cable_reference(), exact),
    )
    page.show(found)
    save("superelements.md", page.figures(found))
    if not quick:
        page.write(found, FOLDER)
    return 0


if __name__ == "__main__":
    sys.exit(main())
