"""A block on a belt that sticks and slips."""

from __future__ import annotations

import numpy as np
import sympy as sp

import cardan as cd

from .case import UNDAMPED, Case, alike

BELT, STATIC, FALL = 0.2, 1.0, 3.0
SLIP, PERIOD, END_OF_SLIP = 4.295999526464542, 12.00103129578276, -0.5410063538636437


def build() -> cd.Scene:
    """Friction that falls with speed, true sticking."""
    scene = cd.Scene("stick_slip", gravity=(0, 0, 0))
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("block", mass=1.0))
    scene.force("spring", cd.JointSpring("x", stiffness=1.0))
    law = STATIC / (1 + FALL * sp.Abs(scene.u("x") - BELT))
    scene.force("belt", cd.Friction("x", coulomb=law, static=STATIC, against=BELT))
    return scene


def error(model: cd.CompiledModel, motion: cd.Trajectory) -> float:
    """Largest error of the times of slipping and of the period [s], and of the place [m]."""
    slips = np.array([event.t for event in motion.events if event.name == "belt.slip"])
    stops = np.array([event.t for event in motion.events if event.name == "belt.stop"])
    if len(slips) != 3 or len(stops) != 3:
        return np.inf
    place = motion.at(stops[0])[0] - END_OF_SLIP
    found = (np.diff(slips) - PERIOD, stops - slips - SLIP, place)
    return float(max(np.abs(values).max() for values in found))


CASE = Case(
    name="stick-slip",
    hard="dry friction on a belt: the block sticks, breaks loose, slides and sticks again",
    oracle="limit cycle with located events, 30 digits; error of times [s] and position [m]",
    advice="use `cd.Friction` with true sticking and an adaptive method of order 4 or higher",
    build=build,
    t=34.0,
    start={"q": {"x": 0.0}, "u": {"x": BELT}},
    error=error,
    step=1e-3,
    expected=alike(
        explicit=1e-8,
        lower=5e-8,
        implicit=1e-8,
        damped=1e-2,
        fixed=1e-8,
        energy=1e-5,
        Newmark=UNDAMPED,
    ),
)
