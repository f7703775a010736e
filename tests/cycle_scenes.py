"""Scenes whose motions repeat, for tests of cycles."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import sympy as sp

import cardan as cd

POINT = {"mass": 1.0, "inertia": (1.0, 1.0, 1.0)}
STATES, MULTIPLIERS = 1e-11, 1e-10
# of the table: frequency, speed of a flight, and the least amplitude
OMEGA, APEX = 2 * np.pi * 15, 9.81 / 30
NEUTRAL_A = np.pi * 9.81 / OMEGA**2 / 3  # (1 - e) / (1 + e) = 1/3


def oscillator(force: Any) -> cd.CompiledModel:
    """x'' = force(x, x'), with parameters by name."""
    scene = cd.Scene("oscillator", gravity=(0, 0, 0))
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("body", **POINT))
    scene.force("force", cd.JointForce("x", force(scene, scene.q("x"), scene.u("x"))))
    return cd.compile(scene)


def walker() -> cd.CompiledModel:
    """M. Garcia, A. Chatterjee, A. Ruina, M. Coleman (1998): the stance and the swing leg."""
    scene = cd.Scene("walker", gravity=(0, 0, 0))
    slope = scene.parameter("slope", 0.009)
    for name in ("stance", "swing"):
        body = scene.body(f"body_{name}", **POINT)
        scene.joint(name, cd.Prismatic("x"), scene.ground, body)
    stance, swing, rate = scene.q("stance"), scene.q("swing"), scene.u("stance")
    scene.force("first", cd.JointForce("stance", sp.sin(stance - slope)))
    pull = rate**2 * sp.sin(swing) - sp.cos(stance - slope) * sp.sin(swing)
    scene.force("second", cd.JointForce("swing", sp.sin(stance - slope) + pull))
    scene.force("strike", cd.Event(swing - 2 * stance, direction="both"))
    return cd.compile(scene)


def heel_strike(before: Mapping[str, float]) -> dict[str, float]:
    """Angular momentum about the new contact is kept, and the legs change their names."""
    angle, rate = before["stance"], np.cos(2 * before["stance"]) * before["stance.u"]
    swing_rate = (1 - np.cos(2 * angle)) * rate
    return {"stance": -angle, "stance.u": rate, "swing": -2 * angle, "swing.u": swing_rate}


def step(model: cd.CompiledModel, angle: float, rate: float, **options: Any) -> Any:
    """The gait next to an angle and a rate behind a heel strike."""
    start = heel_strike({"stance": -angle, "stance.u": rate / np.cos(2 * angle)})
    return model.cycle(start, section="strike.up", symmetry=heel_strike, check=True, **options)


def duffing() -> tuple[cd.CompiledModel, Any]:
    """G. Duffing (1918)."""
    scene = cd.Scene("duffing", gravity=(0, 0, 0))
    omega = scene.parameter("omega", 1.4)
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("body", **POINT))
    x, v = scene.q("x"), scene.u("x")
    scene.force("force", cd.JointForce("x", 0.5 * sp.cos(omega * cd.t) - 0.1 * v - x - x**3))
    return cd.compile(scene), omega


def table(amplitude: float) -> cd.CompiledModel:
    """A ball that bounces on a table with A sin(w t), w of 15 Hz, restitution 1/2."""
    scene = cd.Scene("ball_on_table", gravity=(0, 0, -9.81))
    A, plate, ball = (
        scene.parameter("A", amplitude),
        scene.body("plate"),
        scene.body("ball", **POINT),
    )
    motion = A * sp.sin(2 * sp.pi * 15 * cd.t)
    scene.joint("table", cd.Prismatic("z"), scene.ground, plate, prescribed=motion)
    scene.joint("gap", cd.Prismatic("z"), plate, ball)
    scene.force("bounce", cd.Stop("gap", lower=0.0, restitution=0.5))
    return cd.compile(scene)


def bounce(model: cd.CompiledModel, amplitude: float, **options: Any) -> Any:
    """The motion of one bounce per period, from the top of a flight."""
    phase = np.arccos(NEUTRAL_A / amplitude)
    start = {
        "gap": APEX**2 / 2 / 9.81 + amplitude * np.sin(phase),
        "gap.u": amplitude * OMEGA * np.cos(phase),
    }
    t = phase / OMEGA - 1 / 30
    return model.cycle(start, period=1 / 15, t=t, check=True, **options)
