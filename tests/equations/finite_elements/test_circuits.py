"""Loops, every kind of joint in the tree and cut, wheels: the same as in joint coordinates."""

from __future__ import annotations

from functools import cache
from itertools import product

import numpy as np
import pytest

import cardan as cd
from equations.finite_elements.cases import State, both
from laws.circuits import EVERY, PLACES, compiled, scene_of, start
from laws.test_cut_joints import INSTANCES, Pair
from mechanisms.rolling import ROLLING
from spread import some

# rounding of both ways, in multiples of eps times the condition number
ROUNDING = 100


def agree(state: State) -> set[str]:
    """Constraints hold, accelerations are the same, reactions where they are unique.

    Returns:
        The joints whose reactions are.
    """
    g, rates = state.reference.constraints()
    assert np.abs(g).max(initial=0) < 1e-12
    assert np.abs(rates).max(initial=0) < 1e-11 * (1 + np.abs(state.reference.u).max())
    mine, other = state.accelerations()
    bound = ROUNDING * state.solved[2]
    assert bound < 1e-6
    assert np.abs(mine - other).max() < bound * (1 + np.abs(other).max())
    wrenches, expected = state.reactions()
    size = 1 + max(np.abs(w).max() for w in expected.values())
    certain = {joint for joint in wrenches if state.certain(joint)}
    for joint in certain:
        assert np.abs(wrenches[joint] - expected[joint]).max() < bound * size, joint
    return certain


@cache
def circuit(name: str) -> State:
    """A closed mechanism somewhere along its motion."""
    equations = cd.derive(scene_of(name))
    q, u = start(compiled(name), name, PLACES[0])
    return both(equations).at(q, u)


@pytest.mark.parametrize("name", some(EVERY, 3, 1))
def test_circuits(name: str) -> None:
    agree(circuit(name))


@cache
def pair(name: str, back: bool) -> Pair:
    return Pair(name, back)


@pytest.mark.parametrize("name", some(INSTANCES, 2))
def test_joints_of_a_tree(name: str) -> None:
    own = pair(name, False)
    # a fixed joint makes one body of two
    known = {"pivot", "tested"} - set(own.tree.system.fixed)
    assert agree(both(own.tree).at(own.q, own.u)) == known


@pytest.mark.parametrize(("name", "back"), some(product(INSTANCES, (False, True)), 3))
def test_joints_that_close_circuits(name: str, back: bool) -> None:
    own = pair(name, back)
    assert agree(both(own.cut).at(*own.floating)) == {"pivot", "tested"}


@pytest.mark.parametrize("name", some(ROLLING, 2))
def test_wheels(name: str) -> None:
    equations = cd.derive(ROLLING[name]())
    rng = np.random.default_rng(3)
    own = both(equations)
    q, u = (rng.uniform(0.2, 0.6, n) for n in (equations.system.nq, equations.system.nu))
    u = own.call("close_velocity", q=q, u=u)["u"]
    agree(own.at(q, u))
