"""Wheels in bodies: what moves them in three ways, in closed form; stability of dual spin."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from mechanisms.space import dual_spin
from table import each

TIGHT = {"rtol": 1e-12, "atol": 1e-13}
I1, I2, I3, J = 2.0, 2.6, 3.1, 0.4


def gyrostat(carrier: tuple[float, float, float], **wheel: Any) -> cd.Scene:
    scene = cd.Scene("gyrostat", gravity=(0, 0, 0))
    bus = scene.body("bus", mass=5.0, inertia=carrier)
    scene.joint("attitude", cd.Spherical(), scene.ground, bus)
    scene.force("wheel", cd.Rotor(bus, **wheel))
    return scene


def test_three_ways_of_moving_are_one_gyrostat() -> None:
    """A free wheel keeps its momentum, one of constant speed that against the carrier."""
    start, spin, times = [0.3, -0.2, 0.7], 9.0, [0.0, 2.0, 7.0]

    def rates(scene: cd.Scene, **more: Any) -> Any:
        u = {"attitude": start, **more}
        return cd.compile(scene).simulate(times, u=u, **TIGHT).u[:, :3]

    idle = rates(gyrostat((I1, I2, I3), inertia=J), **{"wheel.rotor": spin})
    kept = rates(gyrostat((I1, I2, I3), momentum=J * (spin + start[2])))
    np.testing.assert_allclose(idle, kept, atol=1e-10)
    steady = rates(gyrostat((I1, I2, I3), inertia=J, speed=spin))
    locked = rates(gyrostat((I1, I2, I3 + J), momentum=J * spin))
    np.testing.assert_allclose(steady, locked, atol=1e-10)
    assert np.abs(idle - steady).max() > 1e-4


def test_nutation_in_closed_form() -> None:
    """Of a symmetric gyrostat the rate across the axis turns at ((I3 - I1) nu + h) / I1."""
    nu, h, tilt = 0.8, 2.5, 0.3
    model = cd.compile(gyrostat((I1, I1, I3), momentum=h))
    motion = model.simulate(20.0, u={"attitude": [tilt, 0, nu]}, **TIGHT)
    turn = ((I3 - I1) * nu + h) / I1 * motion.t
    wanted = np.stack([tilt * np.cos(turn), tilt * np.sin(turn), np.full(turn.shape, nu)], axis=1)
    np.testing.assert_allclose(motion.u, wanted, atol=1e-9)
    # the whole momentum keeps its direction in space; the wheel's is not in model.momentum
    axis = model.pose("bus", motion.q)[:, :3, 2]
    whole = model.momentum(motion.q, motion.u)[:, :3] + h * axis
    np.testing.assert_allclose(whole, whole[np.zeros(len(whole), int)], atol=1e-9)


def test_spin_up_exchanges_momentum() -> None:
    """A motor torque turns wheel and carrier against each other; friction brings them back."""
    scene = gyrostat((I1, I2, I3), inertia=J, torque=0.2)
    model = cd.compile(scene)
    motion = model.simulate(5.0, **TIGHT)
    np.testing.assert_allclose(motion["attitude.u.z"], -0.2 * motion.t / I3, atol=1e-12)
    relative = 0.2 * motion.t * (1 / J + 1 / I3)
    np.testing.assert_allclose(motion["wheel.rotor.u"], relative, atol=1e-12)
    assert np.abs(model.momentum(motion.q, motion.u)[:, 2]).max() < 1e-14
    scene = gyrostat((I1, I2, I3), inertia=J, friction=0.3)
    motion = cd.compile(scene).simulate(4.0, u={"wheel.rotor": 10.0}, **TIGHT)
    slowed = 10.0 * np.exp(-0.3 * (1 / J + 1 / I3) * motion.t)
    np.testing.assert_allclose(motion["wheel.rotor.u"], slowed, atol=1e-10)
    assert np.abs(motion.energy_residual).max() < 1e-10


def test_motor_with_feedback(tmp_path: Path) -> None:
    """A law in the speed of the wheel by its name, in Python and in a file."""
    scene = gyrostat((I1, I2, I3), inertia=J)
    law = cd.JointForce("wheel.rotor", 2.0 * (6.0 - scene.u("wheel.rotor")))
    scene.force("motor", law)
    scene.save(tmp_path / "scene.yaml")
    for read in (scene, cd.load(tmp_path / "scene.yaml")):
        motion = cd.compile(read).simulate(5.0)
        assert motion["wheel.rotor.u"][-1] == pytest.approx(6.0, abs=1e-6)


@cache
def spinning() -> cd.CompiledModel:
    return cd.compile(dual_spin())


@each("damping", [0.0, 0.05])
@each("nu", [1.2, -1.2, 0.4])
@each("hs", [-8.0, -1.0, 0.1, 0.6, 1.2, 6.0])
def test_dual_spin_is_stable_where_it_should(nu: float, hs: float, damping: float) -> None:
    """Undamped: a product of two signs. With a damper: least energy at the momentum that is kept.

    Across the axis the energy grows by (1 / Ik - nu / (I3 nu + hs)) Hk^2 / 2, k = 1, 2: for
    momentum along nu it must exceed max(I1, I2) nu, against it all is stable.
    """
    i1, i2, i3 = 4.0, 4.2, 3.6
    model = spinning().with_parameters({"nu": nu, "hs": hs, "damper.damping": damping})
    values = np.linalg.eigvals(model.linearize().A)
    grows = values.real.max() > 1e-9
    effective = (i3 * nu + hs) / nu
    if damping:
        assert grows == (0 < effective < max(i1, i2))
    else:
        assert grows == ((effective - i1) * (effective - i2) < 0)
