"""DOP853 against SciPy's, step by step: the same numbers up to rounding."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from scipy.integrate import DOP853, solve_ivp

from kernels.problem import SWING, Problem, swing


def right(t: float, x: np.ndarray) -> np.ndarray:
    return np.array([2 * t * x[0] * np.log(x[1]), -2 * t * x[1] * np.log(x[0])])


def test_one_step_and_its_inside(tmp_path: Path) -> None:
    h = 0.1
    other = DOP853(right, 1.0, swing(1.0), 2.0, first_step=h, max_step=h, rtol=1e-3, atol=1e-3)
    other.step()
    options = {"step": h, "max_step": h, "rtol": 1e-3, "atol": 1e-3}
    ours = Problem(tmp_path, SWING).run((1.0, 1.0 + h), swing(1.0), **options)
    # a few roundings of numbers up to 3
    np.testing.assert_allclose(ours.x[-1], other.y, rtol=0, atol=1e-14)
    inside = np.linspace(1.0, 1.0 + h, 11)
    np.testing.assert_allclose(ours.at(inside), other.dense_output()(inside).T, rtol=0, atol=1e-14)


def test_steps_are_as_many(tmp_path: Path) -> None:
    start = swing(0.0)
    ours = Problem(tmp_path, SWING).run((0.0, 4.0), start, rtol=1e-9, atol=1e-9)
    theirs = solve_ivp(right, (0, 4), start, method="DOP853", rtol=1e-9, atol=1e-9)
    # another control, which aims at a smaller error and so rejects less: by a tenth
    assert abs(ours.statistics["steps"] - (len(theirs.t) - 1)) <= 0.1 * len(theirs.t)
    assert ours.statistics["rejections"] <= (theirs.nfev - 2) // 11 - len(theirs.t)
    # 12 evaluations a trial, the first of a step is the last of the one before; 2 to begin. What is
    # between waits for somebody to ask
    count = ours.statistics
    expected = 12 * count["steps"] + 11 * count["rejections"] + 2
    assert count["evaluations"] == expected


def test_output_times_and_dense_output_agree(tmp_path: Path) -> None:
    problem = Problem(tmp_path, SWING)
    dense = problem.run((0.0, 3.0), swing(0.0), rtol=1e-10)
    times = np.linspace(0.0, 3.0, 77)
    listed = problem.run(times, swing(0.0), rtol=1e-10)
    assert np.array_equal(listed.t, times)
    # C against NumPy: the same polynomial, sums rounded differently
    np.testing.assert_allclose(listed.x, dense.at(times), rtol=0, atol=1e-14)
    np.testing.assert_array_equal(dense.at(dense.t), dense.x)


def test_output_times_cost_nothing_where_none_falls_in_a_step(tmp_path: Path) -> None:
    problem = Problem(tmp_path, SWING)
    ends = problem.run((0.0, 3.0), swing(0.0), t_eval=np.array([0.0, 3.0]), rtol=1e-10)
    dense = problem.run((0.0, 3.0), swing(0.0), rtol=1e-10)
    steps = dense.statistics["steps"]
    assert ends.statistics["steps"] == steps
    assert ends.statistics["evaluations"] == dense.statistics["evaluations"]
    # three evaluations for every step that has one inside
    inside = problem.run((0.0, 3.0), swing(0.0), t_eval=np.array([0.0, 1.0, 3.0]), rtol=1e-10)
    assert inside.statistics["evaluations"] == ends.statistics["evaluations"] + 3
    np.testing.assert_array_equal(ends.x[-1], dense.x[-1])
