"""A chain of a hundred rods against an independent recursion in 40 digits."""

from __future__ import annotations

import numpy as np

import cardan as cd
from mechanisms.chain import GRAVITY, chain
from mechanisms.chain40 import accelerations

SEED = 20
LENGTH = 100
STATES = 20
# the recursion of articulated bodies is backward stable rod by rod: about 90 eps here
ALLOWED = 2e-14


def test_recursion_of_one_rod() -> None:
    q, u = np.array([0.3]), np.array([0.5])
    exact = 1.5 * 9.81 * np.cos(0.3)
    np.testing.assert_allclose(accelerations(q, u, GRAVITY), [exact], rtol=4e-16)


def test_articulated_forward_dynamics() -> None:
    model = cd.compile(chain(LENGTH), method="articulated", functions=("forward_dynamics",))
    rng = np.random.default_rng(SEED)
    q = rng.uniform(-np.pi, np.pi, (STATES, LENGTH))
    u = rng.uniform(-1, 1, (STATES, LENGTH))
    exact = np.array([accelerations(*state, GRAVITY) for state in zip(q, u, strict=True)])
    computed = model.forward_dynamics(q, u)
    error = np.abs(computed - exact).max(axis=1) / np.abs(exact).max(axis=1)
    print(f"seed {SEED}: worst of {STATES} states {error.max():.2e} of max |udot|")
    assert error.max() <= ALLOWED
