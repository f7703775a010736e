"""What carries a mechanism: pins and rails on the ground, clamped ends of beams."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from ..arrays import Array
from ..records import dataclass
from ..runtime.trajectory.trajectory import TrajectoryRecord
from .beams import DrawnBeam
from .solids import RAIL, REVOLUTE, UNLINKED, DrawnBody, link_radius


@dataclass(frozen=True)
class Support:
    """A place where the ground holds something.

    Attributes:
        kind: ``"pin"``, ``"rail"`` or ``"clamp"``.
        at: Its position (3,).
        axis: Of the pin or rail; of a clamp, out of the ground along the beam (3,).
        radius: Of the links or the beam that it holds [m].
        travel: How far a slider goes along a rail from ``at``, backward and forward [m].
    """

    kind: str
    at: Array
    axis: Array
    radius: float
    travel: tuple[float, float] = (0.0, 0.0)


def supports(
    motion: TrajectoryRecord, bodies: Sequence[DrawnBody], drawn_beams: Sequence[DrawnBeam]
) -> list[Support]:
    """Supports of a scene; none where the ground has shapes of its own or joints without axes."""
    manifest = motion.manifest
    owners = {row.name: row.body for row in manifest.frames}
    if any(owners.get(shape.frame) == "ground" for shape in manifest.shapes):
        return []
    if manifest.absolute:
        return list(_clamps(motion, drawn_beams, owners))
    rows = [*_of_tree(motion, bodies), *_of_cuts(motion, bodies, owners)]
    # links between all of them are drawn where some have no axis
    if any(row is None and linked for row, linked in rows):
        return []
    # shapes of the user show how they are held, but not how far they slide
    return [row for row, linked in rows if row and (linked or row.kind == "rail")]


def _of_tree(
    motion: TrajectoryRecord, bodies: Sequence[DrawnBody]
) -> Iterator[tuple[Support | None, bool]]:
    axes, radius = np.reshape(motion.scene["axis"], (-1, 3)), link_radius(motion)
    drawn = {body.name: body for body in bodies}
    for k, row in enumerate(motion.manifest.joints):
        if row.parent == "ground" and row.child in drawn and row.kind not in UNLINKED:
            body = drawn[row.child]
            yield _support(row.kind, body.poses, axes[k], radius), _linked(body)


def _of_cuts(
    motion: TrajectoryRecord, bodies: Sequence[DrawnBody], owners: dict[str, str]
) -> Iterator[tuple[Support | None, bool]]:
    axes, radius = np.reshape(motion.scene.get("cut_axis", ()), (-1, 3)), link_radius(motion)
    drawn = {body.name: body for body in bodies}
    for k, row in enumerate(motion.manifest.cuts):
        moving = [f for f in (row.parent_frame, row.child_frame) if owners.get(f) != "ground"]
        if len(moving) == 1 and owners.get(moving[0]) in drawn:
            poses = motion.pose(moving[0])
            axis = poses[0, :3, :3].T @ motion.pose(row.child_frame)[0, :3, :3] @ axes[k]
            yield _support(row.kind, poses, axis, radius), _linked(drawn[owners[moving[0]]])


def _linked(body: DrawnBody) -> bool:
    """True if a body has no shapes of the user, and is drawn as links."""
    return body.solids is body.fallback


def _support(kind: str, poses: Array, axis: Array, radius: float) -> Support | None:
    """Of a joint, from poses (nt, 4, 4) of a frame there and its axis in this frame."""
    at, along = poses[0, :3, 3], poses[0, :3, :3] @ axis
    length = float(np.linalg.norm(along))
    if kind not in (*REVOLUTE, *RAIL) or not length > 0:
        return None
    offsets = (poses[:, :3, 3] - at) @ (along / length)
    travel = (float(offsets.min()), float(offsets.max())) if kind in RAIL else (0.0, 0.0)
    return Support("rail" if kind in RAIL else "pin", at, along / length, radius, travel)


def _clamps(
    motion: TrajectoryRecord, drawn_beams: Sequence[DrawnBeam], owners: dict[str, str]
) -> Iterator[Support]:
    drawn = {beam.name: beam for beam in drawn_beams}
    for row in motion.manifest.beams:
        beam = drawn.get(row.name)
        for end, sign, frame in ((0, 1.0, row.start), (-1, -1.0, row.end)):
            if beam is not None and owners.get(frame) == "ground":
                section = beam.sections[0, end]
                yield Support("clamp", section[:3, 3], sign * section[:3, 0], beam.radius)
