"""A motion as a glTF scene: a node for every body, with its frames; beams, springs, surfaces.

glTF has y upward: the root node turns what is against gravity there, and everything below it is in
the axes and meters of the scene.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import count

import numpy as np

from ...arrays import Array
from ...errors import ModelError
from ...runtime.trajectory.frame_history import inverse
from ...runtime.trajectory.trajectory import TrajectoryRecord
from .. import drawing as drawn
from ..beams import DrawnBeam
from ..drawing import DrawnSpring
from ..mesh_parts import MeshParts
from ..packing import turns
from ..page import rows_of
from ..solids import DrawnBody, Solid
from ..surfaces import DrawnSurface
from .beam_skins import skinned
from .container import Color, Container
from .keyframes import Keys, keys_of
from .springs import aligned, coil, rod
from .tessellation import Triangles, joined, of_mesh, of_solid, smoothed

# those of the page, in its order
PALETTE = ("4d8fd6", "e34d61", "2f9e55", "d9b93b", "66ccee", "b5489a", "a07d4a", "8080c8")
GREY, STEEL = "8a919d", "7c8594"
STILL = 1e-9  # of what moves: changes that are none
WIDE = 0.03  # radius of a spring, of the size of the scene


def content(motion: TrajectoryRecord) -> bytes:
    """The binary glTF file of a motion."""
    sampled, keys = keys_of(motion)
    return _Scene(sampled, keys, float(min(motion.t[0], motion.t[-1]))).content()


class _Scene:
    """One writing."""

    def __init__(self, motion: TrajectoryRecord, keys: Keys, start: float) -> None:
        self.motion, self.keys, self.start = motion, keys, start
        self.file = Container(motion.manifest.name)
        self.root = self.file.node(motion.manifest.name)
        self.upward = upward(drawn.upward(motion)[0])
        self.file.place(self.root, "rotation", turns(self.upward[None])[0])
        self.times = self.file.numbers(keys.t, bounds=True) if len(keys.t) > 1 else None
        self.colors = (color_of(PALETTE[k % len(PALETTE)]) for k in count())

    def content(self) -> bytes:
        """The file; to be asked once."""
        bodies, ground, beams, surfaces = drawn.solids_of(self.motion)
        springs = drawn.springs(self.motion)
        every = [solid for body in bodies for solid in body.solids] + ground
        self.meshes = MeshParts(every, "auto")
        self._ground(ground)
        for body in bodies:
            self._body(body, next(self.colors))
        for beam in beams:
            self._beam(beam, next(self.colors))
        for surface in surfaces:
            self._surface(surface, next(self.colors))
        starts = [body.poses[0, :3, 3] for body in bodies]
        starts += [end[0] for spring in springs for end in spring.ends]
        size = float(np.ptp(starts, axis=0).max()) if starts else 0.0
        for spring in springs:
            self._spring(spring, WIDE * (size or 1.0))
        self.meshes.complain()
        return self.file.content({"start": self.start})

    # moving

    def _move(self, node: int, path: str, values: Array) -> None:
        """A node along values (nt, k); it stands still where they do not change."""
        if not np.isfinite(values).all():
            raise ModelError(
                f"an animation needs finite places; some of '{self.motion.manifest.name}' are not"
            )
        self.file.place(node, path, values[0])
        largest = float(np.abs(values).max(initial=0.0))
        if self.times is not None and np.abs(values - values[0]).max() > STILL * largest:
            self.file.animate(node, path, self.times, self.keys.spline(values))

    def _carry(self, node: int, poses: Array) -> None:
        """A node along transforms (nt, 4, 4)."""
        self._move(node, "translation", poses[:, :3, 3])
        self._move(node, "rotation", turns(poses[:, :3, :3]))

    # bodies

    def _ground(self, solids: list[Solid]) -> None:
        node = self.file.node("ground", self.root)
        self._show(node, "ground", solids, [], color_of(GREY))
        self._frames(node, "ground", np.eye(4))

    def _body(self, body: DrawnBody, color: Color) -> None:
        node = self.file.node(body.name, self.root)
        self._carry(node, body.poses)
        self._show(node, body.name, body.solids, body.fallback, color)
        self._frames(node, body.name, body.poses[0])

    def _frames(self, node: int, body: str, pose: Array) -> None:
        """The named frames of a body, at places that do not change."""
        motion, first = self.motion, rows_of(self.motion, np.zeros(1, np.intp))
        for row in motion.manifest.frames:
            if row.body != body or row.name == body:
                continue
            if motion.manifest.absolute:
                place = inverse(pose) @ first.pose(row.name)[0]
            else:
                place = motion.frame_on_body(row.name)
            frame = self.file.node(row.name, node)
            self.file.place(frame, "translation", place[:3, 3])
            self.file.place(frame, "rotation", turns(place[None, :3, :3])[0])

    def _show(
        self, node: int, name: str, solids: list[Solid], fallback: list[Solid], color: Color
    ) -> None:
        """Draw solids, each color at once; ``fallback`` where not one can be."""
        by_color: dict[Color, list[Triangles]] = {}
        for solid in solids:
            for part, stated in self._triangles(solid):
                by_color.setdefault(stated or color, []).append(part)
        if not by_color and solids is not fallback:
            return self._show(node, name, fallback, fallback, color)
        if by_color:
            primitives = [self.file.triangles(joined(p), c) for c, p in by_color.items()]
            self.file.show(node, self.file.mesh(name, primitives))
        return None

    def _triangles(self, solid: Solid) -> Iterator[tuple[Triangles, Color | None]]:
        """Triangles of a solid with their color, where they have one."""
        entries = solid.get("color")
        stated = None if entries is None else (*map(float, entries), 1.0)[:4]
        if solid["kind"] != "mesh":
            yield of_solid(solid), stated
            return
        for part in self.meshes.of(str(solid["file"])):
            yield (
                of_mesh(part, solid),
                stated or (None if part.color is None else (*part.color, 1.0)),
            )

    # what bends

    def _beam(self, beam: DrawnBeam, color: Color) -> None:
        """A skin over nodes at the sections."""
        skin = skinned(beam, self.upward)
        joints = []
        for k in range(beam.sections.shape[1]):
            joints.append(self.file.node(f"{beam.name}.section{k}", self.root))
            self._carry(joints[-1], beam.sections[:, k])
        primitive = self.file.triangles(skin.surface, color)
        primitive["attributes"] |= self.file.bound(skin.joints, skin.weights)
        number = self.file.skin(joints, skin.inverses)
        # placed by its joints alone: below the root it would be turned twice by some viewers
        self.file.show(self.file.node(beam.name), self.file.mesh(beam.name, [primitive]), number)

    def _surface(self, one: DrawnSurface, color: Color) -> None:
        """A surface whose shapes are added in changing parts."""
        node = self.file.node(one.name, self.root)
        if one.poses is not None:
            self._carry(node, one.poses)
        largest = np.abs(one.amplitudes).max(axis=0, initial=0.0)
        moving = np.flatnonzero(largest > 0)
        shapes = one.shapes[moving] * largest[moving, None, None]
        primitives = []
        if len(one.triangles):
            part, source = smoothed(one.points, one.triangles)
            primitives.append(self.file.triangles(part, color))
            self.file.morph(primitives[-1], shapes[:, source])
        if len(one.lines):
            primitives.append(self.file.lines(one.points, one.lines, color))
            self.file.morph(primitives[-1], shapes)
        amplitudes = one.amplitudes[:, moving] / largest[moving]
        more = {"weights": amplitudes[0].tolist()} if len(moving) else {}
        self.file.show(node, self.file.mesh(one.name, primitives, **more))
        if len(moving):
            self._move(node, "weights", amplitudes)

    def _spring(self, spring: DrawnSpring, radius: float) -> None:
        """A coil of unit length, turned and stretched."""
        node = self.file.node(spring.name, self.root)
        start, along = spring.ends[0], spring.ends[1] - spring.ends[0]
        lengths = np.linalg.norm(along, axis=1)
        self._move(node, "translation", start)
        self._move(node, "rotation", turns(aligned(along)))
        ones = np.ones_like(lengths)
        self._move(node, "scale", np.stack([ones, ones, lengths], axis=1))
        part = coil(radius) if spring.coil else rod(radius)
        primitive = self.file.triangles(part, color_of(STEEL))
        self.file.show(node, self.file.mesh(spring.name, [primitive]))


def color_of(code: str) -> Color:
    """A color of six hexadecimal digits."""
    red, green, blue = bytes.fromhex(code)
    return red / 255, green / 255, blue / 255, 1.0


def upward(up: Array) -> Array:
    """The shortest rotation (3, 3) that turns a unit vector to y."""
    y = np.array([0.0, 1.0, 0.0])
    if up @ y < -1 + 1e-12:
        return np.diag([1.0, -1.0, -1.0])
    axis = np.cross(up, y)
    cross = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return np.asarray(np.eye(3) + cross + cross @ cross / (1 + up @ y))
