"""Surfaces that deform: points which move by shapes, with triangles or lines between them.

Those of superelements in motion also go with their frame.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np

from ..arrays import Array, Integers
from ..records import dataclass
from ..runtime.models.finite_elements.superelements import (
    DeformedSuperelementRecord,
    superelement_of_run,
)
from ..runtime.trajectory.trajectory import TrajectoryRecord
from ..superelements.stress_recovery import von_mises

DISPLACEMENT, VON_MISES = "displacement", "stress"  # what colors a surface
NAMES = {DISPLACEMENT: "displacement", VON_MISES: "von Mises stress"}
SHARP = 0.85  # cosine of the angle between triangles beyond which their common edge is drawn


@dataclass(frozen=True, eq=False)
class DrawnSurface:
    """A surface of a picture: in row i, points stand at ``points`` + ``amplitudes[i]`` of shapes.

    That is in axes which move by ``poses``.

    Attributes:
        name: Of what it belongs to.
        points: Undeformed (points, 3) [m].
        triangles, lines: Between the points (triangles, 3), (lines, 2).
        outline: Lines that show the undeformed surface (edges, 2).
        shapes: Displacements by amplitudes of 1 (shapes, points, 3) [m].
        amplitudes: Of the shapes (nt, shapes).
        kind: What colors it, ``DISPLACEMENT`` or ``VON_MISES``; None for nothing.
        stressed: Points whose stress is known (k,).
        stresses: Their stress by amplitudes of 1 (shapes, k, 6) [Pa].
        poses: Transforms (nt, 4, 4) of its axes to those of the ground; None where they stay.
    """

    name: str
    points: Array
    triangles: Integers
    lines: Integers
    outline: Integers
    shapes: Array
    amplitudes: Array
    kind: str | None
    stressed: Integers
    stresses: Array
    poses: Array | None = None

    @property
    def colored_by(self) -> str:
        """What colors it, for people."""
        return NAMES.get(self.kind or "", "")

    def displacements(self, row: int) -> Array:
        """Displacements of the points (points, 3) [m]."""
        moved: Array = np.tensordot(self.amplitudes[row], self.shapes, 1)
        return moved

    def places(self, row: int, points: Integers | None = None, deformed: bool = True) -> Array:
        """Positions of points (points, 3) [m], of all by default, in ground axes.

        Args:
            row: Of the motion.
            points: Which ones.
            deformed: Whether shapes move them.
        """
        chosen = slice(None) if points is None else points
        local = self.points[chosen]
        if deformed:
            local = local + np.tensordot(self.amplitudes[row], self.shapes[:, chosen], 1)
        if self.poses is None:
            return np.asarray(local)
        pose = self.poses[row]
        return np.asarray(local @ pose[:3, :3].T + pose[:3, 3])

    def values(self, row: int) -> Array:
        """What colors the points (points,), NaN where it is not known."""
        if self.kind != VON_MISES:
            return np.asarray(np.linalg.norm(self.displacements(row), axis=1))
        values = np.full(len(self.points), np.nan)
        values[self.stressed] = von_mises(np.tensordot(self.amplitudes[row], self.stresses, 1))
        return values

    @cached_property
    def largest(self) -> float:
        """Largest value that colors a point; 1 where all are 0."""
        rows = range(len(self.amplitudes))
        if self.amplitudes.shape[1] == 1:
            # of one shape that where it is largest
            rows = range(k := int(np.argmax(np.abs(self.amplitudes[:, 0]))), k + 1)
        return max(float(np.nanmax(self.values(row), initial=0.0)) for row in rows) or 1.0


def surfaces(motion: TrajectoryRecord, kind: str | None) -> list[DrawnSurface]:
    """The surfaces of the superelements of a motion.

    Args:
        motion: The motion.
        kind: What colors them; superelements without stress stay as they are where it is stress.
    """
    rows = motion.manifest.superelements
    return [drawn_surface(superelement_of_run(motion, row.name), kind) for row in rows]


def drawn_surface(deformed: DeformedSuperelementRecord, kind: str | None) -> DrawnSurface:
    """A superelement of a motion; a color that it has not is left out."""
    surface = deformed.surface
    stressed = kind == VON_MISES and len(surface.stressed) > 0
    count = len(surface.stressed) if stressed else 0
    return DrawnSurface(
        name=deformed.name,
        points=surface.points,
        triangles=surface.triangles,
        lines=surface.lines,
        outline=np.zeros((0, 2), np.intp),
        shapes=surface.shapes,
        amplitudes=deformed.amplitudes,
        kind=kind if stressed or kind == DISPLACEMENT else None,
        stressed=surface.stressed[:count],
        stresses=surface.stresses[:, :count],
        poses=deformed.pose,
    )


def outline(points: Array, triangles: Integers) -> Integers:
    """Edges (k, 2) where triangles meet at an angle, or that one triangle has alone."""
    if not len(triangles):
        return np.zeros((0, 2), np.intp)
    a, b, c = points[triangles].transpose(1, 0, 2)
    normals = np.cross(b - a, c - a)
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    edges = np.concatenate([triangles[:, pair] for pair in ([0, 1], [1, 2], [2, 0])])
    owner = np.tile(np.arange(len(triangles)), 3)
    ends, number, count = np.unique(
        np.sort(edges, axis=1), axis=0, return_inverse=True, return_counts=True
    )
    order = np.argsort(number.ravel(), kind="stable")
    first = np.cumsum(count) - count
    one, other = owner[order[first]], owner[order[first + count - 1]]
    angle = np.einsum("ij,ij->i", normals[one], normals[other])
    chosen: Integers = ends[(count != 2) | (angle < SHARP)]
    return chosen
