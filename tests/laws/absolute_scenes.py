"""Scenes in absolute coordinates whose functions are differentiated: joints, beams and both."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import cardan as cd
from mechanisms import ZOO
from mechanisms.superelements import FLYERS


def rubber(elements: int = 2) -> cd.Scene:
    """A rubber bar on a driven hinge with a body at its tip and one that hangs from that.

    Everything that matters is a parameter; sides differ, as the torsion of a bar has a corner where
    they do not.
    """
    scene = cd.Scene("rubber", gravity=(0, 0, -9.81))
    values = {"E": 5e6, "rho": 1100.0, "width": 0.03, "height": 0.04, "m": 0.1, "l": 0.4, "a": 0.2}
    E, rho, width, height, m, length, a = (scene.parameter(n, x) for n, x in values.items())
    torque = scene.input("torque", unit="N*m")
    hub = scene.body("hub", mass=0.2, inertia=(1e-3, 1e-3, 1e-3))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, hub)
    scene.force("motor", cd.JointForce("hinge", torque * (1 + cd.t)))
    material = cd.material(E=E, nu=0.45, rho=rho, damping=1e-3)
    section = cd.section.rectangle(width, height)
    bar = scene.beam("bar", hub, (1, 0, 0), section, material, elements=elements)
    rod = cd.inertia.box(m, 0.05, 0.05, length)
    tip = scene.body("tip", mass=m, com=(0, 0, -length / 2), inertia=rod)
    scene.joint("wrist", cd.Revolute("y"), bar.end, tip)
    low = scene.body("low", mass=m, com=(0, 0, -length / 2), inertia=rod)
    scene.joint("elbow", cd.Spherical(), tip.at(0, 0, -length), low)
    scene.output("z", low.at(0, 0, -a).position()[2])
    scene.output("acceleration", tip.acceleration()[0])
    return scene


def cantilever(elements: int = 2) -> cd.Scene:
    """A bar that is clamped, without gravity and losses: forces are proportional to E, masses to
    rho."""
    scene = cd.Scene("cantilever", gravity=(0, 0, 0))
    E, rho = scene.parameter("E", 5e6), scene.parameter("rho", 1100.0)
    section = cd.section.rectangle(0.03, 0.04)
    material = cd.material(E=E, nu=0.45, rho=rho)
    bar = scene.beam("bar", scene.ground, (1, 0, 0), section, material, elements=elements)
    scene.output("deflection", bar.end.position()[2])
    bar.end.at(0.05, 0, -0.1, rotation=("XYZ", 0, 0.4, 0), name="eye")
    return scene


def flying(name: str) -> cd.Scene:
    """A superelement in flight, where gravity pulls."""
    return FLYERS[name].build(gravity=(0.3, 0.2, -9.81))


SCENES: dict[str, tuple[Callable[[], cd.Scene], dict[str, str]]] = {
    "rubber, joints in trees": (rubber, {}),
    "rubber, nodes": (rubber, {"coordinates": "absolute"}),
    "cantilever": (cantilever, {}),
    "cantilever in its plane": (cantilever, {"coordinates": "absolute", "plane": "y"}),
    "many elements side by side": (lambda: cantilever(10), {}),
    **{
        name: (ZOO[name].build, {"coordinates": "absolute"})
        for name in ("double_pendulum", "crane", "drives", "spherical_mrp", "universal")
    },
    **{f"superelement, {name}": (partial(flying, name), {}) for name in FLYERS},
}
