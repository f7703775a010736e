"""Measured cost and accuracy of every function of a model."""

from __future__ import annotations

import math
from contextlib import suppress
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from ...arrays import Array
from ...errors import DerivationError, ModelError
from ...ir.serialize import from_dict
from ...schema.blocks import ORDER
from . import measuring, samples
from .batch import one_by_one
from .calling import Argument
from .lanes import States
from .loaded_function import LoadedFunction
from .measuring import BATCH, Row, timed

if TYPE_CHECKING:
    from ..models.loaded_model import LoadedModel

EXACT_STATES = 3
MAIN = ("rhs", "forward_dynamics", "inverse_dynamics", "mass_matrix", "bias")


def functions(model: LoadedModel, seed: int, with_errors: bool) -> list[Row]:
    """The dynamics and every other function that has C of its own."""
    for name in MAIN:
        # not asked for, or without meaning: udot where M of a massless tip is singular
        with suppress(DerivationError, ModelError):
            model.prepare(name)
    saved, rows = model._objects.saved(), []
    for function in model._load(model._written()):
        values = samples.values(model, function, np.random.default_rng(seed), BATCH)
        data = saved.get(function.symbol) if with_errors else None
        error = _error(model, function, data, values) if data else None
        rows.append(_measure(function, values, error))
    return rows


def _measure(function: LoadedFunction, values: dict[str, Array], error: float | None) -> Row:
    caller = function.caller
    one = [_first(values[a.name], a) for a in caller.arguments]
    many = samples.states(function, values, BATCH)
    # the batch as it is once it pays, in this thread
    lanes = caller.batch.build(False, caller.call, many)
    way = caller.batch.lane_run(False, many) or one_by_one(caller.call, many)
    state_ns = timed(lambda: way(0, BATCH), BATCH)
    float_ns, float_error = math.nan, math.nan
    if caller.single is not None:
        float_ns, float_error = _in_floats(function, values, many)
    still = one_by_one(caller.call, replace(many, strides=[0] * len(many.strides)))
    return Row(
        function=function.symbol,
        operations=function.entry.total_operations,
        python_ns=timed(lambda: function.fast(None, *one), 1),
        call_ns=math.nan if function.interpreted else timed(lambda: still(0, BATCH), BATCH),
        state_ns=state_ns,
        lanes=lanes,
        error=error,
        float_ns=float_ns,
        float_error=float_error,
    )


def _in_floats(
    function: LoadedFunction, values: dict[str, Array], doubles: States
) -> tuple[float, float]:
    """Time of a state in a batch of float32 [ns], and its largest difference from doubles.

    Args:
        function: Of a model that has such batches.
        values: Arguments.
        doubles: The same states, with their results.
    """
    caller, floats = function.caller, samples.states(function, values, BATCH, dtype="float32")
    assert caller.single is not None
    caller.single.build(False, caller.call, floats)
    sizes = caller.single.sizes
    way = caller.single.lane_run(False, floats) or one_by_one(caller.call, floats, sizes)
    seconds = timed(lambda: way(0, BATCH), BATCH)
    scale = float(np.abs(doubles.out).max(initial=0.0)) or 1.0
    return seconds, float(np.abs(floats.out - doubles.out).max(initial=0.0)) / scale


def _first(array: Array, argument: Argument) -> Any:
    """The first state of a batch, as a user would give it."""
    return array[0].copy() if argument.shape else float(array[0])


def _error(
    model: LoadedModel, function: LoadedFunction, saved: dict[str, Any], values: dict[str, Array]
) -> float:
    """Largest |error| / |largest entry| of the C against 40 digits at some states."""
    exact = from_dict(saved)
    arguments = function.caller.arguments
    worst = 0.0
    for k in range(EXACT_STATES):
        blocks: dict[str, Any] = {"p": model.parameters.vector.tolist()}
        for argument in arguments:
            flat = np.atleast_1d(values[argument.name][k]).reshape(-1)
            starts = [first for _, first in argument.blocks]
            for (slot, first), end in zip(
                argument.blocks, [*starts[1:], argument.size], strict=True
            ):
                blocks[ORDER[slot]] = flat[first:end].tolist()
        value = function.caller(None, *(values[a.name][k] for a in arguments))
        worst = max(worst, measuring.error(exact, blocks, value))
    return worst
