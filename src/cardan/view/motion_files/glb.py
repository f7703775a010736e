"""Animated glTF (``.glb``): for Blender, three.js, office programs and the like."""

from __future__ import annotations

from pathlib import Path

from ...runtime.trajectory.trajectory import TrajectoryRecord
from ..gltf.scene import content
from .motion_format import MotionFormat


def _written(motion: TrajectoryRecord, path: Path) -> None:
    path.write_bytes(content(motion))


GLB = MotionFormat("animated glTF", (".glb",), _written)
