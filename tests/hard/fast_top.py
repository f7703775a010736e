"""A heavy top that spins at 150 rad/s."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np

import cardan as cd

from .case import Case, alike

FILE = Path(__file__).parents[1] / "references" / "heavy_top_bca.json"
KNOWN = json.loads(FILE.read_text("utf-8"))
ROWS = KNOWN["reference"]["own"]["rows"]
TURNS = np.array([row["quat"] for row in ROWS], dtype=float)


def build() -> cd.Scene:
    """The top of Géradin and Cardona on a ball joint."""
    given = KNOWN["parameters"]
    scene = cd.Scene("fast_top", gravity=tuple(given["g"]))
    body = scene.body("top", mass=given["m"], com=(0, 0, 0), inertia=tuple(given["J_cog"]))
    scene.joint("pivot", cd.Spherical(), scene.ground, body.at(*(-x for x in given["X"])))
    return scene


def error(model: cd.CompiledModel, motion: cd.Trajectory) -> float:
    """Largest error of the quaternion, of either sign."""
    found = motion.q[1:]
    found = found * np.sign((found * TURNS).sum(axis=1))[:, None]
    return float(np.abs(found - TURNS).max())


EXPECTED = alike(
    explicit=1e-6, lower=1e-6, implicit=1e-6, damped=1e-1, fixed=1e-3, energy=1e-2
)  # fmt: skip

CASE = Case(
    name="fast top",
    hard="a heavy top spins at 150 rad/s and precesses at 5 rad/s, for 2 s",
    oracle="30 digits by extrapolation; largest error of the quaternion",
    advice="use `DOP853`; methods of order 2 need a tighter rtol than here",
    build=build,
    t=np.array([0.0, *(row["t"] for row in ROWS)]),
    start={"u": {"pivot": KNOWN["initial_state"]["Omega0_body"]}},
    error=error,
    expected=EXPECTED,
    step=1e-4,
)
