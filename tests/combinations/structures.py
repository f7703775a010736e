"""Features of structure: loops, flexible members, motions that are prescribed, fields."""

from __future__ import annotations

from functools import cache
from typing import Any

import sympy as sp

import cardan as cd

from .mechanism import Mechanism


def loop(made: Mechanism, present: bool) -> None:
    """A four-bar linkage on the forearm, which is its fixed link."""
    scene, hinge = made.scene, cd.Revolute("y")
    crank, coupler = made.bar("crank", 0.1), made.bar("coupler", 0.3)
    rocker = made.bar("rocker", 0.22)
    scene.joint("A", hinge, made.forearm.at(0.05, 0.05, 0), crank, q0=0.5)
    scene.joint("B", hinge, crank.at(0.1, 0, 0), coupler, q0=0.4)
    scene.joint("D", hinge, made.forearm.at(0.3, 0.05, 0), rocker, q0=1.6)
    if present:
        scene.joint("C", hinge, coupler.at(0.3, 0, 0), rocker.at(0.22, 0, 0), cut=True)


def second_loop(made: Mechanism, present: bool) -> None:
    """A slider-crank whose crank is the forearm and whose rail is the arm."""
    scene, hinge = made.scene, cd.Revolute("y")
    block, rod = scene.body("block", mass=0.2, inertia=(1e-3,) * 3), made.bar("rod", 0.25)
    scene.joint("guide", cd.Prismatic("x"), made.arm.at(0.1, 0, 0.05), block, q0=0.258)
    scene.joint("pin", hinge, block, rod, q0=0.4)
    if present:
        scene.joint("knuckle", hinge, rod.at(0.25, 0, 0), made.forearm.at(0.1, 0, 0), cut=True)


def redundant_loop(made: Mechanism, present: bool) -> None:
    """A parallelogram with one bar too many, which hangs across the arm."""
    scene, hinge = made.scene, cd.Revolute("y")
    plate = scene.body("plate", mass=0.3, com=(0, 0, 0.1), inertia=(2e-3, 2e-3, 1e-3))
    bars = [made.bar(f"leg{k + 1}", 0.15, 0.1) for k in range(3)]
    for k, bar in enumerate(bars):
        place = made.arm.at(0.2, -0.05, 0.1 * k - 0.1)
        scene.joint(f"hip{k + 1}", hinge, place, bar, q0=0.8)
    scene.joint("foot1", hinge, bars[0].at(0.15, 0, 0), plate, q0=-0.8)
    for k in (1, 2):
        if present:
            end = bars[k].at(0.15, 0, 0)
            scene.joint(f"foot{k + 1}", hinge, end, plate.at(0, 0, 0.1 * k), cut=True)


def beam(made: Mechanism, present: bool) -> None:
    """An elastic link of the chain; without the feature a rigid one of its mass."""
    length, mass = 0.3, 0.3
    if not present:
        made.tip = rigid_link(made, "beam", length, mass)
    else:
        section = cd.section.general(EA=2e3, GA=1e3, GJ=1.5, EI=2.0, rhoA=mass / length, rhoI=1e-3)
        end = (made.reach + length, 0, 0)
        elastic = made.scene.beam("beam", made.tip, end, section, elements=2, up="z")
        made.tip = elastic.end
    made.reach += length


def superelement(made: Mechanism, present: bool) -> None:
    """A reduced link of the chain; without the feature a rigid one of its mass."""
    length, mass = 0.25, 0.25
    if not present:
        made.tip = rigid_link(made, "boom", length, mass)
    else:
        # the mean of the interfaces by the weight of one of them is that interface
        placed = {"frame": "mean", "weights": (1, 0)} if made.by_conditions else {"frame": "start"}
        record = reduced_link(length, mass)
        made.tip = made.scene.superelement("boom", record, {"start": made.tip}, **placed).at("end")
    made.reach += length


@cache
def reduced_link(length: float, mass: float) -> Any:
    """Beams along x as one component."""
    scene = cd.Scene("link")
    section = cd.section.general(EA=2e3, GA=1e3, GJ=3.0, EI=4.0, rhoA=mass / length, rhoI=1e-3)
    scene.beam("boom", (0, 0, 0), (length, 0, 0), section, elements=4, up="z")
    return cd.superelement.from_beams(scene, "boom", modes=2)


def rigid_link(made: Mechanism, name: str, length: float, mass: float) -> Any:
    """A rod at the tip; its other end."""
    rod = made.scene.body(
        name, mass=mass, com=(length / 2, 0, 0), inertia=cd.inertia.rod(mass, length, axis="x")
    )
    made.scene.joint(f"{name}_joint", cd.Fixed(), made.tip, rod)
    return rod.at(length, 0, 0)


def cable(made: Mechanism, present: bool) -> None:
    """A cable between the forearm and the base, slack at first."""
    if present:
        ends = made.forearm.at(0.35, 0, 0), made.root.at(0.8, 0.1, 0.1)
        made.scene.force("rope", cd.Cable(*ends, EA=60.0, length=0.65, damping=0.01))


def prescribed_motion(made: Mechanism, present: bool) -> None:
    """An eccentric disk on the forearm that turns as a function of time."""
    disk = made.scene.body("eccentric", mass=0.3, com=(0.06, 0, 0.01), inertia=(1e-3, 2e-3, 1e-3))
    at = made.forearm.at(0.2, 0.03, 0.05)
    if present:
        angle = 6 * cd.t + cd.t**2 / 2
        made.scene.joint("spin", cd.Revolute("y"), at, disk, prescribed=angle)
    else:
        made.scene.joint("spin", cd.Fixed(), at, disk)


def moving_base(made: Mechanism, present: bool) -> None:
    """A base that heaves as a function of time."""
    base = made.scene.body("base", mass=2.0, inertia=(0.1, 0.1, 0.1))
    if present:
        heave = 0.03 * sp.sin(9 * cd.t)
        made.scene.joint("heave", cd.Prismatic("z"), made.scene.ground, base, prescribed=heave)
    else:
        made.scene.joint("heave", cd.Fixed(), made.scene.ground, base)
    made.root = base


def gravity_field(made: Mechanism, present: bool) -> None:
    """The pull of a heavy point below, on all that has mass."""
    if present:
        center = made.scene.ground.at(0.5, 1.0, -3.0)
        made.scene.force("planet", cd.CentralGravity(center, mu=30.0))
