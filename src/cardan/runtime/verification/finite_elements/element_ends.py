"""Poses and speeds at the ends of flexible elements."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ..joint_motion import Array, cross, times
from ..rotations import quaternion
from .members import NODE, Members
from .shapes import ENERGIES, STRESSES, quaternion_of


def ends_of(members: Members) -> tuple[Array, Array, dict[str, Array]] | None:
    """Poses (n, 14) and speeds (n, 12) of both ends of a flexible element, and its data by name.

    Ends that are fixed to nodes, or to the ground, have their place among the data. None of
    elements that are not flexible, and of those in a plane.
    """
    name = members.table.kind.name
    if not any(name.startswith(kind) for kind in (*ENERGIES, *STRESSES)):
        return None
    if any(not block.node or block.nq != NODE for block in members.blocks):
        return None
    form = next(iter(members.codes.values())).symbol
    inputs = members.model._objects.saved()[form]["inputs"]
    names: list[str] = next((b["entries"] for b in inputs if b["name"] == "p"), [])
    data = {entry: members.inputs["p"][:, k] for k, entry in enumerate(names)}
    q, u, k = list[Array](), list[Array](), 0
    for end in ("start", "end"):
        attached = f"{end}_px" in data
        grounded = attached and _grounded(members, end, data)
        pose, speed = np.tile([1.0] + [0.0] * 6, (members.count, 1)), np.zeros((members.count, 6))
        if not grounded:
            pose = members.inputs["q"][:, 7 * k : 7 * k + 7]
            speed = members.inputs["u"][:, 6 * k : 6 * k + 6]
            k += 1
        if attached:
            pose, speed = _end_motion(pose, speed, end, data)
        q, u = [*q, pose], [*u, speed]
    return np.concatenate(q, axis=-1), np.concatenate(u, axis=-1), data


def _grounded(members: Members, end: str, data: Mapping[str, Array]) -> bool:
    """True when an end is fixed to the ground: the other one is the only node then."""
    other = "end" if end == "start" else "start"
    parts = members.table.kind.name.split("_")
    if len(members.blocks) == 2:
        return False
    return f"{other}_px" not in data or parts[-2 if end == "start" else -1] == "ground"


def _end_motion(
    pose: Array, speed: Array, end: str, data: Mapping[str, Array]
) -> tuple[Array, Array]:
    """Pose and speeds of a frame that is fixed to another."""
    n = len(pose)
    cells = [data[f"{end}_R{i}{j}"] for i in "123" for j in "123"]
    R = np.stack(cells, axis=-1).reshape(n, 3, 3)
    p = np.stack([data[f"{end}_p{x}"] for x in "xyz"], axis=-1)
    rotation = quaternion(pose[:, :4])
    place = pose[:, 4:] + times(rotation, p)
    back = np.swapaxes(R, -1, -2)
    moved = speed[:, 3:] + times(rotation, cross(speed[:, :3], p))
    end_pose = np.concatenate([quaternion_of(rotation @ R), place], axis=-1)
    return end_pose, np.concatenate([times(back, speed[:, :3]), moved], axis=-1)
