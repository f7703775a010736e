"""What scenes with beams are to reach, and reach, where no other program is needed for it."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from multiprocessing import get_context
from pathlib import Path

import numpy as np

import cardan as cd
from benchmarks import flexible, flexible_cable, flexible_large, mixed, sparse
from mechanisms.flexible import bend45

TESTS = Path(__file__).parents[1]
# times of factor and solve of a chain by its number of nodes, prototype and SuperLU beside it [us]
SOLVED = {10: (3.2, 1.3), 100: (38, 13), 1000: (400, 131), 10_000: (9400, 1640)}
# balance with tangent of an element by itself and in lanes [ns]
ELEMENTS = {"hellinger_reissner": (1000, 250), "linked_inertia": (600, 150)}
COLD = """
import sys
sys.path.insert(0, sys.argv[1])
import cardan as cd
from benchmarks import flexible_problem as problem
model = cd.compile(cd.derive(problem.scene(int(sys.argv[2]))))
model.forward_dynamics(*model.split(model.initial()))
"""


@dataclass(frozen=True)
class Figure:
    """One figure: what was measured, what it is to be at most, what it is, whether that holds."""

    what: str
    target: str
    found: str
    reached: bool


def figures(quick: bool = False) -> Iterator[Figure]:
    """All of them; quick: without very many elements."""
    yield _bend()
    yield from _elements()
    yield from _solved(1000 if quick else 10_000)
    for n in (10, 1000):
        spent = _cold(n)
        text = f"derived, written, compiled and called the first time, {n} elements"
        yield Figure(text, "3 s", f"{spent:.1f} s", spent <= 3)
    yield from _mixed((2,) if quick else (2, 8, 32))
    if not quick:
        yield from _cables()
        yield from _large()


def _bend() -> Figure:
    known = json.loads((TESTS / "references" / "bend45.json").read_text(encoding="utf-8"))
    wanted = np.array(known["reference"]["tip_position_own"]["J_1/6"]["600"])
    found = cd.compile(bend45(8)).equilibrium()
    tip = np.array([found[f"bend.end.{c}"] for c in ("px", "py", "pz")])
    error, steps = float(np.abs(tip - wanted).max()), found.iterations
    return Figure(
        "45-degree bend, 8 elements, whole load at once (radius 100)",
        "1.5e-3, 9 iterations",
        f"{error:.2e}, {steps} iterations",
        error <= 1.5e-3 and steps <= 9,
    )


def _elements() -> Iterator[Figure]:
    for kind, (alone, simd) in ELEMENTS.items():
        rows = [r for r in flexible.measured([kind]) if r.function.startswith("balance")]
        one, several = sum(r.alone for r in rows), sum(r.simd for r in rows)
        yield Figure(
            f"{kind}: balance and tangent, by itself / in lanes",
            f"{alone} / {simd} ns",
            f"{one:.0f} / {several:.0f} ns",
            one <= alone and several <= simd,
        )


def _solved(most: int) -> Iterator[Figure]:
    for row in sparse.measured(["chain"], most):
        if row.nodes in SOLVED:
            factor, solve = SOLVED[row.nodes]
            own, other = 1e6 * row.factor, 1e6 * row.solve
            theirs = f"{1e6 * row.superlu_factor:.0f} / {1e6 * row.superlu_solve:.0f}"
            yield Figure(
                f"chain of {row.nodes:,}: factor / solve (SuperLU {theirs} us)",
                f"{factor} / {solve} us",
                f"{own:.1f} / {other:.1f} us",
                own <= factor and other <= solve,
            )


def _cold(n: int) -> float:
    """Seconds of a new process with an empty cache but for the kernels, which serve every model."""
    with tempfile.TemporaryDirectory(prefix="cardan-cold-") as cache:
        given = os.environ | {"CARDAN_CACHE": cache}
        kernels = "from cardan.runtime.build import kernels; kernels.library()"
        subprocess.run([sys.executable, "-c", kernels], env=given, check=True)
        start = time.perf_counter()
        subprocess.run([sys.executable, "-c", COLD, str(TESTS), str(n)], env=given, check=True)
        return time.perf_counter() - start


def _mixed(sizes: tuple[int, ...]) -> Iterator[Figure]:
    for n in sizes:
        found = mixed.robots(n)
        most = 1.5 * found["rod"] + found["robot"]
        yield Figure(
            f"UR5 with a flexible rod of {n} elements, a step of 1 ms: 1.5 of the clamped rod"
            " and the rigid robot",
            f"{1e6 * most:.0f} us",
            f"{1e6 * found['both']:.0f} us",
            found["both"] <= most,
        )
    spent, apart = mixed.bodies_on_nodes()
    yield Figure(
        f"{mixed.BODIES} rigid bodies on nodes, {mixed.FEW} steps: at most Exudyn's time "
        f"({1e6 * apart:.2g} um apart)",
        f"{1e3 * spent['Exudyn']:.0f} ms",
        f"{1e3 * spent['cardan']:.0f} ms",
        spent["cardan"] <= spent["Exudyn"],
    )
    start = spent["start"]
    title = f"{mixed.BODIES} rigid bodies on nodes, a run of one step"
    yield Figure(title, "5 ms", f"{1e3 * start:.1f} ms", start <= 5e-3)


def _cables() -> Iterator[Figure]:
    for pair in flexible_cable.pairs():
        yield Figure(
            f"3-D cable of {pair.elements} elements, {1e3 * pair.error:.2g} mm: Exudyn's time of a "
            "step over cardan's for that error",
            f"{flexible_cable.AIM:g}",
            f"{pair.ratio:.1f}",
            pair.ratio >= flexible_cable.AIM,
        )


def _large() -> Iterator[Figure]:
    with ProcessPoolExecutor(1, get_context("spawn")) as alone:
        found = alone.submit(flexible_large.Costs).result()
    peak = found.rows[-1].peak
    yield Figure(
        f"{flexible_large.ELEMENTS:,} elements: start of a call like an earlier one",
        "0.5 s",
        f"{found.start:.2f} s",
        found.start <= 0.5,
    )
    yield Figure(
        f"{flexible_large.ELEMENTS:,} elements: a step of generalized-alpha, memory of the process",
        "50 ms, 2 GB",
        f"{1e3 * found.step:.0f} ms, {peak:.2f} GB",
        found.step <= 50e-3 and peak <= 2,
    )
