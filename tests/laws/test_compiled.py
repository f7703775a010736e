"""The compiled zoo against the expressions in 40 digits, and momentum of what floats freely."""

from __future__ import annotations

import numpy as np
import pytest

from cardan.ir.interpreter import evaluate
from laws.cases import EPS, compiled, derived, states, values
from mechanisms import ZOO
from spread import some

FUNCTIONS = {
    "forward_dynamics": "udot",
    "inverse_dynamics": "tau",
    "mass_matrix": "M",
    "qdot": "qdot",
}


@pytest.mark.parametrize("name", some(ZOO, 4))
def test_c_against_40_digits(name: str) -> None:
    equations, model = derived(name), compiled(name)
    q, u = states(name)
    udot = np.random.default_rng(11).uniform(-2, 2, u.shape)
    got = {
        "forward_dynamics": model.forward_dynamics(q, u, t=0.3),
        "inverse_dynamics": model.inverse_dynamics(q, u, udot, t=0.3),
        "mass_matrix": model.mass_matrix(q),
        "qdot": model.qdot(q, u),
    }
    # one listed and one random state: forty digits are slow
    for k in (1, len(q) - 1):
        blocks = values(equations, q=q[k], u=u[k], udot=udot[k])
        exact = {
            f: np.array(
                evaluate(equations.function(f), blocks, arithmetic="mp")[out], dtype=float
            ).ravel()
            for f, out in FUNCTIONS.items()
        }
        mass = exact["mass_matrix"].reshape(len(u[k]), -1)
        for f in FUNCTIONS:
            # only forward dynamics solves with M; the rest loses a few eps per body
            allowed = EPS * (100 * np.linalg.cond(mass) if f == "forward_dynamics" else 200)
            error = np.abs(got[f][k].ravel() - exact[f]).max()
            assert error <= allowed * max(np.abs(exact[f]).max(), 1e-300), f


@pytest.mark.parametrize("name", ["satellite", "free_quaternion", "free_dcm"])
def test_momentum_is_kept_in_free_flight(name: str) -> None:
    model, state = compiled(name), ZOO[name].states[1]
    motion = model.simulate(5.0, q=dict(state.q), u=dict(state.u), rtol=1e-11, atol=1e-13)
    momentum = model.momentum(motion.q, motion.u)
    assert np.abs(momentum - momentum[0]).max() <= 1e-8 * np.abs(momentum[0]).max()


@pytest.mark.parametrize("name", some(ZOO, 4, 2))
def test_integrate_and_difference_are_inverse(name: str) -> None:
    model = compiled(name)
    q, u = states(name)
    du = np.random.default_rng(5).uniform(-0.1, 0.1, u.shape)
    np.testing.assert_allclose(model.difference(q, model.integrate(q, du)), du, rtol=0, atol=1e-13)
