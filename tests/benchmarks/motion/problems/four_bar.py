"""A crank-rocker that falls from rest."""

from __future__ import annotations

from benchmarks.motion.problem import Problem
from mechanisms.closed_planar import four_bar, four_bar_angles

ANGLE = 1.0
JOINTS = ("A", "B", "D")

PROBLEM = Problem(
    name="four_bar",
    title="four-bar",
    text="a crank-rocker of 0.1, 0.25 and 0.2 m on 0.3 m of ground, 1 kg per meter, from rest with"
    " the crank at 1 rad under gravity; 2 s",
    build=four_bar,
    start={name: angle for name, angle in four_bar_angles(ANGLE).items() if name in JOINTS},
    end=2.0,
    places=lambda model, q: q[:3],
    unit="rad",
    methods={
        "DOP853": (1e-4, 1e-6, 1e-8, 1e-9, 1e-10, 1e-11),
        "RK45": (1e-4, 1e-6, 1e-8, 1e-10),
        "Rosenbrock": (1e-4, 1e-6, 1e-8),
        "Radau": (1e-4, 1e-6, 1e-8),
        "GeneralizedAlpha": (1e-4, 1e-6, 1e-8),
    },
    tolerances=(1e-4, 1e-6, 1e-8, 1e-10),
    steps=(1_000, 3_000, 10_000, 30_000),
)
