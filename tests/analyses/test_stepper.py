"""Stepping by hand: the same motion, new inputs, and checkpoints to the bit."""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd

METHODS = pytest.mark.parametrize(
    "options", [{"rtol": 1e-11, "atol": 1e-12}, {"method": "RK4", "step": 1e-3}], ids=str
)


@METHODS
def test_steps_lead_where_a_run_leads(double: cd.CompiledModel, options: dict) -> None:
    stepper = double.stepper(q={"elbow": 0.4}, inputs={"torque": 0.3}, **options)
    for _ in range(20):
        state = stepper.step(0.05)
    motion = double.simulate(1.0, q={"elbow": 0.4}, inputs={"torque": 0.3}, **options)
    assert stepper.t == pytest.approx(1.0, abs=1e-14)
    np.testing.assert_allclose(state, motion.x[-1], rtol=0, atol=1e-9)
    assert stepper.work["motor"] == pytest.approx(motion.work["motor"][-1], abs=1e-9)


@METHODS
def test_restore_is_bit_for_bit(double: cd.CompiledModel, options: dict) -> None:
    stepper = double.stepper(q={"elbow": 0.9}, **options)
    stepper.step(0.37)
    saved = stepper.save()
    inputs = [{"torque": 0.2}, None, {"torque": -1.0}, None]
    first = [stepper.step(0.05 * (k + 1), inputs[k]) for k in range(4)]
    stepper.restore(saved)
    assert stepper.t == pytest.approx(0.37)
    assert stepper.inputs == {"torque": 0.0}
    again = [stepper.step(0.05 * (k + 1), inputs[k]) for k in range(4)]
    np.testing.assert_array_equal(first, again)


def test_inputs_hold_until_changed(double: cd.CompiledModel) -> None:
    stepper = double.stepper(inputs={"torque": 1.0})
    stepper.step(0.1)
    assert stepper.inputs == {"torque": 1.0}
    stepper.step(0.1, inputs={"torque": -2.0})
    assert stepper.inputs == {"torque": -2.0}
    assert "t = 0.2 s" in repr(stepper)


def test_backward_and_forward(double: cd.CompiledModel) -> None:
    stepper = double.stepper(t=2.0, q={"elbow": 0.4}, rtol=1e-12, atol=1e-13)
    start = stepper.state
    stepper.step(0.5)
    stepper.step(-0.5)
    assert stepper.t == 2.0
    np.testing.assert_allclose(stepper.state, start, rtol=0, atol=1e-11)


def test_mistakes(double: cd.CompiledModel, ball: cd.CompiledModel) -> None:
    stepper = double.stepper()
    with pytest.raises(cd.ModelError, match="takes some time"):
        stepper.step(0.0)
    with pytest.raises(cd.ModelError, match="Did you mean 'torque'"):
        stepper.step(0.1, inputs={"torqu": 1.0})
    with pytest.raises(cd.SolveError, match="'torque' is nan"):
        stepper.step(0.1, inputs={"torque": np.nan})
    with pytest.raises(cd.ModelError, match="RK4 needs step="):
        double.stepper(method="RK4")
    with pytest.raises(cd.ModelError, match="takes numbers"):
        double.stepper(inputs={"torque": np.sin})
    with pytest.raises(cd.ModelError, match="another stepper"):
        stepper.restore(ball.stepper().save())


def test_one_step_from_many_states(double: cd.CompiledModel) -> None:
    """Leading axes broadcast, and there and back again is where it began."""
    rng = np.random.default_rng(3)
    x = rng.uniform(-1, 1, (2, 3, double.nx))
    options = {"rtol": 1e-12, "atol": 1e-13}
    there = double.step(x, 0.2, **options)
    assert there.shape == x.shape
    for place in np.ndindex(2, 3):
        motion = double.simulate(0.2, x0=x[place], **options)
        np.testing.assert_allclose(there[place], motion.x[-1], rtol=0, atol=1e-11)
    np.testing.assert_allclose(double.step(there, -0.2, **options), x, rtol=0, atol=1e-10)
