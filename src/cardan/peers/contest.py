"""Contenders in turn, round after round: what slows the machine slows all of them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from time import perf_counter

import numpy as np

from ..arrays import Array
from ..records import dataclass
from .peer import States

# seconds of one run; short against what disturbs a machine, long against its clock
RUN = 4e-3
ROUNDS = 9
Run = Callable[[int], float]


@dataclass(frozen=True)
class Time:
    """Seconds per call.

    Attributes:
        least, median: Of all rounds.
    """

    least: float
    median: float


def contest(runs: Mapping[str, Run], rounds: int = ROUNDS) -> dict[str, Time]:
    """Time programs against each other.

    Args:
        runs: Name -> ``run(repeats)``, the seconds per call.
        rounds: How often everybody has a turn.
    """
    repeats = {name: _repeats(run) for name, run in runs.items()}
    times: dict[str, list[float]] = {name: [] for name in runs}
    for _ in range(rounds):
        for name, run in runs.items():
            times[name].append(run(repeats[name]))
    return {name: Time(min(t), float(np.median(t))) for name, t in times.items()}


def _repeats(run: Run) -> int:
    """Repeats that take about ``RUN`` seconds."""
    run(1)
    began = perf_counter()
    run(1)
    return max(1, round(RUN / max(perf_counter() - began, 1e-9)))


def relative(values: Array, expected: Array) -> float:
    """max|error| / max|value|, the worst of all states."""
    rows = len(expected)
    error = np.abs(values - expected).reshape(rows, -1).max(axis=1)
    size = np.abs(expected).reshape(rows, -1).max(axis=1)
    return float((error / np.where(size > 0, size, 1.0)).max())


def few(states: States, count: int) -> States:
    """The first states."""
    return States(states.q[:count], states.u[:count], states.third[:count])
