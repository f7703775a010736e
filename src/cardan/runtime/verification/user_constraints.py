"""Constraints that the user wrote, as conditions on the accelerations of the judge.

Their Jacobian is the model's own, which differences of the constraints judge
(:mod:`.verification.constraints`); what they ask of accelerations follows from their rates along a
motion. They hold at any state, whether it fulfils the constraints or not.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from ...ir.interpreter import evaluate
from ...ir.serialize import from_dict
from .closed_states import Bound
from .differences import input_rates, slope
from .joint_motion import Array

if TYPE_CHECKING:
    from ..models.loaded_model import LoadedModel


def written(model: LoadedModel) -> list[int]:
    """Numbers of the multipliers of constraints that the user wrote."""
    rows = enumerate(model.manifest.multipliers)
    return [k for k, row in rows if row.name == row.joint and not row.switched]


# what slopes of rates may be off by, of the largest, to say what accelerations have to be
RELIABLE = 1e-11


def with_written(model: LoadedModel, bound: Bound, t: float) -> Bound | None:
    """Constraints of a model, with those that the user wrote.

    States at which the slopes of their rates are not known well are left out, such as beside the
    ends of cases; None where that leaves none.

    Raises:
        ModelError, DerivationError: their expressions are not there.
    """
    rows = written(model)
    if not rows:
        return bound
    n, nu, objects = len(bound.q), model.nu, model._objects
    at = {"t": np.full((n, 1), t), "q": bound.q[:, : model.nq], "u": bound.u[:, :nu], "r": bound.r}
    defaults = {block: model._layout.start(block) for block in "zs"}
    defaults["p"] = model.parameters.vector

    def saved(name: str) -> Any:
        symbol = objects.symbol(name)
        return from_dict(objects.saved()[symbol])

    rates, jacobian, motion = (
        saved(name) for name in ("constraint_rates", "constraint_jacobian", "qdot")
    )

    def value(function: Any, blocks: dict[str, Array], shape: tuple[int, ...]) -> Array:
        (values,) = evaluate(function, {**defaults, **blocks}, "numpy").values()
        return np.broadcast_to(values, (len(blocks["q"]), *shape))

    m = len(model.manifest.multipliers)
    G = value(jacobian, at, (m, nu))[:, rows]
    along = {"q": value(motion, at, (model.nq,)), "t": np.ones((n, 1))}
    if model.inputs:
        along["r"] = input_rates(model.inputs, bound.r)
    fastest = np.abs(along["q"]).max(axis=-1, initial=1.0)
    changed, off = slope(lambda blocks: value(rates, blocks, (m,)), at, along, fastest)
    sure = off <= RELIABLE * np.maximum(1.0, np.abs(changed).max(axis=-1, initial=0.0))
    if not sure.any():
        return None
    wide = np.zeros((n, len(rows), bound.G.shape[-1]))
    wide[..., :nu] = G
    extended = replace(
        bound,
        G=np.concatenate([bound.G, wide], axis=-2),
        bias=np.concatenate([bound.bias, changed[:, rows]], axis=-1),
    )
    return extended.only(np.flatnonzero(sure))
