"""Scenes of beams in gravity fields."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import cardan as cd

MU = 20.0
Mu = Callable[[cd.Scene], Any]


def boom(
    mu: Mu,
    center: str = "ground",
    hub: str = "free",
    bodies: tuple[str, ...] = (),
    inertia: str = "linked",
) -> cd.Scene:
    """A hub with a beam in a field about a point of the ground, of a node or of a rigid tree."""
    scene = cd.Scene("boom", gravity=(0, 0, 0))
    body = scene.body("hub", mass=2.0, inertia=(0.1, 0.12, 0.13))
    # a free joint at the origin of the ground has the coordinates of its node
    joint, x = (cd.Free(), 0) if hub == "free" else (cd.Revolute("z"), 3)
    q0 = (1, 0, 0, 0, 3, 0, 0) if hub == "free" else 0
    scene.joint("hub", joint, scene.ground.at(x, 0, 0), body, q0=q0)
    place = scene.ground
    if center != "ground":
        place = scene.body("planet", mass=5.0, inertia=(1, 1, 1))
        on = cd.Free() if center == "node" else cd.Revolute("z")
        scene.joint("planet", on, scene.ground, place)
    section = cd.section.general(EA=1e4, GA=1e4, GJ=1e3, EI=1e3, rhoA=1.3, rhoI=(0.02, 0.03))
    scene.beam("beam", body, (x + 2, 0.5, 0), section, elements=2, inertia=inertia)
    strength = mu(scene)
    scene.force("pull", cd.CentralGravity(place.at(0.1, 0.2, 0.3), strength, bodies))
    scene.force("extent", cd.GravityGradient(place.at(0.1, 0.2, 0.3), strength, bodies))
    scene.output("strength", strength)
    return scene
