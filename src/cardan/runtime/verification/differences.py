"""Slopes of functions known by their values alone, with an estimate of what they miss."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from .joint_motion import Array

# Rounding of either side stays below 1e-12 of the largest term even for chains of a hundred bodies;
# a wrong formula is wrong in the first digits. In between lies the bound.
BOUND = 1e-9
# of the eighth order at k = 1 ... 4 steps to either side
# Source: Fornberg, Math. Comp. 51 (1988), table 1.
_WEIGHTS = np.array([4 / 5, -1 / 5, 4 / 105, -1 / 280])
REACH = np.arange(1.0, 5.0)
# the longest step is this part of where a coordinate has moved by its own size; each is so much of
# the one before. Halves would see the same slow wave in place of a fast one, and agree on it
LONGEST, SHORTER = 0.1, 0.45
STEPS = 9
# states by which rounding is judged, and by how much of themselves their entries differ
SHAKES, SHAKEN = 8, 4e-16

Blocks = Mapping[str, Array]


def relative(difference: Array, *terms: Array) -> float:
    """Largest difference of a state over its largest term, the worst of all states.

    A difference that is not a number is wrong without bound: a larger one would hide it. So is one
    of an infinite term.
    """
    worst = _most(np.where(np.isnan(difference), np.inf, difference))
    size = np.max([_most(term) for term in terms], axis=0)
    return float(np.max(worst / np.where((size > 0) & (size < np.inf), size, 1.0), initial=0.0))


def _most(values: Array) -> Array:
    """Largest size of the entries of every state."""
    return np.asarray(np.abs(values).max(axis=tuple(range(1, values.ndim)), initial=0.0))


def central(ahead: Array, behind: Array) -> Array:
    """Change per step (...), to eighth order, of values (4, ...) at :data:`REACH` steps each way.

    The error is h^8 / 630 of the ninth derivative.
    """
    return np.asarray(np.tensordot(_WEIGHTS, ahead - behind, 1))


def slope(
    f: Callable[[dict[str, Array]], Array], at: Blocks, rates: Blocks, size: Array
) -> tuple[Array, Array]:
    """Derivative of ``f`` along ``rates``, and how far it may be off, (n, ...) each.

    Of two neighboring steps that agree best the shorter one is taken, entry by entry of the states.

    Args:
        f: Blocks of N states -> (N, ...).
        at: Blocks (n, size), or without states of their own.
        rates: Of some of them.
        size: How far a unit of the parameter of the line moves in terms of sizes, (n,).
    """
    n = len(size)
    steps = LONGEST / np.maximum(size, 1e-300) * SHORTER ** np.arange(STEPS)[:, None]
    away = np.concatenate([REACH, -REACH])[:, None, None] * steps  # (8, STEPS, n)
    near = [shaken(at, k) for k in range(SHAKES)]
    count, places = away.size + SHAKES * n, {}
    for name, value in at.items():
        shape = (n, np.shape(value)[-1])
        moved = value + away.reshape(-1, n, 1) * rates.get(name, np.zeros(shape))
        rounded = np.stack([np.broadcast_to(x[name], shape) for x in near])
        places[name] = np.concatenate([moved, rounded]).reshape(count, shape[-1])
    values = np.asarray(f(places))
    entries = values.size // count
    values, rounded = np.split(values.reshape(count, entries), [away.size])
    values = values.reshape(*away.shape, entries)
    rounded = np.where(np.isfinite(rounded), rounded, 0.0).reshape(SHAKES, n, entries)
    with np.errstate(invalid="ignore"):
        quotients = central(*np.split(values, 2)) / steps[..., None]
        quotients = np.where(np.isfinite(quotients), quotients, np.inf)
        disagreement = np.abs(np.diff(quotients, axis=0))
    disagreement = np.where(np.isfinite(disagreement), disagreement, np.inf).max(axis=-1)
    best = np.argmin(disagreement, axis=0)
    every = np.arange(n)
    # rounding of the values over the step, which two steps may share by chance
    blur = np.ptp(rounded, axis=0).max(axis=-1, initial=0.0)
    most = np.abs(np.where(np.isfinite(values), values, 0.0)).max(axis=(0, 1, 3), initial=0.0)
    rounding = np.maximum(4e-16 * most, blur) / steps[best + 1, every]
    return quotients[best + 1, every], disagreement[best, every] + rounding


def shaken(at: Blocks, seed: int) -> dict[str, Array]:
    """Blocks of which every number is rounded once more, by chance; modes stay what they are."""
    rng = np.random.default_rng(seed)
    changes = {k: SHAKEN * rng.uniform(-1, 1, np.shape(x)) for k, x in at.items()}
    return {k: x if k == "s" else x * (1 + changes[k]) for k, x in at.items()}


def ways(n: int, size: int) -> list[Array]:
    """Random ways (n, size): a fault in any column of a derivative shows along each of them."""
    rng = np.random.default_rng(8)
    return [rng.uniform(0.3, 1.0, (n, size)) * rng.choice([-1.0, 1.0], (n, size)) for _ in "ab"]


def missing(difference: Array, off: Array, derivative: Array, *terms: object) -> float:
    """Difference of two numbers beyond the error of either, over their largest term.

    States at which the slope says little are passed over: NaN where it says little at all of them.
    What is not finite where there is a slope is wrong without bound.
    """
    n = len(difference)
    derivative = np.asarray(derivative).reshape(n, -1)
    if (~np.isfinite(derivative).all(axis=-1) & np.isfinite(off)).any():
        return np.inf
    sizes = [
        np.abs(derivative).max(axis=-1, initial=0.0),
        np.abs(difference).max(axis=-1, initial=0.0),
    ]
    sizes += [np.abs(np.asarray(term)).reshape(n, -1).max(axis=-1, initial=0.0) for term in terms]
    most = np.max(sizes, axis=0)
    scale = np.where(most > 0, most, 1.0)
    sharp = np.isfinite(off) & (off <= SHARP * scale)
    if not sharp.any():
        return np.nan
    beyond = np.abs(difference - derivative).max(axis=-1, initial=0.0)[sharp] - MARGIN * off[sharp]
    return float(np.max(np.maximum(beyond, 0.0) / scale[sharp]))


def worst_of(*errors: float) -> float:
    """The largest of some errors; NaN where no comparison said anything."""
    return float(np.fmax.reduce(errors))


BLURRED = "its slopes are nowhere known well enough"
# slopes that are less certain than this part of their terms say nothing
SHARP = 1e-5
MARGIN = 20.0


def input_rates(names: Sequence[str], r: Array) -> Array:
    """Rates of inputs (..., nr): those that prescribe a motion have them as inputs of theirs."""
    place = {name: k for k, name in enumerate(names)}
    rates = np.zeros(r.shape)
    for name, k in place.items():
        if f"{name}.rate" in place:
            rates[..., k] = r[..., place[f"{name}.rate"]]
            rates[..., place[f"{name}.rate"]] = r[..., place[f"{name}.acceleration"]]
    return rates
