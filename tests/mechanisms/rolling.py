"""Wheels and disks on planes: what rolls, and what slides along an edge."""

from __future__ import annotations

from collections.abc import Callable

import cardan as cd

COIN = {"r": 0.1, "m": 1.0, "g": 9.81}


def coin() -> cd.Scene:
    """A thin uniform disk that rolls on the ground."""
    r, m = COIN["r"], COIN["m"]
    scene = cd.Scene("coin", gravity=(0, 0, -COIN["g"]))
    disk = scene.body("disk", mass=m, inertia=(m * r**2 / 4, m * r**2 / 2, m * r**2 / 4))
    scene.joint("rolls", cd.RollingDisk(r), scene.ground, disk)
    return scene


def skate() -> cd.Scene:
    """A disk that slides along its edge on a slope, and carries a pendulum."""
    scene = cd.Scene("skate", gravity=(1.5, 0.4, -9.5))
    disk = scene.body("disk", mass=2.0, com=(0.02, 0, 0.05), inertia=(0.02, 0.03, 0.02))
    bob = scene.body("bob", mass=0.3, com=(0, 0, -0.2), inertia=(0.004, 0.004, 0.001))
    scene.joint("rolls", cd.RollingDisk(0.2, "z", knife_edge=True), scene.ground, disk)
    scene.joint("hinge", cd.Revolute("y"), disk.at(0, 0.1, 0), bob)
    return scene


def wheel() -> cd.Scene:
    """A wheel with a round tread on a tilted plane, with a fork on its axle."""
    scene = cd.Scene("wheel", gravity=(0, 0, -9.81))
    rim = scene.body("rim", mass=3.0, com=(0, 0.01, 0), inertia=(0.05, 0.09, 0.05))
    fork = scene.body("fork", mass=1.0, com=(0.1, 0, 0.3), inertia=(0.03, 0.03, 0.005))
    scene.joint("rolls", cd.Wheel(0.35, 0.05, (0.1, 0, 1)), scene.ground.at(0.3, 0, 0), rim)
    scene.joint("axle", cd.Revolute("y"), rim, fork)
    return scene


def tire() -> cd.Scene:
    """An unbalanced wheel that may slide sideways on a wall."""
    scene = cd.Scene("tire", gravity=(0, 0, -9.81))
    rim = scene.body("rim", mass=3.0, com=(0.02, 0.01, 0), inertia=(0.05, 0.09, 0.05))
    scene.joint("rolls", cd.Wheel(0.35, 0.1, "x", lateral_slip=True), scene.ground, rim)
    return scene


ROLLING: dict[str, Callable[[], cd.Scene]] = {
    "coin": coin,
    "skate": skate,
    "wheel": wheel,
    "tire": tire,
}
