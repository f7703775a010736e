"""The data of the plain page, which draws on a 2-D canvas."""

from __future__ import annotations

import json

import numpy as np

from ..arrays import Array
from .drawing import Drawing
from .packing import JsonObject, below_one
from .scene_page import size_of
from .surfaces import DrawnSurface, outline

EDGE, MOST_NUMBERS = 0.002, 300_000  # of edges of surfaces: radius by size, numbers of all edges


def data(drawing: Drawing) -> str:
    """A drawing as JSON: bodies as solids with poses (nt, 12), beams and edges as tubes."""
    decimals = 5 + below_one(size_of(drawing))
    t = drawing.abscissa.values
    bodies = [
        {
            "name": body.name,
            "solids": [s for s in body.solids if s["kind"] != "mesh"] or body.fallback,
            "pose": _rows(body.poses, decimals),
        }
        for body in drawing.bodies
    ]
    tubes = []
    for beam in drawing.beams:
        places = beam.sections[:, :, :3, 3].reshape(len(beam.sections), -1)
        tubes.append(
            {"name": beam.name, "r": beam.radius, "path": np.round(places, decimals).tolist()}
        )
    tubes += [edge for one in drawing.surfaces for edge in _edges(one, drawing, decimals)]
    contents = {
        "t": np.round(t, 6 + below_one(float(np.ptp(t)))).tolist(),
        "name": drawing.name,
        "bodies": bodies,
        "ground": [s for s in drawing.ground if s["kind"] != "mesh"],
        "beams": tubes,
    }
    return json.dumps(contents, separators=(",", ":"), allow_nan=False)


def _edges(one: DrawnSurface, drawing: Drawing, decimals: int) -> list[JsonObject]:
    """The longest edges of a surface as thin tubes."""
    edges = outline(one.points, one.triangles) if len(one.triangles) else one.lines
    lengths = np.linalg.norm(np.diff(one.points[edges], axis=1)[:, 0], axis=1)
    rows = range(len(one.amplitudes))
    chosen = edges[np.argsort(-lengths, kind="stable")[: max(12, MOST_NUMBERS // (6 * len(rows)))]]
    ends = np.array([one.places(row, chosen.ravel()) for row in rows]).reshape(len(rows), -1, 6)
    radius = EDGE * size_of(drawing)
    return [
        {"name": one.name, "r": radius, "path": np.round(path, decimals).tolist()}
        for path in ends.transpose(1, 0, 2)
    ]


def _rows(poses: Array, decimals: int) -> list[list[float]]:
    """Rotations row by row, then positions to so many decimals."""
    rotations = np.round(poses[:, :3, :3].reshape(-1, 9), 5)
    rows: list[list[float]] = np.concatenate(
        [rotations, np.round(poses[:, :3, 3], decimals)], axis=1
    ).tolist()
    return rows
