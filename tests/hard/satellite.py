"""A satellite that swings in the gradient of gravity for a hundred orbits."""

from __future__ import annotations

import numpy as np
import sympy as sp
from scipy.special import ellipj, ellipk

import cardan as cd

from .case import Case, alike

RATE = 1.1e-3  # of a low orbit [rad/s]
INERTIA = (10.0, 12.0, 5.0)
START = 0.5
TIMES = np.linspace(0, 100 * 2 * np.pi / RATE, 101)


def build() -> cd.Scene:
    """3 n^2 e x I e with e the direction to the earth, which turns about y."""
    scene = cd.Scene("satellite", gravity=(0, 0, 0))
    body = scene.body("hull", mass=1.0, com=(0, 0, 0), inertia=INERTIA)
    scene.joint("attitude", cd.Spherical(), scene.ground, body)
    down = sp.Matrix([sp.sin(RATE * cd.t), 0, sp.cos(RATE * cd.t)])
    R = body.rotation()
    e = sp.Matrix([sum(R[i, j] * down[i] for i in range(3)) for j in range(3)])
    torque = 3 * RATE**2 * e.cross(sp.diag(*INERTIA) @ e)
    scene.force("gradient", cd.Torque(body, tuple(torque), in_=body))
    return scene


def error(model: cd.CompiledModel, motion: cd.Trajectory) -> float:
    """Largest error of the attitude, all axes [rad]."""
    ratio = 3 * (INERTIA[0] - INERTIA[2]) / INERTIA[1]
    # 2 pitch swings like a pendulum
    k = np.sin(START)
    sn = ellipj(ellipk(k * k) - np.sqrt(ratio) * RATE * TIMES, k * k)[0]
    angle = RATE * TIMES + np.arcsin(k * sn)
    known = np.stack([np.cos(angle / 2), 0 * angle, np.sin(angle / 2), 0 * angle], axis=-1)
    found = motion.q * np.sign((motion.q * known).sum(axis=1))[:, None]
    return float(2 * np.abs(found - known).max())


CASE = Case(
    name="satellite",
    hard="attitude motion under the gravity gradient for 100 orbits, 5.7e5 s",
    oracle="pitch in closed form, roll and yaw zero; largest error of the attitude [rad]",
    advice="use `DOP853`; set atol far below the slow speeds, here 1e-3 rad/s",
    build=build,
    t=TIMES,
    start={
        "q": {"attitude": [np.cos(START / 2), 0, np.sin(START / 2), 0]},
        "u": {"attitude": [0, RATE, 0]},
    },
    error=error,
    fine={"rtol": 1e-9, "atol": 1e-13},
    coarse={"rtol": 1e-6, "atol": 1e-9},
    step=2.0,
    expected=alike(explicit=1e-5, lower=1e-4, implicit=1e-4, damped=1.0, fixed=1e-5, energy=1e-2),
)
