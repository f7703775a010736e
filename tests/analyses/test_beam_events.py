"""Events of scenes with beams against beams written by hand, and against rigid bodies."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import cardan as cd

Array = Any
LENGTH, EI, RHO_A, HEAD, GRAVITY, LOWER = 1.0, 10.0, 1.0, 0.1, 1.0, -0.006


def cantilever(elements: int, **stop: float) -> cd.Scene:
    """A beam that falls from rest, with a body at its tip that meets a stop."""
    scene = cd.Scene("cantilever", gravity=(0, 0, -GRAVITY))
    section = cd.section.general(EA=1e6, GA=1e6, GJ=EI, EI=EI, rhoA=RHO_A, rhoI=1e-6)
    light = {"mass": 1e-6, "inertia": (1e-9,) * 3}
    carrier, runner = scene.body("carrier", **light), scene.body("runner", **light)
    head = scene.body("head", mass=HEAD, inertia=(1e-6,) * 3)
    scene.joint("rail", cd.Prismatic("z"), scene.ground.at(LENGTH, 0, 0), carrier)
    scene.joint("run", cd.Prismatic("x"), carrier, runner)
    scene.joint("tilt", cd.Revolute("y"), runner, head)
    scene.beam("beam", scene.ground, head, section, elements=elements, up="z")
    if stop:
        scene.force("stop", cd.Stop("rail", **stop))
    return scene


def hermite(n: int) -> tuple[Array, Array, Array]:
    """M, K and loads of a clamped Euler-Bernoulli beam with n elements and a body at its tip."""
    h, size = LENGTH / n, 2 * n + 2
    M, K, f = np.zeros((size, size)), np.zeros((size, size)), np.zeros(size)
    k = [[12, 6 * h, -12, 6 * h], [6 * h, 4 * h * h, -6 * h, 2 * h * h],
         [-12, -6 * h, 12, -6 * h], [6 * h, 2 * h * h, -6 * h, 4 * h * h]]  # fmt: skip
    m = [[156, 22 * h, 54, -13 * h], [22 * h, 4 * h * h, 13 * h, -3 * h * h],
         [54, 13 * h, 156, -22 * h], [-13 * h, -3 * h * h, -22 * h, 4 * h * h]]  # fmt: skip
    for e in range(n):
        at = slice(2 * e, 2 * e + 4)
        K[at, at] += EI / h**3 * np.array(k)
        M[at, at] += RHO_A * h / 420 * np.array(m)
        f[at] -= RHO_A * GRAVITY * np.array([h / 2, h * h / 12, h / 2, -h * h / 12])
    M[-2, -2] += HEAD
    f[-2] -= HEAD * GRAVITY
    return M[2:, 2:], K[2:, 2:], f[2:]


def fine(f: Any, x: Array, what: Any) -> Any:
    """A motion until something passes zero from above."""
    what.terminal, what.direction = True, -1
    return solve_ivp(f, (0, 3), x, events=what, rtol=1e-10, atol=1e-12, method="DOP853")


def test_the_tip_of_a_cantilever_meets_a_stop_and_leaves_it() -> None:
    model = cd.compile(cantilever(4, lower=LOWER, restitution=0.0))
    motion = model.simulate(0.6, step=2e-4, method=cd.GeneralizedAlpha(0.8))
    M, K, f = hermite(4)
    n, tip = len(M), len(M) - 2
    free = fine(
        lambda t, x: np.concatenate([x[n:], np.linalg.solve(M, f - K @ x[:n])]),
        np.zeros(2 * n),
        lambda t, x: x[tip] - LOWER,
    )
    x, hit = free.y[:, -1], free.t[-1]
    # the impulse along the tip takes its speed
    along = np.linalg.solve(M, np.eye(n)[tip])
    x[n:] -= along * x[n + tip] / along[tip]

    def force(x: Array) -> float:
        """Of the stop."""
        return float(-np.linalg.solve(M, f - K @ x[:n])[tip] / along[tip])

    lying = fine(
        lambda t, x: np.concatenate(
            [x[n:], np.linalg.solve(M, f - K @ x[:n]) + along * force(x)]
        ),
        x,
        lambda t, x: force(x),
    )
    names = [event.name for event in motion.events]
    assert names[:2] == ["stop.lower", "stop.release"]
    times = [event.t for event in motion.events]
    assert times[0] == pytest.approx(hit, rel=2e-3)
    assert times[1] - times[0] == pytest.approx(lying.t[-1], rel=2e-2)
    between = (motion.t > times[0] + 1e-9) & (motion.t < times[1] - 1e-9)
    assert motion["rail"][between] == pytest.approx(LOWER, abs=1e-9)


def slider_crank(stiffness: float, coulomb: float = 1.5) -> cd.Scene:
    """A slider-crank whose coupler is a beam of some stiffness, or rigid for 0."""
    scene = cd.Scene("slider crank", gravity=(0, 0, -9.81))
    crank = scene.body("crank", mass=1.0, com=(0.1, 0, 0), inertia=(0.01, 0.02, 0.02))
    block = scene.body("block", mass=0.4, inertia=(0.01,) * 3)
    small = {"mass": 0.1, "inertia": (1e-3,) * 3}
    one, two = scene.body("one", **small), scene.body("two", **small)
    scene.joint("A", cd.Revolute("y"), scene.ground, crank)
    scene.joint("B", cd.Revolute("y"), crank.at(0.2, 0, 0), one)
    scene.joint("S", cd.Prismatic("x"), scene.ground, block)
    scene.joint("C", cd.Revolute("y"), block, two)
    if stiffness:
        values = {"EA": 1e3, "GA": 1e3, "GJ": 1.0, "EI": 1.0}
        values = {name: stiffness * value for name, value in values.items()}
        section = cd.section.general(**values, rhoA=0.4, rhoI=1e-5)
        scene.beam("coupler", one, two, section, elements=2, up="y")
    if coulomb:
        scene.force("rub", cd.Friction("S", coulomb=coulomb))
    return scene
