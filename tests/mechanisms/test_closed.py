"""Closed mechanisms move as they say: on their constraints, with their freedoms."""

from __future__ import annotations

import numpy as np

import cardan as cd
from mechanisms.carried import CARRIED
from mechanisms.closed import CLOSED, Closed
from table import each

EVERY = [*CLOSED.values(), *CARRIED.values()]
PLACES = np.linspace(-0.8, 0.8, 9)
# differences of sixth order: rounding over the step
SPEEDS = 1e-11


@each("mechanism", EVERY)
def test_motions_are_allowed(mechanism: Closed) -> None:
    model = cd.compile(mechanism.build())
    moving = {joint["name"] for joint in model.manifest["joints"] if joint["q"]}
    for s in PLACES:
        state = mechanism.state(s, 2.0, moving)
        q, u = model.split(model.initial(q=state.q, u=state.u))
        # closing conditions that follow from others too
        np.testing.assert_allclose(model.closure(q), 0, atol=1e-14)
        size = np.abs(u).max()
        np.testing.assert_allclose(model.constraint_rates(q, u), 0, atol=SPEEDS * size)


@each("mechanism", EVERY)
def test_freedoms(mechanism: Closed) -> None:
    model = cd.compile(mechanism.build())
    cuts = model.manifest["cuts"]
    moving = {joint["name"] for joint in model.manifest["joints"] if joint["q"]}
    state = mechanism.state(0.3, 1.0, moving)
    q, _ = model.split(model.initial(q=state.q, u=state.u))
    rank = np.linalg.matrix_rank(model.constraint_jacobian(q), tol=1e-9)
    assert len(cuts) == mechanism.circuits
    assert model.nu - rank == mechanism.freedoms
    assert len(model.closure(q)) - rank == mechanism.redundant
