"""Inputs of a run: constants, values at times with corners and jumps, functions, samples."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import cardan as cd


@pytest.fixture(scope="module")
def cart() -> cd.CompiledModel:
    """A mass of 2 kg pushed along x."""
    scene = cd.Scene("cart", gravity=(0, 0, 0))
    body = scene.body("body", mass=2.0, com=(0, 0, 0), inertia=(1, 1, 1))
    scene.joint("rail", cd.Prismatic("x"), scene.ground, body)
    push = scene.input("push")
    scene.force("motor", cd.JointForce("rail", push))
    return cd.compile(scene)


METHODS = pytest.mark.parametrize("method", ["DOP853", "RK4"])


@METHODS
def test_corners_and_jumps_are_exact(cart: cd.CompiledModel, method: str) -> None:
    # a ramp up to 1 N, a jump to -1 N, a hold: every piece is a polynomial, so no error is left
    given = ([0.0, 0.7, 0.7, 2.0], [0.0, 1.0, -1.0, -1.0])
    motion = cart.simulate(2.0, method=method, inputs={"push": given}, rtol=1e-3)
    speed = 0.5 * (0.5 * 0.7) - 0.5 * 1.3
    path = 0.7**2 / 12 + 0.5 * (0.5 * 0.7) * 1.3 - 0.25 * 1.3**2
    np.testing.assert_allclose(motion.x[-1], [path, speed], rtol=0, atol=1e-13)
    assert 0.7 in motion.t
    assert motion["push"][-1] == -1.0


@METHODS
def test_functions_are_called_at_every_stage(cart: cd.CompiledModel, method: str) -> None:
    calls: list[float] = []

    def spring(t: float, x: np.ndarray) -> float:
        calls.append(t)
        return -2.0 * float(x[0])

    options: dict[str, Any] = {"method": method, "rtol": 1e-10, "atol": 1e-12}
    motion = cart.simulate(1.0, q={"rail": 1.0}, inputs={"push": spring}, **options)
    assert motion["rail"][-1] == pytest.approx(np.cos(1.0), abs=1e-9)
    assert len(calls) >= motion.statistics["evaluations"]


@METHODS
def test_samples_are_held(cart: cd.CompiledModel, method: str) -> None:
    times: list[float] = []

    def clock(t: float, x: np.ndarray) -> float:
        times.append(t)
        return 2.0 * len(times)

    # acceleration 1, 2, 3, 4 m/s^2 for a quarter of a second each
    motion = cart.simulate(1.0, method=method, inputs={"push": clock}, sample=0.25, rtol=1e-3)
    assert times == [0.0, 0.25, 0.5, 0.75]
    assert motion["rail.u"][-1] == pytest.approx(2.5, abs=1e-13)
    held = motion.resample([0.1, 0.3, 0.6, 0.9])["push"]
    np.testing.assert_array_equal(held, [2, 4, 6, 8])


def test_inputs_between_rows(cart: cd.CompiledModel) -> None:
    motion = cart.simulate(2.0, inputs={"push": ([0, 1, 2], [0, 1, 0])}, rtol=1e-3)
    times = np.array([0.0, 0.25, 0.5, 1.0, 1.75])
    np.testing.assert_allclose(motion.resample(times)["push"], [0, 0.25, 0.5, 1, 0.25], atol=1e-15)


def broken(t: float, x: np.ndarray) -> float:
    """A function that works for half a second."""
    if t > 0.5:
        raise LookupError("no such gain")
    return 1.0


@pytest.mark.parametrize("where", ["inputs", "events"])
def test_an_error_in_a_function_says_where(cart: cd.CompiledModel, where: str) -> None:
    name = {"inputs": "push", "events": "bumper"}[where]
    with pytest.raises(cd.FunctionError) as told:
        cart.simulate(1.0, max_step=0.1, **{where: {name: broken}})
    error = told.value
    assert f"{where}: the function of '{name}' raised at t = " in str(error)
    assert "LookupError: no such gain" in str(error)
    assert isinstance(error.__cause__, LookupError)
    # what was computed until then is kept
    assert error.motion.status == "function_failed"
    assert error.motion.message == str(error)
    assert 0.3 < error.motion.t[-1] <= 0.5
    push = 1.0 if where == "inputs" else 0.0
    np.testing.assert_allclose(error.motion["rail.u"], push / 2 * error.motion.t, atol=1e-12)


def test_a_stepper_stays_where_a_function_failed(cart: cd.CompiledModel) -> None:
    stepper = cart.stepper(events={"bumper": broken}, max_step=0.1)
    there = stepper.step(0.4)
    with pytest.raises(cd.FunctionError, match="'bumper' raised at t = 0"):
        stepper.step(0.3)
    assert stepper.t == 0.4
    assert (stepper.state == there).all()


def test_prescribed_motion_by_values(crank: cd.CompiledModel) -> None:
    times = np.linspace(0, 2, 201)
    motion = crank.simulate(2.0, inputs={"angle": (times, 0.5 * np.sin(3 * times))}, rtol=1e-9)
    known = 0.5 * np.sin(3 * motion.t)
    # the spline: h^4 / 384 times the fourth derivative, larger at its ends
    np.testing.assert_allclose(motion["angle"], known, rtol=0, atol=1e-7)
    np.testing.assert_allclose(motion["angle.rate"], 1.5 * np.cos(3 * motion.t), atol=1e-4)
    # what the drive gives is what the energy gains
    assert np.abs(motion.energy_residual).max() < 1e-7
    with pytest.raises(cd.ModelError, match="needs rate and acceleration"):
        crank.simulate(1.0, inputs={"angle": lambda t, x: t})
    with pytest.raises(cd.ModelError, match="no coordinate of its own"):
        crank.simulate(1.0, q={"drive": 1.0})


@pytest.mark.parametrize(
    ("times", "values", "exact"),
    [([0, 2], [0.5, 2.5], (0.5, 1.0, 0.0)), ([0, 0.5, 2], [0.1, 0.2, 1.1], (0.1, 0.1, 0.2))],
)
def test_prescribed_motion_by_two_or_three_values(
    crank: cd.CompiledModel, times: list[float], values: list[float], exact: tuple[float, ...]
) -> None:
    """A straight line, and a parabola, a + b t + c t^2, with their own rates and accelerations."""
    a, b, c = exact
    motion = crank.simulate(2.0, inputs={"angle": (times, values)}, rtol=1e-9)
    t = motion.t
    for name, known in (
        ("angle", a + b * t + c * t**2),
        ("angle.rate", b + 2 * c * t),
        ("angle.acceleration", 2 * c + 0 * t),
    ):
        np.testing.assert_allclose(motion[name], known, rtol=0, atol=1e-13)
    with pytest.raises(cd.ModelError, match="no jumps: give no time twice"):
        crank.simulate(1.0, inputs={"angle": ([0, 1, 1, 2], [0, 1, 2, 3])})


def test_a_function_with_other_arguments_is_refused() -> None:
    import cardan as cd
    from cardan.errors import ArgumentError

    scene = cd.Scene("pushed")
    push = scene.input("push")
    block = scene.body("block", mass=1.0)
    scene.joint("track", cd.Prismatic("x"), scene.ground, block)
    scene.force("motor", cd.JointForce("track", push))
    model = cd.compile(scene)
    for wrong in (lambda: 1.0, lambda t, x, more: 1.0, lambda t, *, key: 1.0):
        with pytest.raises(ArgumentError, match=r"'push' must take \(t, x\).* it takes \("):
            model.simulate(1.0, inputs={"push": wrong})
    # the state would take the place of what the user set
    for trap in (lambda t, k=3.0: k, lambda t, k=3.0, more=1.0: k):
        with pytest.raises(ArgumentError, match="would replace the default of 'k'"):
            model.simulate(1.0, inputs={"push": trap})
    alone = [
        lambda t: 2 * t,
        lambda t, *, k=2.0: k * t,
        lambda t, x, k=2.0: k * t,
        lambda *a: 2 * a[0],
    ]
    turn = cd.compile(scene).simulate(1.0, inputs={"push": np.sin}, rtol=1e-9)
    assert turn["track"][-1] == pytest.approx(1 - np.sin(1), abs=1e-9)
    for function in alone:
        motion = model.simulate(1.0, inputs={"push": function}, rtol=1e-9)
        assert motion["track"][-1] == pytest.approx(1 / 3, abs=1e-9)
