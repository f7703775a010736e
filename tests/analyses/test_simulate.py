"""What a user asks of ``simulate``, and what it answers to mistakes."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import ArrayLike

import cardan as cd


def test_end_pair_and_array_are_one_motion(double: cd.CompiledModel) -> None:
    options: dict[str, Any] = {"q": {"elbow": 0.4}, "rtol": 1e-10}
    end = double.simulate(2.0, **options)
    pair = double.simulate((0.0, 2.0), **options)
    times = np.linspace(0.0, 2.0, 21)
    listed = double.simulate(times, **options)
    np.testing.assert_array_equal(end.x, pair.x)
    np.testing.assert_array_equal(listed.t, times)
    # the same steps; C and NumPy round the interpolation differently
    np.testing.assert_allclose(listed.x, end.at(times), rtol=0, atol=1e-14)


def test_start_by_names_arrays_and_state(double: cd.CompiledModel) -> None:
    named = double.simulate(0.1, q={"shoulder": 0.2, "elbow": 0.4}, u={"elbow": -1.0})
    arrays = double.simulate(0.1, q=[0.2, 0.4], u=np.array([0.0, -1.0]))
    state = double.simulate(0.1, x0=[0.2, 0.4, 0.0, -1.0])
    np.testing.assert_array_equal(named.x, arrays.x)
    np.testing.assert_array_equal(named.x, state.x)
    assert named.solver_info.defaulted == ("shoulder.u", "torque")
    assert state.solver_info.defaulted == ("torque",)
    # q0 of the joint where nobody says otherwise
    assert double.simulate(0.1)["shoulder"][0] == 0.1


def test_energy_is_accounted_for(double: cd.CompiledModel) -> None:
    motion = double.simulate(10.0, q={"elbow": 1.0}, inputs={"torque": 0.7}, rtol=1e-11, atol=1e-12)
    gained = motion.energy.total[-1] - motion.energy.total[0]
    turned = motion["shoulder"][-1] - motion["shoulder"][0]
    # a constant torque gives torque times angle
    assert motion.work["motor"][-1] == pytest.approx(0.7 * turned, abs=1e-8)
    assert gained == pytest.approx(0.7 * turned, abs=1e-8)
    assert np.abs(motion.energy_residual).max() < 1e-8


def test_free_body_flies_and_keeps_its_quaternion(ball: cd.CompiledModel) -> None:
    start = {"base": [1 + 5e-7, 0, 0, 0, 0, 0, 1.0]}
    motion = ball.simulate(2.0, q=start, u={"base": [0.1, 4.0, 0.1, 1.0, 0, 3.0]}, rtol=1e-9)
    np.testing.assert_allclose(motion["base.px"], motion.t, rtol=0, atol=1e-12)
    height = 1.0 + 3.0 * motion.t - 0.5 * 9.81 * motion.t**2
    np.testing.assert_allclose(motion["base"][:, 6], height, rtol=0, atol=1e-11)
    np.testing.assert_allclose(np.linalg.norm(motion.q[:, :4], axis=1), 1, rtol=0, atol=4e-16)
    # energy of the tumbling body to the tolerance times some 50 steps
    assert np.abs(motion.energy_residual).max() < 1e-6


def test_backward_returns_to_the_start(double: cd.CompiledModel) -> None:
    there = double.simulate((0.0, 1.5), q={"elbow": 0.8}, rtol=1e-12, atol=1e-13)
    back = double.simulate((1.5, 0.0), x0=there.x[-1], rtol=1e-12, atol=1e-13)
    assert back.t[-1] == 0.0
    np.testing.assert_allclose(back.x[-1], there.x[0], rtol=0, atol=1e-9)


def test_default_fixed_step_is_said(double: cd.CompiledModel) -> None:
    motion = double.simulate(2.0, method="RK4", q={"elbow": 0.4})
    assert motion.statistics["steps"] == 10_000
    assert "step 0.0002 s, 1/10000 of the span as none was given" in repr(motion)
    fine = double.simulate(2.0, q={"elbow": 0.4}, rtol=1e-12, atol=1e-13)
    np.testing.assert_allclose(motion.x[-1], fine.x[-1], rtol=0, atol=1e-10)


def test_too_tight_a_tolerance_is_said(double: cd.CompiledModel) -> None:
    motion = double.simulate(0.5, q={"elbow": 0.4}, rtol=1e-16, atol=1e-16)
    assert motion.success
    assert "double precision ends there" in repr(motion)


MISTAKES: list[tuple[Any, dict[str, Any], type[Exception], str]] = [
    (1.0, {"q": {"elbw": 1}}, cd.ModelError, "Did you mean 'elbow'"),
    (1.0, {"u": {"elbow.w": 1}}, cd.ModelError, "no joint or speed 'elbow.w'"),
    (1.0, {"q": {"elbow": np.nan}}, cd.SolveError, "'elbow' is nan"),
    (1.0, {"q": {"elbow": [1, 2]}}, ValueError, "2 values, expected 1"),
    (1.0, {"q": {"elbow": "1"}}, ValueError, "give numbers or arrays by name"),
    (1.0, {"q": [1.0]}, ValueError, r"q has shape \(1,\), expected \(2,\): shoulder, elbow"),
    (1.0, {"x0": [0, 0, np.inf, 0]}, cd.SolveError, "'shoulder.u' is inf"),
    (1.0, {"x0": [0, 0, 0, 0], "q": {"elbow": 1}}, cd.ModelError, "given twice"),
    (0.0, {}, cd.ModelError, "goes forward"),
    (-1.0, {}, cd.ModelError, r"t=\(0, -1\)"),
    ((1, 1), {}, cd.ModelError, "no length"),
    (np.nan, {}, cd.SolveError, "must be finite"),
    ([0, 1, 1, 2], {}, cd.ModelError, "times 1 and 2"),
    (np.array([1.0]), {}, cd.ModelError, "at least two"),
    ([[0, 1]], {}, ValueError, r"shape \(1, 2\)"),
    ("soon", {}, ValueError, "'soon'"),
    (1.0, {"method": "RK5"}, cd.ModelError, "Did you mean 'RK45'"),
    (1.0, {"method": "dop853"}, cd.ModelError, "Did you mean 'DOP853'"),
    (1.0, {"rtol": -1}, cd.ModelError, "rtol=-1"),
    (1.0, {"rtol": 0, "atol": 0}, cd.ModelError, "one may be 0"),
    (1.0, {"step": 0}, cd.ModelError, "step=0"),
    (1.0, {"method": "RK4", "max_step": 1}, cd.ModelError, "takes step="),
    (1.0, {"inputs": {"torqe": 1}}, cd.ModelError, "Did you mean 'torque'"),
    (1.0, {"inputs": {"torque": np.nan}}, cd.SolveError, "'torque' is nan"),
    (1.0, {"inputs": {"torque": "full"}}, ValueError, "'torque' is 'full'"),
    (1.0, {"inputs": {"torque": ([0, 1], [1])}}, ValueError, "equal lengths"),
    (1.0, {"inputs": {"torque": ([0, 1], [1, np.nan])}}, cd.SolveError, "value 1 is nan"),
    (1.0, {"inputs": {"torque": ([1, 0], [1, 1])}}, cd.ModelError, "must ascend"),
    (1.0, {"inputs": {"torque": ([0, 0.5], [1, 1])}}, cd.ModelError, "Add values"),
    (1.0, {"sample": 0.1}, cd.ModelError, "none is given"),
    (1.0, {"sample": -1, "inputs": {"torque": np.sin}}, cd.ModelError, "must be positive"),
]


@pytest.mark.parametrize(("t", "options", "error", "words"), MISTAKES, ids=lambda x: str(x)[:30])
def test_mistakes_are_named(
    double: cd.CompiledModel, t: ArrayLike, options: dict[str, Any], error: Any, words: str
) -> None:
    with pytest.raises(error, match=words):
        double.simulate(t, **options)


def test_a_quaternion_of_no_length(ball: cd.CompiledModel) -> None:
    with pytest.raises(cd.SolveError, match=r"'base\.qw' has length 0"):
        ball.simulate(1.0, q={"base": np.zeros(7)})


def test_progress_is_told(double: cd.CompiledModel) -> None:
    seen: list[float] = []
    double.simulate(20.0, q={"elbow": 1.0}, rtol=1e-9, progress=seen.append)
    assert seen == sorted(seen)
    assert seen[-1] == 1.0


def test_bar_appears_on_long_runs_only(
    double: cd.CompiledModel, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    double.simulate(1.0, progress=True)
    assert capsys.readouterr().err == ""
    monkeypatch.setattr("cardan.analyses.simulation.progress.PATIENCE", 0.0)
    double.simulate(1.0, progress=True)
    assert capsys.readouterr().err == ""
    monkeypatch.setenv("FORCE_COLOR", "1")
    double.simulate(1.0, progress=True)
    assert "double" in capsys.readouterr().err


def test_summary_says_what_was_run(double: cd.CompiledModel) -> None:
    text = repr(double.simulate(1.0, q={"elbow": 0.4}, rtol=1e-8))
    for words in (
        "motion of 'double', 0 s to 1 s: reached the end",
        "DOP853, rtol 1e-08, atol 1e-11",
        "given: elbow = 0.4",
        "by default: shoulder = 0.1, shoulder.u = 0, elbow.u = 0, torque = 0",
        "J unaccounted for",
        "work      in J: motor = 0",
    ):
        assert words in text
    assert max(len(line) for line in text.splitlines()) <= 100
