"""Lengths of a micrometer and of an astronomical unit, in meters."""

from __future__ import annotations

import numpy as np
from scipy.optimize import brentq

import cardan as cd

from .case import Case, alike

# a mass of a nanogram on a spring: amplitude 1 um, 1e6 rad/s, 16 periods
AMPLITUDE, RATE = 1e-6, 1e6
SHORT = np.linspace(0, 1e-4, 41)


def resonator() -> cd.Scene:
    """1e-12 kg on 1 N/m."""
    scene = cd.Scene("resonator", gravity=(0, 0, 0))
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("mass", mass=1e-12))
    scene.force("spring", cd.JointSpring("x", stiffness=1.0))
    return scene


def missed(model: cd.CompiledModel, motion: cd.Trajectory) -> float:
    """Largest error over the amplitude."""
    return float(np.abs(motion["x"] / AMPLITUDE - np.cos(RATE * SHORT)).max())


# Halley's comet: half axis 17.8 AU, from perihelion through one and a half revolutions
SUN, AU, YEAR = 1.32712440018e20, 1.495978707e11, 3.15576e7
HALF, ECCENTRICITY = 17.834 * AU, 0.967
MOTION = np.sqrt(SUN / HALF**3)
LONG = np.linspace(0, 1.5 * 2 * np.pi / MOTION, 31)
NEAREST = HALF * (1 - ECCENTRICITY)
FASTEST = np.sqrt(SUN / HALF * (1 + ECCENTRICITY) / (1 - ECCENTRICITY))


def comet() -> cd.Scene:
    """A point mass in the field of the sun."""
    scene = cd.Scene("comet", gravity=(0, 0, 0))
    rider, head = scene.body("rider", mass=0), scene.body("head", mass=2.2e14)
    scene.joint("x", cd.Prismatic("x"), scene.ground, rider)
    scene.joint("y", cd.Prismatic("y"), rider, head)
    x, y = scene.q("x"), scene.q("y")
    pull = -SUN * 2.2e14 / (x**2 + y**2) ** 1.5
    scene.force("sun", cd.Force(head, (pull * x, pull * y, 0)))
    return scene


def kepler(t: float) -> tuple[float, float]:
    """Place at a time by Kepler's equation, in half axes."""
    mean = MOTION * t
    e = ECCENTRICITY
    angle = brentq(lambda E: E - e * np.sin(E) - mean, mean - 1, mean + 1, xtol=1e-14, rtol=1e-15)
    return np.cos(angle) - e, np.sqrt(1 - e * e) * np.sin(angle)


def astray(model: cd.CompiledModel, motion: cd.Trajectory) -> float:
    """Largest error of the place over the half axis."""
    known = np.array([kepler(t) for t in LONG])
    found = np.stack([motion["x"], motion["y"]], axis=-1) / HALF
    return float(np.linalg.norm(found - known, axis=1).max())


TINY = Case(
    name="micrometers",
    hard="a resonator of 1e-12 kg with an amplitude of 1e-6 m at 160 kHz",
    oracle="closed form; largest error divided by the amplitude",
    advice="set atol to rtol times the amplitude",
    build=resonator,
    t=SHORT,
    start={"q": {"x": AMPLITUDE}},
    error=missed,
    # atol goes with the amplitude: 1e-9 m, the default, would be a thousandth of it
    fine={"rtol": 1e-9, "atol": 1e-9 * AMPLITUDE},
    coarse={"rtol": 1e-6, "atol": 1e-6 * AMPLITUDE},
    step=1e-8,
    # RK4: Omega = 0.01, error Omega^4 t / 120; midpoint: Omega^2 t / 12
    expected=alike(explicit=5e-8, lower=1e-7, implicit=1e-8, damped=5e-2, fixed=1e-8, energy=1e-3),
)
HUGE = Case(
    name="astronomical units",
    hard="Halley's comet for one and a half orbits: 1e12 m and 4e9 s, eccentricity 0.967",
    oracle="Kepler's equation; largest position error divided by the semi-major axis",
    advice="set atol by the smallest length that matters; the default is tighter",
    build=comet,
    t=LONG,
    start={"q": {"x": NEAREST}, "u": {"y": FASTEST}},
    error=astray,
    fine={"rtol": 1e-9, "atol": 1e-3},
    coarse={"rtol": 1e-7, "atol": 1e-1},
    step=LONG[-1] / 200_000,
    # what is lost at the sun, 1e-9 a step, changes the period 90 times as much
    expected=alike(explicit=1e-5, lower=3e-5, implicit=5e-6, damped=3e-1, fixed=1e-6, energy=1e-1),
)
