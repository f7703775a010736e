"""The run record: where steps land, what is kept, how a run ends."""

from __future__ import annotations

import os
import signal
import subprocess
from pathlib import Path

import numpy as np
import pytest

from cardan.build import cache
from cardan.errors import SolveError, SolveWarning
from cardan.schema import kernel_files
from kernels.problem import METHODS, OSCILLATOR, SWING, Problem, swing

BOTH = pytest.mark.parametrize("method", METHODS)


# some warnings come only while gcc optimizes
@pytest.mark.parametrize("made", ["-fsyntax-only", pytest.param("-O2", marks=pytest.mark.slow)])
def test_kernels_compile_strictly(made: str, tmp_path: Path) -> None:
    strict = ["-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror", made]
    sources = [str(path) for path in kernel_files.files("*.c")]
    folders = [f"-I{folder}" for folder in kernel_files.includes()]
    command = [*cache.compiler().command, *strict, *folders, "-c", *sources]
    done = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path, check=False)
    assert done.returncode == 0, done.stderr


@BOTH
def test_a_run_ends_exactly_and_comes_back(method: str, tmp_path: Path) -> None:
    problem = Problem(tmp_path, SWING)
    there = problem.run((0.3, 1.9), swing(0.3), method=method, rtol=1e-12, atol=1e-12)
    assert there.t[0] == 0.3
    assert there.t[-1] == 1.9
    back = problem.run((1.9, 0.3), there.x[-1], method=method, rtol=1e-12, atol=1e-12)
    assert (np.diff(back.t) < 0).all()
    # RK4 takes 10000 steps: h^4 = 7e-16 times fifth derivatives of some 1e4
    np.testing.assert_allclose(back.x[-1], swing(0.3), rtol=0, atol=1e-10)
    np.testing.assert_allclose(back.at(1.0), swing(1.0), rtol=0, atol=1e-9)


def test_fixed_step_keeps_its_grid(tmp_path: Path) -> None:
    motion = Problem(tmp_path, OSCILLATOR).run(1.0, [1, 0], method="RK4", step=0.3)
    np.testing.assert_allclose(motion.t, [0, 0.3, 0.6, 0.9, 1.0], rtol=1e-15)
    even = Problem(tmp_path, OSCILLATOR).run(10.0, [1, 0], method="RK4", step=0.1)
    # 100 steps, not 101: the grid is counted, not summed
    assert len(even) == 101


def test_max_step_is_kept(tmp_path: Path) -> None:
    motion = Problem(tmp_path, OSCILLATOR).run(10.0, [1, 0], rtol=1e-3, max_step=0.25)
    # differences of times up to 10 are rounded
    assert np.diff(motion.t).max() <= 0.25 + 4e-15


@BOTH
def test_many_rows_survive_a_full_buffer(method: str, tmp_path: Path) -> None:
    options = {"max_step": 1e-3} if METHODS[method].adaptive else {"step": 1e-3}
    motion = Problem(tmp_path, OSCILLATOR).run(6.0, [1, 0], method=method, **options)
    assert len(motion) >= 6001
    assert (np.diff(motion.t) > 0).all()
    # RK4: error of the cubic between steps of 1e-3 is below 1e-12 / 384
    times = np.linspace(0, 6, 5001)
    np.testing.assert_allclose(motion.at(times)[:, 0], np.cos(times), rtol=0, atol=1e-11)


@BOTH
def test_quaternions_keep_their_length(method: str, tmp_path: Path) -> None:
    # turning about a fixed axis at 2 rad/s: q = (cos t, 0, 0, sin t)
    turning = "out[0] = -q[3]; out[1] = -q[2]; out[2] = q[1]; out[3] = q[0];"
    problem = Problem(tmp_path, turning, nq=4, nu=0, quaternions=(0,))
    rounded = [1 + 5e-7, 0, 0, 0]
    motion = problem.run(5.0, rounded, method=method, rtol=1e-6)
    # a start of about length 1 is normalized, every row and what is between has length 1
    np.testing.assert_allclose(np.linalg.norm(motion.q, axis=1), 1, rtol=0, atol=4e-16)
    times = np.linspace(0, 5, 101)
    between = motion.at(times)
    np.testing.assert_allclose(np.linalg.norm(between, axis=1), 1, rtol=0, atol=4e-16)
    np.testing.assert_allclose(between[:, 0], np.cos(times), rtol=0, atol=1e-5)
    listed = problem.run(times, rounded, method=method, rtol=1e-6)
    np.testing.assert_allclose(listed.q, between, rtol=0, atol=2e-15)


@BOTH
def test_work_of_a_source_is_outside_the_error_control(method: str, tmp_path: Path) -> None:
    damped = "out[0] = u[0]; out[1] = -q[0] - 0.1 * u[0];"
    options = {"method": method, "rtol": 1e-10, "atol": 1e-12}
    plain = Problem(tmp_path / "a", damped)
    counted = Problem(tmp_path / "b", damped, power="out[0] = -0.1 * u[0] * u[0];")
    plain.folder.mkdir()
    counted.folder.mkdir()
    without, motion = (p.run(20.0, [1, 0], **options) for p in (plain, counted))
    np.testing.assert_array_equal(without.x, motion.x)
    energy = 0.5 * (motion.q[:, 0] ** 2 + motion.u[:, 0] ** 2)
    np.testing.assert_allclose(motion.work["source"], energy - energy[0], rtol=0, atol=1e-9)


# ends before the end


def test_not_finite_names_the_coordinate(tmp_path: Path) -> None:
    problem = Problem(tmp_path, "out[0] = 1; out[1] = sqrt(1 - q[0]);")
    with pytest.warns(SolveWarning, match=r"derivative of 'u0' is not finite"):
        motion = problem.run(3.0, [0, 0])
    assert motion.status == "not_finite"
    assert not motion.success
    # everything up to the border is kept and right: u = 2/3 (1 - (1 - t)^1.5)
    assert 0.99 < motion.t[-1] <= 1
    np.testing.assert_allclose(motion.u[:, 0], 2 / 3 * (1 - (1 - motion.t) ** 1.5), atol=1e-6)


def test_blow_up_keeps_what_is_good(tmp_path: Path) -> None:
    problem = Problem(tmp_path, "out[0] = q[0] * q[0]; out[1] = 0;")
    with pytest.warns(SolveWarning, match="t = 1 s of 3 s"):
        motion = problem.run(3.0, [1, 0], rtol=1e-8)
    assert motion.status in ("step_too_small", "not_finite")
    good = motion.t < 0.999
    # the error of a step grows with the sensitivity 1 / (1 - t)^2
    np.testing.assert_allclose(motion.q[good, 0] * (1 - motion.t[good]), 1, rtol=1e-4)


@BOTH
def test_a_status_of_the_model_ends_the_run(method: str, tmp_path: Path) -> None:
    problem = Problem(tmp_path, "out[0] = u[0]; out[1] = -q[0]; if (t > 0.5) return 7;")
    with pytest.warns(SolveWarning, match="status 7"):
        motion = problem.run(1.0, [1, 0], method=method)
    assert motion.status == "model_failed"
    assert 0.4 < motion.t[-1] <= 0.5
    with pytest.raises(SolveError, match="status 7"):
        problem.run(1.0, [1, 0], method=method, check=True)


@BOTH
def test_a_bad_start_is_kept(method: str, tmp_path: Path) -> None:
    problem = Problem(tmp_path, "out[0] = log(q[0]); out[1] = 0;")
    with pytest.warns(SolveWarning, match=r"at t = 0 s.*'q0'"):
        motion = problem.run(1.0, [-1, 0], method=method)
    np.testing.assert_array_equal(motion.x, [[-1, 0]])


def test_interrupt_keeps_what_was_computed(tmp_path: Path) -> None:
    problem = Problem(tmp_path, OSCILLATOR)
    seen: list[float] = []

    def press(fraction: float) -> None:
        seen.append(fraction)
        if len(seen) == 5:
            os.kill(os.getpid(), signal.SIGINT)

    with pytest.warns(SolveWarning, match="interrupted at t = "):
        motion = problem.run(1e9, [1, 0], method="RK4", step=1e-2, progress=press)
    assert motion.status == "interrupted"
    assert 0 < motion.t[-1] < 1e9
    assert np.hypot(*motion.x[-1]) == pytest.approx(1, abs=1e-3)
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
