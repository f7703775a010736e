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


def lee_frame(elements: int, known: dict[str, float], shear: float = 5 / 6) -> cd.CompiledModel:
    """A column and a beam with a stiff corner, hinged at their ends, under P near the corner.

    Source: S.-L. Lee, F. S. Manuel, E. C. Rossow (1968).

    Args:
        elements: Of the whole, 16 or a multiple of that.
        known: Of the reference: L, E, nu, A, I.
        shear: Factor of GA.
    """
    scene, L, E = cd.Scene("lee", gravity=(0, 0, 0)), known["L"], known["E"]
    G = E / (2 * (1 + known["nu"]))
    EA, EI = E * known["A"], E * known["I"]
    section = cd.section.general(EA=EA, GA=shear * G * known["A"], GJ=EI, EI=EI)
    part = elements // 16
    column = scene.beam("column", (0, 0, 0), (0, 0, L), section, elements=7 * part, up="y")
    short = scene.beam("short", column.end, (0.2 * L, 0, L), section, elements=2 * part, up="y")
    long = scene.beam("long", short.end, (L, 0, L), section, elements=7 * part, up="y")
    scene.joint("foot", cd.Revolute("y"), scene.ground, column.start)
    scene.joint("hinge", cd.Revolute("y"), scene.ground.at(L, 0, L), long.end)
    scene.force("load", cd.Force(short.end, (0, 0, -scene.parameter("P", 0.0))))
    scene.output("v", L - short.end.position()[2], unit="m")
    return cd.compile(scene, plane="y")


def narrow_frame(elements: int, known: dict[str, float]) -> cd.CompiledModel:
    """A clamped right angle of narrow arms in a plane, pulled at its end within the plane.

    Source: J. H. Argyris (1979).

    Args:
        elements: Of both arms.
        known: Of the reference: L, h, b, E, nu.
    """
    scene, L, E, h, b = cd.Scene("frame"), *(known[name] for name in ("L", "E", "h", "b"))
    G, scene.gravity = E / (2 * (1 + known["nu"])), (0, 0, 0)
    section = cd.section.general(
        EA=E * h * b, GA=G * h * b, GJ=G * h * b**3 / 3, EI=(E * b * h**3 / 12, E * h * b**3 / 12)
    )
    half = elements // 2
    one = scene.beam("one", scene.ground, (L, 0, 0), section, elements=half, up="y")
    two = scene.beam("two", one.end, (L, -L, 0), section, elements=half, up="x")
    scene.force("load", cd.Force(two.end, (scene.parameter("P", 0.0), 0, 0)))
    for name, x in zip("xyz", two.end.position(), strict=True):
        scene.output(name, x, unit="m")
    return cd.compile(scene)


def heated_beam(elements: int, known: dict[str, float]) -> cd.CompiledModel:
    """A beam between walls that would stretch by e if it could; it bends in a plane."""
    scene = cd.Scene("heated", gravity=(0, 0, 0))
    rise, material = scene.parameter("e", 0.0), cd.material(expansion=1.0)
    EA, EI = known["EA"], known["EI"]
    section = cd.section.general(EA=EA, GA=EA / 2.6, GJ=EI, EI=EI)
    half = elements // 2
    one = scene.beam(
        "one", scene.ground, (0.5, 0, 0), section, material, elements=half, temperature=rise
    )
    scene.beam(
        "two", one.end, scene.ground.at(1, 0, 0), section, material, elements=half, temperature=rise
    )
    scene.output("w", one.end.position()[2], unit="m")
    return cd.compile(scene, plane="y")


def tall_cantilever(elements: int, known: dict[str, float]) -> cd.CompiledModel:
    """A cantilever with a section that is tall along its tip load P, and buckles aside.

    Source: L. Prandtl (1899); A. G. M. Michell (1899).
    """
    scene = cd.Scene("tall", gravity=(0, 0, 0))
    section = cd.section.general(
        EA=known["EA"], GA=known["GA"], GJ=known["GJ"], EI=(known["EI_strong"], known["EI_weak"])
    )
    beam = scene.beam("beam", scene.ground, (1, 0, 0), section, elements=elements, up="z")
    scene.force("load", cd.Force(beam.end, (0, 0, -scene.parameter("P", 0.0))))
    return cd.compile(scene)
