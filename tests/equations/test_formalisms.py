"""The formalisms agree with each other and with the definition of M on random trees."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from cardan.equations.formalisms import FORMALISMS
from cardan.equations.record import EquationRecord
from cardan.errors import DerivationError
from cardan.ir.function import Function
from cardan.ir.interpreter import evaluate
from spread import some

from .trees import TREES, state

EPS = np.finfo(float).eps
RECURSIVE = ("kane", "newton_euler", "composite", "articulated")
PAIRS = [
    *((name, method) for name in TREES for method in RECURSIVE),
    *some(
        [(name, method) for name in TREES for method in FORMALISMS if method not in RECURSIVE], 3
    ),
]


@cache
def function(name: str, method: str, quantity: str) -> Function:
    return EquationRecord(TREES[name].system, method).function(quantity)


def values(name: str, method: str, quantity: str, seed: int, **given: list[float]) -> np.ndarray:
    """The first output of a function of a tree at a random state."""
    tree, wanted = TREES[name], function(name, method, quantity)
    inputs = {**state(tree.system, seed), "p": list(tree.p), **given}
    result = evaluate(wanted, inputs)
    return np.asarray(result[wanted.outputs[0].name], dtype=float)


@pytest.mark.parametrize(("name", "method"), PAIRS)
def test_formalisms_agree_with_kane(name: str, method: str) -> None:
    tree = TREES[name]
    for seed in range(3):
        m = values(name, "kane", "mass_matrix", seed)
        m = m.reshape(tree.system.nu, tree.system.nu)
        tolerance = 100 * EPS * np.linalg.cond(m)
        for quantity in ("mass_matrix", "bias", "gravity", "inverse_dynamics", "forward_dynamics"):
            expected = values(name, "kane", quantity, seed)
            got = values(name, method, quantity, seed)
            error = np.abs(got - expected).max() / np.abs(expected).max()
            assert error <= tolerance, (quantity, seed)


@pytest.mark.parametrize(("name", "method"), PAIRS)
def test_forward_dynamics_undoes_inverse_dynamics(name: str, method: str) -> None:
    tree = TREES[name]
    m = values(name, method, "mass_matrix", 7).reshape(tree.system.nu, tree.system.nu)
    tau = values(name, method, "inverse_dynamics", 7)
    udot = values(name, method, "forward_dynamics", 7, tau=list(tau))
    expected = np.array(state(tree.system, 7)["udot"])
    assert np.abs(udot - expected).max() <= 100 * EPS * np.linalg.cond(m) * np.abs(expected).max()


@pytest.mark.parametrize("name", TREES)
def test_bias_is_gravity_and_coriolis(name: str) -> None:
    parts = [values(name, "composite", q, 5) for q in ("gravity", "coriolis")]
    bias = values(name, "composite", "bias", 5)
    np.testing.assert_allclose(parts[0] + parts[1], bias, rtol=0, atol=1e-13 * np.abs(bias).max())


def test_names_of_other_schools_are_translated() -> None:
    from cardan.equations.formalism_choice import check_method

    with pytest.raises(DerivationError, match="'aba' is called 'articulated' here"):
        check_method("aba")
    with pytest.raises(DerivationError, match="Did you mean 'composite'"):
        check_method("composit")


def test_unknown_function_frame_and_joint_are_named() -> None:
    equations = EquationRecord(TREES["chain"].system, "composite")
    with pytest.raises(DerivationError, match="Did you mean 'mass_matrix'"):
        equations.function("massmatrix")
    with pytest.raises(DerivationError, match="frame 'tipp1' does not exist"):
        equations.function("pose", "tipp1")
    with pytest.raises(DerivationError, match="joint 'jont0' does not exist"):
        equations.function("reaction", "jont0")
    with pytest.raises(DerivationError, match="needs a frame"):
        equations.function("pose")


@pytest.mark.parametrize(
    ("rewrites", "words"),
    [(False, "names are wanted"), (3, "names are wanted"), ("axis", "Did you mean 'axes'")],
)
def test_rewrites_are_names(rewrites: object, words: str) -> None:
    from cardan.equations.rewrites import check_names

    with pytest.raises(DerivationError, match=words):
        check_names(rewrites)
    assert check_names("parallel") == ("parallel",)
