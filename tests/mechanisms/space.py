"""Bodies in fields of gravity."""

from __future__ import annotations

from dataclasses import replace

import cardan as cd

from .mechanism import Mechanism, State


def orbiter() -> cd.Scene:
    """A hub with a panel on a spring about a flattened planet, which sees their extent."""
    scene = cd.Scene("orbiter", gravity=(0, 0, 0))
    hub = scene.body("hub", mass=2.0, com=(0.01, 0, 0.02), inertia=(0.05, 0.07, 0.04))
    flat = {"xx": 0.003, "yy": 0.02, "zz": 0.02, "xy": 1e-3}
    panel = scene.body("panel", mass=0.4, com=(0.2, 0, 0), inertia=flat)
    scene.joint("orbit", cd.Free(), scene.ground, hub)
    scene.joint("hinge", cd.Revolute("y"), hub.at(0.1, 0, 0.05), panel)
    scene.force("spring", cd.JointSpring("hinge", stiffness=0.5))
    planet = scene.ground.at(0.1, -0.05, 0.1, rotation=("XYZ", 0.2, 0.1, 0.0))
    mu = scene.parameter("mu", 1.1, unit="m^3/s^2")
    scene.force("field", cd.CentralGravity(planet, mu))
    scene.force("extent", cd.GravityGradient(planet, mu, bodies=(hub, panel)))
    scene.force("bulge", cd.J2(planet, mu, 0.05, 0.6, pole=(0.1, 0, 1), gradient=True))
    return scene


def binary() -> cd.Scene:
    """Two bodies that attract each other, the heavier of which is flattened, and a pendulum."""
    scene = cd.Scene("binary", gravity=(0, 0, 0))
    star = scene.body("star", mass=3.0, com=(0.02, 0, 0), inertia=(0.4, 0.4, 0.5))
    moon = scene.body("moon", mass=0.5, com=(0, 0.03, 0), inertia=(0.02, 0.03, 0.025))
    bob = scene.body("bob", mass=0.1, com=(0, 0, -0.2), inertia=(1e-3, 1e-3, 5e-4))
    scene.joint("star", cd.Free(), scene.ground, star)
    scene.joint("moon", cd.Free(), scene.ground.at(1.5, 0, 0), moon)
    scene.joint("bob", cd.Universal("x", "y"), moon, bob)
    strength = scene.parameter("G", 0.4)
    center = star.at(0.02, 0, 0)
    scene.force("pull", cd.CentralGravity(center, strength * 3.0))
    scene.force("tide", cd.GravityGradient(center, strength * 3.0, moon))
    scene.force("bulge", cd.J2(center, strength * 3.0, 0.04, 0.4))
    return scene


def librating() -> cd.Scene:
    """A satellite whose attitude in a circular orbit is what moves: roll x, pitch y, yaw z."""
    scene = cd.Scene("librating", gravity=(0, 0, 0))
    rate = scene.parameter("n", 1.0, unit="rad/s")
    place = cd.orbit.circular(scene, "orbit", rate**2 * 7.0**3, 7.0, inclination=0.5)
    sat = scene.body("sat", mass=3.0, inertia=(10, 12, 5))
    scene.joint("attitude", cd.Spherical("ZYX"), place, sat)
    scene.force("gradient", cd.GravityGradient(scene.ground, rate**2 * 7.0**3))
    return scene


def gyrostat() -> cd.Scene:
    """A free body with wheels of every kind: of constant momentum and speed, free, and driven."""
    scene = cd.Scene("gyrostat", gravity=(0, 0, 0))
    bus = scene.body("bus", mass=5.0, com=(0.1, 0, 0.05), inertia=(2.0, 2.5, 3.0))
    scene.joint("free", cd.Free(), scene.ground, bus)
    scene.force("kept", cd.Rotor(bus, axis=(1, 2, -2), momentum=1.5))
    scene.force("steady", cd.Rotor(bus.at(0.2, 0, 0), axis="x", inertia=0.1, speed=12.0))
    scene.force("idle", cd.Rotor(bus.at(rotation=("XYZ", 0.3, 0, 0)), inertia=0.2))
    scene.force("slanted", cd.Rotor(bus, axis=(0, 3, 4), inertia=0.1, torque=0.3, friction=0.05))
    return scene


def dual_spin() -> cd.Scene:
    """A satellite on a frame that spins at nu, with a wheel of momentum hs and a nutation damper.

    Its coordinates are the small turns against the frame. The damper is a mass that slides along
    the axis, and is part of the inertia about the mass centre: I1 = 4, I2 = 4.2, I3 = 3.6.
    """
    scene = cd.Scene("dual_spin", gravity=(0, 0, 0))
    nu = scene.parameter("nu", 1.2, unit="rad/s")
    hs = scene.parameter("hs", 3.0, unit="N*m*s")
    frame = scene.body("frame")
    scene.joint("spin", cd.Revolute("z"), scene.ground, frame, prescribed=nu * cd.t)
    bus = scene.body("bus", mass=20.0, com=(-0.5 * 0.1 / 20.0, 0, 0))
    rest = 0.1 * 0.5**2 + 20.0 * (0.5 * 0.1 / 20.0) ** 2
    bus = scene.bodies["bus"] = replace(bus, inertia=(4.0, 0, 0, 4.2 - rest, 0, 3.6 - rest))
    scene.joint("attitude", cd.Spherical("XYZ"), frame, bus)
    scene.force("wheel", cd.Rotor(bus, momentum=hs))
    ball = scene.body("ball", mass=0.1)
    scene.joint("tube", cd.Prismatic("z"), bus.at(0.5, 0, 0), ball)
    scene.force("damper", cd.JointSpring("tube", stiffness=0.5, damping=0.05))
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
    Mechanism(
        "librating",
        librating,
        (
            State({"attitude": (0.1, 0.2, -0.3)}),
            State({"attitude": (-0.4, 0.5, 0.3)}, {"attitude": (0.2, -0.4, 0.3)}),
        ),
        conservative=False,
    ),
    Mechanism(
        "gyrostat",
        gyrostat,
        (
            State({}, {"free": (0.3, -0.2, 0.8, 0.1, 0, 0), "idle.rotor": 5.0}),
            State({"free": (0.5, 0.5, -0.5, 0.5, 1, 2, 3)}, {"slanted.rotor": -4.0}),
        ),
        conservative=False,
    ),
    Mechanism(
        "dual_spin",
        dual_spin,
        (
            State({"attitude": (0.1, -0.05, 0.0)}),
            State({"attitude": (-0.2, 0.3, 0.4), "tube": 0.1}, {"tube": -0.5}),
        ),
        conservative=False,
    ),
)
