"""A tree of hinges and slides as Exudyn's kinematic tree."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from benchmarks.motion.problem import Array, Task
from cardan.peers.tree import central, directions

LETTERS = "XYZ"
KINDS = {"revolute": "Revolute", "prismatic": "Prismatic"}


def refusal(task: Task) -> str:
    """It has joints along x, y and z."""
    scene = task.scene
    for joint, kind, axis in zip(
        task.model.coordinates, scene.kinds, directions(scene), strict=True
    ):
        if kind not in KINDS or sorted(axis) != [0.0, 0.0, 1.0]:
            return f"joint '{joint}' is {kind} along {axis.tolist()}"
    return ""


def built(task: Task) -> tuple[Any, Callable[[], Array]]:
    """The system, and what reads our coordinates from it."""
    import exudyn as exu
    from exudyn.itemInterface import NodeGenericODE2, ObjectKinematicTree

    system = exu.SystemContainer().AddSystem()
    scene, n, count = task.scene, task.scene.numbers, len(task.scene.parents)
    com, inertia = central(scene)
    still = [0.0] * count
    node = system.AddNode(
        NodeGenericODE2(
            referenceCoordinates=still,
            initialCoordinates=list(task.x0[:count]),
            initialCoordinates_t=still,
            numberOfODE2Coordinates=count,
        )
    )
    kinds = [
        getattr(exu.JointType, KINDS[kind] + LETTERS[int(np.argmax(axis))])
        for kind, axis in zip(scene.kinds, directions(scene), strict=True)
    ]
    stiffness, damping, force = (
        task.along(values)
        for values in (
            task.problem.loads.stiffness,
            task.problem.loads.damping,
            task.problem.loads.constant,
        )
    )
    system.AddObject(
        ObjectKinematicTree(
            nodeNumber=node,
            gravity=list(n["gravity"]),
            jointTypes=kinds,
            linkParents=list(scene.parents),
            jointTransformations=exu.Matrix3DList(list(n["rotation"])),
            jointOffsets=exu.Vector3DList(list(n["position"])),
            linkInertiasCOM=exu.Matrix3DList(list(inertia)),
            linkCOMs=exu.Vector3DList(list(com)),
            linkMasses=list(n["mass"]),
            jointForceVector=list(force),
            jointPositionOffsetVector=still,
            jointVelocityOffsetVector=still,
            jointPControlVector=list(stiffness),
            jointDControlVector=list(damping),
        )
    )
    system.Assemble()

    def read() -> Array:
        return np.array(system.GetNodeOutput(node, exu.OutputVariableType.Coordinates)).reshape(-1)

    return system, read
