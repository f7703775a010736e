"""Residuals of the equations of motion as methods for implicit differential equations want them.

Source: K. E. Brenan, S. L. Campbell, L. R. Petzold, Numerical Solution of Initial-Value Problems in
Differential-Algebraic Equations, chapter 6 (forms of index 3, 2 and 1).
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...arguments import checked
from ...arrays import Array
from ...errors import ArgumentError, brief
from ...runtime.calls.argument_values import numbers
from ...runtime.calls.evaluation import State, Values
from ...runtime.models.constraint_projection import Closing
from ...runtime.models.loaded_model import LoadedModel
from ...schema.blocks import Blocks


@checked
def residual(
    model: LoadedModel,
    t: ArrayLike,
    q: State,
    u: State,
    udot: State,
    lam: ArrayLike = (),
    *,
    qdot: State | None = None,
    index: int = 3,
    tau: State | None = None,
    r: State | None = None,
    parameters: Values | None = None,
) -> Array:
    """[qdot - N u - n, M udot + h - f - tau - Gᵀ lam, constraints] (..., nq + nu + m).

    Args:
        model: The compiled model.
        t, q, u, udot: Time [s], coordinates (..., nq), speeds and their derivatives (..., nu).
        lam: Multipliers (..., m), in the order of ``model.multipliers_of``.
        qdot: Rates of the coordinates (..., nq); those of u if left out.
        index: Level of the constraints: 3, positions g (and velocities for those that have no
            positions, such as rolling); 2, velocities G u + g_t; 1, accelerations G udot - gamma.
        tau, r, parameters: As :meth:`CompiledModel.forward_dynamics` takes them.

    Raises:
        ArgumentError: another index.
    """
    if index not in (1, 2, 3):
        raise ArgumentError(
            f"index={brief(index)}: 3 (positions), 2 (velocities) or 1 (accelerations)"
        )
    arguments: dict[str, Any] = {"t": t, "r": r, "parameters": parameters}
    rates = model.qdot(q, u, **arguments)
    kinematic = np.zeros_like(rates) if qdot is None else _row(model, "qdot", qdot) - rates
    dynamic = model.inverse_dynamics(q, u, udot, **arguments)
    if tau is not None:
        dynamic = dynamic - _row(model, "tau", tau)
    parts = [kinematic, dynamic]
    if model.nlam:
        G = model.constraint_jacobian(q, **arguments)
        forces = np.asarray(lam, dtype=np.float64)
        if forces.shape[-1:] != (model.nlam,):
            raise ArgumentError(
                f"residual: lam has the shape {forces.shape}, expected (..., {model.nlam}): "
                f"{', '.join(model.multipliers_of[:6])}"
            )
        parts[1] = dynamic - np.einsum("...mu,...m->...u", G, forces)
        parts.append(_constraints(model, index, q, u, udot, arguments))
    lead = np.broadcast_shapes(*(part.shape[:-1] for part in parts))
    return np.concatenate([np.broadcast_to(p, (*lead, p.shape[-1])) for p in parts], axis=-1)


def _row(model: LoadedModel, name: str, values: object) -> Array:
    """A vector (..., nq) or (..., nu), by names too where it is tau."""
    count = model.nq if name == "qdot" else model.nu
    array = numbers(name, values) if name == "qdot" else model._vector(name, values)
    if array.shape[-1:] != (count,):
        raise ArgumentError(f"residual: {name} has shape {array.shape}, expected (..., {count})")
    return np.asarray(array)


def _constraints(
    model: LoadedModel, index: int, q: Any, u: Any, udot: Any, arguments: dict[str, Any]
) -> Array:
    """Residuals (..., m) of the constraints at a level."""
    if index == 1:
        wrt = Blocks(("t", "q", "u"))
        by_t, by_q, by_u = model.derivative("constraint_rates", wrt)(q, u, **arguments)
        moving = np.einsum("...mu,...u->...m", by_q, model._vector("u", u))
        gamma: Array = by_t + moving + np.einsum("...mu,...u->...m", by_u, model._vector("u", udot))
        return gamma
    gamma = model.constraint_rates(q, u, **arguments)
    count = Closing.of(model).positions
    if index == 3 and count:
        g = model.constraints(q, **arguments)
        lead = np.broadcast_shapes(g.shape[:-1], gamma.shape[:-1])
        g = np.broadcast_to(g, (*lead, count))
        gamma = np.concatenate(
            [g, np.broadcast_to(gamma, (*lead, model.nlam))[..., count:]], axis=-1
        )
    return gamma
