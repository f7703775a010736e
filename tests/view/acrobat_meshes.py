"""Make the meshes of the acrobat, ``src/cardan/scenes/acrobat``: run it after a change.

A body is a smooth union of ellipsoids and tapered rods, given by its distance field. Where the
field changes sign between points of a grid, surface nets lay quadrilaterals, whose corners are then
moved onto the surface.

Source: S. F. F. Gibson, Constrained elastic surface nets, 1998.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import reduce
from itertools import pairwise
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Field = Callable[[Array], Array]
Point = tuple[float, float, float]
Surface = tuple[Array, list[list[int]]]

FOLDER = Path(__file__).parents[2] / "src" / "cardan" / "scenes" / "acrobat"
CLOTH = 0.004  # thickness [m]
SMOOTHINGS, PROJECTIONS = 6, 3


# distance fields: negative inside


def ellipsoid(center: Point, radii: Point) -> Field:
    def field(p: Array) -> Array:
        scaled = (p - center) / np.array(radii)
        k = np.linalg.norm(scaled, axis=-1)
        slope = np.linalg.norm(scaled / np.array(radii), axis=-1)
        return np.asarray(k * (k - 1) / np.maximum(slope, 1e-9))

    return field


def rod(a: Point, b: Point, start: float, end: float) -> Field:
    """A rod with round ends of two radii."""

    def field(p: Array) -> Array:
        along = np.subtract(b, a)
        k = np.clip((p - a) @ along / (along @ along), 0, 1)
        away = np.linalg.norm(p - a - k[..., None] * along, axis=-1)
        return np.asarray(away - start - k * (end - start))

    return field


def above(normal: Point, height: float) -> Field:
    """The half space in the direction of a normal beyond a height."""
    n = np.array(normal) / np.linalg.norm(normal)
    return lambda p: np.asarray(height - p @ n)


def union(*fields: Field, blend: float) -> Field:
    """All of the fields, with fillets."""

    def smooth(a: Array, b: Array) -> Array:
        h = np.maximum(blend - np.abs(a - b), 0)
        return np.asarray(np.minimum(a, b) - h * h / (4 * blend))

    return lambda p: reduce(smooth, [field(p) for field in fields])


def common(*fields: Field) -> Field:
    return lambda p: np.asarray(np.max([field(p) for field in fields], axis=0))


def outside(field: Field) -> Field:
    return lambda p: -field(p)


def grown(field: Field, by: float) -> Field:
    return lambda p: field(p) - by


def mirrored(field: Field) -> Field:
    """A field and its mirror image in y, from the half with y > 0."""
    return lambda p: field(p * [1, 0, 1] + np.abs(p) * [0, 1, 0])


# surfaces


def surface(field: Field, box: tuple[Point, Point], step: float, *regions: Field) -> Surface:
    """Vertices and polygons, counterclockwise from outside, of what lies in some regions.

    Args:
        field: Of the surface.
        box: Two corners of what is looked through.
        step: Edge of a polygon, about [m].
        regions: What is outside one of them is cut off.
    """
    low, high = box
    axes = [np.arange(a - step, b + 2 * step, step) for a, b in zip(low, high, strict=True)]
    grid = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1)
    inside = field(grid) < 0
    cells = np.stack(
        [
            inside[i : i - 1 or None, j : j - 1 or None, k : k - 1 or None]
            for i in (0, 1)
            for j in (0, 1)
            for k in (0, 1)
        ]
    )
    crossed = cells.any(axis=0) & ~cells.all(axis=0)
    number = np.full(crossed.shape, -1)
    number[crossed] = np.arange(crossed.sum())
    vertices = grid[:-1, :-1, :-1][crossed] + step / 2
    quads = []
    for axis in range(3):
        # edges of the grid along an axis that go through the surface, and the four cells around
        first = np.moveaxis(inside, axis, 0)
        leaves = first[:-1] & ~first[1:]
        enters = ~first[:-1] & first[1:]
        cell = np.moveaxis(number, axis, 0)
        around = np.stack(
            [cell[:, :-1, :-1], cell[:, 1:, :-1], cell[:, 1:, 1:], cell[:, :-1, 1:]], -1
        )
        # of the axes that follow, y before x turns the other way round
        order = -1 if axis == 1 else 1
        quads += [
            around[leaves[:, 1:-1, 1:-1]][:, ::order],
            around[enters[:, 1:-1, 1:-1]][:, ::-order],
        ]
    faces = np.concatenate(quads)
    vertices, polygons = settled(field, vertices, faces, step), faces.tolist()
    for region in regions:
        vertices, polygons = cut(vertices, polygons, region)
    used = sorted({k for polygon in polygons for k in polygon})
    place = {k: i for i, k in enumerate(used)}
    return vertices[used], [[place[k] for k in polygon] for polygon in polygons]


def cut(vertices: Array, polygons: list[list[int]], region: Field) -> Surface:
    """The part of a surface in a region; polygons are cut where the field of that is zero.

    Source: I. E. Sutherland and G. W. Hodgman, Reentrant polygon clipping, 1974.
    """
    height = region(vertices)
    added: dict[tuple[int, int], int] = {}
    points, remaining = list(vertices), []
    for polygon in polygons:
        inner = list[int]()
        for a, b in zip(polygon, [*polygon[1:], polygon[0]], strict=True):
            if height[a] < 0:
                inner.append(a)
            if (height[a] < 0) != (height[b] < 0):
                key = min(a, b), max(a, b)
                if key not in added:
                    added[key] = len(points)
                    points.append(crossing(region, vertices[key[0]], vertices[key[1]]))
                inner.append(added[key])
        if len(inner) > 2:
            remaining.append(inner)
    return np.array(points), remaining


def crossing(region: Field, a: Array, b: Array) -> Array:
    """The point between two others at the border of a region."""
    begins = float(region(a)) < 0
    for _ in range(20):
        middle = (a + b) / 2
        a, b = (middle, b) if (float(region(middle)) < 0) == begins else (a, middle)
    return a


def settled(field: Field, vertices: Array, faces: NDArray[np.intp], step: float) -> Array:
    """Vertices evenly spread and on the surface."""
    for _ in range(SMOOTHINGS):
        sums, counts = np.zeros_like(vertices), np.zeros(len(vertices))
        for a, b in ((0, 1), (1, 2), (2, 3), (3, 0)):
            for one, other in ((a, b), (b, a)):
                np.add.at(sums, faces[:, one], vertices[faces[:, other]])
                np.add.at(counts, faces[:, one], 1)
        vertices = 0.5 * vertices + 0.5 * sums / counts[:, None]
        for _ in range(PROJECTIONS):
            vertices = projected(field, vertices, step)
    return vertices


def projected(field: Field, p: Array, step: float) -> Array:
    """Points one step of Newton's method nearer to the surface."""
    h = 1e-4
    slopes = [(field(p + h * e) - field(p - h * e)) / (2 * h) for e in np.eye(3)]
    gradient = np.stack(slopes, axis=-1)
    size = np.maximum(np.sum(gradient**2, axis=-1), 0.1)
    move = np.clip(field(p) / size, -step / 2, step / 2)
    return np.asarray(p - move[:, None] * gradient)


def write(name: str, pieces: Sequence[Surface], folder: Path) -> None:
    """An OBJ file of some surfaces."""
    lines, count = ["# made by tests/view/acrobat_meshes.py"], 1
    for vertices, faces in pieces:
        lines += ["v " + " ".join(f"{x:.4f}" for x in row) for row in vertices + 0.0]
        lines += ["f " + " ".join(str(k + count) for k in row) for row in faces]
        count += len(vertices)
    (folder / f"{name}.obj").write_text("\n".join(lines) + "\n", encoding="ascii")


# the acrobat: x is forward, z up; lengths in meters


def torso() -> Field:
    half = [
        ellipsoid((0.0, 0.0, -0.745), (0.106, 0.158, 0.185)),
        rod((-0.005, 0.0, -0.625), (-0.005, 0.15, -0.61), 0.07, 0.055),
        rod((-0.03, 0.06, -0.90), (-0.012, 0.178, -0.60), 0.05, 0.047),
        ellipsoid((0.066, 0.074, -0.70), (0.042, 0.078, 0.056)),
        ellipsoid((0.0, 0.0, -0.94), (0.088, 0.122, 0.15)),
        ellipsoid((0.05, 0.028, -0.90), (0.042, 0.038, 0.13)),
        ellipsoid((-0.005, 0.025, -1.06), (0.10, 0.118, 0.10)),
        rod((-0.03, 0.11, -0.61), (0.02, 0.02, -0.545), 0.045, 0.05),
    ]
    return mirrored(union(*half, blend=0.05))


def pelvis() -> Field:
    """With the beginnings of the thighs, which cover the joints."""
    half = [
        ellipsoid((-0.048, 0.066, -1.10), (0.078, 0.07, 0.085)),
        rod((-0.002, 0.095, -1.10), (-0.002, 0.095, -1.145), 0.070, 0.064),
    ]
    return union(torso(), mirrored(union(*half, blend=0.04)), blend=0.05)


def neck() -> Field:
    return rod((0.0, 0.0, -0.62), (0.062, 0.0, -0.44), 0.062, 0.054)


def arm() -> Field:
    return union(
        rod((-0.005, 0.180, -0.600), (-0.008, 0.208, -0.44), 0.064, 0.045),
        rod((-0.008, 0.205, -0.46), (-0.012, 0.222, -0.31), 0.044, 0.038),
        ellipsoid((0.016, 0.198, -0.45), (0.036, 0.038, 0.085)),
        ellipsoid((-0.034, 0.200, -0.47), (0.034, 0.038, 0.095)),
        rod((-0.012, 0.222, -0.31), (-0.014, 0.220, -0.07), 0.036, 0.026),
        ellipsoid((0.004, 0.234, -0.235), (0.034, 0.034, 0.075)),
        ellipsoid((-0.022, 0.212, -0.235), (0.03, 0.032, 0.08)),
        blend=0.03,
    )


def hand() -> Field:
    """A fist around the bar, whose fingers come from behind over it to the front."""
    rods = []
    for k, y in enumerate((0.187, 0.207, 0.227, 0.246)):
        r = 0.0115 - 0.001 * (k == 3)
        angles = np.radians([200, 140, 80, 20, -35])
        places = [(0.0275 * float(np.cos(a)), y, 0.0275 * float(np.sin(a))) for a in angles]
        rods += [rod(a, b, r, r) for a, b in pairwise(places)]
    fingers = union(*rods, blend=0.008)
    palm = union(
        ellipsoid((-0.026, 0.217, -0.03), (0.02, 0.043, 0.042)),
        rod((-0.014, 0.220, -0.09), (-0.02, 0.219, -0.05), 0.027, 0.026),
        blend=0.02,
    )
    thumb = union(
        rod((-0.024, 0.187, -0.045), (0.004, 0.180, -0.031), 0.014, 0.0125),
        rod((0.004, 0.180, -0.031), (0.03, 0.192, -0.012), 0.0125, 0.0105),
        blend=0.01,
    )
    return union(palm, fingers, thumb, blend=0.012)


def head() -> Field:
    """In axes of the head, whose center is its origin."""
    half = [
        ellipsoid((-0.014, 0.0, 0.028), (0.097, 0.076, 0.092)),
        ellipsoid((0.026, 0.0, -0.03), (0.064, 0.056, 0.078)),
        rod((0.066, 0.0, -0.094), (0.064, 0.010, -0.094), 0.019, 0.017),
        rod((-0.010, 0.046, -0.062), (0.05, 0.016, -0.092), 0.014, 0.016),
        rod((0.081, 0.0, 0.022), (0.072, 0.034, 0.019), 0.013, 0.012),
        ellipsoid((0.064, 0.034, -0.022), (0.02, 0.018, 0.014)),
        rod((-0.03, 0.0, -0.06), (-0.075, 0.0, -0.19), 0.050, 0.056),
    ]
    face = union(*half, blend=0.028)
    nose = union(
        rod((0.086, 0.0, 0.012), (0.104, 0.0, -0.024), 0.007, 0.0105),
        ellipsoid((0.095, 0.009, -0.028), (0.01, 0.008, 0.008)),
        blend=0.012,
    )
    lips = union(
        ellipsoid((0.074, 0.0, -0.052), (0.017, 0.026, 0.022)),
        rod((0.084, 0.0, -0.062), (0.078, 0.019, -0.063), 0.0085, 0.006),
        blend=0.012,
    )
    ear = union(
        ellipsoid((-0.012, 0.078, -0.004), (0.02, 0.009, 0.031)),
        ellipsoid((-0.006, 0.071, -0.02), (0.014, 0.012, 0.016)),
        blend=0.01,
    )
    return mirrored(union(face, nose, lips, ear, blend=0.014))


def cap() -> Field:
    """Hair, wherever it is cut."""
    return union(
        ellipsoid((-0.018, 0.0, 0.034), (0.104, 0.084, 0.098)),
        ellipsoid((0.03, 0.02, 0.085), (0.055, 0.045, 0.035)),
        blend=0.03,
    )


def thigh() -> Field:
    """From the hip, the origin, to the knee."""
    return union(
        rod((-0.004, 0.0, -0.005), (0.002, 0.0, -0.42), 0.078, 0.050),
        ellipsoid((0.024, 0.0, -0.18), (0.060, 0.070, 0.17)),
        ellipsoid((-0.026, 0.0, -0.17), (0.058, 0.068, 0.18)),
        ellipsoid((0.014, 0.0, -0.42), (0.044, 0.046, 0.052)),
        blend=0.03,
    )


def shin() -> Field:
    """From the knee, the origin, to the ankle."""
    return union(
        rod((0.0, 0.0, 0.0), (0.0, 0.0, -0.12), 0.0505, 0.046),
        rod((0.004, 0.0, -0.10), (0.0, 0.0, -0.415), 0.046, 0.034),
        ellipsoid((-0.026, 0.012, -0.145), (0.046, 0.042, 0.115)),
        ellipsoid((-0.026, -0.012, -0.155), (0.046, 0.042, 0.115)),
        blend=0.03,
    )


def foot() -> Field:
    """With pointed toes, in axes of the shin."""
    return union(
        rod((0.0, 0.0, -0.395), (0.006, 0.0, -0.435), 0.037, 0.037),
        ellipsoid((-0.018, 0.0, -0.445), (0.032, 0.031, 0.033)),
        rod((0.012, 0.0, -0.445), (0.062, 0.0, -0.535), 0.036, 0.026),
        rod((0.060, 0.015, -0.535), (0.086, 0.010, -0.588), 0.024, 0.014),
        rod((0.060, -0.015, -0.535), (0.084, -0.010, -0.584), 0.024, 0.013),
        blend=0.025,
    )


def make(folder: Path, *names: str) -> None:
    """Write all files into a folder, or those of some names."""
    both = mirrored(union(arm(), hand(), blend=0.02))
    body = union(torso(), neck(), both, blend=0.035)
    armholes = mirrored(rod((0.0, 0.245, -0.60), (0.0, 0.225, -0.40), 0.085, 0.12))
    neckline = rod((0.045, 0.0, -0.515), (0.12, 0.0, -0.53), 0.10, 0.13)
    dressed = common(above((0, 0, -1), 0.50), outside(union(armholes, neckline, blend=0.02)))
    bare, lower = outside(grown(dressed, -0.02)), above((0, 0, -1), 1.0)
    shirt = union(torso(), neck(), blend=0.05)
    wrist, chest = 0.08, 0.72
    whole = (-0.16, -0.30, -1.25), (0.18, 0.30, 0.06)
    fists, skull = (
        ((-0.06, -0.28, -0.12), (0.06, 0.28, 0.05)),
        ((-0.14, -0.11, -0.2), (0.13, 0.11, 0.15)),
    )

    def skin() -> list[Surface]:
        sides = above((0, 0, 1), -chest), above((0, 0, -1), wrist)
        return [
            surface(body, whole, 0.021, *sides, bare),
            surface(both, fists, 0.0105, above((0, 0, 1), -wrist)),
        ]

    hairline, collar = above((-0.62, 0.0, 1.0), 0.012), above((0, 0, 1), -0.15)
    pieces: dict[str, Callable[[], list[Surface]]] = {
        "skin": skin,
        "shirt": lambda: [
            surface(grown(shirt, CLOTH), whole, 0.022, above((0, 0, 1), -1.02), dressed)
        ],
        "hips": lambda: [surface(grown(pelvis(), 2 * CLOTH), whole, 0.021, lower)],
        "head": lambda: [surface(head(), skull, 0.012, collar)],
        "hair": lambda: [surface(cap(), skull, 0.015, hairline)],
        "thigh": lambda: [surface(thigh(), ((-0.12, -0.12, -0.52), (0.13, 0.12, 0.12)), 0.021)],
        "shin": lambda: [surface(shin(), ((-0.1, -0.08, -0.46), (0.09, 0.08, 0.08)), 0.018)],
        "foot": lambda: [surface(foot(), ((-0.07, -0.06, -0.63), (0.12, 0.06, -0.34)), 0.0145)],
    }
    folder.mkdir(exist_ok=True)
    for name in names or pieces:
        write(name, pieces[name](), folder)


if __name__ == "__main__":
    make(FOLDER)
