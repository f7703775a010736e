"""Internal states in steps of generalized-alpha: solved to rounding, or the step fails."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from scipy.linalg import expm

import cardan as cd

SPAN, STEP = 0.05, 1e-3


def free_body(name: str) -> cd.Scene:
    """A body that floats beside what is looked at."""
    scene = cd.Scene(name, gravity=(0, 0, 0))
    block = scene.body("block", mass=1.0, inertia=(0.1, 0.2, 0.3))
    scene.joint("J", cd.Free(), scene.ground, block)
    return scene


def diffusion(count: int, rate: float) -> tuple[cd.Scene, np.ndarray]:
    """A chain of states that level out, the last ones as fast as the first; its matrix."""
    scene = free_body("diffusion")
    z = [sp.Symbol(f"z{k}") for k in range(count)]
    A = rate * (np.eye(count, k=1) + np.eye(count, k=-1) - 2 * np.eye(count))
    changes = [sum(A[i, j] * z[j] for j in range(count) if A[i, j]) for i in range(count)]
    start = [float(k + 1) for k in range(count)]
    scene.force("chain", cd.Controller(states=z, changes=changes, start=start))
    return scene, A


@pytest.mark.parametrize("rate", [1e2, 1e6])
def test_many_states_of_one_element_are_solved_together(rate: float) -> None:
    scene, A = diffusion(12, rate)
    model = cd.compile(scene, coordinates="absolute")
    errors = []
    for step in (STEP, STEP / 2):
        motion = model.simulate(SPAN, method=cd.GeneralizedAlpha(0.5), step=step)
        assert motion.success
        expected = expm(A * SPAN) @ np.arange(1.0, 13.0)
        errors.append(np.abs(motion.z[-1] - expected).max())
    if rate < 1e3:
        assert 3 < errors[0] / errors[1] < 5
    # stiff ones die out
    assert errors[1] < 1e-3


def test_states_that_no_step_solves_stop_a_run_by_name() -> None:
    scene, z = free_body("relay"), sp.Symbol("z")
    # towards 0.1 from either side, at once: an equation of a step has no solution there
    change = -1e6 * sp.sign(z - sp.Float(0.1))
    scene.force("relay", cd.Controller(states=[z], changes=[change], start=[0.0]))
    model = cd.compile(scene, coordinates="absolute")
    with pytest.warns(cd.SolveWarning, match=r"relay.*step="):
        motion = model.simulate(SPAN, method=cd.GeneralizedAlpha(0.5), step=STEP)
    assert motion.status == "not_solved"
    assert motion.t[-1] < SPAN


def test_states_that_a_shorter_step_solves_shorten_it() -> None:
    # beyond its range a root is no number: a long step looks there, a short one does not
    scene, z = free_body("tank"), sp.Symbol("z")
    change = -40 * sp.sqrt(z) + 38
    scene.force("tank", cd.Controller(states=[z], changes=[change], start=[1.0]))
    model = cd.compile(scene, coordinates="absolute")
    motion = model.simulate(1.0, method="GeneralizedAlpha", rtol=1e-7, atol=1e-9)
    assert motion.success
    assert motion["tank.z"][-1] == pytest.approx((38 / 40) ** 2, abs=1e-6)


def test_small_states_are_solved_as_well_as_large_ones() -> None:
    finals = []
    for size in (1.0, 1e-12):
        scene, z = free_body("scale"), sp.Symbol("z")
        change = -300 * z - (100 / size**2) * z**3
        scene.force("scale", cd.Controller(states=[z], changes=[change], start=[size]))
        model = cd.compile(scene, coordinates="absolute")
        motion = model.simulate(0.01, method=cd.GeneralizedAlpha(0.5), step=STEP)
        finals.append(motion["scale.z"][-1] / size)
    assert finals[1] == pytest.approx(finals[0], rel=1e-11)


def test_newmark_takes_internal_states_by_the_trapezoidal_rule() -> None:
    scene, A = diffusion(3, 1e2)
    model = cd.compile(scene, coordinates="absolute")
    motion = model.simulate(SPAN, method="Newmark", step=STEP)
    rule = np.linalg.solve(np.eye(3) - STEP / 2 * A, np.eye(3) + STEP / 2 * A)
    expected = np.linalg.matrix_power(rule, round(SPAN / STEP)) @ [1.0, 2.0, 3.0]
    assert motion.z[-1] == pytest.approx(expected, rel=1e-12)
