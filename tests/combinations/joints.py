"""Features that are joints; without the feature they are fixed."""

from __future__ import annotations

from typing import Any

import sympy as sp

import cardan as cd

from .mechanism import Mechanism


def _fixed(joint: Any, present: bool, **start: Any) -> tuple[Any, dict[str, Any]]:
    return (joint, start) if present else (cd.Fixed(), {})


def revolute(made: Mechanism, present: bool) -> None:
    """A hinge out of the plane of the bars."""
    joint, start = _fixed(cd.Revolute("z"), present, q0=0.2, u0=-1.0)
    made.link("swivel", joint, **start)


def prismatic(made: Mechanism, present: bool) -> None:
    """A slide with a spring."""
    joint, start = _fixed(cd.Prismatic("x"), present, u0=0.5)
    made.link("slide", joint, **start)
    if present:
        made.scene.force("slide_spring", cd.JointSpring("slide_joint", 60.0, 1.0))


def spherical(made: Mechanism, present: bool) -> None:
    """A ball joint."""
    joint, start = _fixed(cd.Spherical(), present, u0=(0.5, -0.4, 0.8))
    made.link("ball", joint, **start)


def universal(made: Mechanism, present: bool) -> None:
    """Two crossed hinges."""
    joint, start = _fixed(cd.Universal("y", "z"), present, q0=(0.2, -0.3))
    made.link("cross", joint, **start)


def custom(made: Mechanism, present: bool) -> None:
    """A slide along a curve that turns on its way, with a spring."""
    s = sp.Symbol("s")
    c, n = sp.cos(2 * s), sp.sin(2 * s)
    joint, start = _fixed(
        cd.Custom((s,), (s, s**2, 0), ((c, -n, 0), (n, c, 0), (0, 0, 1))), present, u0=0.6
    )
    made.link("cam", joint, **start)
    if present:
        made.scene.force("cam_spring", cd.JointSpring("cam_joint", 50.0, 0.5))


def free(made: Mechanism, present: bool) -> None:
    """A body without a joint on a spring."""
    satellite = made.scene.body("satellite", mass=0.4, inertia=(0.003, 0.004, 0.005))
    at = (0.3, -0.5, -0.2)
    if present:
        u0 = (0.5, -1.0, 0.7, 0.0, 0.3, 0.0)
        made.scene.joint("float", cd.Free(), made.root, satellite, q0=(1, 0, 0, 0, *at), u0=u0)
    else:
        made.scene.joint("float", cd.Fixed(), made.root.at(*at), satellite)
    spring = cd.SpringDamper(
        satellite.at(0.05, 0.02, 0.06), made.forearm.at(0.3, 0, 0), 60.0, 1.0, 0.5
    )
    made.scene.force("tether", spring)


def wheel(made: Mechanism, present: bool) -> None:
    """A wheel that rolls on a plane of the base, on a spring."""
    disk = made.scene.body("disk", mass=0.5, inertia=(0.001, 0.002, 0.001))
    plane = made.root.at(0.5, 0.5, -0.5)
    if present:
        joint = cd.Wheel(radius=0.1, crown=0.02)
        made.scene.joint("rolls", joint, plane, disk, q0=(0, 0, 0.1, 0.05, 0))
    else:
        made.scene.joint("rolls", cd.Fixed(), plane.at(0, 0, 0.1), disk)
    rod = cd.SpringDamper(disk, made.forearm.at(0.2, 0, 0), 50.0, 1.0, 0.3)
    made.scene.force("wheel_spring", rod)


def gear(made: Mechanism, present: bool) -> None:
    """A pinion that the elbow turns."""
    inertia = (0.001, 0.004, 0.004)
    pinion = made.scene.body("pinion", mass=0.3, com=(0.02, 0, 0), inertia=inertia)
    joint = cd.Gear("elbow", ratio=-3.0, axis="y") if present else cd.Fixed()
    made.scene.joint("mesh", joint, made.arm.at(0.25, 0, 0.1), pinion)
