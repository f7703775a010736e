"""Long chains, of unit rods and of bodies with any inertia: accuracy and speed at scale."""

from __future__ import annotations

import numpy as np

import cardan as cd

GRAVITY = (0.0, 0.0, -9.81)


def chain(n: int, axes: str = "yz") -> cd.Scene:
    """n thin rods of 1 kg and 1 m along x, hinged about these axes in turn."""
    scene = cd.Scene(f"chain{n}", gravity=GRAVITY)
    parent = scene.ground
    for i in range(n):
        rod = scene.body(
            f"rod{i}", mass=1.0, com=(0.5, 0, 0), inertia=cd.inertia.rod(1.0, 1.0, axis="x")
        )
        scene.joint(f"hinge{i}", cd.Revolute(axes[i % len(axes)]), parent, rod)
        parent = rod.at(1.0, 0, 0)
    return scene


def full_chain(n: int) -> cd.Scene:
    """n bodies whose inertias, centers of mass and joints have no zeros, hinged about x, y, z."""
    scene, rng = cd.Scene(f"full{n}", gravity=GRAVITY), np.random.default_rng(5)
    parent = scene.ground
    for i in range(n):
        half = rng.normal(size=(3, 3))
        inertia = 0.02 * half @ half.T + 0.05 * np.eye(3)
        com = tuple(map(float, rng.uniform(-0.2, 0.5, 3)))
        mass = float(rng.uniform(0.5, 2.0))
        body = scene.body(f"body{i}", mass=mass, com=com, inertia=inertia.tolist())
        scene.joint(f"hinge{i}", cd.Revolute("xyz"[i % 3]), parent, body)
        parent = body.at(*map(float, rng.uniform(-0.3, 0.5, 3)))
    return scene
