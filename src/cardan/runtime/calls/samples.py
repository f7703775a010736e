"""Random arguments of a function: what it is measured with, and what its builds are compared at."""

from __future__ import annotations

from math import prod
from typing import TYPE_CHECKING

import numpy as np

from ...arrays import Array
from ...schema.blocks import ORDER, SLOT
from .argument_values import prepared
from .lanes import States
from .loaded_function import LoadedFunction

if TYPE_CHECKING:
    from ..models.loaded_model import LoadedModel

# where builds are compared
SEED, STATES = 1, 32


def values(
    model: LoadedModel, function: LoadedFunction, rng: np.random.Generator, count: int
) -> dict[str, Array]:
    """Random arguments, (count, ...): states inside limits; inputs, internal states and modes at
    their defaults."""
    arrays: dict[str, Array] = {}
    x = model.random_state(rng, (count,))
    q, u = model.split(x)
    states = {"q": q, "q0": q, "u": u, "x": x, "t": np.full(count, 0.3)}
    for argument in function.caller.arguments:
        if argument.name in "rzs" and argument.default is not None:
            default = np.broadcast_to(argument.default, (count, *argument.shape)).copy()
            states[argument.name] = default
        random = rng.uniform(-1, 1, (count, *argument.shape))
        arrays[argument.name] = states.get(argument.name, random)
    return arrays


def states(
    function: LoadedFunction,
    values: dict[str, Array],
    count: int,
    lane_parameters: bool = False,
    dtype: str = "float64",
) -> States:
    """The arguments as blocks, with room for the results of each of ``count`` states.

    Args:
        function: What is called.
        values: Arguments (count, ...) by name; a function of parameters alone has none.
        count: States.
        lane_parameters: Every state has parameters of its own; they are equal.
        dtype: Of all numbers.
    """
    blocks: list[Array | None] = [None] * len(ORDER)
    strides = [0] * len(ORDER)
    for argument in function.caller.arguments:
        array = values[argument.name]
        for slot, first in argument.blocks:
            blocks[slot] = np.ascontiguousarray(array, dtype).reshape(-1)[first:]
            strides[slot] = argument.size
    w = function.w
    if lane_parameters:
        w, strides[SLOT["w"]] = np.tile(w, count), len(w)
    if dtype == "float32":
        w = prepared(function.caller.name, w, function.caller.sources)
    blocks[SLOT["w"]] = w
    return States(blocks, strides, np.empty((count, prod(function.caller.shape)), dtype))


def build(model: LoadedModel, function: LoadedFunction, lane_parameters: bool = False) -> int:
    """Make the lane builds of a function now; returns the width in doubles, 1 where there is none.

    Args:
        lane_parameters: For states with parameters of their own.
    """
    arrays = values(model, function, np.random.default_rng(SEED), STATES)
    caller = function.caller
    if caller.single is not None:
        floats = states(function, arrays, STATES, lane_parameters, "float32")
        caller.single.build(lane_parameters, caller.call, floats)
        run = caller.single.lane_run(lane_parameters, floats)
        if run is not None:
            run(0, STATES)
            caller.judge(floats)
    doubles = states(function, arrays, STATES, lane_parameters)
    return caller.batch.build(lane_parameters, caller.call, doubles)
