"""The data of the plain page, which draws on a 2-D canvas."""

from __future__ import annotations

import json

import numpy as np

from ..arrays import Array
from .drawing import Drawing


def data(drawing: Drawing) -> str:
    """A drawing as JSON: bodies as solids with poses (nt, 12), beams as tubes."""
    bodies = [
        {
            "name": body.name,
            "solids": [s for s in body.solids if s["kind"] != "mesh"] or body.fallback,
            "pose": _rows(body.poses),
        }
        for body in drawing.bodies
    ]
    tubes = []
    for beam in drawing.beams:
        places = beam.sections[:, :, :3, 3].reshape(len(beam.sections), -1)
        tubes.append({"name": beam.name, "r": beam.radius, "path": np.round(places, 5).tolist()})
    contents = {
        "t": np.round(drawing.abscissa.values, 6).tolist(),
        "name": drawing.name,
        "bodies": bodies,
        "ground": [s for s in drawing.ground if s["kind"] != "mesh"],
        "beams": tubes,
    }
    return json.dumps(contents, separators=(",", ":"), allow_nan=False)


def _rows(poses: Array) -> list[list[float]]:
    """Rotations row by row, then positions."""
    flat = np.concatenate([poses[:, :3, :3].reshape(-1, 9), poses[:, :3, 3]], axis=1)
    rows: list[list[float]] = np.round(flat, 5).tolist()
    return rows
