"""Bodies in fields of gravity."""

from __future__ import annotations

import cardan as cd

from .mechanism import Mechanism, State


def orbiter() -> cd.Model:
    """A hub with a panel on a spring about a flattened planet, which sees their extent."""
    scene = cd.Model("orbiter", gravity=(0, 0, 0))
    hub = scene.body("hub", mass=2.0, com=(0.01, 0, 0.02), inertia=(0.05, 0.07, 0.04))
    flat = {"xx": 0.003, "yy": 0.02, "zz": 0.02, "xy": 1e-3}
    panel = scene.body("panel", mass=0.4, com=(0.2, 0, 0), inertia=flat)
    scene.joint("orbit", cd.Free(), scene.ground, hub)
    scene.joint("hinge", cd.Revolute("y"), hub.at(0.1, 0, 0.05), panel)
    scene.force("spring", cd.TorsionSpring("hinge", stiffness=0.5))
    planet = scene.ground.at(0.1, -0.05, 0.1, rotation=("XYZ", 0.2, 0.1, 0.0))
    mu = scene.parameter("mu", 1.1, unit="m^3/s^2")
    scene.force("field", cd.CentralGravity(planet, mu))
    scene.force("extent", cd.GravityGradient(planet, mu, bodies=(hub, panel)))
    scene.force("bulge", cd.J2(planet, mu, 0.05, 0.6, pole=(0.1, 0, 1), gradient=True))
    return scene


def binary() -> cd.Model:
    """Two bodies that attract each other, the heavier of which is flattened, and a pendulum."""
    scene = cd.Model("binary", gravity=(0, 0, 0))
    star = scene.body("star", mass=3.0, com=(0.02, 0, 0), inertia=(0.4, 0.4, 0.5))
    moon = scene.body("moon", mass=0.5, com=(0, 0.03, 0), inertia=(0.02, 0.03, 0.025))
    bob = scene.body("bob", mass=0.1, com=(0, 0, -0.2), inertia=(1e-3, 1e-3, 5e-4))
    scene.joint("star", cd.Free(), scene.ground, star)
    scene.joint("moon", cd.Free(), scene.ground.at(1.5, 0, 0), moon)
    scene.joint("bob", cd.Universal("x", "y"), moon, bob)
    strength = scene.parameter("G", 0.4)
    center = star.at(0.02, 0, 0)
    scene.force("pull", cd.CentralGravity(center, strength * 3.0))
    scene.force("tide", cd.GravityGradient(center, strength * 3.0, "moon"))
    scene.force("bulge", cd.J2(center, strength * 3.0, 0.04, 0.4))
    return scene


MEMBERS = (
    Mechanism(
        "orbiter",
        orbiter,
        (
            State({"orbit": (1, 0, 0, 0, 1.2, 0, 0)}, {"orbit": (0.2, 0.5, 0.8, 0, 0.9, 0.3)}),
            State({"orbit": (0.5, 0.5, -0.5, 0.5, 0, 1, -0.8), "hinge": 0.7}, {"hinge": -1.0}),
        ),
    ),
    Mechanism(
        "binary",
        binary,
        (
            State(
                {"bob": (0.3, -0.2)},
                {"star": (0, 0.1, 0.7, 0, -0.1, 0), "moon": (0, 0, 0.3, 0, 0.8, 0.1)},
            ),
            State({"moon": (1, 0, 0, 0, 0.4, 0.5, -0.3), "bob": (-0.4, 0.5)}, {"bob": (1, -2)}),
        ),
    ),
)
