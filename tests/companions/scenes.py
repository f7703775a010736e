"""Scenes on which the calls of the companions run."""

from __future__ import annotations

import sympy as sp

import cardan as cd

ROD = {"mass": 1.0, "com": (0, 0, -0.25), "inertia": cd.inertia.rod(1.0, 0.5, axis="z")}
STEEL = cd.material(E=210e9, nu=0.3, rho=7850)
RUBBER = cd.material(E=5e6, nu=0.5, rho=1100)


def double_pendulum() -> cd.Scene:
    scene = cd.Scene("double_pendulum", gravity=(0, 0, -9.81))
    m, l = scene.parameter("m", 1.0, unit="kg"), scene.parameter("l", 0.5, unit="m")
    rod = {"mass": m, "com": (0, 0, -l / 2), "inertia": cd.inertia.rod(m, l, axis="z")}
    upper, lower = scene.body("upper", **rod), scene.body("lower", **rod)
    scene.joint("theta1", cd.Revolute("y"), scene.ground, upper)
    scene.joint("theta2", cd.Revolute("y"), upper.at(0, 0, -l), lower)
    lower.at(0, 0, -l, name="tip")
    return scene


def branched() -> cd.Scene:
    """A trunk with two arms, one on a ball."""
    scene = cd.Scene("branched", gravity=(0, 0, -9.81))
    rod = ROD | {"inertia": cd.inertia.cylinder(1.0, 0.03, 0.5, axis="z")}
    trunk, left, right = (scene.body(name, **rod) for name in ("trunk", "left", "right"))
    scene.joint("hip", cd.Universal("x", "y"), scene.ground, trunk)
    scene.joint("shoulder", cd.Spherical(), trunk.at(0.1, 0, -0.5), left)
    scene.joint("slide", cd.Prismatic("x"), trunk.at(-0.1, 0, -0.5), right)
    return scene


def top() -> cd.Scene:
    """A heavy top on a ball joint, in quaternions."""
    scene = cd.Scene("top", gravity=(0, 0, -9.81))
    body = scene.body("top", mass=1.0, com=(0, 0, 0.3), inertia=(0.02, 0.02, 0.03))
    scene.joint("pivot", cd.Spherical(), scene.ground, body)
    return scene


def gimbals() -> cd.Scene:
    """The same top in three angles."""
    scene = cd.Scene("gimbals", gravity=(0, 0, -9.81))
    body = scene.body("top", mass=1.0, com=(0, 0, 0.3), inertia=(0.02, 0.02, 0.03))
    scene.joint("pivot", cd.Spherical(rotation="ZXZ"), scene.ground, body)
    return scene


def free_body() -> cd.Scene:
    scene = cd.Scene("free_body", gravity=(0, 0, 0))
    body = scene.body("body", mass=2.0, com=(0.1, 0, 0), inertia=(1.0, 2.0, 2.5))
    scene.joint("free", cd.Free(), scene.ground, body)
    return scene


def screw() -> cd.Scene:
    scene = cd.Scene("screw", gravity=(0, 0, 0))
    nut = scene.body("nut", mass=1.0, inertia=(0.1, 0.1, 0.1))
    scene.joint("thread", cd.Screw("z", pitch=0.02), scene.ground, nut)
    return scene


def coin() -> cd.Scene:
    """A coin that rolls without sliding."""
    scene = cd.Scene("coin", gravity=(0, 0, -9.81))
    disk = scene.body("disk", mass=1.0, inertia=(0.0025, 0.005, 0.0025))
    scene.joint("rolling", cd.RollingDisk(0.1), scene.ground, disk)
    return scene


def four_bar() -> cd.Scene:
    scene = cd.Scene("four_bar", gravity=(0, -9.81, 0))
    links = {}
    for name, length in (("crank", 0.1), ("coupler", 0.25), ("rocker", 0.2)):
        rod = cd.inertia.rod(length, length, axis="x")
        links[name] = scene.body(name, mass=length, com=(length / 2, 0, 0), inertia=rod)
    crank, coupler, rocker = links.values()
    scene.joint("A", cd.Revolute("z"), scene.ground, crank)
    scene.joint("B", cd.Revolute("z"), crank.at(0.1, 0, 0), coupler)
    scene.joint("D", cd.Revolute("z"), scene.ground.at(0.3, 0, 0), rocker)
    scene.joint("C", cd.Revolute("z"), coupler.at(0.25, 0, 0), rocker.at(0.2, 0, 0), cut=True)
    return scene


def two_links_free() -> cd.Scene:
    """The double pendulum with a free joint for every body, and its pins as constraints."""
    scene = cd.Scene("two_links_free", gravity=(0, 0, -9.81))
    upper, lower = scene.body("upper", **ROD), scene.body("lower", **ROD)
    for body in (upper, lower):
        scene.joint(f"free_{body.name}", cd.Free(), scene.ground, body)
    scene.joint("pin1", cd.Revolute("y"), scene.ground, upper, cut=True)
    scene.joint("pin2", cd.Revolute("y"), upper.at(0, 0, -0.5), lower, cut=True)
    return scene


def arm() -> cd.Scene:
    """A robot of three links, with springs in its drives."""
    scene = cd.Scene("arm", gravity=(0, 0, -9.81))
    link, place = scene.ground, (0, 0, 0)
    for n, axis in enumerate("zyy", 1):
        base, link = link.at(*place), scene.body(f"link{n}", **ROD)
        scene.joint(f"q{n}", cd.Revolute(axis), base, link)
        place = (0, 0, -0.5)
    link.at(0, 0, -0.5, name="hand")
    return scene


def block() -> cd.Scene:
    """A block on a rail: dry friction, a stop, a spring."""
    scene = cd.Scene("block", gravity=(0, 0, 0))
    body = scene.body("block", mass=1.0)
    scene.joint("x", cd.Prismatic("x"), scene.ground, body)
    scene.force("friction", cd.Friction("x", coulomb=1.0))
    scene.force("stop", cd.Stop("x", lower=-1.0, upper=1.0, restitution=0.5))
    scene.force("spring", cd.JointSpring("x", stiffness=10.0))
    return scene


def servo() -> cd.Scene:
    """A pendulum that a controller with an integral part holds."""
    scene = cd.Scene("servo", gravity=(0, 0, -9.81))
    scene.joint("pivot", cd.Revolute("y"), scene.ground, scene.body("rod", **ROD))
    error = scene.input("target", default=0.5) - scene.q("pivot")
    i = sp.Symbol("i")
    law = 40 * error + 10 * i - 8 * scene.u("pivot")
    scene.force("motor", cd.Controller("pivot", (i,), (error,), law))
    return scene


def satellite() -> cd.Scene:
    """Attitude on a circular orbit under the gradient of gravity."""
    scene = cd.Scene("satellite", gravity=(0, 0, 0))
    mu = 3.986e14
    body = scene.body("body", mass=100.0, inertia=(30.0, 40.0, 20.0))
    scene.joint("free", cd.Free(), scene.ground, body)
    scene.force("earth", cd.CentralGravity(scene.ground, mu=mu))
    scene.force("gradient", cd.GravityGradient(scene.ground, mu=mu))
    return scene


def cantilever() -> cd.Scene:
    """A beam of steel, clamped, with a force at its tip."""
    scene = cd.Scene("cantilever", gravity=(0, 0, 0))
    section = cd.section.rectangle(0.02, 0.01)
    beam = scene.beam("beam", scene.ground, (1.0, 0, 0), section, STEEL, elements=4)
    force = scene.parameter("P", 0.0, unit="N")
    scene.force("tip", cd.Force(beam.at(1.0), (0, 0, force)))
    return scene


def flexible_pendulum() -> cd.Scene:
    scene = cd.Scene("flexible_pendulum", gravity=(0, 0, -9.81))
    hub = scene.body("hub", mass=0.1, inertia=(1e-4, 1e-4, 1e-4))
    scene.joint("pin", cd.Revolute("y"), scene.ground, hub)
    round_bar = cd.section.circle(0.01)
    scene.beam("rod", hub, (0.5, 0, 0), round_bar, RUBBER, elements=4, inertia="lumped")
    return scene


def truss(rise: float = 3.0) -> cd.Scene:
    """Bars of axial stiffness 1 between supports at -1 and 1 and an apex under the load P."""
    scene = cd.Scene("truss", gravity=(0, 0, 0))
    P = scene.parameter("P", 0.0)
    slide, apex = scene.body("slide"), scene.body("apex", mass=1.0)
    scene.joint("u", cd.Prismatic("x"), scene.ground.at(0, 0, rise), slide)
    scene.joint("w", cd.Prismatic("-z"), slide, apex)
    length = (1 + rise**2) ** 0.5
    for name, x in (("left", -1.0), ("right", 1.0)):
        bar = cd.SpringDamper(
            scene.ground.at(x, 0, 0), apex, stiffness=1 / length, rest_length=length
        )
        scene.force(name, bar)
    scene.force("load", cd.Force(apex, (0, 0, -P)))
    return scene


def shallow() -> cd.Scene:
    """The truss with a small rise: it snaps through."""
    return truss(0.3)


def lee() -> cd.Scene:
    """Lee's frame [cm, N]."""
    side, stiffness = 120.0, 7.2e6
    scene = cd.Scene("lee", gravity=(0, 0, 0))
    shear = 5 / 6 * stiffness * 6.0 / 2.6
    section = cd.section.general(
        EA=stiffness * 6.0, GA=shear, GJ=stiffness * 2.0, EI=stiffness * 2.0
    )
    column = scene.beam("column", (0, 0, 0), (0, 0, side), section, elements=4, up="y")
    short = scene.beam("short", column.end, (side / 5, 0, side), section, elements=1, up="y")
    long = scene.beam("long", short.end, (side, 0, side), section, elements=4, up="y")
    scene.joint("foot", cd.Revolute("y"), scene.ground, column.start)
    scene.joint("hinge", cd.Revolute("y"), scene.ground.at(side, 0, side), long.end)
    scene.force("load", cd.Force(short.end, (0, 0, -scene.parameter("P", 0.0))))
    scene.output("down", side - short.end.position()[2])
    return scene


def boom() -> cd.Scene:
    """A beam of sixteen elements, of which superelements are made."""
    scene = cd.Scene("boom", gravity=(0, 0, 0))
    scene.joint("free", cd.Free(), scene.ground, scene.body("hub", mass=10.0, inertia=(1, 1, 1)))
    carbon = cd.material(E=90e9, nu=0.3, rho=1600)
    tube = cd.section.tube(0.03, 0.028)
    scene.beam("boom", "hub", (8.0, 0, 0), tube, carbon, elements=16, base="hub")
    return scene


def hinged_boom() -> cd.Scene:
    """The beam as a superelement on a hinge."""
    record = cd.superelement.from_beams(boom(), "boom", modes=4)
    scene = cd.Scene("hinged_boom", gravity=(0, 0, 0))
    hub = scene.body("hub", mass=10.0, inertia=(1, 1, 1))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, hub)
    scene.superelement("boom", record, {"start": hub})
    return scene


def rotor() -> cd.Scene:
    """A disk on springs across its axis, damped inside."""
    scene = cd.Scene("rotor", gravity=(0, 0, 0))
    spin = scene.parameter("k", 100.0, unit="N/m")
    disk = scene.body("disk", mass=1.0, inertia=(0.01, 0.01, 0.02))
    carrier = scene.body("carrier")
    scene.joint("x", cd.Prismatic("x"), scene.ground, carrier)
    other = scene.body("other")
    scene.joint("y", cd.Prismatic("y"), carrier, other)
    scene.joint("spin", cd.Revolute("z"), other, disk)
    for name in ("x", "y"):
        scene.force(f"spring_{name}", cd.JointSpring(name, stiffness=spin, damping=0.1))
    return scene


def oscillator() -> cd.Scene:
    scene = cd.Scene("oscillator", gravity=(0, 0, 0))
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("mass", mass=1.0))
    scene.force("spring", cd.JointSpring("x", stiffness=4.0 * 9.8696044010893586))
    return scene
