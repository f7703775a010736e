"""How the start of a run follows from what was named, backward."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...arrays import Array
from ...runtime.models.loaded_model import LoadedModel
from ..simulation.simulate import RunSetup
from .adjoint import Sweep

RANK = 1e-9  # of the largest singular value: rows that say nothing new


def by_named_start(setup: RunSetup, sweep: Sweep, state: Mapping[str, object], s: Array) -> Array:
    """Gradient by the start as it was named: along the speeds, by speeds, by internal states.

    Where loops are closed, what was not named follows from what was, and from parameters and
    inputs, whose gradients the sweep gains by that: the shortest change that keeps loops closed.

    Args:
        setup: The run.
        sweep: Whose gradients by the first state are known.
        state: x0, q, u and z as they were given.
        s: Modes (ns,) at the start.
    """
    model, x = setup.model, setup.begin.x
    q, u, z = model.parts_of(x)
    lam, nq, nu = sweep.lam, model.nq, model.nu
    t = setup.over.start
    at: dict[str, Any] = {"t": t, "r": sweep.inputs_at(t)[0]}
    along = model.vjp("qdot", wrt="u")(q, u, weights=lam[:nq], **at) if nu else lam[:0]
    by_q, by_u = np.array(along), lam[nq : nq + nu].copy()
    closing = sweep.runner.closing
    if closing.rates:
        blocks = [name for name, size in (("r", model.nr), ("p", len(sweep.by_p))) if size]
        wrt = ("q", "u", *blocks)
        columns = model.derivative("constraint_rates", wrt=wrt)(q, u, z=z, s=s, **at)
        named = _named(model, "u", state["u"])
        weights = _held(by_u, columns[1], named)
        by_q -= weights @ columns[0]
        _add(sweep, t, dict(zip(blocks, columns[2:], strict=True)), weights)
    if closing.positions:
        wrt = ("q", *blocks)
        columns = model.derivative("constraints", wrt=wrt)(q, **at)
        weights = _held(by_q, columns[0], _named(model, "q", state["q"]))
        _add(sweep, t, dict(zip(blocks, columns[1:], strict=True)), weights)
    return np.concatenate([by_q, by_u, lam[nq + nu :]])


def _held(bars: Array, rows: Array, named: NDArray[np.bool_]) -> Array:
    """Take what rows @ change = 0 determines out of a gradient, where named entries are held.

    Returns:
        Weights of the rows: the gradient gains -weights @ what else changes them.
    """
    free = rows[:, ~named]
    weights: Array = np.linalg.pinv(free, rcond=RANK).T @ bars[~named]
    bars -= weights @ rows
    return weights


def _named(model: LoadedModel, block: str, values: object) -> NDArray[np.bool_]:
    """Speeds (nu,) whose coordinates, or which themselves, were named."""
    mask = np.zeros(model.nu, dtype=bool)
    if not isinstance(values, Mapping):
        return mask
    for joint in model.manifest.joints:
        if joint.u is None:
            continue
        first, size = joint.u
        own = joint.q if block == "q" else joint.u
        names = model.coordinates if block == "q" else model.speeds
        entries = names[own[0] : own[0] + own[1]] if own is not None else ()
        if joint.name in values or any(name in values for name in entries):
            mask[first : first + size] = True
    return mask


def _add(sweep: Sweep, t: float, columns: Mapping[str, Array], weights: Array) -> None:
    """Gradients by inputs and parameters through what they move at the start."""
    if "r" in columns:
        sweep.add_inputs(t, -(weights @ columns["r"]))
    if "p" in columns:
        sweep.by_p -= weights @ columns["p"]
