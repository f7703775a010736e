"""The implicit methods on stiff problems, and what inputs do to their Jacobian."""

from __future__ import annotations

import inspect
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cardan.schema.integrators import INTEGRATORS
from kernels.problem import SWING, Problem, swing
from kernels.test_order import fixed, slope

IMPLICIT = [name for name, m in INTEGRATORS.items() if "rhs_jacobian" in m.needs]
METHODS = pytest.mark.parametrize("method", IMPLICIT)


def test_both_are_there() -> None:
    assert {"Radau", "Rosenbrock"} <= set(IMPLICIT)


# u' = a (u - sin t) + cos t, q' = u: Prothero and Robinson
STIFF = """
    out[0] = u[0];
    out[1] = -1e6 * (u[0] - sin(t)) + cos(t);
"""
EXACT = """
    out[0] = 0; out[1] = 1; out[2] = 0; out[3] = -1e6;
    out[4] = 0; out[5] = 1e6 * cos(t) - sin(t);
"""


@METHODS
def test_stiff_order(method: str, tmp_path: Path) -> None:
    problem = Problem(tmp_path, STIFF, jacobian=EXACT)
    steps, errors = (0.2, 0.1, 0.05), []
    for h in steps:
        options = fixed(INTEGRATORS[method], h)
        motion = problem.run(2.0, [-1.0, 0.0], **options)
        exact = np.stack([-np.cos(motion.t), np.sin(motion.t)], axis=1)
        errors.append(np.abs(motion.x - exact).max(axis=0))
    # h a = 5e4 ... 2e5: the stiff entry has the order of the stages, 3, over a
    assert slope(steps, [e[0] for e in errors]) == pytest.approx(5, abs=0.15)
    assert slope(steps, [e[1] for e in errors]) == pytest.approx(3, abs=0.15)
    assert errors[0][1] < 1e-9


# u'' = 1000 ((1 - q^2) u) - q: relaxation oscillations
VAN_DER_POL = "out[0] = u[0]; out[1] = 1e3 * (1 - q[0] * q[0]) * u[0] - q[0];"


@METHODS
def test_van_der_pol(method: str, tmp_path: Path) -> None:
    problem = Problem(tmp_path, VAN_DER_POL)
    options = {"method": method, "atol": 1e-8}
    fine = problem.run([0, 1200.0], [2, 0], method=method, rtol=1e-10, atol=1e-12)
    motion = problem.run([0, 1200.0], [2, 0], rtol=1e-6, **options)
    # behind a jump: a shift in time by 1e-6 of the period of 1614 moves q by 1e-6
    assert motion.success
    assert motion.statistics["steps"] < 500
    assert abs(motion.q[-1, 0] - fine.q[-1, 0]) < 1e-5
    # known to four digits: the jump is past after 807, and q falls slowly from -2
    assert -2 < motion.q[-1, 0] < -1.5


ROBERTSON = """
    out[0] = -0.04 * q[0] + 1e4 * q[1] * q[2];
    out[1] = 0.04 * q[0] - 1e4 * q[1] * q[2] - 3e7 * q[1] * q[1];
    out[2] = 3e7 * q[1] * q[1];
"""
BY_HAND = """
    for (int i = 0; i < 12; i++) out[i] = 0;
    out[0] = -0.04; out[1] = 1e4 * q[2]; out[2] = 1e4 * q[1];
    out[3] = 0.04; out[4] = -1e4 * q[2] - 6e7 * q[1]; out[5] = -1e4 * q[1];
    out[7] = 6e7 * q[1];
"""
# Hairer and Wanner II, IV.10: what is left after 40 s
LEFT = (0.7158270687193941, 0.9185534764557338e-5, 0.2841637457458413)


@METHODS
def test_robertson(method: str, tmp_path: Path) -> None:
    problem = Problem(tmp_path, ROBERTSON, nq=3, nu=0, jacobian=BY_HAND)
    motion = problem.run([0, 40.0], [1, 0, 0], method=method, rtol=1e-7, atol=1e-13)
    np.testing.assert_allclose(motion.q[-1], LEFT, rtol=1e-6)
    # linear invariants are kept
    assert abs(motion.q[-1].sum() - 1) < 1e-13
    assert motion.statistics["steps"] < 200


@METHODS
@pytest.mark.parametrize("first", [{}, {"step": 1e-6}])
def test_a_long_run_begins_with_short_steps(
    method: str, first: dict[str, float], tmp_path: Path
) -> None:
    problem = Problem(tmp_path, ROBERTSON, nq=3, nu=0, jacobian=BY_HAND)
    motion = problem.run([0, 1e11], [1, 0, 0], method=method, rtol=1e-6, atol=1e-14, **first)
    # the same source: what is left after 1e11 s
    np.testing.assert_allclose(motion.q[-1, :2], (2.083340149701e-8, 8.333360770334e-14), rtol=1e-3)
    assert motion.statistics["steps"] < 800


def test_factors_are_kept(tmp_path: Path) -> None:
    problem = Problem(tmp_path, VAN_DER_POL)
    motion = problem.run([0, 2000.0], [2, 0], method="Radau", rtol=1e-8, atol=1e-10)
    count = motion.statistics
    assert 0 < count["jacobians"] <= count["factorizations"]
    assert count["factorizations"] < 0.5 * count["steps"]
    # the other one takes new ones for every trial
    motion = problem.run([0, 2000.0], [2, 0], method="Rosenbrock", rtol=1e-8, atol=1e-10)
    count = motion.statistics
    assert count["jacobians"] == count["steps"]
    assert count["factorizations"] == count["steps"] + count["rejections"]


# inputs

BY_INPUTS = "out[0] = r[0]; out[1] = r[1] * u[0];"
FUNCTIONS = {"a": lambda t, x: 2 * t * x[0] * np.log(x[1]), "b": lambda t, x: -2 * t * np.log(x[0])}


@METHODS
def test_functions_as_inputs_keep_the_order(method: str, tmp_path: Path) -> None:
    # the right-hand side of SWING, all of it as inputs
    problem = Problem(tmp_path, BY_INPUTS, inputs=("a", "b"))
    steps, errors = (0.04, 0.02, 0.01), []
    for h in steps:
        options: Mapping[str, Any] = fixed(INTEGRATORS[method], h)
        motion = problem.run(1.6, swing(0.0), inputs=FUNCTIONS, **options)
        errors.append(np.abs(motion.x - swing(motion.t)).max())
    assert slope(steps, errors) == pytest.approx(5, abs=0.5)


@METHODS
def test_inputs_given_by_values(method: str, tmp_path: Path) -> None:
    # u' = -1e5 (u - r) with r = 0 ... 1 ... 1 in straight lines: behind by 1e-5 on the slope
    problem = Problem(tmp_path, "out[0] = u[0]; out[1] = -1e5 * (u[0] - r[0]);", inputs=("r",))
    inputs = {"r": ([0, 1, 2], [0, 1, 1])}
    options = {"method": method, "rtol": 1e-8, "atol": 1e-10}
    motion = problem.run([0, 0.5, 1, 2], [0, 0], inputs=inputs, **options)
    np.testing.assert_allclose(motion.u[:, 0], [0, 0.5 - 1e-5, 1 - 1e-5, 1], rtol=0, atol=1e-8)
    np.testing.assert_allclose(motion.q[:, 0], [0, 0.125 - 5e-6, 0.5 - 1e-5, 1.5 - 1e-5], atol=1e-8)
    assert motion.statistics["steps"] < 200


# what is kept of the state

TURNING = """
    real w = 1 + 2 * sin(3 * t);
    out[0] = -0.5 * w * q[3]; out[1] = -0.5 * w * q[2];
    out[2] = 0.5 * w * q[1]; out[3] = 0.5 * w * q[0];
"""


@METHODS
def test_quaternions_keep_the_order(method: str, tmp_path: Path) -> None:
    problem = Problem(tmp_path, TURNING, nq=4, nu=0, quaternions=(0,))
    steps, errors = (0.1, 0.05, 0.025), []
    for h in steps:
        motion = problem.run(2.0, [1, 0, 0, 0], **fixed(INTEGRATORS[method], h))
        half = 0.5 * (motion.t + 2 / 3 * (1 - np.cos(3 * motion.t)))
        exact = np.stack([np.cos(half), 0 * half, 0 * half, np.sin(half)], axis=1)
        errors.append(np.abs(motion.q - exact).max())
    assert slope(steps, errors) == pytest.approx(5, abs=0.5)


@METHODS
def test_energies_have_the_order_too(method: str, tmp_path: Path) -> None:
    problem = Problem(tmp_path, SWING, power="out[0] = t * q[0] * u[0];")
    fine = problem.run(1.6, swing(0.0), rtol=1e-13, atol=1e-13).work["source"][-1]
    steps, errors = (0.04, 0.02, 0.01), []
    for h in steps:
        motion = problem.run(1.6, swing(0.0), **fixed(INTEGRATORS[method], h))
        errors.append(abs(motion.work["source"][-1] - fine))
    assert slope(steps, errors) > 4.5


@METHODS
def test_a_checkpoint_is_all(method: str, tmp_path: Path) -> None:
    from cardan.analyses.simulation.stepper import stepper

    problem = Problem(tmp_path, VAN_DER_POL)
    stepping = inspect.unwrap(stepper)(problem, x0=[2, 0], method=method)
    stepping.step(10.0)
    saved = stepping.save()
    there = stepping.step(700.0)
    stepping.restore(saved)
    np.testing.assert_array_equal(stepping.step(700.0), there)
