"""Compiled functions against the expressions they were written from."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import prod

import numpy as np

from ...errors import CardanError
from ...ir.function import Function
from ...ir.interpreter import evaluate
from ...ir.serialize import from_dict
from ...schema.c_functions import ResultRow
from .evaluation import Trial
from .joint_motion import Array

# Inputs are shaken by this, 45 roundings, to see what those inside of a function may do where terms
# cancel, and by how much more: what C contracts and NumPy does not is rounded in every operation.
# Zeros are shaken too, by as much of the largest entry: where exact zeros cancel in NumPy, a
# contracted product leaves its rounding.
SHAKEN, LESS = 1e-14, 1e3
# How often: of two constraints that say the same rounding leaves out one or the other, as a coin
# falls. That C and the expressions choose otherwise and no shake shows it has a chance of
# 2^-8 / 2, one in 512 of such functions; of more equal constraints it is less.
SHAKES = 8
# of digits that rounding takes, as a part of the result
LOST = 1e-3
# operations beyond which expressions take longer than the compiler; loops say so themselves
LARGEST = 60_000


def written(trial: Trial, name: str, of: str | None) -> float | str:
    """Error of a function at the states; why it could not be found."""
    model = trial.model
    function = model._function(name, of)
    saved = model._objects.saved().get(function.symbol)
    if saved is None:
        return "its expressions are not saved"
    if function.entry.total_operations > LARGEST:
        return f"more than {LARGEST} operations"
    blocks = {k: np.array(x, dtype=float) for k, x in _blocks(trial).items()}
    weights = (len(trial.reference.q), len(function.entry.vector))
    blocks["v"] = np.random.default_rng(9).uniform(-1, 1, weights)
    with np.errstate(all="ignore"):
        value = trial.call(name, of, blocks)
    expressions = from_dict(saved)
    expected = _flat(expressions, blocks, model.parameters.vector, value)
    error = _error(value, expected, function.outputs)
    if error <= 1e-11:
        return error
    rng = np.random.default_rng(6)
    shaken, p = 0.0, model.parameters.vector
    for _ in range(SHAKES):
        moved = {k: x + SHAKEN * _size(x) * rng.uniform(-1, 1, x.shape) for k, x in blocks.items()}
        # equal legs stay equal unless their lengths differ
        other = p * (1 + SHAKEN * rng.uniform(-1, 1, p.shape))
        near = _flat(expressions, moved, other, value)
        shaken = float(np.maximum(shaken, LESS * _error(near, expected, function.outputs)))
    if not shaken <= LOST:
        return "rounding decides its results"
    return error if not error <= shaken else 0.0


def _size(x: Array) -> Array:
    """Size of an entry, against which its rounding counts:

    structures stand where coordinates are 0.
    """
    return np.maximum(np.abs(x), min(1.0, float(np.abs(x).max(initial=0.0))))


def _blocks(trial: Trial) -> Mapping[str, Array]:
    """All that functions may read, nothing at its rest."""
    model, layout, rng = trial.model, trial.model._layout, np.random.default_rng(7)
    n = len(trial.reference.q)
    more = {"lam": len(layout.multipliers), "du": model.nu, "e": len(layout.events)}
    blocks = {**trial.blocks, **{k: rng.uniform(-1, 1, (n, size)) for k, size in more.items()}}
    blocks["e"] = (blocks["e"] > 0).astype(float)
    blocks["q0"] = blocks["q"][::-1].copy()
    blocks["wrench"] = rng.uniform(-1, 1, (n, len(layout.parts), 6))
    blocks["z"] = blocks["z"] + rng.uniform(-0.3, 0.3, blocks["z"].shape)
    return blocks


def _flat(expressions: Function, blocks: Mapping[str, Array], p: Array, like: Array) -> Array:
    """Results one after the other (n, k)."""
    n = len(like)
    inputs = {k: x.reshape(n, x.size // n) for k, x in blocks.items()}
    try:
        return results(expressions, {**inputs, "p": p}, n)
    except CardanError:
        return np.full(like.reshape(n, -1).shape, np.nan)


def results(expressions: Function, inputs: Mapping[str, Array], n: int) -> Array:
    """Outputs of expressions at n states, one after the other (n, k).

    Raises:
        CardanError: they cannot be evaluated there.
    """
    with np.errstate(all="ignore"):
        values_of = evaluate(expressions, inputs, "numpy")
    parts = []
    for output in expressions.outputs:
        values, size = np.asarray(values_of[output.name], dtype=float), len(output.nodes)
        lead = values.shape[: values.ndim - len(output.shape)]
        parts.append(np.broadcast_to(values.reshape(*lead, size), (n, size)))
    return np.concatenate(parts, axis=-1)


def _error(value: Array, expected: Array, outputs: Sequence[ResultRow]) -> float:
    """Largest difference of an output over its largest entry; where both are not numbers, none."""
    value, worst, at = value.reshape(len(value), -1), 0.0, 0
    for output in outputs:
        size = prod(output.shape)
        a, b, at = value[:, at : at + size], expected[:, at : at + size], at + size
        both = np.isfinite(a) & np.isfinite(b)
        if (np.isfinite(a) != np.isfinite(b)).any():
            return np.inf
        most = np.abs(np.where(both, b, 0.0)).max(initial=0.0)
        difference = np.abs(np.where(both, a, 0.0) - np.where(both, b, 0.0)).max(initial=0.0)
        worst = max(worst, float(difference / (most or 1.0)))
    return worst
