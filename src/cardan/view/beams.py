"""Motions in finite-element coordinates: beams along their sections, and bodies on their nodes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ..arrays import Array
from ..errors import ModelError
from ..records import dataclass
from ..runtime.models.finite_elements.beams import at_nodes, beam
from ..runtime.trajectory.frame_history import inverse
from ..runtime.trajectory.trajectory import TrajectoryRecord
from ..schema.mechanism import ShapeRow
from .solids import THICK, DrawnBody, Solid, link, solid

# sections of one beam; numbers of all beams in all pictures
MOST_SECTIONS, MOST_NUMBERS = 80, 3_000_000
# least half width against the size of what is drawn
THIN = 1 / 400
STRESS, STRAIN = "largest normal stress", "largest normal strain"


@dataclass(frozen=True)
class DrawnBeam:
    """A beam of a picture.

    Attributes:
        name: Of the beam.
        sections: Transforms (nt, n, 4, 4) of its sections to ground axes, x along the beam.
        half_widths: Of a section along y and z [m].
        is_round: Whether the section is round.
        contour: Corners of a section (y, z) [m] that is neither round nor a rectangle.
        values: What colors it (nt, n), None where nothing does.
        colored_by: What the values are.
    """

    name: str
    sections: Array
    half_widths: tuple[float, float]
    is_round: bool
    contour: tuple[tuple[float, float], ...] = ()
    values: Array | None = None
    colored_by: str = STRESS

    @property
    def radius(self) -> float:
        """Mean half width [m]."""
        return sum(self.half_widths) / 2


def beams(motion: TrajectoryRecord, colored_by: str | None = None) -> list[DrawnBeam]:
    """The beams of a motion, each at some of its sections; colors as of :func:`.solids_of`."""
    rows = {row.name: row for row in motion.manifest.beams}
    if not rows:
        return []
    sections = {name: motion.sections(name) for name in rows}
    ends = np.concatenate([each[0, :, :3, 3] for each in sections.values()])
    least = THIN * float(np.ptp(ends, axis=0).max())
    room = MOST_NUMBERS // (7 * len(motion) * len(sections))
    drawn = []
    for name, each in sections.items():
        count = int(np.clip(room, 2, min(MOST_SECTIONS, each.shape[1])))
        chosen = np.unique(np.linspace(0, each.shape[1] - 1, count).round().astype(int))
        e2, e3, is_round = rows[name].outline
        values, what = _values(motion, name, colored_by)
        drawn.append(
            DrawnBeam(
                name,
                each[:, chosen],
                (max(e2, least), max(e3, least)),
                bool(is_round),
                tuple(rows[name].contour),
                None if values is None else values[:, chosen],
                what,
            )
        )
    return drawn


def _values(
    motion: TrajectoryRecord, name: str, colored_by: str | None
) -> tuple[Array | None, str]:
    """Largest normal stress or strain at every node of a beam (nt, n).

    Without a wish it is stress, or strain where E is not known, or None.

    Raises:
        ModelError: what is wished for is not known.
    """
    if colored_by == "displacement":
        return None, STRESS
    if colored_by:
        motion._model(f"the {colored_by} of beam '{name}'")
    elif motion.model is None:
        return None, STRESS
    stress = beam(motion._model("stress"), name, motion.q)
    has_modulus, has_outline = stress.modulus is not None, any(stress.outline[:2])
    if colored_by == "stress" and not has_modulus:
        raise ModelError(
            f"show='stress': the section of beam '{name}' has no Young's modulus; take 'strain'"
        )
    if not has_modulus and not has_outline:
        if colored_by:
            raise ModelError(f"show='strain': the section of beam '{name}' has no outline")
        return None, STRAIN
    by_stress = has_modulus and colored_by != "strain"
    if by_stress:
        return stress.extreme_at_nodes, STRESS
    return at_nodes(stress.extreme_strain), STRAIN


def bodies(
    motion: TrajectoryRecord, drawn_beams: Sequence[DrawnBeam]
) -> tuple[list[DrawnBody], list[Solid]]:
    """Bodies on nodes, as :func:`.solids.bodies`."""
    manifest = motion.manifest
    # superelements are drawn by their surfaces
    hidden = {body for row in manifest.superelements for body in row.bodies}
    undeformed = {frame for row in manifest.superelements for frame in row.undeformed}
    nodes = {end for row in manifest.beams for end in (row.start, row.end)}
    frames: dict[str, list[str]] = {}
    for row in manifest.frames:
        if row.name not in undeformed:
            frames.setdefault(row.body, []).append(row.name)
    shapes: dict[str, list[ShapeRow]] = {}
    for shape in manifest.shapes:
        shapes.setdefault(shape.frame, []).append(shape)
    drawn, arms = [], []
    for body in manifest.bodies:
        if hidden.issuperset(body.parts):
            continue
        name, frame_names = body.name, frames[body.name]
        pose = motion.pose(frame_names[0])
        places = {frame: inverse(pose[0]) @ motion.pose(frame)[0] for frame in frame_names}
        # a node of beams with nothing on it is drawn with its beams
        is_node = all(np.linalg.norm(place[:3, 3]) < 1e-9 for place in places.values())
        if is_node and body.parts == [name] and name in nodes:
            continue
        solids = [solid(row, places[f]) for f in frame_names for row in shapes.get(f, ())]
        drawn.append(DrawnBody(name, solids, [], pose))
        arms.append([place[:3, 3] for place in places.values()])
    ground = [
        solid(row, motion.pose(f)[0]) for f in frames.get("ground", ()) for row in shapes.get(f, ())
    ]
    complete = [
        replace(one, solids=one.solids or fallback, fallback=fallback)
        for one, fallback in zip(drawn, _fallbacks(arms, drawn_beams), strict=True)
    ]
    return complete, ground


def _fallbacks(
    arms: Sequence[Sequence[Array]], drawn_beams: Sequence[DrawnBeam]
) -> list[list[Solid]]:
    """Bodies without shapes: a ball at the origin, links from there to the other frames.

    Args:
        arms: Positions of the frames of every body, in its axes.
        drawn_beams: Balls must show beside the beams that they hang on.
    """
    lengths = [float(np.linalg.norm(arm)) for row in arms for arm in row]
    lengths = [length for length in lengths if length > 0]
    radius = THICK * float(np.mean(lengths)) if lengths else 0.02
    radius = max([radius, *(1.5 * beam.radius for beam in drawn_beams)])
    ball = {"kind": "sphere", "a": [0.0, 0.0, 0.0], "r": 1.15 * radius, "color": None}
    return [
        [ball, *(link(np.zeros(3), arm, radius) for arm in row if np.linalg.norm(arm) > 0)]
        for row in arms
    ]
