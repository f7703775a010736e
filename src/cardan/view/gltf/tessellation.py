"""Solids as triangles with normals."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from ...arrays import Array, Integers
from ...records import dataclass
from ..mesh_files.part import Part
from ..solids import Solid

AROUND, ALONG = 32, 16  # facets of round solids
SHARP = 0.825  # cosine of the angle between triangles beyond which they meet in an edge
MOST_AROUND = 64  # triangles at one vertex that smooth it


@dataclass(frozen=True)
class Triangles:
    """Triangles of a surface.

    Attributes:
        vertices, normals: (n, 3) each.
        triangles: Rows of vertices (m, 3), counterclockwise seen from outside.
    """

    vertices: Array
    normals: Array
    triangles: Integers


def joined(parts: Sequence[Triangles]) -> Triangles:
    """All triangles of some surfaces."""
    starts = np.cumsum([0, *(len(part.vertices) for part in parts[:-1])])
    return Triangles(
        np.concatenate([part.vertices for part in parts]),
        np.concatenate([part.normals for part in parts]),
        np.concatenate([part.triangles + k for part, k in zip(parts, starts, strict=True)]),
    )


def of_solid(solid: Solid) -> Triangles:
    """A solid of a drawing other than a mesh, in the axes of its body."""
    return MAKERS[solid["kind"]](solid)


def of_mesh(part: Part, solid: Solid) -> Triangles:
    """A part of a mesh file, where a solid puts it."""
    R, at = np.reshape(solid["R"], (3, 3)), np.asarray(solid["a"], dtype=np.float64)
    scale = np.asarray(solid["scale"], dtype=np.float64)
    vertices = (part.vertices.astype(np.float64) * scale) @ R.T + at
    rows = part.triangles.astype(np.intp)
    # a mirrored surface is seen from its other side
    return smoothed(vertices, rows if np.prod(scale) > 0 else rows[:, ::-1])[0]


def smoothed(vertices: Array, rows: Integers) -> tuple[Triangles, Integers]:
    """Triangles with a normal at every corner: of all triangles there that meet smoothly.

    Returns:
        The triangles, and which of the vertices each of theirs is.
    """
    a, b, c = (vertices[rows[:, k]] for k in range(3))
    across = np.cross(b - a, c - a)
    flat = across / np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-300)
    # corners in the order of their vertices; each looks at those around
    corner = np.argsort(rows.ravel(), kind="stable")
    vertex = rows.ravel()[corner]
    triangle = corner // 3
    total = across[triangle].copy()
    for step in range(1, MOST_AROUND):
        near = np.flatnonzero(vertex[step:] == vertex[:-step])
        if not len(near):
            break
        one, other = near, near + step
        smooth = np.einsum("ij,ij->i", flat[triangle[one]], flat[triangle[other]]) > SHARP
        one, other = one[smooth], other[smooth]
        np.add.at(total, one, across[triangle[other]])
        np.add.at(total, other, across[triangle[one]])
    normals = total / np.maximum(np.linalg.norm(total, axis=1, keepdims=True), 1e-300)
    # corners of one vertex with one normal are one
    steps = np.rint(normals * 1000).astype(np.int64) + 1001
    keys = ((vertex * 2003 + steps[:, 0]) * 2003 + steps[:, 1]) * 2003 + steps[:, 2]
    _, first, number = np.unique(keys, return_index=True, return_inverse=True)
    new_rows = np.empty(len(corner), dtype=np.intp)
    new_rows[corner] = number.ravel()
    surface = Triangles(vertices[vertex[first]], normals[first], new_rows.reshape(-1, 3))
    return surface, vertex[first]


def tube(a: Array, b: Array, start: float, end: float, closed: bool) -> Triangles:
    """A cylinder or cone from a to b by the radii there; with flat ends where it is closed."""
    along = b - a
    length = float(np.linalg.norm(along))
    frame = upright(along)
    angle = 2 * np.pi * np.arange(AROUND) / AROUND
    ring = np.stack([np.cos(angle), np.sin(angle), np.zeros(AROUND)], axis=1)
    slope = np.stack([ring[:, 0], ring[:, 1], np.full(AROUND, (start - end) / (length or 1))], 1)
    slope /= np.linalg.norm(slope, axis=1, keepdims=True)
    up = np.array([0.0, 0.0, 1.0])
    vertices, normals = [start * ring, end * ring + length * up], [slope, slope]
    k, more = np.arange(AROUND), np.roll(np.arange(AROUND), -1)
    rows = [np.stack([k, more, AROUND + more], 1), np.stack([k, AROUND + more, AROUND + k], 1)]
    if closed:
        vertices += [start * ring, end * ring + length * up]
        normals += [np.tile(-up, (AROUND, 1)), np.tile(up, (AROUND, 1))]
        fan = np.stack([np.zeros(AROUND - 2, np.intp), k[1:-1], k[2:]], 1)
        rows += [fan[:, ::-1] + 2 * AROUND, fan + 3 * AROUND]
    points, directions = np.concatenate(vertices), np.concatenate(normals)
    return Triangles(points @ frame.T + a, directions @ frame.T, np.concatenate(rows))


def ball(center: Array, radius: float) -> Triangles:
    """A sphere."""
    latitude = np.pi * np.arange(ALONG + 1) / ALONG
    angle = 2 * np.pi * np.arange(AROUND + 1) / AROUND
    normals = np.stack(
        [
            np.outer(np.sin(latitude), np.cos(angle)),
            np.outer(np.sin(latitude), np.sin(angle)),
            np.outer(np.cos(latitude), np.ones(AROUND + 1)),
        ],
        axis=-1,
    ).reshape(-1, 3)
    i, k = (x.ravel() for x in np.mgrid[:ALONG, :AROUND])
    corner = i * (AROUND + 1) + k
    below = corner + AROUND + 1
    # at the poles one of the two has no area
    upper = np.stack([corner, below, corner + 1], 1)[i > 0]
    lower = np.stack([corner + 1, below, below + 1], 1)[i < ALONG - 1]
    return Triangles(center + radius * normals, normals, np.concatenate([upper, lower]))


def box(size: Array, R: Array, at: Array) -> Triangles:
    """A box with its center at a place."""
    vertices, normals, rows = list[Array](), list[Array](), list[list[list[int]]]()
    for axis in range(3):
        for sign in (1.0, -1.0):
            normal = np.zeros(3)
            normal[axis] = sign
            one, other = np.eye(3)[(axis + 1) % 3], np.eye(3)[(axis + 2) % 3]
            corners = [normal + y * one + z * other for y, z in SQUARE[:: int(sign)]]
            start = 4 * len(rows)
            vertices += corners
            normals += [normal] * 4
            rows.append([[start, start + 1, start + 2], [start, start + 2, start + 3]])
    points = np.array(vertices) * np.asarray(size, dtype=np.float64) / 2
    return Triangles(points @ R.T + at, np.array(normals) @ R.T, np.concatenate(rows))


SQUARE = ((-1, -1), (1, -1), (1, 1), (-1, 1))


def upright(along: Array) -> Array:
    """A rotation (3, 3) whose last column is a direction; the identity where it has no length."""
    length = float(np.linalg.norm(along))
    if not length > 0:
        return np.eye(3)
    z = along / length
    x = np.eye(3)[int(np.argmin(np.abs(z)))]
    x = x - z * float(z @ x)
    x /= np.linalg.norm(x)
    return np.column_stack([x, np.cross(z, x), z])


def _vector(numbers: object) -> Array:
    return np.asarray(numbers, dtype=np.float64)


def _sphere(solid: Solid) -> Triangles:
    return ball(_vector(solid["a"]), solid["r"])


def _box(solid: Solid) -> Triangles:
    return box(_vector(solid["size"]), _vector(solid["R"]).reshape(3, 3), _vector(solid["a"]))


def _cylinder(solid: Solid) -> Triangles:
    r = float(solid["r"])
    return tube(_vector(solid["a"]), _vector(solid["b"]), r, r, closed=True)


def _link(solid: Solid) -> Triangles:
    """A rod that may get thinner, between balls."""
    a, b, r = _vector(solid["a"]), _vector(solid["b"]), float(solid["r"])
    end = float(solid.get("end", r))
    parts = [ball(a, 1.3 * r if solid.get("joint") else r), ball(b, end)]
    if np.linalg.norm(b - a) > 0:
        parts.append(tube(a, b, r, end, closed=False))
    return joined(parts)


MAKERS: Mapping[str, Callable[[Solid], Triangles]] = {
    "sphere": _sphere,
    "box": _box,
    "cylinder": _cylinder,
    "link": _link,
}
