"""A long chain of unit rods, hinged about y and z in turn: accuracy and speed at scale."""

from __future__ import annotations

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
