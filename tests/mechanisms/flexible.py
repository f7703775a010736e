"""Scenes with beams: the published problems, each with the number of elements to choose.

Loads that grow are parameters named as in their sources.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import sympy

import cardan as cd

# EA and GA where a source calls a beam inextensible and rigid in shear
STIFF = 1e6


def roll_up(elements: int = 10) -> cd.Scene:
    """A cantilever of length 1 and EI = 1, rolled to a circle by an end moment M = 2 pi.

    Source: Simo and Vu-Quoc, CMAME 58 (1986), example 7.1.
    """
    scene = cd.Scene("roll_up", gravity=(0, 0, 0))
    moment = scene.parameter("M", 2 * math.pi, unit="N*m")
    section = cd.section.general(EA=STIFF, GA=STIFF, GJ=1, EI=1, rhoA=1)
    beam = scene.beam("beam", scene.ground, (1, 0, 0), section, elements=elements)
    scene.force("load", cd.Torque(beam.end, (0, 0, moment)))
    return scene


def bend45(elements: int = 8, torsion: float = 1 / 6) -> cd.Scene:
    """An eighth of a circle of radius 100, clamped, with a force P across its plane at the tip.

    Source: Bathe and Bolourchi, IJNME 14 (1979).
    """
    scene = cd.Scene("bend45", gravity=(0, 0, 0))
    force, e, g = scene.parameter("P", 600, unit="N"), 1e7, 5e6
    section = cd.section.general(EA=e, GA=g, GJ=g * torsion, EI=e / 12, rhoA=1)
    radius = 100
    half, whole = ((radius * (1 - math.cos(a)), radius * math.sin(a), 0) for a in EIGHTHS)
    beam = scene.beam(
        "bend", scene.ground, whole, section, elements=elements, line=cd.arc(through=half)
    )
    scene.force("load", cd.Force(beam.end, (0, 0, force)))
    return scene


EIGHTHS = (math.pi / 8, math.pi / 4)


def elastica(elements: int = 10, stiff: float = STIFF) -> cd.Scene:
    """A cantilever of length 1 and EI = 1 with a dead force P across its tip.

    Source: Mattiasson, IJNME 17 (1981).
    """
    scene = cd.Scene("elastica", gravity=(0, 0, 0))
    force = scene.parameter("P", 10, unit="N")
    section = cd.section.general(EA=stiff, GA=stiff, GJ=1, EI=1, rhoA=1)
    beam = scene.beam("beam", scene.ground, (1, 0, 0), section, elements=elements)
    scene.force("load", cd.Force(beam.end, (0, force, 0)))
    return scene


def two_loads(elements: int = 16) -> cd.Scene:
    """A cantilever of length 100 with dead forces P1 at 52.03 and P2 at the tip.

    Source: Frisch-Fay, Flexible Bars (1962); EA and GA of a section of 0.2 with nu = 0.3.
    """
    scene = cd.Scene("two_loads", gravity=(0, 0, 0))
    loads = [scene.parameter(name, x, unit="N") for name, x in (("P1", 0.85), ("P2", 1.35))]
    section = cd.section.general(EA=6000, GA=6000 / 2.6, GJ=5000, EI=5000, rhoA=1)
    beam = scene.beam("beam", scene.ground, (100, 0, 0), section, elements=elements)
    for load, place in zip(loads, (beam.at(0.5203), beam.end), strict=True):
        scene.force(f"{load}", cd.Force(place, (0, load, 0)))
    return scene


def column(
    elements: int = 10, imperfection: float = 1e-4, stiff: float = STIFF, shear: float | None = None
) -> cd.Scene:
    """A pinned column of length 1 and EI = 1 under P in units of the load of Euler.

    It is bent beforehand by a part of a sine, so that it buckles to one side; or a force F in
    the middle pushes it there. EA is ``stiff``, GA is ``shear``, the same if left out: then it
    bends as if it neither stretched nor sheared, and is shorter by P / EA, exactly.

    Source: Timoshenko and Gere, Theory of Elastic Stability (elastica).
    """
    scene = cd.Scene("column", gravity=(0, 0, 0))
    load, aside = scene.parameter("P", 1.1), scene.parameter("F", 0, unit="N")
    section = cd.section.general(EA=stiff, GA=shear or stiff, GJ=1, EI=1, rhoA=1)
    xs = [k / 40 for k in range(41)]
    points = [(x, 0, imperfection * math.sin(math.pi * x)) for x in xs]
    points[-1] = (1, 0, 0)
    beam = scene.beam(
        "beam", (0, 0, 0), (1, 0, 0), section, elements=elements, line=cd.spline(points)
    )
    roller = scene.body("roller", pose=(1, 0, 0))
    scene.joint("pin", cd.Revolute("y"), scene.ground, beam.start)
    scene.joint("guide", cd.Prismatic("x"), scene.ground, roller)
    scene.joint("hinge", cd.Revolute("y"), roller, beam.end)
    scene.force("load", cd.Force(roller, (-load * math.pi**2, 0, 0)))
    scene.force("push", cd.Force(beam.at(0.5), (0, 0, aside)))
    scene.output("middle", beam.at(0.5).position()[2], unit="m")
    return scene


def right_angle(elements: int = 8) -> cd.Scene:
    """Two arms of 10 with a corner, swung out of their plane by a pulse at the elbow.

    Source: Simo and Vu-Quoc, CMAME 66 (1988).
    """
    scene = cd.Scene("right_angle", gravity=(0, 0, 0))
    section = cd.section.general(EA=1e6, GA=1e6, GJ=1e3, EI=1e3, rhoA=1, rhoI=10)
    inner = scene.beam("inner", scene.ground, (10, 0, 0), section, elements=elements)
    outer = scene.beam("outer", inner.end, (10, 10, 0), section, elements=elements)
    pulse = sympy.Piecewise((50 * cd.t, cd.t < 1), (100 - 50 * cd.t, cd.t < 2), (0, True))
    scene.force("pulse", cd.Force(inner.end, (0, 0, pulse)))
    scene.output("elbow", inner.end.position()[2], unit="m")
    scene.output("tip", outer.end.position()[2], unit="m")
    return scene


def spaghetti(elements: int = 16) -> cd.Scene:
    """A free rod of length 10, thrown by a force and a moment at one end while they are ``on``.

    Source: Simo and Vu-Quoc, J. Appl. Mech. 53 (1986).
    """
    scene = cd.Scene("spaghetti", gravity=(0, 0, 0))
    section = cd.section.general(EA=1e4, GA=1e4, GJ=100, EI=100, rhoA=1, rhoI=10)
    rod = scene.beam("rod", (6, 0, 0), (0, 8, 0), section, elements=elements)
    on = scene.input("on", default=1)
    scene.force("push", cd.Force(rod.start, (8 * on, 0, 0)))
    scene.force("turn", cd.Torque(rod.start, (0, 0, -80 * on)))
    return scene


def spin_up(elements: int = 10) -> cd.Scene:
    """A blade of length 10 on a hub that is turned up to 6 rad/s within 15 s.

    Source: Simo and Vu-Quoc, J. Sound Vib. 119 (1987).
    """
    scene = cd.Scene("spin_up", gravity=(0, 0, 0))
    t, rise = cd.t, 15
    wave = (rise / (2 * sympy.pi)) ** 2 * (sympy.cos(2 * sympy.pi * t / rise) - 1)
    angle = sympy.Piecewise((6 * (t**2 / 2 + wave) / rise, t < rise), (6 * t - 45, True))
    hub = scene.body("hub", mass=1, inertia=(1, 1, 1))
    scene.joint("drive", cd.Revolute("z"), scene.ground, hub, prescribed=angle)
    section = cd.section.general(EA=2.8e7, GA=1e7, GJ=1.4e4, EI=1.4e4, rhoA=1.2, rhoI=6e-4)
    blade = scene.beam("blade", hub, (10, 0, 0), section, elements=elements)
    for k, name in enumerate(("along", "across")):
        scene.output(name, blade.end.position(in_=hub)[k] - (10, 0)[k], unit="m")
    return scene


def rotating_blade(elements: int = 16, stiff: float = STIFF) -> cd.Scene:
    """A blade of length 1, EI = 1 and rhoA = 1 that turns with the speed Omega.

    Source: Wright, Smith, Thresher and Wang, J. Appl. Mech. 49 (1982).
    """
    scene = cd.Scene("rotating_blade", gravity=(0, 0, 0))
    speed = scene.parameter("Omega", 6, unit="rad/s")
    hub = scene.body("hub", mass=1, inertia=(1, 1, 1))
    scene.joint("drive", cd.Revolute("z"), scene.ground, hub, prescribed=speed * cd.t)
    section = cd.section.general(EA=stiff, GA=stiff, GJ=1, EI=1, rhoA=1)
    scene.beam("blade", hub, (1, 0, 0), section, elements=elements)
    return scene


def slider_crank(elements: int = 8) -> cd.Scene:
    """A crank at 150 rad/s, an elastic rod of 0.3 m on it, and a slider.

    The rod is a beam with all its inertia, damping none: the modes of the source and its mass of
    the axial ones are its own.

    Source: Simeon, Math. Modelling of Systems 2 (1996).
    """
    scene = cd.Scene("slider_crank", gravity=(0, 0, 0))
    crank = scene.body("crank", mass=0.36, com=(0.075, 0, 0), inertia=(0, 0.002727, 0.002727))
    slider = scene.body("slider", mass=0.075552, pose=(0.45, 0, 0))
    scene.joint("drive", cd.Revolute("z"), scene.ground, crank, prescribed=150 * cd.t)
    scene.joint("guide", cd.Prismatic("x"), scene.ground, slider)
    rod = scene.beam(
        "rod", crank.at(0.15, 0, 0), slider, cd.section.rectangle(0.008, 0.008),
        cd.material(E=2e11, nu=0.3, rho=7870), elements=elements,
        release_start="rz", release_end="rz",
    )  # fmt: skip
    scene.output("middle", rod.at(0.5).position()[1], unit="m")
    return scene


def pendulum(elements: int = 10) -> cd.Scene:
    """A rubber bar of 1 m that swings from a pin.

    Source: T. Maqueda, O. Bauchau, A. Shabana, Effect of the centrifugal forces on the finite
    element eigenvalue solution of a rotating blade, 2008 (kind of problem).
    """
    scene = cd.Scene("pendulum")
    rubber = cd.material(E=5e6, nu=0.3, rho=1100)
    bar = scene.beam(
        "bar", (0, 0, 0), (1, 0, 0), cd.section.rectangle(0.02, 0.02), rubber, elements=elements
    )
    scene.joint("pin", cd.Revolute("y"), scene.ground, bar.start)
    return scene


def folding_arm(elements: int = 6) -> cd.Scene:
    """Two elastic tubes with a bar between them that a spring turns at its hinge.

    Source: M. Géradin, A. Cardona, Flexible Multibody Dynamics, 2001 (kind of mechanism).
    """
    scene = cd.Scene("folding_arm", gravity=(0, 0, 0))
    carbon = cd.material(E=7e10, nu=0.3, rho=1600)
    tube = cd.section.tube(outer=0.02, inner=0.018)
    inner = scene.beam("inner", scene.ground, (1, 0, 0), tube, carbon, elements=elements)
    bar = scene.body("bar", mass=0.3, com=(0.5, 0, 0), inertia=(0, 0.025, 0.025))
    scene.joint("hinge", cd.Revolute("z"), inner.end, bar)
    scene.beam("outer", bar.at(1, 0, 0), (2.5, 0, 0), tube, carbon, elements=elements)
    scene.force("spring", cd.JointSpring("hinge", stiffness=2, damping=0.01, rest=2))
    return scene


FLEXIBLE: dict[str, Callable[[], cd.Scene]] = {
    scene.__name__: scene
    for scene in (
        *(roll_up, bend45, elastica, two_loads, column, right_angle, spaghetti),
        *(spin_up, rotating_blade, slider_crank, pendulum, folding_arm),
    )
}
