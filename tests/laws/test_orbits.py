"""Frames along orbits and attitude in them: closed forms, and the motion of the whole."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.special import ellipk

import cardan as cd

INERTIA = (10.0, 12.0, 5.0)


def satellite(size: float = 1.0, radius: float = 7.0) -> cd.Scene:
    """Attitude alone: a satellite whose centre goes along a circular orbit with n = 1 rad/s."""
    scene = cd.Scene("attitude", gravity=(0, 0, 0))
    place = cd.orbit.circular(scene, "orbit", radius**3, radius, inclination=0.3)
    sat = scene.body("sat", mass=3.0, inertia=tuple(size**2 * x for x in INERTIA))
    scene.joint("attitude", cd.Spherical("ZYX"), place, sat)
    scene.force("gradient", cd.GravityGradient(scene.ground, radius**3))
    return scene


def test_place_and_axes() -> None:
    scene = cd.Scene("placed", gravity=(0, 0, 0))
    mu, radius, lean, node, phase = 2.0, 1.5, 0.4, 0.7, -0.2
    center = scene.ground.at(1, 2, 3, rotation=("XYZ", 0.1, 0.2, 0.3), name="planet")
    place = cd.orbit.circular(scene, "orbit", mu, radius, lean, node, phase, center=center)
    sat = scene.body("sat", mass=1.0, inertia=(1, 2, 3))
    scene.joint("attitude", cd.Spherical("ZYX"), place, sat)
    for name, angle in zip(("roll", "pitch", "yaw"), cd.orbit.attitude(sat, center), strict=True):
        scene.output(name, angle)
    model = cd.compile(scene)
    q, u, t = [0.5, -0.3, 0.8], np.zeros(3), 0.9
    np.testing.assert_allclose(model.outputs(q, u, t=t)[:3], q[::-1], atol=1e-14)
    c, s = np.cos([node, lean]), np.sin([node, lean])
    along = np.array([c[0], s[0], 0])
    across = np.array([-s[0] * c[1], c[0] * c[1], s[1]])
    turn = phase + np.sqrt(mu / radius**3) * t
    planet = model.pose("planet", q, t=t)
    out, forward = (
        planet[:3, :3] @ (along * np.cos(a) + across * np.sin(a)) for a in (turn, turn + np.pi / 2)
    )
    pose = model.pose("orbit", q, t=t)
    np.testing.assert_allclose(pose[:3, 3], planet[:3, 3] + radius * out, atol=1e-14)
    np.testing.assert_allclose(pose[:3, 0], forward, atol=1e-14)
    np.testing.assert_allclose(pose[:3, 2], -out, atol=1e-14)


def test_equations_do_not_see_the_orbit() -> None:
    """Attitude in a circular orbit is autonomous, to the sign of every term."""
    equations = cd.derive(satellite())
    for matrix in (equations.bias, equations.forces):
        assert "t" not in {symbol.name for symbol in matrix.free_symbols}


def test_pitch_libration_is_a_pendulum() -> None:
    """2 pitch swings like a pendulum: its period is an elliptic integral, whatever its size."""
    amplitude = 1.2
    frequency = np.sqrt(3 * (INERTIA[0] - INERTIA[2]) / INERTIA[1])
    period = 4 * ellipk(np.sin(amplitude) ** 2) / frequency
    motion = cd.compile(satellite()).simulate(
        [0, period / 2, period], q={"attitude": [0, amplitude, 0]}, rtol=1e-11, atol=1e-12
    )
    np.testing.assert_allclose(
        motion["attitude.angle2"], amplitude * np.array([1, -1, 1]), atol=1e-9
    )
    assert np.abs(motion.energy_residual).max() < 1e-8


def test_attitude_alone_is_the_limit_of_the_whole_motion() -> None:
    """What prescribing the orbit leaves out falls with the square of size / r."""
    start = [0.2, 0.5, -0.1]
    missed = []
    for size in (0.04, 0.02, 0.01):
        alone = cd.compile(satellite(size)).simulate([0, 3.0], q={"attitude": start}, rtol=1e-12)
        scene = cd.Scene("whole", gravity=(0, 0, 0))
        sat = scene.body("sat", mass=3.0, inertia=tuple(size**2 * x for x in INERTIA))
        scene.joint("free", cd.Free("ZYX"), scene.ground, sat)
        scene.force("field", cd.CentralGravity(scene.ground, 343.0))
        scene.force("gradient", cd.GravityGradient(scene.ground, 343.0))
        for name, angle in zip(("roll", "pitch", "yaw"), cd.orbit.attitude(sat), strict=True):
            scene.output(name, angle)
        model = cd.compile(scene)
        local = alone.pose("sat")[0]
        yaw, pitch, roll = (
            np.arctan2(local[1, 0], local[0, 0]),
            -np.arcsin(local[2, 0]),
            np.arctan2(local[2, 1], local[2, 2]),
        )
        normal = np.array([0, -np.sin(0.3), np.cos(0.3)])
        motion = model.simulate(
            [0, 3.0],
            q={"free": [yaw, pitch, roll, *local[:3, 3]]},
            u={"free": [*(local[:3, :3].T @ normal), *np.cross(normal, local[:3, 3])]},
            rtol=1e-12,
        )
        found = [motion[name][-1] for name in ("yaw", "pitch", "roll")]
        missed.append(np.abs(np.array(found) - alone.q[-1]).max())
    ratios = np.array(missed[:-1]) / missed[1:]
    np.testing.assert_allclose(ratios, 4, rtol=0.03)


def test_bad_orbits() -> None:
    scene = cd.Scene("bad")
    with pytest.raises(cd.ModelError, match="orbit 'o': radius is -1"):
        cd.orbit.circular(scene, "o", 1.0, -1.0)
    assert not scene.bodies
