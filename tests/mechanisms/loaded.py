"""Structures under loads at which they lose their stability."""

from __future__ import annotations

import math

import cardan as cd


def arch(
    elements: int, known: dict[str, float], clamped: bool = False, coordinates: str = "auto"
) -> cd.CompiledModel:
    """A circular arch under a load P down at its crown.

    Args:
        elements: Of the whole.
        coordinates: "absolute" gives the crown a height that can be held.
        known: Of the reference: radius R, arc_deg, EI, EA, GA.
        clamped: Whether the left end is; hinged else, as the right one is.
    """
    scene, R, half = cd.Scene("arch", gravity=(0, 0, 0)), known["R"], 0.5 * known["arc_deg"]
    EI, EA, GA = (known[name] for name in ("EI", "EA", "GA"))
    section = cd.section.general(EA=EA, GA=GA, GJ=EI, EI=EI, rhoA=1.0, rhoI=1e-3)

    def at(degrees: float) -> tuple[float, float, float]:
        angle = math.radians(degrees)
        return R * math.sin(angle), 0.0, R * math.cos(angle)

    def end(name: str, degrees: float) -> cd.Body:
        body = scene.body(name, mass=0.01, inertia=(1e-3,) * 3, pose=at(degrees))
        scene.joint(f"{name}_hinge", cd.Revolute("y"), scene.ground.at(*at(degrees)), body)
        return body

    left = scene.ground.at(*at(-half)) if clamped else end("left", -half)
    right = end("right", half)
    crown = scene.body("crown", mass=0.01, inertia=(1e-3,) * 3, pose=at(0))
    scene.joint("plane", cd.Planar("y"), scene.ground.at(0, 0, R), crown)
    for name, start, stop, side in (("west", left, crown, -1), ("east", crown, right, 1)):
        line = cd.arc(through=at(side * half / 2))
        scene.beam(name, start, stop, section, line=line, elements=elements // 2)
    scene.force("load", cd.Force(crown, (0, 0, -scene.parameter("P", 0.0))))
    return cd.compile(scene, coordinates=coordinates)


def shaft(elements: int, EI: float = 100.0) -> cd.CompiledModel:
    """Greenhill's: clamped at both ends, twisted at one that turns and slides along the axis."""
    scene = cd.Scene("shaft", gravity=(0, 0, 0))
    end = scene.body("end", mass=1, inertia=(1, 1, 1), pose=(1, 0, 0))
    scene.joint("turn", cd.Cylindrical("x"), scene.ground.at(1, 0, 0), end)
    section = cd.section.general(EA=1e7, GA=1e7, GJ=80, EI=EI)
    scene.beam("b", scene.ground, end, section, elements=elements)
    scene.force("load", cd.Torque(end, (scene.parameter("T", 0.0), 0, 0)))
    return cd.compile(scene)


def follower_column(elements: int, EI: float = 100.0) -> cd.CompiledModel:
    """Beck's: a cantilever pressed by a force P that turns along with its end."""
    scene = cd.Scene("beck", gravity=(0, 0, 0))
    section = cd.section.general(EA=1e7, GA=1e7, GJ=80, EI=EI, rhoA=1.0, rhoI=1e-6)
    beam = scene.beam("b", scene.ground, (1, 0, 0), section, elements=elements)
    push = cd.Force(beam.end, (-scene.parameter("P", 0.0), 0, 0), in_=beam.end)
    scene.force("push", push)
    return cd.compile(scene)
