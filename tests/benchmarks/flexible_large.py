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
from pathlib import Path
from typing import TypeVar

# the benchmarks stand in the folder above
sys.path.insert(0, str(Path(__file__).parents[1]))

import numpy as np

import cardan as cd
from benchmarks import flexible_problem as problem
from cardan.runtime.absolute.loading import tables_of
from cardan.runtime.absolute.matrices import Matrices

T = TypeVar("T")
ELEMENTS, STEP, STEPS = 100_000, 1e-5, 10


def _told(what: str, action: Callable[[], T]) -> T:
    """The result of an action, whose cost is printed."""
    wall, cpu = time.perf_counter(), time.process_time()
    found = action()
    wall, cpu = time.perf_counter() - wall, time.process_time() - cpu
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6
    print(f"{what:<24} {cpu:8.2f} s of processor {wall:8.2f} s in all, peak {peak:.2f} GB")
    return found


def main() -> int:
    """Measure and print."""
    n = int(sys.argv[1]) if len(sys.argv) > 1 else ELEMENTS
    print(f"{n} elements; load {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores")
    equations = _told("derive", lambda: cd.derive(problem.scene(n), "absolute"))
    model = _told("compile", lambda: cd.compile(equations))
    _told("tables and plan", lambda: tables_of(model).once(Matrices.of))

    def run(steps: int) -> cd.Trajectory:
        method = cd.GeneralizedAlpha(problem.RHO_INF, index=3)
        return model.simulate(np.linspace(0, steps * STEP, 2), method=method, step=STEP)

    _told("first run, one step", lambda: run(1))
    _told("again", lambda: run(1))
    motion = _told(f"{STEPS} steps", lambda: run(STEPS))
    # what a free end falls before anything of the pin is felt there
    fall = -0.5 * problem.GRAVITY * (STEPS * STEP) ** 2
    print(f"tip fell {motion['z'][-1]:.6e} m, freely {fall:.6e} m; {motion.message}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
