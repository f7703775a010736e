"""A hundred million times as heavy below as above: two rods that swing like one."""

from __future__ import annotations

import numpy as np
from scipy.special import ellipj, ellipk

import cardan as cd

from .case import Case, Cell, alike

LIGHT, HEAVY, G = 1e-4, 1e4, 9.81
START = 1.0
# its side of the line
SIDE = -1
# where the light mass hangs off the line while the heavy one is at rest: it does not vibrate
OFF = LIGHT / HEAVY * np.tan(START) / 4
TIMES = np.linspace(0, 5.0, 26)


def build() -> cd.Scene:
    """Point masses on massless rods of 1 m."""
    scene = cd.Scene("mass_ratio", gravity=(0, 0, -G))
    upper = scene.body("upper", mass=LIGHT, com=(0, 0, -1.0))
    lower = scene.body("lower", mass=HEAVY, com=(0, 0, -1.0))
    scene.joint("shoulder", cd.Revolute("y"), scene.ground, upper)
    scene.joint("elbow", cd.Revolute("y"), upper.at(0, 0, -1.0), lower)
    return scene


def swing(start: float, length: float, t: np.ndarray) -> np.ndarray:
    """Angle of a pendulum that was let go: Jacobi's sn."""
    k = np.sin(start / 2)
    sn = ellipj(ellipk(k * k) - np.sqrt(G / length) * t, k * k)[0]
    return 2 * np.arcsin(k * sn)


def error(model: cd.CompiledModel, motion: cd.Trajectory) -> float:
    """Largest error of both angles."""
    known = swing(START, 2.0, motion.t)
    return float(max(np.abs(motion["shoulder"] - known).max(), np.abs(motion["elbow"]).max()))


# the light mass leaves the line by some 1e-8 itself
EXPECTED = alike(
    explicit=1e-6, lower=1e-6, implicit=1e-6, damped=1e-3, fixed=1e-6, energy=1e-4,
    EnergyMidpoint=Cell(1e-4, {"step": 1e-3}),
)  # fmt: skip

CASE = Case(
    name="mass ratio",
    hard="1e4 kg below 1e-4 kg: M has condition number 1e8; the light mass vibrates at 1e5 rad/s",
    oracle="closed form of one rod of total length, within 1e-8; largest error of an angle [rad]",
    advice="use `Rosenbrock` at rtol=1e-8 or above; others follow the vibration",
    build=build,
    t=TIMES,
    start={"q": {"shoulder": START + SIDE * OFF, "elbow": -2 * SIDE * OFF}},
    fine={"rtol": 1e-8, "atol": 1e-10},
    error=error,
    expected=EXPECTED,
    step=1e-5,
)
