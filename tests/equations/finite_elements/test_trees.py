"""Every tree of the zoo moves in absolute coordinates as it does in those of its joints."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from equations.finite_elements.cases import State, both
from laws.cases import derived, states
from mechanisms import ZOO
from spread import some

# rounding of both ways, in multiples of eps times the condition number
ROUNDING = 20
# every test takes the same: states are made once
NAMES = some(ZOO, 2)


@cache
def at(name: str) -> list[State]:
    """Listed states of a mechanism and random ones."""
    own = both(derived(name))
    return [own.at(q, u) for q, u in zip(*states(name), strict=True)]


@pytest.mark.parametrize("name", NAMES)
def test_states_satisfy_the_constraints(name: str) -> None:
    for state in at(name):
        g, rates = state.reference.constraints()
        assert np.abs(g).max(initial=0) < 1e-13
        assert np.abs(rates).max(initial=0) < 1e-13 * (1 + np.abs(state.reference.u).max())


@pytest.mark.parametrize("name", NAMES)
def test_accelerations(name: str) -> None:
    for state in at(name):
        mine, other = state.accelerations()
        size = 1 + np.abs(other).max(initial=0)
        assert np.abs(mine - other).max(initial=0) < ROUNDING * state.solved[2] * size


@pytest.mark.parametrize("name", NAMES)
def test_accelerations_of_coordinates(name: str) -> None:
    """Joints have the coordinates, speeds and accelerations of the relative formulation."""
    for state in at(name):
        relative, absolute = state.both.relative, state.both.absolute
        size = 1 + np.abs(state.udot).max(initial=0)
        for k, speed in enumerate(relative.speeds):
            mine = absolute.speeds.index(speed)
            error = abs(state.solved[0][mine] - state.udot[k])
            assert error < ROUNDING * state.solved[2] * size
            assert abs(state.reference.u[mine] - state.u[k]) < 1e-14 * (1 + abs(state.u[k]))
        for k, name_of in enumerate(relative.coordinates):
            mine = absolute.coordinates.index(name_of)
            assert abs(state.reference.q[mine] - state.q[k]) < 1e-14 * (1 + abs(state.q[k]))


@pytest.mark.parametrize("name", NAMES)
def test_reactions(name: str) -> None:
    for state in at(name):
        mine, other = state.reactions()
        size = 1 + max((np.abs(w).max() for w in other.values()), default=0)
        for joint, wrench in mine.items():
            error = np.abs(wrench - other[joint]).max()
            assert error < ROUNDING * state.solved[2] * size, joint


@pytest.mark.parametrize("name", NAMES)
def test_energy_and_momentum(name: str) -> None:
    """Sums over the elements; the relative formulation adds up its bodies."""
    for state in at(name):
        for function in ("energy", "momentum"):
            mine = state.reference.sum(function)
            other = state.both.call(function, q=state.q, u=state.u)
            for key, value in mine.items():
                size = 1 + np.abs(other[key]).max()
                assert np.abs(value - other[key]).max() < 1e-12 * size
