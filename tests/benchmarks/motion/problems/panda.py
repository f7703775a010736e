"""The Panda arm falls from a bent posture; its joints are damped."""

from __future__ import annotations

from benchmarks.motion.digits import final
from benchmarks.motion.problem import Loads, Problem
from mechanisms.robots import panda

JOINTS = tuple(f"panda_joint{k}" for k in range(1, 8))
POSTURE = (0.0, 0.3, 0.0, -1.5, 0.0, 1.8, 0.5)
# N m s, that of its URDF
DAMPING = 0.003

PROBLEM = Problem(
    name="panda",
    title="Panda, damped joints",
    text="the arm of seven joints, fingers fixed, 0.003 N m s in every joint, from rest at"
    f" {list(POSTURE)}; 1 s",
    build=panda,
    start=dict(zip(JOINTS, POSTURE, strict=True)),
    end=1.0,
    places=lambda model, q: q[:7],
    unit="rad",
    methods={
        "DOP853": (1e-4, 1e-6, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12),
        "RK45": (1e-4, 1e-6, 1e-8, 1e-10),
        "Rosenbrock": (1e-4, 1e-6, 1e-8),
        "Radau": (1e-4, 1e-6, 1e-8),
        "GeneralizedAlpha": (1e-4, 1e-6),
    },
    tolerances=(1e-4, 1e-6, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12),
    steps=(100, 300, 1_000, 3_000, 10_000),
    loads=Loads(damping=dict.fromkeys(JOINTS, DAMPING)),
    exact=lambda model, x0: final(model, x0, 1.0)[:7],
    source="extrapolation in 40 digits",
)
