"""Andrews' squeezing mechanism, the classical problem with loops."""

from __future__ import annotations

import json
from typing import Any

import numpy as np

from benchmarks.motion.problem import Array, Loads, Problem, Spring
from mechanisms.closed_planar import ANDREWS, andrews

# order of the published problem
NAMES = ("beta", "theta", "gamma", "phi", "delta", "omega", "epsilon")
KNOWN: dict[str, Any] = json.loads(ANDREWS.read_text("utf-8"))
P = KNOWN["parameters"]


def angles(model: Any, q: Array) -> Array:
    """The seven angles in the published order."""
    return np.array([q[model.coordinates.index(name)] for name in NAMES])


def published(model: Any, x0: Array) -> Array:
    """Those at 0.03 s to 15 digits."""
    return np.array(KNOWN["reference"]["own_high_precision_q_qdot"][:7], dtype=float)


PROBLEM = Problem(
    name="andrews",
    title="Andrews' squeezer",
    text="seven bodies in a plane, three loops, one freedom, driven by 0.033 N m; 0.03 s",
    build=andrews,
    start=dict(zip(NAMES, KNOWN["initial_state"]["q"], strict=True)),
    end=0.03,
    places=angles,
    unit="rad",
    methods={
        "DOP853": (1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11),
        "RK45": (1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-10),
        "Rosenbrock": (1e-4, 1e-6, 1e-8),
        "Radau": (1e-4, 1e-6, 1e-8),
        "GeneralizedAlpha": (1e-4, 1e-6, 1e-8),
    },
    tolerances=(1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11),
    steps=(300, 1_000, 3_000, 10_000, 50_000),
    loads=Loads(
        constant={"beta": P["mom"]},
        springs=(
            Spring(
                (("ground", (P["xc"], P["yc"], 0.0)), ("K3", (P["sd"], -P["sc"], 0.0))),
                P["c0"],
                P["l0"],
            ),
        ),
    ),
    exact=published,
    source="published initial values, own values at the end from 40 digits",
)
