"""A spring so stiff that it is a rod, started where it does not vibrate."""

from __future__ import annotations

import numpy as np

import cardan as cd

from .case import Case, Cell, alike
from .mass_ratio import G, swing

STIFFNESS, START = 1e10, 1.0
TIMES = np.linspace(0, 10.0, 101)


def build() -> cd.Scene:
    """A bob of 1 kg on a spring of 1 m that swings."""
    scene = cd.Scene("stiff_spring", gravity=(0, 0, -G))
    sleeve = scene.body("sleeve", mass=0)
    bob = scene.body("bob", mass=1.0)
    scene.joint("swing", cd.Revolute("y"), scene.ground, sleeve)
    scene.joint("stretch", cd.Prismatic((0, 0, -1)), sleeve.at(0, 0, -1.0), bob)
    scene.force("spring", cd.JointSpring("stretch", stiffness=STIFFNESS))
    return scene


def error(model: cd.CompiledModel, motion: cd.Trajectory) -> float:
    """Largest error of the angle."""
    return float(np.abs(motion["swing"] - swing(START, 1.0, motion.t)).max())


# the spring gives by some 1e-9 m, so that the closed form of a rod is right to some 1e-8
EXPECTED = alike(
    explicit=1e-6, lower=1e-6, implicit=1e-5, damped=1e-2, fixed=1e-6, energy=1e-3,
    EnergyMidpoint=Cell(1e-3, {"step": 1e-3}),
)  # fmt: skip

CASE = Case(
    name="stiff spring",
    hard="a bob on a spring of 1e10 N/m: a mode at 16 kHz that is present but not excited",
    oracle="closed form of a rigid rod, within 1e-8; largest error of the angle over 10 s [rad]",
    advice="use `Rosenbrock`, which `auto` finds, or replace the spring by a rigid joint",
    build=build,
    t=TIMES,
    start={"q": {"swing": START, "stretch": G * np.cos(START) / STIFFNESS}},
    error=error,
    expected=EXPECTED,
    fine={"rtol": 1e-7, "atol": 1e-9},
    step=1e-5,
)
