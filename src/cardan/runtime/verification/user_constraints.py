"""Constraints that the user wrote, as conditions on the accelerations of the judge.

Their Jacobian is the model's own, which differences of the constraints judge
(:mod:`.verification.constraints`); what they ask of accelerations follows from their rates along a
motion. They hold at any state, whether it fulfils the constraints or not, as long as they do not
contradict what closes the loops: such a state can lie in a singular position alone.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from ...ir.interpreter import evaluate
from ...ir.serialize import from_dict
from .closed_states import RANK, Bound, best_first
from .differences import input_rates, slope
from .joint_motion import Array, times

if TYPE_CHECKING:
    from ..models.loaded_model import LoadedModel


def written(model: LoadedModel) -> list[int]:
    """Numbers of the multipliers of constraints that the user wrote."""
    rows = enumerate(model.manifest.multipliers)
    return [k for k, row in rows if row.name == row.joint and not row.switched]


def yields(model: LoadedModel) -> str:
    """Why accelerations of a model may differ from those that its constraints ask for; "" if not.

    States are drawn on the loops, not on the constraints that the user wrote: these a
    stabilization pulls back, at accelerations of its own.
    """
    treatment = model.manifest.scene.treatment
    if treatment and not treatment.exact:
        return f"constraints treated by '{treatment.name}' give way"
    if treatment and treatment.name in STABILIZED and written(model):
        return f"states off the relations, which '{treatment.name}' pulls back"
    return ""


# treatments that are exact on the constraints alone
STABILIZED = ("baumgarte",)
# what slopes of rates may be off by, of the largest, to say what accelerations have to be
RELIABLE = 1e-11
# what conditions that depend on each other may differ by, of the largest, to agree
CONSISTENT = 1e-10


def with_written(model: LoadedModel, bound: Bound, t: float) -> Bound | None:
    """Constraints of a model, with those that the user wrote.

    States at which the slopes of their rates are not known well are left out, such as beside the
    ends of cases, and those where they contradict others; None where that leaves none.

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
    wide = np.zeros((n, len(rows), bound.G.shape[-1]))
    wide[..., :nu] = G
    extended = replace(
        bound,
        G=np.concatenate([bound.G, wide], axis=-2),
        bias=np.concatenate([bound.bias, changed[:, rows]], axis=-1),
    )
    missing = np.zeros_like(extended.bias)
    missing[:, bound.bias.shape[-1] :] = value(rates, at, (m,))[:, rows]
    sure &= fulfilled(extended.G, missing) & fulfilled(extended.G, extended.bias)
    if not sure.any():
        return None
    consistent = extended.only(np.flatnonzero(sure))
    return consistent.only(best_first(consistent.G))


def fulfilled(G: Array, missing: Array) -> Array:
    """Whether some speeds change conditions (n, m, k) by what they miss (n, m)."""
    left = missing - times(G, times(np.linalg.pinv(G, rcond=RANK), missing))
    size = np.abs(G).max(axis=(-1, -2), initial=1.0) + np.abs(missing).max(axis=-1, initial=0.0)
    return np.asarray(np.abs(left).max(axis=-1, initial=0.0) <= CONSISTENT * size)
