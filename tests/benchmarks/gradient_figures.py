"""What is to be reached by gradients, for the table of all figures."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

# times of its simulation that a gradient may take, and of ours that CVODES should take at least
AIMS = {
    "double pendulum": (3.0, 80.0),
    "Panda with its hand": (4.0, 100.0),
    "four-bar, closed loop": (5.0, math.nan),
}
PRODUCT = 100.0  # ns that a product by state and parameters may take in lanes


def figures(
    rows: Sequence[Sequence[str]], by_lanes: Sequence[Sequence[str]]
) -> Iterator[tuple[str, str, str, str]]:
    """Figures to reach, for the table of all."""
    starts = [k for k, row in enumerate(rows) if row[0]]
    for first, end in zip(starts, [*starts[1:], len(rows)], strict=True):
        name = rows[first][0].split(" (")[0]
        most, least = AIMS[name]
        times, peers = float(rows[first][4]), [float(row[5]) for row in rows[first + 1 : end]]
        verdict = "yes" if times <= most else "no"
        yield f"{name}, gradient by its simulation", f"≤ {most:g}", f"{times:g}", verdict
        if peers and not math.isnan(least):
            verdict = "yes" if min(peers) >= least else "no"
            yield f"{name}, gradient by CVODES", f"≥ {least:g}", f"{min(peers):g}", verdict
    for name, *_, cell in by_lanes:
        time = float(cell.split(" / ")[0])
        verdict = "yes" if time <= PRODUCT else "no"
        yield f"{name}, product in lanes", f"≤ {PRODUCT:g} ns", f"{time:g} ns", verdict
