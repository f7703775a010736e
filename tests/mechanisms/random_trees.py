"""Trees drawn by chance: any joint, any axis, any branching, springs and dampers between bodies."""

from __future__ import annotations

from typing import Any

import numpy as np

import cardan as cd

ROTATIONS = ("quaternion", "ZYX", "mrp", "rodrigues")


def random_tree(seed: int) -> cd.Scene:
    """A tree of 3 to 6 bodies; the same one for the same seed everywhere."""
    rng = np.random.default_rng(seed)
    scene = cd.Scene(f"tree_{seed}", gravity=tuple(_numbers(rng, 3, 9.81)))
    bodies: list[Any] = []
    for k in range(int(rng.integers(3, 7))):
        # principal values of some solid fulfil the triangle inequality
        a, b, c = rng.uniform(0.01, 0.1, 3)
        body = scene.body(
            f"b{k}",
            mass=round(float(rng.uniform(0.2, 3.0)), 3),
            com=_numbers(rng, 3, 0.2),
            inertia=tuple(round(float(x), 4) for x in (b + c, a + c, a + b)),
        )
        parent = bodies[int(rng.integers(len(bodies)))] if bodies else scene.ground
        turned = ("ZYX", *_numbers(rng, 3, 1.0))
        scene.joint(f"j{k}", _joint(rng), parent.at(*_numbers(rng, 3, 0.5), rotation=turned), body)
        bodies.append(body)
    ends = bodies[0].at(0.1, 0, 0), bodies[-1].at(0, 0.2, 0)
    stiffness, damping = _numbers(rng, 2, 5.0)
    spring = cd.SpringDamper(*ends, stiffness=10 + stiffness, damping=6 + damping, rest_length=0.3)
    scene.force("spring", spring)
    return scene


def large_tree(n: int, seed: int = 1) -> cd.Scene:
    """n bodies, hinged about x, y or z anywhere on one of the 20 bodies before."""
    rng = np.random.default_rng(seed)
    scene = cd.Scene(f"large_tree_{n}", gravity=(0, 0, -9.81))
    bodies: list[Any] = []
    for k in range(n):
        mass = round(float(rng.uniform(0.5, 2.0)), 3)
        body = scene.body(f"b{k}", mass=mass, com=_numbers(rng, 3, 0.2), inertia=(0.2, 0.3, 0.25))
        parent = bodies[int(rng.integers(max(0, k - 20), k))] if bodies else scene.ground
        axis = "xyz"[int(rng.integers(3))]
        scene.joint(f"j{k}", cd.Revolute(axis), parent.at(*_numbers(rng, 3, 0.5)), body)
        bodies.append(body)
    return scene


def _numbers(rng: np.random.Generator, count: int, reach: float) -> list[float]:
    return [round(float(x), 3) for x in rng.uniform(-reach, reach, count)]


def _joint(rng: np.random.Generator) -> Any:
    """Any kind of joint, about any axis."""
    axis, across = _numbers(rng, 3, 1.0), ("x", "y", "z")[int(rng.integers(3))]
    rotation = ROTATIONS[int(rng.integers(len(ROTATIONS)))]
    kinds = (
        lambda: cd.Revolute(axis),
        lambda: cd.Prismatic(axis),
        lambda: cd.Cylindrical(axis),
        lambda: cd.Screw(axis, pitch=0.1),
        lambda: cd.Universal(),
        lambda: cd.Planar(across),
        lambda: cd.Spherical(rotation=rotation),
        lambda: cd.Free(rotation=rotation),
    )
    return kinds[int(rng.integers(len(kinds)))]()
