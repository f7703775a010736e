"""A pendulum whose rod is a very stiff spring, started where the spring does not vibrate."""

from __future__ import annotations

from typing import Any

import numpy as np

import cardan as cd
from benchmarks.motion.problem import Array, Loads, Problem

STIFFNESS, ANGLE, GRAVITY = 1e9, 1.0, 9.81


def spring_pendulum() -> cd.Scene:
    """A bob of 1 kg on a spring of 1 m and 1e9 N/m, hinged at the ground."""
    scene = cd.Scene("spring_pendulum", gravity=(0, 0, -GRAVITY))
    k = scene.parameter("k", STIFFNESS, unit="N/m")
    hub = scene.body("hub", mass=1e-3, inertia=(1e-3, 1e-3, 1e-3))
    bob = scene.body("bob", mass=1.0)
    scene.joint("swing", cd.Revolute("y"), scene.ground, hub)
    scene.joint("stretch", cd.Prismatic("z"), hub.at(0, 0, -1), bob)
    scene.force("spring", cd.JointForce("stretch", -k * scene.q("stretch")))
    return scene


def bob(model: Any, q: Array) -> Array:
    """Place (x, z) of the bob."""
    return (q[1] - 1) * np.array([np.sin(q[0]), np.cos(q[0])])


PROBLEM = Problem(
    name="spring_pendulum",
    title="stiff spring pendulum",
    text="a bob of 1 kg on a spring of 1 m and 1e9 N/m, from rest at 1 rad where the spring carries"
    " the weight along it; 10 s",
    build=spring_pendulum,
    start={"swing": ANGLE, "stretch": -GRAVITY * float(np.cos(ANGLE)) / STIFFNESS},
    end=10.0,
    places=bob,
    unit="m",
    methods={
        "Radau": (1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10),
        "Rosenbrock": (1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9),
        "GeneralizedAlpha": (1e-4, 1e-5, 1e-6),
        "DOP853": (1e-5,),
    },
    tolerances=(1e-4, 1e-6, 1e-8, 1e-10),
    steps=(1_000, 10_000, 200_000),
    loads=Loads(stiffness={"stretch": STIFFNESS}),
    stiff=True,
)
