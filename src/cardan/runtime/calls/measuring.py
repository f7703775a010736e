"""Cost of one function from Python, in C and in lanes."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from ...arrays import Array
from ...ir.function import Function
from ...ir.interpreter import evaluate
from ...records import dataclass

BATCH = 1024
DIGITS = 40
TINY = 1e-30
ROUNDS = 5
PATIENCE = 2e-3


@dataclass(frozen=True)
class Row:
    """One function.

    Attributes:
        function: C name.
        operations: Number of operators.
        python_ns: One call from Python with arrays for one state; NaN where only C calls it.
        call_ns: One call in a C loop at the same state again and again; NaN without a compiler.
        state_ns: Per state in a batch of 1024.
        lanes: States done at once in the batch.
        error: Largest |error| / |largest entry| against 40 digits at three random states; None
            where it could not be judged.
    """

    function: str
    operations: int
    python_ns: float
    call_ns: float
    state_ns: float
    lanes: int
    error: float | None


def timed(run: Callable[[], Any], states: int) -> float:
    """Best time of some rounds per state [ns]."""
    run()
    start = time.perf_counter()
    run()
    once = time.perf_counter() - start
    repeat = max(1, int(PATIENCE / max(once, 1e-7)))
    best = float("inf")
    for _ in range(ROUNDS):
        start = time.perf_counter()
        for _ in range(repeat):
            run()
        best = min(best, time.perf_counter() - start)
    return best / repeat / states * 1e9


def error(function: Function, blocks: Mapping[str, object], value: Array) -> float:
    """Largest |error| / |largest entry| of results at one state against 40 digits."""
    exact = evaluate(function, blocks, "mp", DIGITS)
    numbers = [x for o in function.outputs for x in exact[o.name]]
    largest = max((abs(x) for x in numbers), default=0)
    errors = [abs(x - float(y)) for x, y in zip(numbers, np.ravel(value), strict=True)]
    # what is 0 up to the digits has nothing to be measured by
    return float(max(errors) / largest) if largest > TINY else float(max(errors, default=0))
