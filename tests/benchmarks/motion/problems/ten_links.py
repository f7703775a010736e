"""Ten point masses in a plane, let go stretched out."""

from __future__ import annotations

import math

from benchmarks.motion.problem import Problem, points, tip

PROBLEM = Problem(
    name="ten_links",
    title="ten-link pendulum",
    text="ten point masses of 1 kg on rods of 0.2 m in a plane, stretched out at 30 degrees from"
    " hanging, at rest; 10 s",
    build=lambda: points("ten_links", 10, 2.0),
    start={"hinge0": math.pi / 6},
    end=10.0,
    places=tip(10, 2.0),
    unit="m",
    methods={
        "DOP853": (1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10),
        "RK45": (1e-4, 1e-6, 1e-8, 1e-10),
        "Rosenbrock": (1e-4, 1e-6, 1e-8),
        "Radau": (1e-4, 1e-6, 1e-8),
        "GeneralizedAlpha": (1e-4, 1e-6),
    },
    tolerances=(1e-4, 1e-6, 1e-8, 1e-10, 1e-12),
    steps=(2_000, 5_000, 10_000, 20_000),
)
