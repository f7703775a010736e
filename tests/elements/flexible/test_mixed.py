"""Stress as an unknown of Newton's method: the same equations, solved from further away."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from elements.flexible.states import ELEMENTS, ENDS, State, state
from elements.flexible.test_laws import ROUNDING, UNLOADED, matrix

MIXED = [name for name, element in ELEMENTS.items() if "mixed" in element.derived()]
every = pytest.mark.parametrize("name", MIXED)
both = pytest.mark.parametrize("kinds", ENDS, ids="-".join)


def middle(s: State) -> Any:
    """Stress of the middle of the element."""
    return s.value("mixed_step", "z", z=np.zeros(6), du=np.zeros(len(s.u)))


@every
@both
def test_at_the_stress_of_the_strain_nothing_changes(name: str, kinds: tuple[str, str]) -> None:
    s = state(ELEMENTS[name], kinds)
    z, du = middle(s), np.zeros(len(s.u))
    b, K = s.value("balance", "balance"), matrix(s, "K")
    assert s.value("mixed", "balance", z=z) == pytest.approx(b, abs=ROUNDING)
    assert matrix(s, "K", "mixed", z=z) == pytest.approx(K, abs=ROUNDING)
    assert s.value("mixed_step", "z", z=z, du=du) == pytest.approx(z, abs=ROUNDING)


@every
def test_without_load_it_is_the_mean_of_both_ends(name: str) -> None:
    follower = {f"follower_force_{k}": 0.0 for k in (1, 2, 3)}
    s = state(ELEMENTS[name], **UNLOADED, **follower)
    mean = s.value("stress", "stress").reshape(4, 6)[:2].mean(axis=0)
    assert middle(s) == pytest.approx(mean, abs=ROUNDING)


@every
@both
def test_the_step_is_that_of_newton(name: str, kinds: tuple[str, str]) -> None:
    """Along any increment the eliminated equations are those of displacements and stress."""
    s = state(ELEMENTS[name], kinds)
    rng = np.random.default_rng(3)
    z, du = middle(s) + rng.normal(size=6), rng.normal(size=len(s.u))
    reached = s.value("mixed_step", "z", z=z, du=du)
    # from the increments the stress is that of the linearized strain, wherever it started
    change = s.along(lambda q: middle(State(**{**vars(s), "q": q})))
    shift = s.value("mixed_step", "z", z=z, du=0 * du)
    linear = reached - shift
    assert s.value("mixed_step", "z", z=z, du=2 * du) - shift == pytest.approx(
        2 * linear, rel=1e-9, abs=ROUNDING
    )
    exact = s.value("mixed_step", "z", z=middle(s), du=du) - middle(s)
    assert exact == pytest.approx(change @ du, rel=1e-9, abs=1e-10)
