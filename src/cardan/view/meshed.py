"""Drawing of a motion in finite-element coordinates: beams as tubes, and bodies."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..runtime.trajectory.frame_history import inverse
from ..runtime.trajectory.trajectory import TrajectoryRecord
from ..schema.mechanism import ShapeRow
from .scene import SOLIDS, THICK, link, solid

# points of one beam in one picture; numbers of all beams in all pictures
MOST_POINTS, MOST_NUMBERS = 60, 3_000_000
# least radius of a tube against the size of what is drawn
THIN = 1 / 400


def tubes(motion: TrajectoryRecord) -> list[dict[str, object]]:
    """Beams as tubes: name, radius, and the points of the line in every picture (nt, 3 n)."""
    rows = {row.name: row for row in motion.manifest.beams}
    if not rows:
        return []
    lines = {name: motion.line(name) for name in rows}
    ends = np.concatenate([line[0] for line in lines.values()])
    least = THIN * float(np.ptp(ends, axis=0).max())
    room = MOST_NUMBERS // (3 * len(motion) * len(lines))
    drawn = []
    for name, line in lines.items():
        count = int(np.clip(room, 2, min(MOST_POINTS, line.shape[1])))
        chosen = np.unique(np.linspace(0, line.shape[1] - 1, count).round().astype(int))
        points = np.round(line[:, chosen].reshape(len(motion), -1), 5).tolist()
        e2, e3, _ = rows[name].outline
        drawn.append({"name": name, "r": max((e2 + e3) / 2, least), "path": points})
    return drawn


def drawing(motion: TrajectoryRecord) -> dict[str, object]:
    """Everything the page needs to know, as :func:`.scene.drawing` says it, and ``beams``."""
    manifest, lines = motion.manifest, tubes(motion)
    nodes = {end for row in manifest.beams for end in (row.start, row.end)}
    frames: dict[str, list[str]] = {}
    for row in manifest.frames:
        frames.setdefault(row.body, []).append(row.name)
    shapes: dict[str, list[ShapeRow]] = {}
    for shape in manifest.shapes:
        if shape.kind in SOLIDS:
            shapes.setdefault(shape.frame, []).append(shape)
    bodies = []
    for body in manifest.bodies:
        name, frame_names = body.name, frames[body.name]
        pose = motion.pose(frame_names[0])
        places = {frame: inverse(pose[0]) @ motion.pose(frame)[0] for frame in frame_names}
        # a node of beams with nothing on it is drawn with its beams
        bare = all(np.linalg.norm(place[:3, 3]) < 1e-9 for place in places.values())
        if bare and body.parts == [name] and name in nodes:
            continue
        solids = [solid(row, places[f]) for f in frame_names for row in shapes.get(f, ())]
        flat = np.concatenate([pose[:, :3, :3].reshape(-1, 9), pose[:, :3, 3]], axis=1)
        bodies.append(
            {"name": name, "solids": solids, "arms": places, "pose": np.round(flat, 5).tolist()}
        )
    ground = [
        solid(row, motion.pose(f)[0]) for f in frames.get("ground", ()) for row in shapes.get(f, ())
    ]
    _without_shapes(bodies, lines)
    return {"name": manifest.name, "bodies": bodies, "ground": ground, "beams": lines}


def _without_shapes(bodies: list[dict[str, Any]], lines: list[dict[str, Any]]) -> None:
    """Bodies without shapes: a ball at the origin, links from there to the other frames."""
    lengths = [float(np.linalg.norm(p[:3, 3])) for body in bodies for p in body["arms"].values()]
    lengths = [length for length in lengths if length > 0]
    radius = THICK * float(np.mean(lengths)) if lengths else 0.02
    # balls must show beside the beams that they hang on
    radius = max([radius, *(1.5 * line["r"] for line in lines)])
    for body in bodies:
        arms = [place[:3, 3] for place in body.pop("arms").values()]
        if not body["solids"]:
            ball = {"kind": "sphere", "a": [0.0, 0.0, 0.0], "r": 1.15 * radius, "color": None}
            links = [link(np.zeros(3), arm, radius) for arm in arms if np.linalg.norm(arm) > 0]
            body["solids"] = [ball, *links]
