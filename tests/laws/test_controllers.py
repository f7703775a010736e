"""Controllers and actuators with states of their own, against closed forms."""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd

FINE = {"rtol": 1e-11, "atol": 1e-12}


def slider(name: str, mass: float = 1.0) -> cd.Scene:
    """A mass on a rail."""
    scene = cd.Scene(name, gravity=(0, 0, 0))
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("block", mass=mass))
    return scene


def test_a_sampled_controller_holds_its_force() -> None:
    """Mass under a digital PD controller: exact steps of a double integrator."""
    m, period = 2.0, 0.05
    scene = slider("digital", mass=m)
    x, v = scene.q("x"), scene.u("x")
    scene.force("pd", cd.Controller.pid("x", x, v, target=1.0, kp=8.0, kd=5.0, sample=period))
    motion = cd.compile(scene).simulate(np.arange(0, 3.001, period), **FINE)
    place = speed = 0.0
    wanted = []
    for _ in motion.t:
        wanted.append((place, speed))
        a = (8.0 * (1.0 - place) - 5.0 * speed) / m
        place, speed = place + speed * period + a * period**2 / 2, speed + a * period
    assert motion.x == pytest.approx(np.array(wanted), abs=1e-10)


def test_a_continuous_controller_has_states() -> None:
    m, kp, ki, kd, target = 2.0, 8.0, 3.0, 5.0, 1.0
    scene = slider("analog", mass=m)
    x, v = scene.q("x"), scene.u("x")
    scene.force("pid", cd.Controller.pid("x", x, v, target=target, kp=kp, ki=ki, kd=kd))
    scene.output("sum", scene.state("pid.integral"))
    motion = cd.compile(scene).simulate(4.0, **FINE)
    A = np.array([[0, 1, 0], [-kp / m, -kd / m, ki / m], [-1, 0, 0]])
    b = np.array([0, kp * target / m, target])
    # x' = A x + b from rest
    w, T = np.linalg.eig(A)
    start = np.linalg.solve(T, np.linalg.solve(A, b))
    wanted = (T @ (np.exp(w * motion.t[-1]) * start)).real - np.linalg.solve(A, b)
    assert motion.x[-1] == pytest.approx(wanted, abs=1e-9)
    assert motion["sum"][-1] == pytest.approx(wanted[2], abs=1e-9)
    assert motion["pid.integral"][-1] == pytest.approx(wanted[2], abs=1e-9)


def test_state_space_controllers_are_their_matrices() -> None:
    scene = slider("observer", mass=1.0)
    measured = [scene.q("x")]
    made = cd.Controller.state_space("x", [[-3.0]], [[2.0]], [1.5], [-4.0], measured, start=(0.2,))
    scene.force("lag", made)
    motion = cd.compile(scene).simulate(2.0, q={"x": 1.0}, **FINE)
    A = np.array([[0, 1, 0], [-4.0, 0, 1.5], [2.0, 0, -3.0]])
    w, T = np.linalg.eig(A)
    wanted = (T @ (np.exp(w * 2.0) * np.linalg.solve(T, [1.0, 0, 0.2]))).real
    assert motion.x[-1] == pytest.approx(wanted, abs=1e-9)


def test_an_actuator_lags() -> None:
    scene = slider("motor", mass=1.0)
    scene.force("motor", cd.Actuator("x", command=3.0, lag=0.2, limit=2.0))
    motion = cd.compile(scene).simulate(1.0, **FINE)
    assert motion["motor.force"] == pytest.approx(3.0 * (1 - np.exp(-motion.t / 0.2)), abs=1e-10)
    # the joint feels it up to its limit
    reached = -0.2 * np.log(1 - 2.0 / 3.0)
    before = 3.0 * (reached - 0.2 * (1 - np.exp(-reached / 0.2)))
    assert motion["x.u"][-1] == pytest.approx(before + 2.0 * (1.0 - reached), abs=1e-6)
