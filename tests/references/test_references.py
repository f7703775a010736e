"""Published and independently computed motions; every JSON file names its source."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd

HERE = Path(__file__).parent


def reference(name: str) -> dict[str, Any]:
    return json.loads((HERE / f"{name}.json").read_text(encoding="utf-8"))


def double_pendulum() -> cd.Scene:
    """Point masses of 1 kg on massless rods of 1 m."""
    scene = cd.Scene("double_pendulum_A", gravity=(0, 0, -9.81))
    upper = scene.body("upper", mass=1.0, com=(0, 0, -1.0))
    lower = scene.body("lower", mass=1.0, com=(0, 0, -1.0))
    scene.joint("shoulder", cd.Revolute("y"), scene.ground, upper)
    scene.joint("elbow", cd.Revolute("y"), upper.at(0, 0, -1.0), lower)
    return scene


@pytest.mark.parametrize("method", ["kane", "newton_euler", "composite", "articulated"])
def test_double_pendulum(method: str) -> None:
    rows = reference("double_pendulum_A")["rows"]
    times = np.array([0.0, *(row["t"] for row in rows)])
    model = cd.compile(double_pendulum(), method=method)
    motion = model.simulate(times, q={"shoulder": np.pi / 2}, rtol=3e-14, atol=3e-15)
    # absolute angles from the vertical, as in the reference
    theta1, rate1 = motion["shoulder"], motion["shoulder.u"]
    computed = np.stack(
        [theta1, theta1 + motion["elbow"], rate1, rate1 + motion["elbow.u"]], axis=-1
    )[1:]
    error = np.abs(computed - [row["y"] for row in rows]).max(axis=1)
    # "separation" is what a perturbation of 1e-10 has grown to: 1e-3 of it is one of 1e-13
    allowed = 1e-3 * np.array([row["separation"] for row in rows])
    print(f"largest error / allowed: {(error / allowed).max():.3f}")
    assert np.all(error <= allowed)


def test_pendulum() -> None:
    known = reference("iftomm_A01_pendulum")
    scene = cd.Scene("iftomm_A01", gravity=(0, -9.81, 0))
    bob = scene.body("bob", mass=1.0, com=(-1.0, 0, 0))
    scene.joint("pivot", cd.Revolute("z"), scene.ground, bob)
    model = cd.compile(scene)
    motion = model.simulate(np.array([0.0, *known["t"]]), rtol=1e-12, atol=1e-13)
    angle = motion["pivot"][1:]
    tolerance = 1e-9
    np.testing.assert_allclose(-np.cos(angle), known["x"], rtol=0, atol=tolerance)
    np.testing.assert_allclose(-np.sin(angle), known["y"], rtol=0, atol=tolerance)
    np.testing.assert_allclose(motion["pivot.u"][1:], known["thetadot"], rtol=0, atol=tolerance)


def test_pendulum_energy_at_ordinary_tolerances() -> None:
    known = reference("iftomm_A01_pendulum")
    scene = cd.Scene("iftomm_A01", gravity=(0, -9.81, 0))
    bob = scene.body("bob", mass=1.0, com=(-1.0, 0, 0))
    scene.joint("pivot", cd.Revolute("z"), scene.ground, bob)
    model = cd.compile(scene)
    motion = model.simulate(10.0, rtol=1e-8, atol=1e-10)
    total = motion.energy.total
    assert np.abs(total - total[0]).max() < known["published_drift"]


def rigid_body(rotation: str) -> cd.Scene:
    scene = cd.Scene("torque_free", gravity=(0, 0, 0))
    body = scene.body("body", mass=1.0, inertia=(1.0, 2.0, 3.0))
    scene.joint("ball", cd.Spherical(rotation=rotation), scene.ground, body)
    return scene


@pytest.mark.parametrize("rotation", ["quaternion", "dcm"])
def test_torque_free_body(rotation: str) -> None:
    known = reference("torque_free_asymmetric")
    model = cd.compile(rigid_body(rotation))
    motion = model.simulate(
        np.array([0.0, *known["t"]]), u={"ball": known["initial_state"]["w0"]},
        rtol=3e-14, atol=3e-15,
    )  # fmt: skip
    # the flip at the unstable axis magnifies rounding, hence 1e-11 as the reference says
    np.testing.assert_allclose(motion.u[1:], known["w"], rtol=0, atol=1e-11)


def test_torque_free_body_keeps_its_integrals_and_period() -> None:
    known = reference("torque_free_asymmetric")
    model = cd.compile(rigid_body("quaternion"))
    w0 = np.array(known["initial_state"]["w0"])
    times = np.array([0.0, known["period_omega2"]])
    motion = model.simulate(times[-1], t_eval=times, u={"ball": w0}, rtol=3e-14, atol=3e-15)
    np.testing.assert_allclose(motion.u[-1], w0, rtol=0, atol=1e-11)
    kinetic = motion.energy.kinetic
    np.testing.assert_allclose(2 * kinetic, known["twoT"], rtol=1e-13)
    # momentum about the ground origin, angular part first
    angular = model.momentum(motion.q, motion.u)[:, :3]
    np.testing.assert_allclose((angular**2).sum(axis=1), known["H2"], rtol=1e-12)
    np.testing.assert_allclose(angular[-1], angular[0], rtol=0, atol=1e-12)
