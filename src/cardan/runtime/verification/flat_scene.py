"""The flat scene of a compiled model as the judge of every build reads it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cache, partial
from typing import TYPE_CHECKING, Any

import numpy as np

from ...schema.manifest import Manifest
from .joint_motion import Array, JointData, joint_data
from .newton_euler import Scene
from .rotations import PARAMETERS

if TYPE_CHECKING:
    from ..models.loaded_model import LoadedModel


def unknown(model: LoadedModel) -> str:
    """Why the scene of a model cannot be judged; "" if it can."""
    manifest, saved = model.manifest, frozenset(model.saved)
    scene = manifest.scene
    if "scene" not in saved:
        return "not checked: the directory holds no scene"
    reasons = list(scene.unknown)
    for joint, rotation in zip(manifest.joints, scene.rotations, strict=True):
        if rotation is not None and rotation not in PARAMETERS:
            reasons.append(f"joint '{joint.name}' is described by {rotation}")
    if not all(name in saved for name in scene.poses):
        reasons.append("the poses of its joints are not saved")
    moved = any(joint.prescribed for joint in manifest.joints)
    if moved and "scene_motion" not in saved:
        reasons.append("the motion of prescribed joints is not saved")
    if any(joint.solved for joint in manifest.joints) and "dependents" not in saved:
        reasons.append("the joints that loops determine are not saved")
    return "not checked: " + "; ".join(reasons[:3]) if reasons else ""


def _joint(model: LoadedModel, function: str, kind: str, rotation: str | None) -> JointData:
    """A joint by the saved Function of its pose, as it was written."""
    p = model.parameters.vector

    def pose(q: Array) -> tuple[Array, Array]:
        pose_values = model._evaluate_saved(function, q=q, p=p)
        n, rotation, position = len(q), pose_values["rotation"], pose_values["position"]
        return (
            np.broadcast_to(rotation, (n, *rotation.shape[-2:])).reshape(n, 3, 3),
            np.broadcast_to(position, (n, *position.shape[-1:])).reshape(n, 3),
        )

    return joint_data(pose, kind, rotation)


def scene_of(model: LoadedModel) -> Scene:
    """The flat scene of a model with its parameter values, as :func:`scene_from` says it."""
    numbers = model._evaluate_saved("scene", p=model.parameters.vector)
    scene = model.manifest.scene
    # joints of one pose are one and the same, so that they are evaluated together
    joint = cache(partial(_joint, model))
    rows = zip(scene.poses, scene.kinds, scene.rotations, strict=True)
    flat = scene_from(model.manifest, numbers, [joint(*row) for row in rows])
    closing = zip(scene.closers, scene.cuts, strict=False)
    closers = (joint(row.pose, kind, row.rotation) for row, kind in closing)
    return replace(flat, closers=tuple(closers))


def scene_from(
    manifest: Manifest, values: Mapping[str, Any], joint_data: Sequence[JointData]
) -> Scene:
    """The flat scene of a manifest with these numbers and joints.

    Joints that loops determine have their coordinates and speeds behind those of the model.
    """
    joints, scene = manifest.joints, manifest.scene
    place = {joint.name: i for i, joint in enumerate(joints)}
    numbers = {"axis2": np.zeros((len(joints), 3)), **values}
    leaders = [place[j.coupled.leader] if j.coupled else -1 for j in joints]
    ends = {"q": len(manifest.coordinates), "u": len(manifest.speeds)}
    slots: dict[str, list[tuple[int, int]]] = {"q": [], "u": []}
    for joint in joints:
        for block, rows in slots.items():
            first, size = joint.slot(block)
            if joint.solved:
                first, size = ends[block], len(joint.solved.names(block))
                ends[block] += size
            rows.append((first, size))
    return Scene(
        parents=tuple(scene.parents),
        kinds=tuple(scene.kinds),
        rotations=tuple(scene.rotations),
        q=tuple(slots["q"]),
        u=tuple(slots["u"]),
        leaders=tuple(leaders),
        prescribed=tuple(j.prescribed for j in joints),
        numbers=numbers,
        nu=ends["u"],
        joints=tuple(joint_data),
    )


def motion_of(model: LoadedModel, t: float, r: object) -> Any:
    """Value, rate and acceleration of prescribed joints (..., nb, 3); None without any."""
    if "scene_motion" not in model.saved:
        return None
    p = model.parameters.vector
    return model._evaluate_saved("scene_motion", t=np.array([t]), r=r, p=p)["motion"]
