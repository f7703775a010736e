"""Methods on the rotation group: order, unit length, steady spins, agreement with others."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from cardan.errors import SolveWarning
from cardan.schema.integrators import Integrator
from kernels.problem import METHODS, TOP_START, TOP_THERE, Problem, top
from kernels.test_order import fixed, slope

CHARTED = {name: method for name, method in METHODS.items() if method.charted}
EACH = pytest.mark.parametrize("method", CHARTED.values(), ids=CHARTED)
# steps over 0.1 s, in which the top turns by 15 rad
STEPS = {4: (50, 64, 80, 100, 128, 160), 5: (50, 64, 80, 100, 128, 160), 8: (20, 25, 32, 40, 50)}
# a body of moments 1, 2, 3 without torques
FREE = """
    real w = q[0], x = q[1], y = q[2], z = q[3], a = u[0], b = u[1], c = u[2];
    out[0] = 0.5 * (-x * a - y * b - z * c); out[1] = 0.5 * (w * a + y * c - z * b);
    out[2] = 0.5 * (w * b + z * a - x * c); out[3] = 0.5 * (w * c + x * b - y * a);
    out[4] = -b * c; out[5] = a * c; out[6] = -a * b / 3;
"""


def free(folder: Path) -> Problem:
    return Problem(folder, FREE, nq=4, nu=3, quaternions=(0,))


@EACH
def test_order_of_rotations_and_speeds(method: Integrator, tmp_path: Path) -> None:
    problem, there = top(tmp_path), np.array(TOP_THERE)
    steps, errors = 0.1 / np.array(STEPS[method.order]), []
    for h in steps:
        end = problem.run((0, 0.1), TOP_START, **fixed(method, h)).x[-1]
        end[:4] *= np.sign(end[:4] @ there[:4])
        missed = np.abs(end - there)
        errors.append((missed[:4].max(), missed[4:].max()))
    for block in np.transpose(errors):
        assert slope(steps, block) == pytest.approx(method.order, abs=0.15)


@EACH
def test_order_between_the_steps(method: Integrator, tmp_path: Path) -> None:
    problem, errors = top(tmp_path), []
    known = problem.run(
        (0, 0.02), TOP_START, method="DOP853", rtol=1e-13, atol=1e-15, max_step=1e-4
    )
    steps = np.array((4e-3, 3e-3, 2e-3, 1.5e-3, 1e-3)) * (2 if method.order == 8 else 0.5)
    for h in steps:
        inside = h * np.linspace(0.05, 0.95, 19)
        motion = problem.run((0, h), TOP_START, **fixed(method, h))
        errors.append(np.abs(motion.at(inside) - known.at(inside)).max())
    assert slope(steps, errors) == pytest.approx(method.dense_order + 1, abs=0.15)


@EACH
def test_a_steady_spin_is_exact(method: Integrator, tmp_path: Path) -> None:
    # about an axis of inertia at 3 rad/s: one radian in a step, a thousand of them
    motion = free(tmp_path).run(1000 / 3, [1, 0, 0, 0, 0, 3, 0], **fixed(method, 1 / 3))
    half = 1.5 * motion.t
    exact = np.stack([np.cos(half), 0 * half, np.sin(half), 0 * half], axis=-1)
    # a rounding of the angle per step, and one of the time
    np.testing.assert_allclose(motion.q, exact, rtol=0, atol=1000 * 2.3e-16)
    np.testing.assert_allclose(np.linalg.norm(motion.q, axis=1), 1, rtol=0, atol=4e-16)
    times = np.linspace(0, 333, 1234)
    np.testing.assert_allclose(
        motion.at(times)[:, 0], np.cos(1.5 * times), rtol=0, atol=1000 * 2.3e-16
    )


def test_a_steady_spin_costs_few_steps(tmp_path: Path) -> None:
    options = {"rtol": 1e-10, "atol": 1e-10}
    start = [1, 0, 0, 0, 0, 30, 0]
    steps = {
        name: free(tmp_path).run(100.0, start, method=name, **options).statistics["steps"]
        for name in ("DOP853", "RKMK853")
    }
    assert steps["RKMK853"] < 0.5 * steps["DOP853"]


@pytest.mark.parametrize("method", ["RKMK45", "RKMK853"])
def test_torque_free_body_against_its_closed_form(method: str, tmp_path: Path) -> None:
    start = [1, 0, 0, 0, 0.01, 1.0, 0.02]
    times = np.array([0.0, 1, 5, 10, 20, 50])
    motion = free(tmp_path).run(times, start, method=method, rtol=1e-12, atol=1e-13)
    # Jacobi's elliptic functions: L. D. Landau, E. M. Lifshitz, Mechanics, section 37
    known = [
        [-0.009416982032865097, 1.0000056602086775, 0.01990543937895159],
        [-0.2172275174686638, 0.976172221308519, 0.1268697420527565],
        [-0.8036645188774618, -0.595166649853217, 0.4643908766339494],
        [0.08460100266529402, -0.9964650873703638, 0.05246373239987002],
        [-0.005911753469583117, -1.000032525056504, 0.01945035414491528],
    ]
    # along an unstable axis errors grow by exp(0.58 t) on the way to 10 s, then come back
    np.testing.assert_allclose(motion.u[1:], known, rtol=0, atol=1e-9)
    np.testing.assert_allclose(np.linalg.norm(motion.q, axis=1), 1, rtol=0, atol=4e-16)
    momentum = rotated(motion.q, motion.u * [1, 2, 3])
    np.testing.assert_allclose(momentum, momentum[:1].repeat(6, 0), rtol=0, atol=1e-9)


def rotated(q: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Vectors in body axes told in space."""
    w, n = q[:, :1], q[:, 1:]
    return v + 2 * np.cross(n, np.cross(n, v) + w * v)


@EACH
def test_events_between_the_steps(method: Integrator, tmp_path: Path) -> None:
    options = {"rtol": 1e-10, "atol": 1e-11} if method.adaptive else {"step": 1e-4}
    watch = {"half": lambda t, x: x[0] - 0.5}
    motion = top(tmp_path).run(0.1, TOP_START, method=method.name, events=watch, **options)
    known = top(tmp_path).run(0.1, TOP_START, rtol=1e-13, atol=1e-14, events=watch)
    assert motion.status == "event"
    assert motion.t[-1] == pytest.approx(known.t[-1], abs=1e-10)
    # the last step ends at the event, and what is inside it is of its own polynomial
    times = np.linspace(0.9, 0.999, 50) * known.t[-1]
    np.testing.assert_allclose(motion.at(times), known.at(times), rtol=0, atol=2e-8)


def test_too_long_a_step_says_so(tmp_path: Path) -> None:
    with pytest.warns(SolveWarning, match=r"a step of 0.2 s is most of a turn.*step= shorter"):
        motion = free(tmp_path).run(1.0, [1, 0, 0, 0, 0, 30, 0], method="RKMK4", step=0.2)
    assert motion.status == "step_too_long"
    assert len(motion) == 1
