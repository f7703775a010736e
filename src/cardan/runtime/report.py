"""Measure every function of a model: what it costs and how exact it is."""

from __future__ import annotations

import importlib.util
import math
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import CompilerMissing, DerivationError, ModelError
from ..ir.interpreter import evaluate
from ..ir.serialize import from_dict
from . import abi, cache, samples
from .batch import one_by_one
from .calling import Argument, Array
from .loaded import LoadedFunction
from .slots import ORDER

if TYPE_CHECKING:
    from rich.table import Table

    from ..analyses.precision import Precision
    from .compiled import CompiledModel

BATCH = 1024
JUDGED = 3
DIGITS = 40
ROUNDS = 5
PATIENCE = 2e-3
MAIN = ("rhs", "forward_dynamics", "inverse_dynamics", "mass_matrix", "bias")


@dataclass(frozen=True)
class Row:
    """One function.

    Attributes:
        function: C name.
        operations: Number of operators.
        python_ns: One call from Python with arrays for one state.
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


@dataclass(frozen=True)
class Report:
    """Cost and exactness of the functions of a model on this machine.

    Attributes:
        model: Its name.
        rows: One per function.
        compiler: What compiled them.
        way: How Python calls them: cython or ctypes.
        note: What could not be measured, and how to change that.
        methods: Speed against error of the integrators, where an end time was given.
    """

    model: str
    rows: tuple[Row, ...]
    compiler: str
    way: str
    note: str = ""
    methods: Precision | None = None

    def table(self) -> Table:
        """As a table for the terminal."""
        from rich.table import Table

        title = f"{self.model}: {self.compiler}, called through {self.way}"
        table = Table(title=title, caption=self.note or None)
        table.add_column("function", no_wrap=True, max_width=34)
        for name in ("ops", "from Python", "in C", "in a batch", "lanes", "error"):
            table.add_column(name, justify="right", no_wrap=True)
        for row in self.rows:
            times = (f"{ns:.0f} ns" for ns in (row.python_ns, row.call_ns, row.state_ns))
            error = "-" if row.error is None else f"{row.error:.1e}"
            table.add_row(row.function, str(row.operations), *times, str(row.lanes), error)
        return table


def report(model: CompiledModel, seed: int = 1) -> Report:
    """Measure the dynamics and every other function that is written; print the table.

    Returns:
        The numbers of the table.
    """
    from rich.console import Console

    for name in MAIN:
        # not asked for, or without meaning: udot where M of a massless tip is singular
        with suppress(DerivationError, ModelError):
            model.prepare(name)
    saved = model._objects.saved()
    judge, note = _judge()
    rows = []
    for function in model._load(model._written()):
        values = samples.values(model, function, np.random.default_rng(seed), BATCH)
        data = saved.get(function.symbol)
        error = judge(model, function, data, values) if data else None
        rows.append(_measure(function, values, error))
    result = Report(model.name, tuple(rows), _compiler(), abi.NAME, note)
    Console().print(result.table())
    return result


def _compiler() -> str:
    try:
        return cache.compiler().identity.splitlines()[0]
    except CompilerMissing:
        return "no C compiler, NumPy"


def _measure(function: LoadedFunction, values: dict[str, Array], error: float | None) -> Row:
    caller = function.caller
    one = [_first(values[a.name], a) for a in caller.arguments]
    many = samples.states(function, values)
    # the batch as it is once it pays, in this thread
    lanes = caller.batch.build(False, caller.call, many)
    way = caller.batch.found(False, many) or one_by_one(caller.call, many)
    still = one_by_one(caller.call, replace(many, strides=[0] * len(many.strides)))
    return Row(
        function=function.symbol,
        operations=sum(function.entry["operations"].values()),
        python_ns=_time(lambda: function.fast(None, *one), 1),
        call_ns=_time(lambda: still(0, BATCH), BATCH) if function.address else math.nan,
        state_ns=_time(lambda: way(0, BATCH), BATCH),
        lanes=lanes,
        error=error,
    )


def _first(array: Array, argument: Argument) -> Any:
    """The first state of a batch, as a user would give it."""
    return array[0].copy() if argument.shape else float(array[0])


def _time(run: Callable[[], Any], states: int) -> float:
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


Judge = Callable[["CompiledModel", LoadedFunction, dict[str, Any], dict[str, Array]], float | None]


def _judge() -> tuple[Judge, str]:
    """What finds the error of a function, and a note where it cannot."""
    if importlib.util.find_spec("mpmath") is None:
        return lambda *_: None, "errors need mpmath: pip install mpmath"
    return _error, ""


def _error(
    model: CompiledModel, function: LoadedFunction, saved: dict[str, Any], values: dict[str, Array]
) -> float:
    """Largest |error| / |largest entry| of the C against 40 digits at some states."""
    exact_function = from_dict(saved)
    arguments = function.caller.arguments
    worst = 0.0
    for k in range(JUDGED):
        blocks: dict[str, Any] = {"p": model.parameters.vector.tolist()}
        for argument in arguments:
            flat = np.atleast_1d(values[argument.name][k]).reshape(-1)
            starts = [first for _, first in argument.blocks]
            for (slot, first), end in zip(
                argument.blocks, [*starts[1:], argument.size], strict=True
            ):
                blocks[ORDER[slot]] = flat[first:end].tolist()
        exact = evaluate(exact_function, blocks, "mp", DIGITS)
        numbers = [x for o in exact_function.outputs for x in exact[o.name]]
        found = function.caller(None, *(values[a.name][k] for a in arguments)).reshape(-1)
        largest = max((abs(x) for x in numbers), default=0)
        errors = [abs(x - float(y)) for x, y in zip(numbers, found, strict=True)]
        if largest:
            worst = max(worst, float(max(errors) / largest))
    return worst
