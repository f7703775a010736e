"""``model.step``: one call of the kernels for all states, with the bits of a stepper for each."""

from __future__ import annotations

import _thread
import threading
import warnings
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
import pytest
import sympy

import cardan as cd
from analyses.conftest import double_scene
from cardan.analyses.simulation.short_runs import AT_ONCE, ShortRuns
from cardan.errors import ArgumentError, ModelError, SolveError
from table import each

DT = 0.01


def example(name: str) -> tuple[Any, np.ndarray]:
    """A model, and a few states near its start."""
    model = cd.compile(cd.load(cd.examples.path(name)))
    with warnings.catch_warnings():
        # a start that is as near to another position
        warnings.simplefilter("ignore")
        x = np.tile(model.initial(), (7, 1))
    if not model.nlam:
        x[:, model.nq : model.nq + model.nu] += np.linspace(0, 0.5, 7)[:, None]
    return model, x


def by_stepper(model: Any, x: np.ndarray, dt: float, **options: Any) -> np.ndarray:
    return np.array([model.stepper(x0=row, **options).step(dt) for row in x])


@each("name", ["double_pendulum", "quadrotor", "four_bar", "cart_pole", "bouncing_ball"])
def test_states_have_the_bits_of_steppers(name: str) -> None:
    """Trees, quaternions, loops; events, which are left to the stepper."""
    model, x = example(name)
    for dt in (DT, -DT) if name != "bouncing_ball" else (DT,):
        expected = by_stepper(model, x, dt, rtol=1e-9)
        for _ in range(2):
            assert model.step(x, dt, rtol=1e-9).tobytes() == expected.tobytes()
            assert model.step(x[3], dt, rtol=1e-9).tobytes() == expected[3].tobytes()
        # after states of another shape, and of one alone
        several = model.step(x[:6].reshape(2, 3, -1), dt, rtol=1e-9)
        assert several.tobytes() == expected[:6].tobytes()
    used = [key for key in model._derived if isinstance(key, tuple) and key[0] is ShortRuns]
    assert bool(used) == (name != "bouncing_ball")


@each(
    "options",
    [
        {"method": "RK4", "step": 1e-3},
        {"method": "Radau", "rtol": 1e-8},
        {"t": 0.3, "max_step": 1e-3},
        {"inputs": {}},
    ],
)
def test_options_are_those_of_the_stepper(options: dict[str, Any]) -> None:
    model, x = example("double_pendulum")
    expected = by_stepper(model, x, DT, **options)
    assert model.step(x, DT, **options).tobytes() == expected.tobytes()
    # and do not stay behind
    assert model.step(x, DT).tobytes() == by_stepper(model, x, DT).tobytes()


def test_steps_end_where_the_model_jumps() -> None:
    scene = double_scene()
    torque = sympy.Piecewise((0.0, cd.t < 0.004), (5.0, True))
    scene.force("push", cd.JointForce("elbow", torque))
    model = cd.compile(scene)
    x = model.random_state(1, (3,))
    assert model.step(x, DT).tobytes() == by_stepper(model, x, DT).tobytes()
    assert model.step(x, DT, t=1.0).tobytes() == by_stepper(model, x, DT, t=1.0).tobytes()


@each("count", [1, 3])
def test_ctrl_c_is_heard_in_the_midst_of_a_run(count: int) -> None:
    """Of one state, or of one after the other; each would take minutes."""
    model, x = example("double_pendulum")
    x = x[1 : 1 + count]
    expected = model.step(x, DT)
    timer = threading.Timer(0.1, _thread.interrupt_main)
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        model.step(x[0] if count == 1 else x, 1e7)
    timer.join()
    # what was under way is not what the next call goes on with
    assert model.step(x, DT).tobytes() == expected.tobytes()


def test_runs_of_many_steps_have_the_bits_of_steppers() -> None:
    """More than one call of the kernels does, in each of several states."""
    model, x = example("double_pendulum")
    fine: Any = {"method": "RK4", "step": 1e-4}
    assert 1.0 / fine["step"] > 2 * AT_ONCE
    expected = by_stepper(model, x[:3], 1.0, **fine)
    assert model.step(x[:3], 1.0, **fine).tobytes() == expected.tobytes()


def test_results_are_nobody_elses() -> None:
    model, x = example("double_pendulum")
    before = x.copy()
    first = model.step(x[0], DT)
    kept = first.copy()
    second, many = model.step(x[1], DT), model.step(x, DT)
    assert not any(np.may_share_memory(first, y) for y in (second, many, x))
    second[:], many[:] = np.nan, np.nan
    assert np.array_equal(model.step(x[0], DT), kept)
    assert np.array_equal(first, kept)
    assert np.array_equal(x, before)


def test_threads_get_their_own_results() -> None:
    model, x = example("double_pendulum")
    x = np.tile(x, (40, 1)) + np.linspace(0, 1, 280)[:, None]
    expected = by_stepper(model, x, DT)

    def one(k: int) -> bool:
        rows = [model.step(row, DT) for row in x[k::8]]
        return np.array_equal(rows, expected[k::8]) and np.array_equal(model.step(x, DT), expected)

    with ThreadPoolExecutor(8) as pool:
        assert all(pool.map(one, range(8)))


def test_a_model_with_other_parameters_moves_otherwise() -> None:
    model = cd.compile(double_scene())
    x = model.random_state(2, (3,))
    name = next(n for n in model.parameters if "mass" in n or n.startswith("m"))
    first = model.step(x, 0.1)
    other = model.with_parameters({name: 3.0 * model.parameters[name]})
    changed = other.step(x, 0.1)
    assert changed.tobytes() == by_stepper(other, x, 0.1).tobytes()
    assert not np.allclose(changed, first, rtol=1e-6)
    assert model.step(x, 0.1).tobytes() == first.tobytes()


MISTAKES = (
    (lambda m, x: m.step(x, 0.0), ModelError, "takes some time"),
    (lambda m, x: m.step(x, np.inf), ModelError, "takes some time"),
    (lambda m, x: m.step(x[0][:-1], DT), ArgumentError, "x0 has shape"),
    (lambda m, x: m.step(1.0, DT), ArgumentError, "x0 has shape"),
    (lambda m, x: m.step(np.where(x == x[3], np.nan, x), DT), SolveError, "must be finite"),
    (lambda m, x: m.step(x.astype(complex), DT), ArgumentError, "real numbers"),
    (lambda m, x: m.step(x, DT, method="RK"), ModelError, "does not exist"),
    (lambda m, x: m.step(x, DT, rtol=-1.0), ModelError, "tolerances are positive"),
    (lambda m, x: m.step(x, DT, inputs={"none": 1.0}), ModelError, "there is no input"),
)


@each("call, error, message", MISTAKES)
def test_mistakes_are_named(call: Any, error: type[Exception], message: str) -> None:
    model, x = example("double_pendulum")
    model.step(x, DT)
    with pytest.raises(error, match=message):
        call(model, x)
    # and leave nothing behind
    assert model.step(x, DT).tobytes() == by_stepper(model, x, DT).tobytes()


def test_quaternions_must_have_length_1() -> None:
    model, x = example("quadrotor")
    x[4, :4] *= 1.1
    with pytest.raises(SolveError, match=r"quaternion at .* has length 1.1"):
        model.step(x, DT)
    with pytest.raises(SolveError, match=r"quaternion at .* has length 1.1"):
        model.step(x[4], DT)


def test_a_run_that_breaks_down_says_why() -> None:
    """One of several states, whose steps are too long for what it does."""
    model, x = example("double_pendulum")
    x[5, model.nq :] = 1e160
    with pytest.raises(SolveError, match=r"stopped at t = "):
        model.step(x, DT)
    with pytest.raises(SolveError, match=r"stopped at t = "):
        model.step(x[5], DT)
    assert np.isfinite(model.step(x[:5], DT)).all()
