"""A planar mechanism as Exudyn's bodies in the plane, every joint a constraint."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from benchmarks.motion.problem import Array, Task
from cardan.peers.circuits import circuits
from cardan.peers.tree import central


def built(task: Task) -> tuple[Any, Callable[[], Array]]:
    """The system, and what reads our coordinates from it."""
    import exudyn as exu
    from exudyn import itemInterface as items

    system = exu.SystemContainer().AddSystem()
    model, scene = task.model, task.scene
    names = [body["name"] for body in model.manifest["bodies"]]
    com, inertia = central(scene)
    nodes, bodies = [], [system.AddObject(items.ObjectGround())]
    gravity = scene.numbers["gravity"]
    q0 = task.x0[: model.nq]
    for k, name in enumerate(names):
        pose = model.pose(name, q0)
        angle = _angle(pose)
        # its nodes are centers of mass
        center = pose[:3, 3] + pose[:3, :3] @ com[k]
        nodes.append(
            system.AddNode(items.NodeRigidBody2D(referenceCoordinates=[*center[:2], angle]))
        )
        mass = float(scene.numbers["mass"][k])
        bodies.append(
            system.AddObject(
                items.ObjectRigidBody2D(
                    mass=mass, inertia=float(inertia[k][2, 2]), nodeNumber=nodes[-1]
                )
            )
        )
        marker = system.AddMarker(items.MarkerBodyMass(bodyNumber=bodies[-1]))
        if np.any(gravity):
            system.AddLoad(
                items.LoadMassProportional(markerNumber=marker, loadVector=list(gravity))
            )

    def mark(body: int, place: Any) -> int:
        local = np.array(place, dtype=float) - (com[body] if body >= 0 else 0.0)
        return system.AddMarker(
            items.MarkerBodyRigid(bodyNumber=bodies[body + 1], localPosition=list(local))
        )

    _joints(task, system, mark)
    _loads(task, system, mark, names)
    system.Assemble()
    parents = np.array(scene.parents)

    def read() -> Array:
        kind = exu.OutputVariableType.Coordinates
        turned = np.array([system.GetNodeOutput(node, kind)[2] for node in nodes])
        # parents of -1 are the ground
        angles = np.concatenate([turned, [0.0]])
        moved = angles[:-1] - angles[parents]
        return np.asarray(q0 + moved)

    return system, read


def _angle(pose: Array) -> float:
    return float(np.arctan2(pose[1, 0], pose[0, 0]))


def _joints(task: Task, system: Any, mark: Callable[[int, Any], int]) -> None:
    """Hinges of the tree at the origins of their bodies, and those that close loops."""
    from exudyn.itemInterface import ObjectJointRevolute2D

    scene = task.scene
    for body, parent in enumerate(scene.parents):
        ends = [mark(parent, scene.numbers["position"][body]), mark(body, np.zeros(3))]
        system.AddObject(ObjectJointRevolute2D(markerNumbers=ends))
    found = circuits(task.model)
    if isinstance(found, str):
        raise ValueError(found)
    for held in found.connections:
        pairs = zip(held.bodies, held.positions, strict=True)
        ends = [mark(body, place) for body, place in pairs]
        system.AddObject(ObjectJointRevolute2D(markerNumbers=ends))


def _loads(task: Task, system: Any, mark: Callable[[int, Any], int], names: list[str]) -> None:
    """Springs between points and torques of the ground."""
    from exudyn.itemInterface import LoadTorqueVector, ObjectConnectorSpringDamper

    loads, joints = task.problem.loads, list(task.model.coordinates)
    for spring in loads.springs:
        ends = [mark(names.index(n) if n != "ground" else -1, at) for n, at in spring.ends]
        system.AddObject(
            ObjectConnectorSpringDamper(
                markerNumbers=ends, referenceLength=spring.length, stiffness=spring.stiffness
            )
        )
    for joint, torque in loads.constant.items():
        body = joints.index(joint)
        system.AddLoad(
            LoadTorqueVector(markerNumber=mark(body, np.zeros(3)), loadVector=[0, 0, torque])
        )
