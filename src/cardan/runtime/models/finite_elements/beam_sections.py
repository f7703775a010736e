"""Poses of the cross sections along a beam."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from ....arrays import Array
from ....errors import ModelError, near
from ....schema.mechanism import BeamRow
from .frames import rotation
from .node_pose import Plane
from .node_pose import pose as node_poses


def sections(rows: Sequence[BeamRow], name: str, q: Array, pose: Callable[[str], Array]) -> Array:
    """Poses (..., n, 4, 4) of the sections at the n nodes of a beam, from its start to its end.

    Args:
        rows: Pieces of beams, of the manifest.
        name: Of the beam.
        q: Coordinates (..., nq).
        pose: Name of a frame -> its transforms (..., 4, 4) at the same coordinates.

    Raises:
        ModelError: there is no such beam.
    """
    segments = [row for row in rows if row.name == name]
    if not segments:
        names = list(dict.fromkeys(row.name for row in rows))
        raise ModelError(f"beam '{name}' does not exist.{near(name, names)}")
    blocks = [pose(segments[0].start)[..., None, :, :]]
    for segment in segments:
        first, count = segment.q
        plane = Plane.of(segment.plane)
        size = 7 if plane is None else 3
        inner = q[..., first : first + size * count].reshape(*q.shape[:-1], count, size)
        places = node_poses(plane, inner)
        T = np.zeros((*places.shape[:-1], 4, 4))
        T[..., :3, :3], T[..., :3, 3], T[..., 3, 3] = rotation(places[..., :4]), places[..., 4:], 1
        blocks += [T, pose(segment.end)[..., None, :, :]]
    return np.concatenate(blocks, axis=-3)
