"""Where frames are along a motion whose model is not at hand."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..errors import ModelError, near
from .calling import Array

if TYPE_CHECKING:
    from .trajectory import Trajectory


def rigid_pose(motion: Trajectory, frame: str) -> Array:
    """Poses (nt, 4, 4) of a frame from the stored ones of another frame of its body.

    Raises:
        ModelError: no such frame, or nothing is stored of its body.
    """
    rows = motion.manifest["frames"]
    body = next((row["body"] for row in rows if row["name"] == frame), None)
    if body is None:
        raise ModelError(
            f"frame '{frame}' does not exist.{near(frame, [row['name'] for row in rows])}"
        )
    place = placed(motion, frame)
    if body == "ground":
        return np.broadcast_to(place, (len(motion), 4, 4)).copy()
    for row in rows:
        history = motion.stored.get(f"pose {row['name']}")
        if row["body"] == body and history is not None:
            pose: Array = history @ np.linalg.inv(placed(motion, row["name"])) @ place
            return pose
    motion._model(f"the pose of '{frame}'")
    raise ModelError(f"the file holds no pose of body '{body}'")


def placed(motion: Trajectory, frame: str) -> Array:
    """Transform (4, 4) from the axes of a frame to those of the rigid body that carries it.

    Raises:
        ModelError: the file does not say.
    """
    names = [row["name"] for row in motion.manifest["frames"]]
    if "frame_rotation" not in motion.scene:
        raise ModelError("the file does not say where frames sit in their bodies")
    k, place = names.index(frame), np.eye(4)
    place[:3, :3] = np.reshape(motion.scene["frame_rotation"], (-1, 3, 3))[k]
    place[:3, 3] = np.reshape(motion.scene["frame_position"], (-1, 3))[k]
    return place


def line(motion: Trajectory, beam: str) -> Array:
    """Positions (nt, nodes, 3) of the nodes of a beam from its start to its end.

    Raises:
        ModelError: no such beam.
    """
    rows = motion.manifest.get("beams", [])
    pieces = [row for row in rows if row["name"] == beam]
    if not pieces:
        names = list(dict.fromkeys(row["name"] for row in rows))
        raise ModelError(f"beam '{beam}' does not exist.{near(beam, names)}")
    found = [motion.pose(pieces[0]["start"])[:, None, :3, 3]]
    for piece in pieces:
        first, count = piece["q"]
        inner = motion.q[:, first : first + 7 * count].reshape(len(motion), count, 7)
        found += [inner[:, :, 4:], motion.pose(piece["end"])[:, None, :3, 3]]
    return np.concatenate(found, axis=1)
