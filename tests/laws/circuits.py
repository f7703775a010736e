"""Closed mechanisms cut at a chosen joint, with states and the motion of their bodies."""

from __future__ import annotations

import dataclasses
from functools import cache
from typing import Any

import numpy as np

import cardan as cd
from laws.maximal import Maximal
from mechanisms.carried import CARRIED, PLAIN
from mechanisms.closed import CLOSED

EVERY = CLOSED | CARRIED
EXACT = ("multipliers", "elimination", "null_space")
# where along its motion every mechanism is looked at
PLACES = (0.3, -0.4)
Array = np.ndarray


def scene_of(name: str, cut: str | None = None) -> cd.Scene:
    """A mechanism, cut at a joint."""
    scene = EVERY[name].build()
    if cut is not None:
        scene.joints[cut] = dataclasses.replace(scene.joints[cut], cut=True)
    return scene


@cache
def compiled(name: str, cut: str | None = None, treatment: Any = "multipliers") -> Any:
    return cd.compile(cd.derive(scene_of(name, cut), constraints=treatment))


def start(model: cd.CompiledModel, name: str, s: float, rate: float = 1.0) -> tuple[Array, Array]:
    """q and u of a mechanism at s along its motion, on the constraints to rounding."""
    joints = {joint["name"] for joint in model.manifest["joints"] if joint["q"]}
    state = EVERY[name].state(s, rate, joints)
    q, u = model.split(model.initial(q=state.q, u=state.u))
    return q, model.close_velocity(q, u)[: model.nu]


def accelerations(
    model: cd.CompiledModel, q: Array, u: Array, udot: Array | None = None
) -> dict[str, Array]:
    """Angular acceleration and that of the origin (6,) of every body."""
    if udot is None:
        udot = model.forward_dynamics(q, u)
    return {body: model.acceleration(body, q, u, udot) for body in model.bodies}


def apart(one: dict[str, Array], other: dict[str, Array]) -> float:
    """Largest difference, relative to the largest value."""
    size = max(float(np.abs(a).max()) for a in other.values())
    return max(float(np.abs(one[name] - a).max()) for name, a in other.items()) / size


@cache
def exact(name: str, s: float) -> dict[str, Array]:
    """Accelerations of the bodies at s along the motion by :class:`Maximal`."""
    scene, model = PLAIN.get(name, EVERY[name].build)(), compiled(name)
    q, u = start(model, name, s)
    poses, twists = {}, np.zeros(6 * len(scene.bodies))
    mechanism = Maximal(scene)
    for body in scene.bodies.values():
        pose, velocity = model.pose(body.name, q), model.velocity(body.name, q, u)
        poses[body.name] = pose[:3, :3], pose[:3, 3]
        twists[mechanism.slot[body.name] :][:6] = velocity
    centers = mechanism.centers(poses)
    for body in scene.bodies.values():
        at = twists[mechanism.slot[body.name] :][:6]
        at[3:] += np.cross(at[:3], centers[body.name])
    return mechanism.origins(poses, twists, mechanism.accelerations(poses, twists))
