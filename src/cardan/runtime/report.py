"""Measure every function of a model: what it costs and how exact it is."""

from __future__ import annotations

import importlib.util
import math
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from ..arrays import Array
from ..errors import CompilerMissing, DerivationError, ModelError, counted
from ..ir.serialize import from_dict
from ..schema.blocks import ORDER
from . import abi, cache, measuring, samples
from .batch import one_by_one
from .calling import Argument
from .loaded import LoadedFunction
from .measuring import BATCH, Row, timed

if TYPE_CHECKING:
    from rich.table import Table

    from ..analyses.precision import Precision
    from .compiled import CompiledModel

JUDGED = 3
MAIN = ("rhs", "forward_dynamics", "inverse_dynamics", "mass_matrix", "bias")


@dataclass(frozen=True)
class Report:
    """Cost and exactness of the functions of a model on this machine.

    Attributes:
        model: Its name.
        rows: One per function.
        compiler: What compiled them.
        way: How Python calls them: cython or ctypes.
        note: What rows mean; what could not be measured, and how to change that.
        methods: Speed against error of the integrators, where an end time was given.
    """

    model: str
    rows: tuple[Row, ...]
    compiler: str
    way: str
    note: str = ""
    methods: Precision | None = None

    def __repr__(self) -> str:
        methods = f", {counted(len(self.methods.points), 'run')}" if self.methods else ""
        return f"Report('{self.model}': {counted(len(self.rows), 'function')}{methods})"

    def table(self) -> Table:
        """As a table for the terminal."""
        from rich.table import Table

        title = f"{self.model}: {self.compiler}, called through {self.way}"
        table = Table(title=title, caption=self.note or None)
        table.add_column("function", no_wrap=True, max_width=34)
        for name in ("ops", "from Python", "in C", "in a batch", "lanes", "error"):
            table.add_column(name, justify="right", no_wrap=True)
        for row in self.rows:
            times = map(_shown, (row.python_ns, row.call_ns, row.state_ns))
            error = "-" if row.error is None else f"{row.error:.1e}"
            table.add_row(row.function, str(row.operations), *times, str(row.lanes), error)
        return table


def _shown(ns: float) -> str:
    return "-" if math.isnan(ns) else f"{ns:.0f} ns"


def report(model: CompiledModel, seed: int = 1) -> Report:
    """Measure the dynamics and every other function that is written; print the table.

    Returns:
        The numbers of the table.
    """
    from rich.console import Console

    judged = importlib.util.find_spec("mpmath") is not None
    notes = [] if judged else ["errors need mpmath: pip install mpmath"]
    if model.manifest.absolute:
        notes.append("of elements, <kind>__<function>: one element")
    rows = model._source.measured(model, seed, judged)
    result = Report(model.name, tuple(rows), _compiler(), abi.NAME, "; ".join(notes))
    Console().print(result.table())
    return result


def functions(model: CompiledModel, seed: int, judged: bool) -> list[Row]:
    """The dynamics and every other function that has C of its own."""
    for name in MAIN:
        # not asked for, or without meaning: udot where M of a massless tip is singular
        with suppress(DerivationError, ModelError):
            model.prepare(name)
    saved, rows = model._objects.saved(), []
    for function in model._load(model._written()):
        values = samples.values(model, function, np.random.default_rng(seed), BATCH)
        data = saved.get(function.symbol) if judged else None
        error = _error(model, function, data, values) if data else None
        rows.append(_measure(function, values, error))
    return rows


def _compiler() -> str:
    try:
        return cache.compiler().identity.splitlines()[0]
    except CompilerMissing:
        return "no C compiler, Python"


def _measure(function: LoadedFunction, values: dict[str, Array], error: float | None) -> Row:
    caller = function.caller
    one = [_first(values[a.name], a) for a in caller.arguments]
    many = samples.states(function, values, BATCH)
    # the batch as it is once it pays, in this thread
    lanes = caller.batch.build(False, caller.call, many)
    way = caller.batch.found(False, many) or one_by_one(caller.call, many)
    still = one_by_one(caller.call, replace(many, strides=[0] * len(many.strides)))
    return Row(
        function=function.symbol,
        operations=function.entry.total_operations,
        python_ns=timed(lambda: function.fast(None, *one), 1),
        call_ns=math.nan if function.interpreted else timed(lambda: still(0, BATCH), BATCH),
        state_ns=timed(lambda: way(0, BATCH), BATCH),
        lanes=lanes,
        error=error,
    )


def _first(array: Array, argument: Argument) -> Any:
    """The first state of a batch, as a user would give it."""
    return array[0].copy() if argument.shape else float(array[0])


def _error(
    model: CompiledModel, function: LoadedFunction, saved: dict[str, Any], values: dict[str, Array]
) -> float:
    """Largest |error| / |largest entry| of the C against 40 digits at some states."""
    exact = from_dict(saved)
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
        found = function.caller(None, *(values[a.name][k] for a in arguments))
        worst = max(worst, measuring.error(exact, blocks, found))
    return worst
