"""COLLADA files (DAE): the polygons of a scene and the diffuse colors of their materials.

As files of robots are meant, the unit of length counts and the direction of "up" does not: the
axes are those of the file.

Source: Khronos Group, COLLADA Digital Asset Schema Release 1.4.1 (2008).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import field
from math import cos, radians, sin
from pathlib import Path
from xml.etree.ElementTree import Element

import numpy as np

from ...arrays import Array, Integers
from ...errors import ModelError
from ...records import dataclass
from . import collada_polygons
from .collada_elements import References, child, children, numbers, parsed, tag
from .part import MOST_TRIANGLES, Color, Part, merged, rgb

DEEPEST, MOST_VISITS = 60, 200_000
SHADINGS = ("phong", "lambert", "blinn", "constant")

Colors = dict[str, Color | None]
Polygons = tuple[str, Array, Integers]  # material symbol, points (n, 3), triangles (m, 3)


def parts(content: bytes, path: Path) -> list[Part]:
    """The polygons of all nodes of the scene, by color.

    Raises:
        ModelError: no COLLADA, references that lead nowhere or in a circle, or too much of
            something.
    """
    del path
    root = parsed(content)
    scene, unit, count = _Scene(root, References.of(root)), _unit(root), 0
    corners: dict[Color | None, list[Array]] = {}
    for geometry, pose, colors in scene.instances():
        for symbol, points, triangles in scene.polygons(geometry):
            count += len(triangles)
            if count > MOST_TRIANGLES:
                raise ModelError(f"more than {MOST_TRIANGLES} triangles")
            # a mirror turns triangles inside out
            order = triangles[:, ::-1] if np.linalg.det(pose[:3, :3]) < 0 else triangles
            # what becomes infinite is refused below
            with np.errstate(over="ignore", invalid="ignore"):
                moved = points[order.ravel()] @ pose[:3, :3].T + pose[:3, 3]
            corners.setdefault(colors.get(symbol), []).append(unit * moved)
    stacked = {color: np.concatenate(blocks) for color, blocks in corners.items()}
    return [merged(rows, np.arange(len(rows)), color) for color, rows in stacked.items()]


def _unit(root: Element) -> float:
    """Meters per unit of length."""
    element = child(root, "asset", "unit")
    text = "1" if element is None else element.get("meter", "1")
    try:
        value = float(text) if len(text) < 40 else 0.0
    except ValueError:
        value = 0.0
    if not 1e-9 <= value <= 1e9:
        raise ModelError(f"a unit of length of {text[:40]!r} meters")
    return value


@dataclass
class _Scene:
    """Nodes of a document, visited with a budget: one node may be used many times."""

    root: Element
    references: References
    visits: int = MOST_VISITS
    # what was read of elements that are used repeatedly, by their identity
    read: dict[int, list[Polygons]] = field(default_factory=dict)
    sources: dict[int, Array] = field(default_factory=dict)
    colored: dict[int, Colors] = field(default_factory=dict)

    def instances(self) -> Iterator[tuple[Element, Array, Colors]]:
        """Geometries with their poses (4, 4) and the colors of their material symbols."""
        instance = child(self.root, "scene", "instance_visual_scene")
        if instance is None:
            scene = child(self.root, "library_visual_scenes", "visual_scene")
        else:
            scene = self.references.target(instance, "url")
        if scene is None:
            raise ModelError("it has no scene")
        for node in children(scene, "node"):
            yield from self._visit(node, np.eye(4), 0)

    def _visit(
        self, node: Element, pose: Array, depth: int
    ) -> Iterator[tuple[Element, Array, Colors]]:
        self.visits -= 1 + len(node)
        if depth > DEEPEST or self.visits < 0:
            raise ModelError(f"nodes more than {DEEPEST} deep, or more than {MOST_VISITS} of them")
        for one in node:
            kind = tag(one)
            if kind in TRANSFORMS:
                with np.errstate(over="ignore", invalid="ignore"):
                    pose = pose @ _transform(one)
            elif kind == "node":
                yield from self._visit(one, pose, depth + 1)
            elif kind == "instance_node":
                yield from self._visit(self.references.target(one, "url"), pose, depth + 1)
            elif kind == "instance_geometry":
                yield self.references.target(one, "url"), pose, self._colors(one)
            elif kind == "instance_controller":
                skin = child(self.references.target(one, "url"), "skin")
                if skin is not None:
                    yield self.references.target(skin, "source"), pose, self._colors(one)

    def polygons(self, geometry: Element) -> list[Polygons]:
        """Polygons of a geometry.

        Raises:
            ModelError: a corner that is none of the points.
        """
        if id(geometry) not in self.read:
            self.read[id(geometry)] = list(self._polygons(geometry))
        return self.read[id(geometry)]

    def _polygons(self, geometry: Element) -> Iterator[Polygons]:
        mesh = child(geometry, "mesh")
        for element in mesh if mesh is not None else ():
            rows = collada_polygons.triangles(element)
            if rows is not None and rows.size:
                source = collada_polygons.positions(element, self.references)
                if id(source) not in self.sources:
                    self.sources[id(source)] = collada_polygons.points(source)
                points = self.sources[id(source)]
                if not 0 <= rows.min() <= rows.max() < len(points):
                    raise ModelError(f"a polygon has a corner that is none of {len(points)} points")
                yield element.get("material", ""), points, rows

    def _colors(self, instance: Element) -> Colors:
        if id(instance) not in self.colored:
            bound = child(instance, "bind_material", "technique_common")
            materials = () if bound is None else children(bound, "instance_material")
            self.colored[id(instance)] = {
                one.get("symbol", ""): self._color(one.get("target", "")) for one in materials
            }
        return self.colored[id(instance)]

    def _color(self, target: str) -> Color | None:
        """Diffuse color of a material; None if it is a texture or missing."""
        material = self.references.ids.get(target[1:])
        effect = None if material is None else child(material, "instance_effect")
        if effect is None:
            return None
        technique = child(self.references.target(effect, "url"), "profile_COMMON", "technique")
        if technique is None:
            return None
        for shading in SHADINGS:
            diffuse = child(technique, shading, "diffuse", "color")
            if diffuse is not None:
                return rgb(numbers(diffuse).tolist())
        return None


def _matrix(element: Element) -> Array:
    return numbers(element, 16).reshape(4, 4)


def _translate(element: Element) -> Array:
    pose = np.eye(4)
    pose[:3, 3] = numbers(element, 3)
    return pose


def _scale(element: Element) -> Array:
    return np.diag([*numbers(element, 3), 1.0])


def _rotate(element: Element) -> Array:
    """Rotation around an axis by an angle in degrees."""
    x, y, z, degrees = numbers(element, 4).tolist()
    length = float(np.linalg.norm([x, y, z]))
    pose = np.eye(4)
    if 0 < length < np.inf and abs(degrees) < np.inf:
        cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]]) / length
        angle = radians(degrees)
        pose[:3, :3] += sin(angle) * cross + (1 - cos(angle)) * cross @ cross
    return pose


TRANSFORMS = {"matrix": _matrix, "translate": _translate, "scale": _scale, "rotate": _rotate}


def _transform(element: Element) -> Array:
    """Pose (4, 4) that an element of a node gives to what follows it.

    Raises:
        ModelError: it is not finite.
    """
    pose = TRANSFORMS[tag(element)](element)
    if not np.all(np.isfinite(pose)):
        raise ModelError(f"<{tag(element)}> is not finite")
    return pose
