"""Cycles of sampled feedback, whose period is a multiple of the time between samples."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import sympy as sp
from scipy.linalg import expm

import cardan as cd
from cardan.errors import ModelError
from cycle_scenes import MULTIPLIERS, POINT

SAMPLE, P, D = 0.1, 2.0, 0.8


def sampled(controller: Any) -> cd.CompiledModel:
    """x'' = -x + cos(2 pi t) + u, with u held between samples."""
    scene = cd.Scene("sampled", gravity=(0, 0, 0))
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("body", **POINT))
    x, v = scene.q("x"), scene.u("x")
    scene.force("feedback", controller(x, v))
    scene.force("drive", cd.JointForce("x", sp.cos(2 * sp.pi * cd.t) - x))
    return cd.compile(scene)


def one_sample(t: float) -> Any:
    """The map of x, x' over a sample that begins at t, with the response to the drive (2, 3)."""
    w = 2 * np.pi
    # x, x', u, cos, sin
    rates = np.zeros((5, 5))
    rates[0, 1], rates[1, [0, 2, 3]] = 1, (-1, 1, 1)
    rates[3, 4], rates[4, 3] = -w, w
    over = expm(rates * SAMPLE)
    states = over[:2, :2] + np.outer(over[:2, 2], [-P, -D])
    driven = over[:2, 3] * np.cos(w * t) + over[:2, 4] * np.sin(w * t)
    return np.column_stack([states, driven])


def exact(count: int) -> tuple[Any, Any]:
    """The start of the cycle and the derivative of a lap of so many samples."""
    M, c = np.eye(2), np.zeros(2)
    for k in range(count):
        step = one_sample(k * SAMPLE)
        M, c = step[:, :2] @ M, step[:, :2] @ c + step[:, 2]
    return np.linalg.solve(np.eye(2) - M, c), M


@pytest.mark.parametrize("laps", [1, 2])
def test_a_period_of_ten_samples(laps: int) -> None:
    model = sampled(lambda x, v: cd.Controller("x", force=-P * x - D * v, sample=SAMPLE))
    cycle = model.cycle({"x": 0.1}, period=1.0, laps=laps, check=True)
    start, M = exact(10)
    np.testing.assert_allclose(cycle.x, start, atol=1e-11)
    expected = np.linalg.eigvals(np.linalg.matrix_power(M, laps))
    ours = sorted(cycle.multipliers, key=lambda value: value.imag)
    theirs = sorted(expected, key=lambda value: value.imag)
    np.testing.assert_allclose(ours, theirs, atol=MULTIPLIERS)
    end = model.simulate((0, 1.0), x0=cycle.x, method="DOP853", rtol=1e-12, atol=1e-14).x[-1]
    np.testing.assert_allclose(end, cycle.x, atol=1e-10)


def test_states_of_a_sampled_controller_are_refused() -> None:
    total = sp.Symbol("total")
    model = sampled(
        lambda x, v: cd.Controller(
            "x", ("total",), (total + SAMPLE * x,), -P * x - D * v - total, sample=SAMPLE
        )
    )
    with pytest.raises(ModelError, match=r"depends on what controllers hold before it"):
        model.cycle({"x": 0.1}, period=1.0)
