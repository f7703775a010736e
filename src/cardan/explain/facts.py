"""Facts about equations as plain data, for JSON and for tables."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..codegen import flat_scene, manifest
from ..ir.interpreter import evaluate
from ..schema.fields import dumped
from ..schema.mechanism import FrameRow

if TYPE_CHECKING:
    from ..equations.record import EquationRecord
    from ..topology.system import System

Numbers: TypeAlias = NDArray[np.float64]


def facts(equations: EquationRecord) -> dict[str, Any]:
    """The manifest without functions, with counts and sources."""
    stated = manifest.base(equations, ()).data
    left_out = ("abi", "available", "functions", "scene", "sha256", "shapes")
    data = {key: part for key, part in vars(stated).items() if key not in left_out}
    data["frames"] = frame_rows(equations.system, stated.frames)
    data["operations"] = {
        name: {"total": counts.total, "operators": dict(counts), "blocks": counts.blocks}
        for name, counts in equations.operations.items()
    }
    data["sources"] = list(equations.sources)
    tree: dict[str, Any] = json.loads(dumped(data))
    return tree


def frame_rows(system: System, frames: Sequence[FrameRow]) -> list[dict[str, Any]]:
    """Frames with position (3) and rotation (3, 3) in body axes at the defaults of parameters."""
    return [
        {**vars(frame), "position": p.tolist(), "rotation": r.tolist()}
        for frame, p, r in zip(frames, *poses(system), strict=True)
        # bodies without parts only stand for joints
        if frame.part is not None or frame.body == "ground"
    ]


def poses(system: System) -> tuple[Numbers, Numbers]:
    """Positions (n, 3) and rotations (n, 3, 3) of all frames in axes of their bodies."""
    defaults = [parameter.value for parameter in system.parameters]
    values = evaluate(flat_scene.scene(system), {"p": defaults})
    count = len(system.frames)
    positions = np.reshape(values["frame_position"], (count, 3)).astype(np.float64)
    return positions, np.reshape(values["frame_rotation"], (count, 3, 3)).astype(np.float64)
