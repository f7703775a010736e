"""Superelements in scenes, and their states by those of the NumPy reference."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

import cardan as cd
from mechanisms.superelements import FLYERS, soft_brick
from superelements.corotational import Corotational
from superelements.rotations import rotation

Array = Any
GRAVITY = (1.0, -2.0, -9.81)


@cache
def free(frame: str, gravity: Any = GRAVITY) -> Any:
    """The brick, free in space."""
    return cd.compile(FLYERS[frame].build(gravity))


def reference(frame: str, gravity: Any = GRAVITY) -> Corotational:
    """The same by the reference."""
    kind = "node" if frame in ("root", "tip") else frame
    node = int(frame == "tip")
    options = {"gravity": np.asarray(gravity, float)}
    if frame == "mean":
        # rotations count as displacements at the distance of the interfaces from their mean
        places = np.array([one.position for one in soft_brick().interfaces])
        options["turning"] = ((places - places.mean(0)) ** 2).sum(1).mean() * np.eye(3)
    return Corotational.of(soft_brick(), kind, node, **options)


def state_of(model: Any, frame: str, q: Array, u: Array) -> tuple[Array, Array]:
    """Coordinates and speeds of the model for those of the reference."""
    element = reference(frame)
    p, x, eta = element.split(q)
    p0, x0, shift, turn = element.frame(q)
    k = element.kinematics(q)
    v, w, z_rate = np.split(k.rates @ u, [3, 6])
    # a body stands at the joint that leads to it, here where the first interface was
    first, R0 = element.places[0], rotation(p0)
    carrier = (p0, x0 + R0 @ first), (w, R0 @ (v + np.cross(w, first)))
    root = (p[0], x[0]), (u[:3], u[3:6])
    bodies = {"free": root, "boom.tip": carrier, "boom.frame": carrier}
    names = [(i, f"boom.{name}") for i, name in enumerate(("root", "tip"))]
    local = {name: np.concatenate([shift[i], turn[i]]) for i, name in names}
    local_rates = {name: z_rate[6 * i : 6 * i + 6] for i, name in names}
    place, speed = np.zeros(model.nq), np.zeros(model.nu)
    for joint in model.manifest.joints:
        (a, count), (b, speeds) = joint.slot("q"), joint.slot("u")
        if count == 7:
            place[a : a + 7], speed[b : b + 6] = map(np.concatenate, bodies[joint.name])
        elif joint.kind == "elastic":
            place[a : a + 6], speed[b : b + 6] = local[joint.name], local_rates[joint.name]
        else:
            place[a : a + count], speed[b : b + speeds] = eta, z_rate[12:]
    return place, speed
