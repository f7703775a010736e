"""Poses of frames along a motion, with or without its model."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from ...arrays import Array
from ...errors import ModelError, near
from ..models.finite_elements import frames
from ..verification import flat_scene, newton_euler
from ..verification.joint_motion import REVERSED
from ..verification.rotations import PARAMETERS
from .joint_poses import POSES, joints_of

if TYPE_CHECKING:
    from ..models.loaded_model import LoadedModel
    from .trajectory import TrajectoryRecord


def numbers(model: LoadedModel) -> Mapping[str, Array]:
    """Numbers of the scene of a model, see :attr:`.Trajectory.scene`."""
    if model.manifest.absolute:
        return frames.numbers(model)
    values: Mapping[str, Array] = model._evaluate_saved("scene", p=model.parameters.vector)
    return values


def pose(motion: TrajectoryRecord, frame: str) -> Array:
    """Poses (nt, 4, 4) of a frame of a run without its model.

    They follow from the stored ones of another frame of its body, else from the coordinates.

    Raises:
        ModelError: no such frame, or the file does not say how its body moves.
    """
    rows = motion.manifest.frames
    frame_row = next((row for row in rows if row.name == frame), None)
    if frame_row is None:
        raise ModelError(
            f"frame '{frame}' does not exist.{near(frame, [row.name for row in rows])}"
        )
    place, body = frame_on_body(motion, frame), frame_row.body
    # nodes of their own, such as those that joints of the user's carry, belong to no body
    if body == "ground" and not frame_row.node:
        return np.broadcast_to(place, (len(motion), 4, 4)).copy()
    for row in rows if body != "ground" else ():
        history = motion.stored.get(f"pose {row.name}")
        if row.body == body and history is not None:
            history_of_frame: Array = history @ inverse(frame_on_body(motion, row.name)) @ place
            return history_of_frame
    on_node = motion.manifest.absolute and "frame_rotation" in motion.scene
    if not (on_node and frame_row.tree is None) and not is_recorded(motion):
        motion._model(f"the pose of '{frame}'")
    if motion.manifest.absolute:
        parts = (motion.scene[name] for name in ("frame_rotation", "frame_position"))
        return frames.Frames(rows, *parts).pose(frame, motion.q)
    try:
        return bodies_in_place(motion)[body] @ place
    except (IndexError, ValueError) as problem:
        raise ModelError(
            f"the file does not say how '{frame}' moves: its joints have other numbers of "
            "coordinates or speeds than their kinds"
        ) from problem


def bodies_in_place(motion: TrajectoryRecord) -> dict[str, Array]:
    """Poses (nt, 4, 4) of all bodies, by the coordinates of a run that :func:`is_recorded`."""
    joints = joints_of(motion.manifest, motion.scene)
    scene = flat_scene.scene_from(motion.manifest, motion.scene, joints)
    rotations, origins = newton_euler.poses(scene, motion.q)
    transforms: dict[str, Array] = {}
    for body, rotation, origin in zip(motion.manifest.bodies, rotations, origins, strict=True):
        T = np.tile(np.eye(4), (len(motion), 1, 1))
        T[:, :3, :3], T[:, :3, 3] = rotation, origin
        transforms[str(body.name)] = T
    return transforms


def inverse(pose: Array) -> Array:
    """The inverse (4, 4) of a rigid transform: also of a damaged one, which may have none."""
    back = np.eye(4)
    back[:3, :3] = pose[:3, :3].T
    back[:3, 3] = -pose[:3, :3].T @ pose[:3, 3]
    return back


def is_recorded(motion: TrajectoryRecord) -> bool:
    """True when a run without its model tells poses by its coordinates alone."""
    manifest = motion.manifest
    if manifest.absolute:
        # bodies of rigid trees are placed by functions of the model
        in_trees = any(row.tree is not None for row in manifest.frames)
        return "frame_rotation" in motion.scene and not in_trees
    scene = manifest.scene
    complete = all(
        kind.removeprefix(REVERSED) in POSES and (rotation is None or rotation in PARAMETERS)
        for kind, rotation in zip(scene.kinds, scene.rotations, strict=True)
    )
    joints = manifest.joints
    driven = any(joint.prescribed or joint.solved for joint in joints)
    return not scene.empty and "position" in motion.scene and complete and not driven


def can_resample(motion: TrajectoryRecord) -> bool:
    """True when a run knows the poses of its bodies at any time, not at its rows alone."""
    return motion.dense is not None and (motion.model is not None or is_recorded(motion))


def frame_on_body(motion: TrajectoryRecord, frame: str) -> Array:
    """Transform (4, 4) from the axes of a frame to those of the rigid body that carries it.

    Raises:
        ModelError: the file does not say.
    """
    names = [row.name for row in motion.manifest.frames]
    if frame not in names:
        raise ModelError(f"frame '{frame}' does not exist.{near(frame, names)}")
    if "frame_rotation" not in motion.scene:
        raise ModelError("the file does not say where frames sit in their bodies")
    k, place = names.index(frame), np.eye(4)
    place[:3, :3] = np.reshape(motion.scene["frame_rotation"], (-1, 3, 3))[k]
    place[:3, 3] = np.reshape(motion.scene["frame_position"], (-1, 3))[k]
    return place
