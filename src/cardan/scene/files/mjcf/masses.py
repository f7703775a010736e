"""Mass, center of mass and inertia of a body: as written, or those of its geoms.

Source: any table of volumes and moments of inertia; densities are constant.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from ....errors import ModelError
from ....records import dataclass
from ....spatial.numbers import UPRIGHT, Rows, Vector, congruent, upright_to
from ... import inertia, shape
from ...shape import Shape
from ..document import Element
from ..pose import Pose
from ..pose import written as written_rotation
from .compiler import Compiler, chosen

KINDS = ("sphere", "capsule", "cylinder", "box", "ellipsoid", "plane", "hfield", "mesh", "sdf")
# numbers of size, and how many of them fromto= replaces
SIZES = {
    "sphere": (1, 0),
    "capsule": (2, 1),
    "cylinder": (2, 1),
    "box": (3, 1),
    "ellipsoid": (3, 1),
}
WATER = "1000"


@dataclass(frozen=True)
class Mass:
    """Mass of a body or of a part of it, in axes of the body.

    Attributes:
        mass: [kg].
        com: Center of mass (3) [m].
        inertia: About it, rows (3, 3) [kg m^2].
    """

    mass: float
    com: Vector
    inertia: Rows


def scaled(masses: Sequence[Mass], total: float) -> list[Mass]:
    """Bodies scaled so that their masses add up; as they are where the total is negative."""
    present = sum(part.mass for part in masses)
    factor = total / present if total >= 0 and present > 0 else 1.0
    if factor == 1.0:
        return list(masses)
    return [
        Mass(factor * m.mass, m.com, [[factor * x for x in row] for row in m.inertia])
        for m in masses
    ]


NOTHING = Mass(0.0, (0.0, 0.0, 0.0), [[0.0] * 3] * 3)


@dataclass(frozen=True)
class Solid:
    """A geom of simple shape.

    Attributes:
        kind: Of ``SIZES``.
        size: Radius; radius and half length; half edges or half axes (3) [m].
        pose: In axes of the body.
    """

    kind: str
    size: tuple[float, ...]
    pose: Pose

    @property
    def volume(self) -> float:
        """[m^3]."""
        a, b, c = (*self.size, 0.0, 0.0)[:3]
        ball = 4 / 3 * math.pi
        return {
            "sphere": ball * a**3,
            "capsule": 2 * math.pi * a**2 * b + ball * a**3,
            "cylinder": 2 * math.pi * a**2 * b,
            "box": 8 * a * b * c,
            "ellipsoid": ball * a * b * c,
        }[self.kind]

    def moments(self, mass: float) -> Sequence[float]:
        """Principal moments (3) [kg m^2]."""
        a, b, c = (*self.size, 0.0, 0.0)[:3]
        if self.kind == "sphere":
            return inertia.sphere(mass, a)
        if self.kind == "cylinder":
            return inertia.cylinder(mass, a, 2 * b)
        if self.kind == "box":
            return inertia.box(mass, 2 * a, 2 * b, 2 * c)
        if self.kind == "ellipsoid":
            return tuple(mass / 5 * s for s in (b * b + c * c, a * a + c * c, a * a + b * b))
        # a capsule: a cylinder and two half balls, 3/8 of the radius outside its ends
        share = 4 * a / (6 * b + 4 * a)
        ends, middle = mass * share, mass * (1 - share)
        across, _, along = inertia.cylinder(middle, a, 2 * b)
        round_ = 2 * ends * a * a / 5
        off = ends * (b * b + 3 * a * b / 4)
        return across + round_ + off, across + round_ + off, along + round_


def solid(geom: Element, kind: str, compiler: Compiler) -> Solid:
    """The shape of a geom.

    Raises:
        ModelError: sizes that are missing or not positive, or both ends at one point.
    """
    count, replaced = SIZES[kind]
    ends = geom.raw.get("fromto") is not None and replaced
    size_count = count - 1 if ends and count == 2 else 1 if ends else count
    size = tuple(geom.several("size", size_count, 3)[:size_count])
    if min(size) <= 0:
        raise ModelError(f"{geom.where}: size={geom.text('size')[:60]!r} must be positive")
    if not ends:
        return Solid(kind, size, compiler.pose(geom))
    entries = geom.numbers("fromto", 6)
    span = [a - b for a, b in zip(entries[:3], entries[3:], strict=True)]
    half = math.hypot(*span) / 2
    if not half > 1e-14:
        raise ModelError(f"{geom.where}: fromto= has both ends at one point")
    x, y, z = ((a + b) / 2 for a, b in zip(entries[:3], entries[3:], strict=True))
    round_ = (size[0],) if count == 2 else (size[0], size[0])
    return Solid(kind, (*round_, half), Pose(upright_to(span), (x, y, z)))


def of_geom(geom: Element, kind: str, compiler: Compiler, around: Pose) -> Mass | None:
    """The mass of a geom, None where it has none.

    Args:
        around: Pose of the frames around it, in axes of the body.

    Raises:
        ModelError: a mesh has mass: its volume is not read.
    """
    if not compiler.groups[0] <= geom.number("group", "0") <= compiler.groups[1]:
        return None
    stated = geom.raw.get("mass")
    factor = geom.number("mass") if stated is not None else geom.number("density", WATER)
    if factor < 0:
        raise ModelError(f"{geom.where}: {'density' if stated is None else 'mass'} is negative")
    if factor == 0 or kind in ("plane", "hfield"):
        return None
    if kind not in SIZES:
        raise ModelError(
            f"{geom.where}: the body takes its mass from this {kind}, whose volume is not read; "
            "give the body an <inertial>, or the geom mass='0'"
        )
    form = solid(geom, kind, compiler)
    mass = factor if stated is not None else factor * form.volume
    pose = around.then(form.pose)
    return Mass(mass, pose.position, _rotated(pose.rotation, form.moments(mass)))


def _rotated(rotation: Rows, moments: Sequence[float]) -> Rows:
    rows = [[m if i == j else 0.0 for j in range(3)] for i, m in enumerate(moments)]
    return rows if rotation == UPRIGHT else congruent(rotation, rows)


def combined(parts: Sequence[Mass]) -> Mass:
    """Several parts as one body.

    Source: parallel-axis theorem.
    """
    if len(parts) == 1:
        return parts[0]
    mass = sum(part.mass for part in parts)
    if mass == 0:
        return NOTHING
    x, y, z = (sum(part.mass * part.com[i] for part in parts) / mass for i in range(3))
    rows = [[0.0] * 3 for _ in range(3)]
    for part in parts:
        off = (part.com[0] - x, part.com[1] - y, part.com[2] - z)
        square = sum(d * d for d in off)
        for i in range(3):
            for j in range(3):
                moved = part.mass * ((square if i == j else 0.0) - off[i] * off[j])
                rows[i][j] += part.inertia[i][j] + moved
    return Mass(mass, (x, y, z), rows)


def written(inertial: Element, compiler: Compiler, around: Pose) -> Mass:
    """The mass of an <inertial>.

    Args:
        around: Pose of the frames around it, in axes of the body.

    Raises:
        ModelError: both kinds of inertia, or a full one with an orientation.
    """
    inertial.numbers("pos", 3)
    mass, pose = inertial.number("mass"), around.then(compiler.pose(inertial))
    if inertial.raw.get("fullinertia") is None:
        moments = inertial.numbers("diaginertia", 3, "0 0 0")
        return Mass(mass, pose.position, _rotated(pose.rotation, moments))
    if inertial.raw.get("diaginertia") is not None or compiler.orientation(inertial) != UPRIGHT:
        raise ModelError(
            f"{inertial.where}: fullinertia stands alone, without diaginertia and orientation"
        )
    xx, yy, zz, xy, xz, yz = inertial.numbers("fullinertia", 6)
    rows = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
    turn = around.rotation
    return Mass(mass, pose.position, congruent(turn, rows))


def kind_of(geom: Element) -> str:
    """The type of a geom; a geom that names a mesh is one.

    Raises:
        ModelError: an unknown one.
    """
    default = "mesh" if geom.raw.get("mesh") is not None else "sphere"
    return chosen(geom, "type", KINDS, default)


def picture(geom: Element, kind: str, compiler: Compiler, around: Pose) -> list[Shape]:
    """The shape of a geom; none for planes, meshes and what is fitted to meshes.

    Args:
        around: Pose of the frames around it, in axes of the body.
    """
    if kind not in SIZES or geom.raw.get("mesh") is not None:
        return []
    form = solid(geom, kind, compiler)
    pose = around.then(form.pose)
    color = geom.numbers("rgba", 4) if geom.raw.get("rgba") is not None else None
    a, b, c = (*form.size, 0.0, 0.0)[:3]
    if kind in ("sphere", "ellipsoid"):
        # an ellipsoid is drawn as the ball of its longest half axis
        return [shape.sphere(max(form.size), position=pose.position, color=color)]
    turn = written_rotation(pose.rotation)
    if kind == "box":
        return [shape.box(2 * a, 2 * b, 2 * c, position=pose.position, rotation=turn, color=color)]
    drawn = shape.capsule if kind == "capsule" else shape.cylinder
    return [drawn(a, 2 * b, position=pose.position, rotation=turn, color=color)]
