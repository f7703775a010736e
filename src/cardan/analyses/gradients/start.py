"""How the start of a run follows from what was named, backward."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ...arrays import Array
from ..simulation.simulate import RunSetup
from .adjoint import Sweep


def by_named_start(setup: RunSetup, sweep: Sweep, state: Mapping[str, object]) -> Array:
    """Gradient by the start as it was named: along the speeds, by speeds, by internal states.

    Where loops are closed, what was not named follows from what was, and from parameters, whose
    gradients the sweep gains by that.

    Args:
        setup: The run.
        sweep: Whose gradients by the first state are known.
        state: x0, q, u and z as they were given.
    """
    model, x = setup.model, setup.begin.x
    q, u, _ = model.parts_of(x)
    lam, nq, nu = sweep.lam, model.nq, model.nu
    t, (inputs, _) = setup.over.start, sweep.inputs_at(setup.over.start)
    along = model.vjp("qdot", wrt="u")(q, u, weights=lam[:nq], t=t, r=inputs) if nu else lam[:0]
    return np.concatenate([np.asarray(along), lam[nq:]])
