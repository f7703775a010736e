"""Cables of a motion, drawn as lines from node to node."""

from __future__ import annotations

import numpy as np

from ..arrays import Array
from ..runtime.trajectory.cables import elements_of
from ..runtime.trajectory.trajectory import TrajectoryRecord
from ..schema.manifest import Manifest
from .beams import DrawnBeam

# half width against the extent of the longest cable
THICKNESS = 1 / 250


def cables(motion: TrajectoryRecord) -> list[DrawnBeam]:
    """The cables of a motion as thin round beams."""
    lines = {}
    for name, elements in elements_of(motion.manifest).items():
        frames = [elements[0].frames["a"], *(element.frames["b"] for element in elements)]
        lines[name] = np.stack([motion.pose(frame)[:, :3, 3] for frame in frames], axis=1)
    extents = [float(np.ptp(line[0], axis=0).max()) for line in lines.values()]
    radius = THICKNESS * (max(extents, default=0.0) or 1.0)
    return [
        DrawnBeam(name, _sections(line), (radius, radius), is_round=True)
        for name, line in lines.items()
    ]


def cable_nodes(manifest: Manifest) -> set[str]:
    """Bodies that are nodes inside cables, which their lines show."""
    bodies = {row.name: row.body for row in manifest.frames}
    parts = {row.name: row.parts for row in manifest.bodies}
    inner = {
        bodies[element.frames["b"]]
        for elements in elements_of(manifest).values()
        for element in elements[:-1]
    }
    return {body for body in inner if list(parts.get(body, ())) == [body]}


def _sections(line: Array) -> Array:
    """Transforms (nt, n, 4, 4) along a line (nt, n, 3), x along it."""
    along = np.gradient(line, axis=1)
    size = np.linalg.norm(along, axis=-1, keepdims=True)
    along = np.where(size > 0, along / np.where(size > 0, size, 1.0), [1.0, 0.0, 0.0])
    # the axis that the line comes least near to: of lines in a plane, its normal if that is one
    across = np.eye(3)[int(np.argmin(np.abs(along).max(axis=(0, 1))))]
    e3 = across - along * (along @ across)[..., None]
    e3 /= np.maximum(np.linalg.norm(e3, axis=-1, keepdims=True), 1e-12)
    sections = np.zeros((*line.shape[:2], 4, 4))
    sections[..., :3, 0], sections[..., :3, 2] = along, e3
    sections[..., :3, 1] = np.cross(e3, along)
    sections[..., :3, 3], sections[..., 3, 3] = line, 1.0
    return sections
