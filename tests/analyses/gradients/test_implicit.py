"""Gradients of stiff motions, by implicit methods."""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd
from table import each


@each("method", ["GeneralizedAlpha", "HHT", "EnergyMidpoint"])
def test_errors_of_gradients_are_those_of_motions(method: str) -> None:
    """Of methods of order 2: a quarter of both with half of the step. Against the closed form."""
    scene = cd.Scene("spring")
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("block", mass=1.0))
    scene.force("spring", cd.JointSpring("x", stiffness=scene.parameter("k", 9.0)))
    model, cost = cd.compile(scene), cd.cost(final="x")
    errors = []
    for step in (2e-3, 1e-3):
        found = model.gradient(2.0, cost, wrt=("k", "q0.x"), q={"x": 1.0}, method=method, step=step)
        errors.append(
            [
                found.value - np.cos(6.0),
                found.slope["k"] + np.sin(6.0) / 3.0,
                found.slope["q0.x"] - np.cos(6.0),
            ]
        )
    first, second = np.abs(errors)
    assert first[0] / second[0] == pytest.approx(4.0, rel=0.05)
    assert (second[1:] <= second[0]).all()


def test_stiff_motions_by_radau() -> None:
    """A damper whose force dies out in 0.1 ms, against the closed form by complex step."""
    scene = cd.Scene("damped")
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("block", mass=1.0))
    c, k = scene.parameter("c", 1e4), scene.parameter("k", 400.0)
    scene.force("spring", cd.JointSpring("x", stiffness=k, damping=c))
    cost = cd.cost(final="x + 3*x.u", running="x^2")
    given = {"q": {"x": 1.0}, "rtol": 1e-10, "atol": 1e-13, "method": "Radau"}
    found = cd.compile(scene).gradient(20.0, cost, wrt=("c", "k", "q0.x"), **given)

    def value(c: complex, k: complex, start: complex) -> complex:
        root = np.sqrt(c * c - 4 * k)
        slow, fast = -2 * k / (c + root), -(c + root) / 2
        a, b = start * fast / (fast - slow), -start * slow / (fast - slow)
        end = sum(w * (1 + 3 * r) * np.exp(20 * r) for w, r in ((a, slow), (b, fast)))
        pairs = ((a * a, 2 * slow), (2 * a * b, slow + fast), (b * b, 2 * fast))
        return end + sum(w * np.expm1(20 * r) / r for w, r in pairs)

    assert found.value == pytest.approx(value(1e4, 400.0, 1.0).real, rel=1e-10)
    for n, name in enumerate(("c", "k", "q0.x")):
        at = np.array([1e4, 400.0, 1.0]) + 1e-30j * np.eye(3)[n]
        assert found.slope[name] == pytest.approx(value(*at).imag / 1e-30, rel=1e-9), name
    assert len(found.motion.t) < 500
