"""Springs and dampers of unit length along z, and the rotations that carry z along a line."""

from __future__ import annotations

import numpy as np

from ...arrays import Array
from .tessellation import Triangles, tube, upright

TURNS, AROUND = 9, 7  # of a coil, and corners of its wire
POINTS = 16 * TURNS
WIRE, THIN = 0.16, 0.3  # radius of the wire and of a rod, of that of the coil


def coil(radius: float) -> Triangles:
    """A wire wound around z from 0 to 1."""
    at = np.linspace(0.0, 1.0, POINTS + 1)
    angle = 2 * np.pi * TURNS * at
    # narrow at both ends, where it is held
    wide = radius * np.minimum(1.0, 16 * np.minimum(at, 1 - at))
    line = np.stack([wide * np.cos(angle), wide * np.sin(angle), at], axis=1)
    outward = np.stack([np.cos(angle), np.sin(angle), np.zeros_like(at)], axis=1)
    other = np.tile([0.0, 0.0, 1.0], (len(at), 1))
    corner = 2 * np.pi * np.arange(AROUND) / AROUND
    normals = np.cos(corner)[None, :, None] * outward[:, None]
    normals = normals + np.sin(corner)[None, :, None] * other[:, None]
    vertices = line[:, None] + WIRE * radius * normals
    i, k = (x.ravel() for x in np.mgrid[:POINTS, :AROUND])
    one, two = i * AROUND + k, i * AROUND + (k + 1) % AROUND
    rows = np.concatenate(
        [np.stack([one, one + AROUND, two], 1), np.stack([two, one + AROUND, two + AROUND], 1)]
    )
    return Triangles(vertices.reshape(-1, 3), normals.reshape(-1, 3), rows)


def rod(radius: float) -> Triangles:
    """A rod along z from 0 to 1, which stands for a damper."""
    return tube(np.zeros(3), np.array([0.0, 0.0, 1.0]), THIN * radius, THIN * radius, closed=True)


def aligned(along: Array) -> Array:
    """Rotations (nt, 3, 3) whose last columns are along vectors (nt, 3), without needless turns."""
    lengths = np.linalg.norm(along, axis=1)
    rotations = np.empty((len(along), 3, 3))
    R = upright(along[int(np.argmax(lengths > 0))])
    for k, (vector, length) in enumerate(zip(along, lengths, strict=True)):
        if length > 0:
            z = vector / length
            x = R[:, 0] - z * float(z @ R[:, 0])
            size = float(np.linalg.norm(x))
            # straight through the old x axis: any other across will do
            x = x / size if size > 1e-6 else upright(vector)[:, 0]
            R = np.column_stack([x, np.cross(z, x), z])
        rotations[k] = R
    return rotations
