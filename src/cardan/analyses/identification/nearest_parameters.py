"""The parameters of a model nearest to its own that have given base parameters.

Source: Gautier, Briot and Venture, Identification of Consistent Standard Dynamic Parameters of
Industrial Robots, IEEE/ASME AIM (2013), for the least change; here in the user's parameters.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from ...arrays import Array, Booleans
from .base_parameters import Base

if TYPE_CHECKING:
    from ...runtime.models.loaded_model import LoadedModel

STEP = 1e-6  # of central differences, relative: phi is of third degree in p at most
STEPS, MET = 30, 1e-12
# a parameter that is 0 may change like this part of those with its unit
SMALL = 0.1
RANK = 1e-9
STATES = 3


def nearest(
    model: LoadedModel,
    base: Base,
    estimates: Array,
    weights: Array,
    only: Sequence[str] | None = None,
) -> dict[str, float]:
    """Values of parameters with the wanted base parameters, as far as they can have them.

    Newton's method with the least change of parameters relative to their sizes; where fewer
    parameters than base parameters are free, the weighted least squares.

    Args:
        base: Base parameters.
        estimates: Their values (nb,).
        weights: A matrix whose square is the inverse of their covariance (nb, nb).
        only: Names of those that may change; by default all.
    """
    names, nominal = list(model.parameters), model.parameters.vector.copy()
    free = _inertial(model)
    if only is not None:
        free &= np.array([name in only for name in names], dtype=np.bool_)
    sizes = _sizes(model)[free]
    p, best, least = nominal.copy(), nominal.copy(), np.inf
    for _ in range(STEPS):
        left = weights @ (estimates - base.matrix @ _phi(model, p))
        size = float(np.linalg.norm(left))
        if size < least:
            best, least = p.copy(), size
        jacobian = weights @ base.matrix @ _slope(model, p, free) * sizes
        change = (p[free] - nominal[free]) / sizes
        step = np.linalg.pinv(jacobian, rcond=RANK) @ (left + jacobian @ change) - change
        p[free] += sizes * step
        if np.linalg.norm(step) <= MET * max(1.0, float(np.linalg.norm(change))):
            break
    left = weights @ (estimates - base.matrix @ _phi(model, p))
    best = p if float(np.linalg.norm(left)) <= least else best
    return {names[k]: float(best[k]) for k in np.flatnonzero(free)}


def _phi(model: LoadedModel, p: Array) -> Array:
    """phi (..., n) of parameter vectors (..., np)."""
    function = model._function("inertial_parameters")
    return np.asarray(function.caller(None, w=function.prepared(p)))


def _slope(model: LoadedModel, p: Array, free: Booleans) -> Array:
    """d phi / d p of the free parameters (n, k)."""
    steps = STEP * _sizes(model)
    moves = np.diag(steps)[free]
    ends = _phi(model, np.concatenate([p + moves, p - moves]))
    half = len(moves)
    return np.asarray((ends[:half] - ends[half:]).T / (2 * steps[free]))


def _sizes(model: LoadedModel) -> Array:
    """Scale of every parameter, below which changes count as small (np,)."""
    values = np.abs(model.parameters.vector)
    units = [model.parameters.unit(name) for name in model.parameters]
    usual = dict.fromkeys(units, 0.0)
    for unit in usual:
        some = [v for v, u in zip(values, units, strict=True) if u == unit and v > 0]
        usual[unit] = float(np.median(some)) if some else 1.0
    return np.maximum(values, [SMALL * usual[unit] for unit in units])


def inertial(model: LoadedModel) -> tuple[str, ...]:
    """Names of the parameters that base parameters consist of."""
    return tuple(n for n, is_one in zip(model.parameters, _inertial(model), strict=True) if is_one)


def _inertial(model: LoadedModel) -> Booleans:
    """Parameters (np,) that change phi and not the regressor: neither lengths nor gravity."""
    p = model.parameters.vector
    changed = p + 0.1 * np.diag(_sizes(model))
    acts = np.any(_phi(model, changed) != _phi(model, p), axis=-1)
    rng = np.random.default_rng(1)
    q, u, _ = model.parts_of(model.random_state(rng, (STATES,)))
    udot = rng.uniform(-1, 1, u.shape)
    function = model._function("regressor")
    places = [a.name for a in function.caller.arguments]
    states = {"t": np.full(STATES, 0.3), "q": q, "u": u, "udot": udot}
    before = model.regressor(q, u, udot, t=states["t"])
    for k in np.flatnonzero(acts):
        w = function.prepared(changed[k])
        after = function.caller(None, *(states.get(name) for name in places), w=w)
        acts[k] = np.array_equal(before, after)
    return np.asarray(acts)
