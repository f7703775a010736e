"""Long loops and many loops of rigid bodies: times beside errors, from 20 to 2,000 links.

Measures the N four-bars of the IFToMM library (problem A02) over all singular positions of 10 s, in
each kind of coordinates, and chains between two pivots: building, equilibria, accelerations and
runs. Times are those of the processor in one process, the least of several, but for cold starts: a
process of its own with an empty cache. Writes docs/performance/large_loops.md and prints its
tables. Times are reported, never asserted.

usage: large_loops.py [--quick]
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

# the zoo and the references stand in the folder above
sys.path.insert(0, str(Path(__file__).parents[1]))

import numpy as np
from rich.console import Console
from rich.table import Table

import cardan as cd
from benchmarks.all_figures import save
from benchmarks.cold import cold, cold_process
from benchmarks.figures import Figure
from benchmarks.page import markdown
from benchmarks.provenance import signed
from mechanisms.closed_planar import arc_angles, hanging_chain, parallelogram
from references.test_large_loops import (
    SPAN,
    chain_accelerations,
    crank_angle,
    hanging_angles,
    pins,
    start_of_cranks,
)

FOLDER = Path(__file__).parents[2] / "docs" / "performance"
WINDOWS, LINKS = (1, 2, 4, 8, 16, 32), (20, 200, 2000)
# joint coordinates of more windows are compiled for minutes
MOST_RELATIVE, TIGHT = 16, {"method": "DOP853", "rtol": 1e-10, "atol": 1e-12}
ROUNDS = 5
# seconds of a step, short, so that all chains take the same number of them, and how many
EXPLICIT, IMPLICIT = (2e-7, 40), (1e-4, 400)
HEADINGS = ("windows", "coordinates", "speeds", "10 s [s]", "steps", "passed", "error [rad]")
CHAINS = (
    "links", "acceleration", "error", "explicit step", "implicit step", "equilibrium",
    "error [rad]",
)  # fmt: skip
TEXT = """# Long loops

Rigid scenes with long loops or many loops
([how coordinates are chosen](../coordinates.md#what-each-kind-offers)), against the motion and the
equilibrium that their own equations give. Written by `tests/benchmarks/large_loops.py`. Times are
seconds of the processor, the least of several runs, on a machine that others used too. Those of
first use include the compiler of C; kernels, which serve every model, are there.

## Figures to reach

"""
FOUR_BARS = """
## N four-bars over their singular positions

Problem A02 of the IFToMM library: N windows of four equal bars under gravity. For 10 s all cranks
and couplers come to lie on one line ten times, where N + 1 motions branch. All cranks turn as one,
which gives one equation for their angle; the error is the largest of all cranks at 41 times. By
`DOP853` with `rtol=1e-10`.

"""
HANGING = """
## Chains between two pivots

Planar chains of equal rods in the coordinates that are chosen for them, per link [us].
Accelerations and equilibria are compared with equations in absolute angles. Explicit steps are
those of `DOP853` (12 evaluations), implicit ones of `GeneralizedAlpha`, by the difference of runs
of few and of many steps.

"""


@dataclass(frozen=True)
class Passing:
    """A run of N four-bars: processor time [s], steps, singular positions, error [rad]."""

    windows: int
    coordinates: str
    speeds: int
    seconds: float
    steps: int
    passed: int
    error: float


@dataclass(frozen=True)
class Chain:
    """Processor times of a chain per link [s], with errors relative to the equations in angles."""

    links: int
    acceleration: float
    acceleration_error: float
    explicit: float
    implicit: float
    equilibrium: float
    equilibrium_error: float

    def growth(self, other: Chain) -> Iterator[tuple[str, float]]:
        """How much longer that takes per link than with another one."""
        for name in ("acceleration", "explicit", "implicit", "equilibrium"):
            yield name, getattr(self, name) / getattr(other, name)


def least(work: Callable[[], object], rounds: int = ROUNDS) -> float:
    """Seconds of the processor."""
    spent = []
    for _ in range(rounds):
        begin = time.process_time()
        work()
        spent.append(time.process_time() - begin)
    return min(spent)


def passing(windows: int, coordinates: str) -> Passing:
    """Ten seconds of N four-bars."""
    plane = "auto" if coordinates == "absolute" else None
    model = cd.compile(parallelogram(windows), coordinates=coordinates, plane=plane)
    q, times = start_of_cranks(model, windows), np.linspace(0, 10, 41)

    def run() -> cd.Trajectory:
        return model.simulate(times, q=q, u={"A0": -1.0}, **TIGHT)

    motion, exact = run(), crank_angle(windows, times)
    error = max(float(np.abs(motion[f"A{k}"] - exact).max()) for k in range(windows + 1))
    count = motion.statistics
    spent = least(run, 3)
    return Passing(windows, coordinates, model.nu, spent, count["steps"], count["passed"], error)


def chain(links: int) -> Chain:
    """A chain in the coordinates that are chosen for it."""
    model = cd.compile(hanging_chain(links))
    a = np.array(arc_angles(links, SPAN))
    start = pins(a)
    q, u = model.split(model.initial(start))
    udot = dict(zip(model.speeds, model.forward_dynamics(q, u), strict=True))
    turning = np.cumsum([udot[f"pin{k}.u"] for k in range(links)])
    exact = chain_accelerations(a, np.zeros(links))
    rest = model.equilibrium(q=start)
    at = dict(zip(model.coordinates, rest.q, strict=True))
    angles = np.cumsum([at[f"pin{k}"] for k in range(links)])

    def steps(count: int, length: float, **how: object) -> float:
        end = count * length
        return least(lambda: model.simulate((0, end), t_eval=(0, end), q=start, **how), 2)

    explicit = {"method": "DOP853", "max_step": EXPLICIT[0], "rtol": 1e-3, "atol": 1e-3}
    implicit = {"method": cd.GeneralizedAlpha(), "step": IMPLICIT[0]}
    more = [
        (steps(count + 2, step, **how) - steps(2, step, **how)) / count / links
        for (step, count), how in ((EXPLICIT, explicit), (IMPLICIT, implicit))
    ]
    calls = 10
    return Chain(
        links,
        least(lambda: [model.forward_dynamics(q, u) for _ in range(calls)]) / calls / links,
        float(np.abs(turning - exact).max() / np.abs(exact).max()),
        more[0],
        more[1],
        least(lambda: model.equilibrium(q=start), 3) / links,
        float(np.abs(angles - hanging_angles(links)).max()),
    )


def figures(
    runs: list[Passing], chains: list[Chain], starts: dict[str, dict[str, float]]
) -> Iterator[Figure]:
    """What is to be reached."""
    for kind in dict.fromkeys(run.coordinates for run in runs):
        worst = max(run.error for run in runs if run.coordinates == kind)
        yield Figure(f"A02, all N, {kind} coordinates, error", 1e-6, worst, "rad")
    for name, row in starts.items():
        for what, target, unit, scale in (
            ("built", 2, "s", 1), ("equilibrium", 1, "s", 1),
            ("equilibrium without angles", 1, "s", 1), ("simulated", 3, "s", 1),
            ("step", 0.3, "ms", 1e3),
        ):  # fmt: skip
            if what in row:
                yield Figure(f"{name}, {what}", target, scale * row[what], unit)
    for name, ratio in chains[-1].growth(chains[0]):
        text = f"{name} per link, {chains[-1].links:,} of {chains[0].links} links"
        yield Figure(text, 1.3, ratio)


def rows(runs: list[Passing]) -> list[tuple[str, ...]]:
    """The table of the four-bars."""
    return [
        (str(r.windows), r.coordinates, str(r.speeds), f"{r.seconds:.3f}", str(r.steps),
         str(r.passed), f"{r.error:.1e}") for r in runs
    ]  # fmt: skip


def links(chains: list[Chain]) -> list[tuple[str, ...]]:
    """The table of the chains."""
    return [
        (f"{c.links:,}", f"{1e6 * c.acceleration:.2f}", f"{c.acceleration_error:.1e}",
         f"{1e6 * c.explicit:.1f}", f"{1e6 * c.implicit:.2f}", f"{1e6 * c.equilibrium:.0f}",
         f"{c.equilibrium_error:.1e}") for c in chains
    ]  # fmt: skip


def main() -> int:
    """Measure, write, print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="the small ones; writes no page")
    parser.add_argument("--cold", help=argparse.SUPPRESS)
    given = parser.parse_args()
    if given.cold:
        print(json.dumps(cold(given.cold)))
        return 0
    windows, chain_sizes = (WINDOWS[:3], LINKS[:2]) if given.quick else (WINDOWS, LINKS)
    runs = [passing(n, "relative") for n in windows if n <= MOST_RELATIVE]
    runs += [passing(n, "absolute") for n in windows]
    chains = [chain(n) for n in chain_sizes]
    cases = ("chain 20", "chain 200", "A02 32")
    starts = {case: cold_process(case) for case in (cases[:1] if given.quick else cases)}
    reached = [row.texts() for row in figures(runs, chains, starts)]
    save("large_loops.md", reached)
    tables = (
        (("figure", "target", "measured", ""), reached, TEXT),
        (HEADINGS, rows(runs), FOUR_BARS),
        (CHAINS, links(chains), HANGING),
    )
    for headings, lines, _ in tables:
        table = Table(*headings, box=None)
        for line in lines:
            table.add_row(*line)
        Console(width=120).print(table, "")
    if not given.quick:
        parts = [text + "\n".join(markdown(h, lines)) + "\n" for h, lines, text in tables]
        (FOLDER / "large_loops.md").write_text(signed("".join(parts)), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
