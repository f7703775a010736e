"""A double pendulum that is chaotic: errors grow, and the oracle says how fast."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np

import cardan as cd

from .case import Case, alike

FILE = Path(__file__).parents[1] / "references" / "double_pendulum_A.json"
ROWS = json.loads(FILE.read_text("utf-8"))["rows"]
KNOWN = np.array([row["y"] for row in ROWS])
# what 1e-10 at the start has become, and so by what an error made there is multiplied
GROWTH = np.array([row["separation"] for row in ROWS]) / 1e-10


def build() -> cd.Scene:
    """Point masses of 1 kg on massless rods of 1 m."""
    scene = cd.Scene("chaos", gravity=(0, 0, -9.81))
    upper = scene.body("upper", mass=1.0, com=(0, 0, -1.0))
    lower = scene.body("lower", mass=1.0, com=(0, 0, -1.0))
    scene.joint("shoulder", cd.Revolute("y"), scene.ground, upper)
    scene.joint("elbow", cd.Revolute("y"), upper.at(0, 0, -1.0), lower)
    return scene


def error(model: cd.CompiledModel, motion: cd.Trajectory) -> float:
    """Largest error of angles and rates over the growth until then."""
    first, rate = motion["shoulder"], motion["shoulder.u"]
    found = np.stack([first, first + motion["elbow"], rate, rate + motion["elbow.u"]], axis=-1)
    return float((np.abs(found[1:] - KNOWN).max(axis=1) / GROWTH).max())


EXPECTED = alike(
    explicit=1e-8, lower=1e-7, implicit=1e-7, damped=1e-2, fixed=1e-6, energy=1e-3
)  # fmt: skip

CASE = Case(
    name="chaos",
    hard="a double pendulum from 90 degrees for 20 s: early errors are amplified",
    oracle="40-digit extrapolation; largest error over the growth of a disturbance [rad, rad/s]",
    advice="run at rtol=1e-9, and again at 1e-10; trust the motion for as long as both agree",
    build=build,
    t=np.array([0.0, *(row["t"] for row in ROWS)]),
    start={"q": {"shoulder": np.pi / 2}},
    error=error,
    expected=EXPECTED,
)
