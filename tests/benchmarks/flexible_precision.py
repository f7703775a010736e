"""Error against time of implicit methods over beams: ``python -m benchmarks.flexible_precision``.

The error is the largest of all coordinates at the output times, against DOP853 at a tight
tolerance; times are those of the processor, the least of three runs.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from rich.console import Console
from rich.table import Table

import cardan as cd
from mechanisms.flexible import pendulum, slider_crank

RUNS = 3
CASES: dict[str, tuple[Any, float, float]] = {
    "rubber pendulum, 4 elements, 0.3 s": (lambda: pendulum(4), 0.3, 1e-11),
    "slider-crank, 4 elements, 0.02 s": (lambda: slider_crank(4), 0.02, 1e-11),
}
METHODS = {"GeneralizedAlpha": (1e-4, 1e-6, 1e-8), "Radau": (1e-3, 1e-4, 1e-5, 1e-6, 1e-8)}


@dataclass(frozen=True)
class Row:
    """One run: its method and tolerance, steps, time [ms] and error [m]."""

    case: str
    method: str
    rtol: float
    steps: int
    milliseconds: float
    error: float


def measured(cases: dict[str, tuple[Any, float, float]] = CASES) -> Iterator[Row]:
    """Every method at every tolerance."""
    for name, (build, span, finest) in cases.items():
        model, times = cd.compile(build()), np.linspace(0, span, 11)
        exact = model.simulate(times, method="DOP853", rtol=finest, atol=1e-13).q
        for method, tolerances in METHODS.items():
            for rtol in tolerances:
                spent = []
                for _ in range(RUNS):
                    begun = time.process_time()
                    motion = model.simulate(times, method=method, rtol=rtol)
                    spent.append(1e3 * (time.process_time() - begun))
                error = float(np.abs(motion.q - exact).max())
                yield Row(name, method, rtol, motion.statistics["steps"], min(spent), error)


def table(rows: list[Row]) -> Table:
    """The rows to print."""
    printed = Table(title="beams: error against time")
    for title in ("case", "method", "rtol", "steps", "ms", "error"):
        printed.add_column(title)
    for row in rows:
        printed.add_row(
            *(row.case, row.method, f"{row.rtol:.0e}", f"{row.steps}"),
            *(f"{row.milliseconds:.0f}", f"{row.error:.1e}"),
        )
    return printed


def main() -> None:
    """Measure and print."""
    Console().print(table(list(measured())))


if __name__ == "__main__":
    main()
