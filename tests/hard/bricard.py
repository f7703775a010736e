"""Bricard's mechanism: six hinges, one constraint too many, one freedom."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np

import cardan as cd
from mechanisms.closed_spatial import bricard

from .case import UNDAMPED, Case, alike

FILE = Path(__file__).parents[1] / "references" / "iftomm_A04_bricard.json"
KNOWN = json.loads(FILE.read_text("utf-8"))["reference"]["P3"]


def error(model: cd.CompiledModel, motion: cd.Trajectory) -> float:
    """Largest error of the corner between rods 3 and 4 [m]."""
    corner = model.pose("rod3", motion.q)[1:, :3, 3]
    return float(np.abs(corner - KNOWN["P3"]).max())


CASE = Case(
    name="redundant Bricard",
    hard="six hinges connect five rods in a loop: five closure conditions of rank four, for 10 s",
    oracle="IFToMM problem A04 in maximal coordinates, within 3e-8; error of a corner [m]",
    advice="keep the loop as it is; `model.redundancy(q)` names the reactions that are not unique",
    build=bricard,
    t=np.array([0.0, *KNOWN["t"]]),
    start={},
    error=error,
    step=1e-3,
    expected=alike(
        explicit=1e-6,
        lower=1e-6,
        implicit=1e-6,
        damped=1e-1,
        fixed=1e-6,
        energy=1e-3,
        Newmark=UNDAMPED,
    ),
    options={"constraints": "multipliers"},
)
