"""Two point masses in a plane, let go with both rods level."""

from __future__ import annotations

import math

from benchmarks.motion.problem import Problem, points, tip

PROBLEM = Problem(
    name="double_pendulum",
    title="double pendulum",
    text="point masses of 1 kg on rods of 1 m in a plane, both at 90 degrees from hanging, at rest;"
    " 10 s",
    build=lambda: points("double_pendulum", 2, 2.0),
    start={"hinge0": math.pi / 2},
    end=10.0,
    places=tip(2, 2.0),
    unit="m",
    methods={
        "DOP853": (1e-4, 1e-6, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13),
        "RK45": (1e-4, 1e-6, 1e-8, 1e-10, 1e-12),
        "Rosenbrock": (1e-4, 1e-6, 1e-8, 1e-10),
        "Radau": (1e-4, 1e-6, 1e-8, 1e-10),
        "GeneralizedAlpha": (1e-4, 1e-6),
    },
    tolerances=(1e-4, 1e-6, 1e-8, 1e-10, 1e-11, 1e-12, 1e-13),
    steps=(1_000, 3_000, 10_000, 30_000),
)
