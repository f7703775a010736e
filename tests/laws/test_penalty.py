"""Treatments that give way converge to the exact accelerations at the order they claim."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.equations.constraints.treatments import Augmented, Penalty, Perturbed, Treatment
from laws.cases import call
from laws.circuits import compiled, scene_of, start
from mechanisms.closed import CLOSED
from spread import some

# symbolic work grows with the mechanism; the law does not change
MEMBERS = [name for name in CLOSED if name != "stewart"]
WEIGHTS = 10.0 ** np.arange(1, 6)
# relative errors of accelerations that neither rounding in M + w Gᵀ G nor later terms spoil
LEAST, MOST = 5e-9, 5e-2


def alternating(first: Any, second: Any) -> list[Any]:
    """One way for one mechanism by default, the other for the next; the rest is slow."""
    ways = [(first, second), (second, first)]
    pairs = [(name, way) for k, name in enumerate(MEMBERS) for way in ways[k % 2]]
    return some(pairs, 2)


def errors(name: str, treatments: list[Treatment]) -> np.ndarray:
    """Largest deviation from the exact accelerations, relative to the largest acceleration."""
    model = compiled(name)
    q, u = start(model, name, 0.3)
    exact = model.forward_dynamics(q, u)
    found = []
    for treatment in treatments:
        equations = cd.derive(scene_of(name), constraints=treatment)
        udot = call(equations, "forward_dynamics", q=q[None], u=u[None])["udot"][0]
        found.append(np.abs(udot - exact).max() / np.abs(exact).max())
    return np.array(found)


@pytest.mark.parametrize(("name", "kind"), alternating("penalty", "perturbed"))
def test_first_order_over_four_decades(name: str, kind: str) -> None:
    weights = WEIGHTS.tolist()
    ways = [
        Penalty(weight=w) if kind == "penalty" else Perturbed(compliance=1 / w) for w in weights
    ]
    found = np.log10(errors(name, ways))
    slopes = -np.diff(found)
    print(f"{name}, {kind}: errors 1e{found[0]:.1f} to 1e{found[-1]:.1f}, slopes {slopes}")
    # the first decade still feels the next term of the series, a tenth of the first
    np.testing.assert_allclose(slopes, 1.0, rtol=0, atol=0.05)
    assert (found[0] - found[-1]) / 4 == pytest.approx(1.0, abs=0.01)


@pytest.mark.parametrize(("name", "repetitions"), alternating(1, 2))
def test_every_repetition_adds_an_order(name: str, repetitions: int) -> None:
    weights = (10.0 ** np.arange(0, 4, 0.5)).tolist()
    ways = [Augmented(weight=w, repetitions=repetitions) for w in weights]
    found = errors(name, ways)
    clear = np.log10(found[(found > LEAST) & (found < MOST)])
    slopes = -np.diff(clear) / 0.5
    print(f"{name}, {repetitions} repetitions: errors {found}, slopes {slopes}")
    assert len(slopes) >= 2
    # the next term of the series again, once for each repetition
    np.testing.assert_allclose(slopes, 1 + repetitions, rtol=0.2)
    assert slopes[-1] == pytest.approx(1 + repetitions, rel=0.03)
