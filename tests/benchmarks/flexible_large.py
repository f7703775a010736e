"""A rubber beam of very many elements: derive, compile, plan and step it, and the memory it takes.

Prints processor times and peak memory of one process; nothing is asserted.

usage: flexible_large.py [ELEMENTS]
"""

from __future__ import annotations

import os
import resource
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

# the benchmarks stand in the folder above
sys.path.insert(0, str(Path(__file__).parents[1]))


import cardan as cd
from benchmarks import flexible_problem as problem
from cardan.runtime.models.finite_elements.table_loading import tables_of
from cardan.runtime.sparse.matrices import Matrices

T = TypeVar("T")
ELEMENTS, STEP, STEPS, ROUNDS = 100_000, 1e-5, 40, 3


@dataclass(frozen=True)
class Cost:
    """What an action took: time of the processor and in all [s], peak of memory since then [GB]."""

    what: str
    cpu: float
    wall: float
    peak: float

    def __str__(self) -> str:
        times = f"{self.cpu:8.2f} s of processor {self.wall:8.2f} s in all"
        return f"{self.what:<24} {times}, peak {self.peak:.2f} GB"


class Costs:
    """Actions one behind the other, in a process of their own for the sake of memory."""

    def __init__(self, elements: int = ELEMENTS) -> None:
        self.rows: list[Cost] = []
        equations = self._of("derive", lambda: cd.derive(problem.scene(elements), "absolute"))
        model = self._of("compile", lambda: cd.compile(equations))
        self._of("tables and plan", lambda: tables_of(model).once(Matrices.of))

        def run(steps: int) -> cd.Trajectory:
            method = cd.GeneralizedAlpha(problem.RHO_INF, index=3)
            return model.simulate(
                (0.0, steps * STEP), t_eval=(0.0, steps * STEP), method=method, step=STEP
            )

        self._of("first run, one step", lambda: run(1))
        # other work slows single calls: the least of each in turns counts
        turns = []
        for _ in range(ROUNDS):
            self._of("again", lambda: run(1))
            motion = self._of(f"{STEPS} steps", lambda: run(STEPS))
            turns.append(tuple(row.cpu for row in self.rows[-2:]))
        self.one, self.several = map(min, zip(*turns, strict=True))
        # what a free end falls before anything of the pin is felt there
        fall = -0.5 * problem.GRAVITY * (STEPS * STEP) ** 2
        self.told = f"tip fell {motion['z'][-1]:.6e} m, freely {fall:.6e} m; {motion.message}"

    @property
    def step(self) -> float:
        """Processor time of one more step [s]."""
        return (self.several - self.one) / (STEPS - 1)

    @property
    def start(self) -> float:
        """Processor time of a call with a step, less the step [s]: of one like an earlier one."""
        return self.one - self.step

    def _of(self, what: str, action: Callable[[], T]) -> T:
        wall, cpu = time.perf_counter(), time.process_time()
        found = action()
        wall, cpu = time.perf_counter() - wall, time.process_time() - cpu
        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6
        self.rows.append(Cost(what, cpu, wall, peak))
        return found


def main() -> int:
    """Measure and print."""
    n = int(sys.argv[1]) if len(sys.argv) > 1 else ELEMENTS
    print(f"{n} elements; load {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores")
    found = Costs(n)
    print(*found.rows, found.told, sep="\n")
    print(f"a step {1e3 * found.step:.1f} ms, a start {found.start:.2f} s of the processor")
    return 0


if __name__ == "__main__":
    sys.exit(main())
