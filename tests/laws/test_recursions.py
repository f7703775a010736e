"""Recursions, spliced or looped over tables, give what straight-line expressions give."""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd
from cardan.ir.interpreter import evaluate
from cardan.schema.functions import FUNCTIONS
from laws.cases import EPS, SEED, derived, states, values
from mechanisms import ZOO
from spread import some
from table import each

# by the formalism that eliminates body by body where it takes the system
METHOD = {
    name: "articulated" if "articulated" in member.methods else "newton_euler"
    for name, member in ZOO.items()
}
# compiled ones: every kind of tree, joint family and force
COMPILED = tuple(ZOO)[::3]


def looped(name: str) -> list[str]:
    e = derived(name, METHOD[name])
    return [function for function in FUNCTIONS if e.loops(function)]


def given(name: str) -> dict:
    (q, u), rng = states(name), np.random.default_rng(SEED + 2)
    udot, tau = rng.uniform(-3, 3, u.shape), rng.uniform(-1, 1, u.shape)
    return values(derived(name, METHOD[name]), q=q, u=u, udot=udot, tau=tau)


@pytest.mark.parametrize("name", some(ZOO, 2))
def test_spliced(name: str) -> None:
    e, blocks = derived(name, METHOD[name]), given(name)
    assert len(looped(name)) >= 9
    for function in looped(name):
        straight = e.function(function)
        found = evaluate(e.recursion(function).straight(), blocks, arithmetic="numpy")
        exact = evaluate(straight, blocks, arithmetic="numpy")
        for output in straight.outputs:
            # the same operations, some summed in another order
            size = max(1.0, np.abs(exact[output.name]).max(initial=0))
            np.testing.assert_allclose(
                found[output.name], exact[output.name], rtol=0, atol=200 * EPS * size
            )


@each("name", COMPILED)
def test_compiled(name: str) -> None:
    e, blocks = derived(name, METHOD[name]), given(name)
    wanted = [f for f in looped(name) if f in ("forward_dynamics", "inverse_dynamics", "energy")]
    model = cd.compile(e, functions=wanted, loops=True)
    assert all(check.reason or check.error < 1e-9 for check in model.verify().checks)
    q, u, tau, udot = (blocks[letter] for letter in ("q", "u", "tau", "udot"))
    for function in wanted:
        exact = evaluate(e.function(function), blocks, arithmetic="numpy")
        if function == "energy":
            found = np.stack(model.energy(q, u, t=0.3), axis=-1)
            expected = np.stack([np.broadcast_to(x, len(q)) for x in exact.values()], axis=-1)
        elif function == "inverse_dynamics":
            found, expected = model.inverse_dynamics(q, u, udot, t=0.3), exact["tau"]
        else:
            found, expected = model.forward_dynamics(q, u, tau=tau, t=0.3), exact["udot"]
        size = max(1.0, np.abs(expected).max(initial=0))
        np.testing.assert_allclose(found, expected, rtol=0, atol=1000 * EPS * size)
