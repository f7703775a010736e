"""Cost of elements, one by one and in lanes, and of the functions that add them up."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from ....arrays import Array
from ....ir.serialize import from_dict
from ...calls import loaded_function, measuring
from ...calls.lanes import unpacked
from ...calls.measuring import Row
from ..initial import start_of
from .assembled import Assembled
from .elements import State
from .mesh import NEEDED

if TYPE_CHECKING:
    from ..loaded_model import LoadedModel
    from .evaluation import Results

# functions of the whole mesh, and what they ask of elements
ASSEMBLED_CALLS = {
    "rhs": "rhs",
    "forward_dynamics": "accelerations",
    "inverse_dynamics": "balance",
    "energy": "energy",
}
ELEMENTS = ("balance", "balance_tangent")
EXACT_STATES = 3
# how far places are moved from where they start: elements are strained, not torn
MOVED = 1e-2


def rows(model: LoadedModel, seed: int, with_errors: bool) -> list[Row]:
    """Functions of the whole mesh, then elements kind by kind; errors are those of elements."""
    source = model._source
    assert isinstance(source, Assembled)
    results = source.results(model)
    rng, tables = np.random.default_rng(seed), results.tables
    start, _ = start_of(model, {}, {})
    q, u, _ = model.parts_of(start)
    at = State(
        q=results.mesh.move(q, MOVED * rng.uniform(-1, 1, tables.nu)),
        u=rng.uniform(-1, 1, tables.nu),
        udot=rng.uniform(-1, 1, tables.nu),
        lam=rng.uniform(-1, 1, tables.m),
        r=model._layout.start("r"),
        z=model._layout.start("z"),
        s=model._layout.start("s"),
    )
    return [*_assembled(model, results, q, u), *_elements(model, results, at, with_errors)]


def _assembled(model: LoadedModel, results: Results, q: Array, u: Array) -> Iterator[Row]:
    """Rows of the functions that add up the elements, called from Python."""
    entries = model.manifest.functions
    for name, call in ASSEMBLED_CALLS.items():
        operations = sum(
            len(group) * entries[group.kind.functions[form]].total_operations
            for group in results.tables.groups
            for form in NEEDED[call]
            if form in group.kind.functions
        )
        caller, inputs = model._function(name).caller, {"q": q, "u": u, "udot": 0 * u, "t": 0.0}
        inputs["x"] = start_of(model, {}, {})[0]
        values = [inputs.get(argument.name) for argument in caller.arguments]
        spent = measuring.timed(lambda c=caller, v=values: c(None, *v), 1)  # type: ignore[misc]
        yield Row(name, operations, spent, math.nan, math.nan, 1, None)


def _elements(model: LoadedModel, results: Results, at: State, with_errors: bool) -> Iterator[Row]:
    """The functions of every kind of element, for those of its largest group."""
    groups, saved = results.tables.groups, model._objects.saved()
    ordered = sorted(range(len(groups)), key=lambda k: -len(groups[k]))
    largest = {groups[k].kind.name: k for k in reversed(ordered)}
    for number in sorted(largest.values()):
        group, inputs = groups[number], results.mesh.read(number, at)
        kind = group.kind
        for symbol in (kind.functions[form] for form in ELEMENTS if form in kind.functions):
            code = model._objects.load([symbol])[0]
            which = np.arange(measuring.BATCH) % len(group)
            rows = {name: x[which] if x.ndim > 1 else x for name, x in inputs.items()}
            run, out = loaded_function.calls(code, rows, len(which))
            spent = measuring.timed(run, len(which)) if code.interpreted is None else math.nan
            run()
            single, lanes = (math.nan, spent) if code.lanes > 1 else (spent, math.nan)
            several = unpacked(out, code.lanes)[: len(group)]
            expressions = saved.get(symbol) if with_errors else None
            error = _error(expressions, inputs, several) if expressions else None
            operations = code.entry.total_operations
            yield Row(symbol, operations, math.nan, single, lanes, code.lanes, error)


def _error(saved: dict[str, Any], inputs: dict[str, Array], values: Array) -> float:
    """Largest error of the first elements against 40 digits."""
    function, worst = from_dict(saved), 0.0
    for k in range(min(EXACT_STATES, len(values))):
        one = {name: (x[k] if x.ndim > 1 else x).tolist() for name, x in inputs.items()}
        worst = max(worst, measuring.error(function, one, values[k]))
    return worst
