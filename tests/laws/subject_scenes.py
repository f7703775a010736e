"""Scenes of everything that users hold and call."""

from __future__ import annotations

import cardan as cd


def arm_scene() -> cd.Scene:
    """An open chain with an input, a parameter, an output, a spring and a fixed hand."""
    s = cd.Scene("arm")
    m = s.parameter("m", 1.0)
    torque = s.input("motor", 0.0)
    upper = s.body("upper", mass=m, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.01))
    lower = s.body("lower", mass=1, com=(0, 0, -0.4), inertia=(0.1, 0.1, 0.01))
    s.joint("shoulder", cd.Revolute("y"), s.ground, upper, limits=(-3, 3))
    s.joint("elbow", cd.Revolute("y"), upper.at(0, 0, -1), lower)
    s.force("drive", cd.JointForce("shoulder", torque))
    s.force("loss", cd.JointDamper("elbow", 0.2))
    s.force("spring", cd.JointSpring("elbow", stiffness=1.0))
    s.output("angle", s.q("shoulder") + s.q("elbow"))
    return s


def four_bar_scene() -> cd.Scene:
    s = cd.Scene("four_bar", gravity=(0, -9.81, 0))
    sizes = {"crank": 0.1, "coupler": 0.25, "rocker": 0.2}
    a, b, c = (
        s.body(n, mass=x, com=(x / 2, 0, 0), inertia=cd.inertia.box(x, x, 0.02, 0.01))
        for n, x in sizes.items()
    )
    s.joint("A", cd.Revolute("z"), s.ground, a)
    s.joint("B", cd.Revolute("z"), a.at(0.1, 0, 0), b)
    s.joint("D", cd.Revolute("z"), s.ground.at(0.3, 0, 0), c)
    s.joint("C", cd.Revolute("z"), b.at(0.25, 0, 0), c.at(0.2, 0, 0))
    return s


def cantilever_scene() -> cd.Scene:
    s = cd.Scene("cantilever", gravity=(0, 0, 0))
    load = s.parameter("P", 1.0, unit="N")
    section = cd.section.rectangle(0.1, 0.01)
    beam = s.beam(
        "beam", s.ground, (1, 0, 0), section, cd.material(E=7e10, nu=0.3, rho=2700), elements=2
    )
    s.force("load", cd.Force(beam.end, (0, 0, load)))
    return s
