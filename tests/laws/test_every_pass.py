"""Every pass and every language keeps the values of the whole zoo."""

from __future__ import annotations

import numpy as np

from cardan.errors import DerivationError
from cardan.ir.function import Function
from cardan.ir.interpreter import evaluate
from cardan.passes import PASSES
from laws.cases import EPS, derived, states, values
from mechanisms import ZOO
from table import each

FUNCTIONS = ("forward_dynamics", "inverse_dynamics", "energy")


def flat(function: Function, blocks: dict) -> np.ndarray:
    found = evaluate(function, blocks, arithmetic="numpy")
    return np.concatenate([np.atleast_1d(found[o.name]).ravel() for o in function.outputs])


@each("of", FUNCTIONS)
@each("name", ZOO)
def test_values_with_each_pass_alone(name: str, of: str) -> None:
    equations = derived(name)
    q, u = states(name)
    udot = np.linspace(-1, 1, u.shape[1])
    blocks = values(equations, q=q[1], u=u[1], udot=udot)
    function = equations.function(of)
    plain = flat(function, blocks)
    mass = evaluate(equations.function("mass_matrix"), blocks, arithmetic="numpy")["M"]
    # a pass may round otherwise: what solving with M makes of that
    allowed = 100 * EPS * np.linalg.cond(mass) * np.abs(plain).max()
    for key, run in PASSES.items():
        assert np.abs(flat(run(function), blocks) - plain).max() <= allowed, key


@each("name", ZOO)
def test_no_pass_adds_operations_to_energy(name: str) -> None:
    function = derived(name).function("energy")
    before = sum(function.operations().values())
    grown = {
        key: sum(run(function).operations().values()) - before
        for key, run in PASSES.items()
        if key != "unroll"
    }
    assert {key: more for key, more in grown.items() if more > 0} == {}


@each("name", ZOO)
def test_passes_come_to_rest_and_add_nothing(name: str) -> None:
    for of in ("forward_dynamics", "inverse_dynamics", "mass_matrix", "bias"):
        try:
            function = PASSES["unroll"](derived(name).function(of))
        except DerivationError:
            continue
        count = sum(function.operations().values())
        for key, run in PASSES.items():
            once = run(function)
            assert sum(once.operations().values()) <= count, (key, of)
            # sums in another order can turn out equal: a few in a hundred are found second
            again, first = (sum(f.operations().values()) for f in (run(once), once))
            assert 0 <= first - again <= max(2, count // 100), (key, of)
