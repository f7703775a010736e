"""Beams as skins: vertices that go with the two sections next to them.

In between, the parts of both change so that the line leaves each section at a right angle, as that
of a beam without shear does.

Source: Khronos Group, glTF 2.0 Specification, section 3.7.3 (skins).
"""

from __future__ import annotations

import numpy as np

from ...arrays import Array, Integers
from ...records import dataclass
from ..beams import DrawnBeam
from .tessellation import Triangles

ROUND = 24  # corners of a round section
FINE = 64  # pieces of a beam, at least


@dataclass(frozen=True)
class Skin:
    """A surface over joints.

    Attributes:
        surface: Where it stands at the start, with y upward.
        joints, weights: Of every vertex (n, 4): numbers of sections, and their parts.
        inverses: Inverse transforms of the sections there (sections, 4, 4).
    """

    surface: Triangles
    joints: Integers
    weights: Array
    inverses: Array


def skinned(beam: DrawnBeam, upward: Array) -> Skin:
    """The skin of a beam.

    Args:
        beam: The beam.
        upward: Rotation (3, 3) from axes of the scene to those of the file.
    """
    sections = beam.sections[0].copy()
    sections[:, :3] = upward @ sections[:, :3]
    intervals = len(sections) - 1
    at = np.linspace(0.0, intervals, intervals * -(-FINE // intervals) + 1)
    first = np.minimum(at.astype(np.intp), intervals - 1)
    x = at - first
    weight = x * x * (3 - 2 * x)
    ahead = np.linalg.norm(np.diff(sections[:, :3, 3], axis=0), axis=1)[first]
    outline, across = _outline(beam)

    def on_sections(rows: Array, along: float, after: Array, before: Array) -> Array:
        """Rows (m, 2) of every ring (n, m, 3), as the sections before and behind carry them."""
        total = np.zeros((len(at), len(rows), 3))
        for section, share, shift in ((first, 1 - weight, after), (first + 1, weight, before)):
            local = np.concatenate([np.zeros((len(rows), 1)), rows], axis=1)
            T = sections[section]
            there = np.einsum("nij,mj->nmi", T[:, :3, :3], local)
            there += along * (T[:, None, :3, 3] + (shift[:, None] * T[:, :3, 0])[:, None])
            total += share[:, None, None] * there
        return total

    rings = on_sections(outline, 1.0, x * ahead, (x - 1) * ahead)
    normals = on_sections(across, 0.0, x, x)
    normals /= np.maximum(np.linalg.norm(normals, axis=-1, keepdims=True), 1e-300)
    surface = _closed(rings, normals, sections[[0, -1], :3, 0], step=1 if beam.is_round else 2)
    ring_of = np.concatenate([np.repeat(np.arange(len(at)), len(outline)),
                              np.repeat([0, len(at) - 1], len(outline))])  # fmt: skip
    joints, weights = np.zeros((len(ring_of), 4), np.intp), np.zeros((len(ring_of), 4))
    joints[:, 0], joints[:, 1] = first[ring_of], first[ring_of] + 1
    weights[:, 0], weights[:, 1] = 1 - weight[ring_of], weight[ring_of]
    # no part, no joint
    joints[weights == 0] = 0
    return Skin(surface, joints, weights, np.linalg.inv(sections))


def _outline(beam: DrawnBeam) -> tuple[Array, Array]:
    """Points (m, 2) around a section and normals there; a corner stands twice."""
    y, z = beam.half_widths
    if beam.is_round:
        angle = 2 * np.pi * np.arange(ROUND) / ROUND
        circle = np.stack([np.cos(angle), np.sin(angle)], axis=1)
        across = circle / [y, z]
        return circle * [y, z], across / np.linalg.norm(across, axis=1, keepdims=True)
    corners = np.array(beam.contour or [(y, z), (-y, z), (-y, -z), (y, -z)])
    ahead = np.roll(corners, -1, axis=0)
    edges = ahead - corners
    across = np.stack([edges[:, 1], -edges[:, 0]], axis=1)
    across /= np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-300)
    points = np.stack([corners, ahead], axis=1).reshape(-1, 2)
    return points, np.repeat(across, 2, axis=0)


def _closed(rings: Array, normals: Array, along: Array, step: int) -> Triangles:
    """The surface over rings (n, m, 3), with flat ends.

    Args:
        rings, normals: Of every ring.
        along: Of the beam at both ends (2, 3).
        step: 2 where points stand twice, with an edge from every second one to the next.
    """
    n, m = rings.shape[:2]
    i, k = (grid.ravel() for grid in np.mgrid[: n - 1, 0:m:step])
    one, two = i * m + k, i * m + (k + 1) % m
    rows = [np.stack([one, two, one + m], 1), np.stack([two, two + m, one + m], 1)]
    corner = np.arange(step, m - step, step)
    fan = np.stack([np.zeros_like(corner), corner, corner + step], axis=1)
    rows += [n * m + fan[:, ::-1], (n + 1) * m + fan]
    vertices = np.concatenate([rings.reshape(-1, 3), rings[0], rings[-1]])
    ends = [np.tile(-along[0], (m, 1)), np.tile(along[1], (m, 1))]
    return Triangles(
        vertices, np.concatenate([normals.reshape(-1, 3), *ends]), np.concatenate(rows)
    )
