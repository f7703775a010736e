"""Scenes that the tests of files write to disk."""

from __future__ import annotations

import cardan as cd


def arm() -> cd.Scene:
    """A free base with two joints, a coupled, a prescribed and a fixed one, a spring, an output."""
    scene = cd.Scene("arm */ of §9", gravity=(0, 0, -9.81))
    m = scene.parameter("m", 2.0, unit="kg")
    base = scene.body("base", mass=5.0, com=(0.1, 0, 0), inertia=(0.3, 0.4, 0.5))
    upper = scene.body("upper", mass=m, com=(0, 0, -0.25), inertia=(0.1, 0.1, 0.02))
    lower = scene.body("lower", mass=1.0, com=(0, 0, -0.2), inertia=(0.05, 0.06, 0.01))
    tool = scene.body("tool", mass=0.3, com=(0, 0.02, 0.1), inertia=(0.01, 0.01, 0.01))
    wheel = scene.body("wheel", mass=0.2, com=(0, 0, 0), inertia=(0.001, 0.001, 0.002))
    scene.joint("float", cd.Free(), scene.ground, base)
    scene.joint("shoulder", cd.Revolute("y"), base.at(0.2, 0, 0), upper, limits=(-2, 2), q0=0.3)
    scene.joint("elbow", cd.Revolute((0, 0.6, 0.8)), upper.at(0, 0, -0.5), lower)
    scene.joint("flange", cd.Fixed(), lower.at(0, 0, -0.4), tool)
    scene.joint("spin", cd.Revolute("x"), base.at(0, 0.1, 0), wheel, prescribed=3 * cd.t)
    scene.force("spring", cd.JointSpring("elbow", stiffness=3.0))
    scene.output("reach", scene.q("elbow") + 1)
    return scene
