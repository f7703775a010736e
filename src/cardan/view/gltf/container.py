"""The container: nodes, meshes, materials and animations as JSON, and all numbers as one block.

Source: Khronos Group, glTF 2.0 Specification, sections 3.6 (buffers) and 4.4 (binary files).
"""

from __future__ import annotations

import json
import struct
from collections.abc import Sequence

import numpy as np

from ...arrays import Array, Integers
from ...version import VERSION
from ..packing import JsonObject
from .tessellation import Triangles

FLOAT, SHORT, LONG = 5126, 5123, 5125  # types of numbers
VERTICES, INDICES = 34962, 34963  # uses of a part of the block
LINES = 1  # mode of a primitive; triangles by default
SHAPES = {1: "SCALAR", 3: "VEC3", 4: "VEC4", 16: "MAT4"}
MOST_SHORT = 0xFFFF  # vertices that two bytes count; this number itself restarts a primitive
METALLIC, ROUGH = 0.05, 0.5

Color = tuple[float, ...]


class Container:
    """A file in the making; every part is called by its number, as glTF does.

    Args:
        name: Of its scene.
    """

    def __init__(self, name: str) -> None:
        self._name = name
        self._block = bytearray()
        self._views: list[JsonObject] = []
        self._accessors: list[JsonObject] = []
        self._nodes: list[JsonObject] = []
        self._roots: list[int] = []
        self._meshes: list[JsonObject] = []
        self._materials: dict[Color, int] = {}
        self._skins: list[JsonObject] = []
        self._samplers: list[JsonObject] = []
        self._channels: list[JsonObject] = []

    def node(self, name: str, parent: int | None = None) -> int:
        """Add a node, at its parent's place."""
        self._nodes.append({"name": name})
        number = len(self._nodes) - 1
        siblings = self._roots if parent is None else self._of(parent).setdefault("children", [])
        siblings.append(number)
        return number

    def _of(self, node: int) -> JsonObject:
        return self._nodes[node]

    def place(self, node: int, path: str, values: Array) -> None:
        """Set ``translation``, ``rotation`` (x, y, z, w), ``scale`` or ``weights`` of a node."""
        self._of(node)[path] = [float(x) for x in np.asarray(values, dtype=np.float32)]

    def show(self, node: int, mesh: int, skin: int | None = None) -> None:
        """Draw a mesh at a node; with a skin its joints place it."""
        self._of(node)["mesh"] = mesh
        if skin is not None:
            self._of(node)["skin"] = skin

    def numbers(self, values: Array, bounds: bool = False, use: int | None = None) -> int:
        """Add numbers (n,) or (n, k), in single precision.

        Args:
            values: The numbers.
            bounds: State the smallest and the largest, as readers of positions and times want.
            use: :data:`VERTICES` of vertices.
        """
        table = np.ascontiguousarray(values, dtype="<f4").reshape(len(values), -1)
        number = self._accessor(table, len(table), FLOAT, SHAPES[table.shape[1]], use)
        if bounds:
            extent = {"min": table.min(axis=0).tolist(), "max": table.max(axis=0).tolist()}
            self._accessors[number] |= extent
        return number

    def indices(self, rows: Integers) -> int:
        """Add numbers of vertices (n, k)."""
        flat = np.asarray(rows).ravel()
        is_short = int(flat.max(initial=0)) < MOST_SHORT
        kind, width = (SHORT, "<u2") if is_short else (LONG, "<u4")
        return self._accessor(flat.astype(width), len(flat), kind, "SCALAR", INDICES)

    def _accessor(self, table: Array, count: int, kind: int, shape: str, use: int | None) -> int:
        self._block.extend(b"\0" * (-len(self._block) % 4))
        view = {"buffer": 0, "byteOffset": len(self._block), "byteLength": table.nbytes}
        self._views.append(view | ({} if use is None else {"target": use}))
        self._block.extend(table.tobytes())
        entry = {"bufferView": len(self._views) - 1, "componentType": kind, "count": count}
        self._accessors.append(entry | {"type": shape})
        return len(self._accessors) - 1

    def material(self, color: Color) -> int:
        """The material of a color: red, green, blue as on a screen, opacity."""
        return self._materials.setdefault(color, len(self._materials))

    def triangles(self, part: Triangles, color: Color) -> JsonObject:
        """A primitive of triangles."""
        attributes = {
            "POSITION": self.numbers(part.vertices, bounds=True, use=VERTICES),
            "NORMAL": self.numbers(part.normals, use=VERTICES),
        }
        return {
            "attributes": attributes,
            "indices": self.indices(part.triangles),
            "material": self.material(color),
        }

    def lines(self, points: Array, rows: Integers, color: Color) -> JsonObject:
        """A primitive of lines between points (n, 3)."""
        attributes = {"POSITION": self.numbers(points, bounds=True, use=VERTICES)}
        entry = {"attributes": attributes, "indices": self.indices(rows), "mode": LINES}
        return entry | {"material": self.material(color)}

    def morph(self, primitive: JsonObject, shapes: Array) -> None:
        """Add shapes (k, n, 3) by which the vertices of a primitive move."""
        if len(shapes):
            targets = [{"POSITION": self.numbers(x, bounds=True, use=VERTICES)} for x in shapes]
            primitive["targets"] = targets

    def bound(self, joints: Integers, weights: Array) -> JsonObject:
        """Attributes of vertices that go with joints: their numbers (n, 4), and parts (n, 4)."""
        table = np.ascontiguousarray(joints, dtype="<u2")
        number = self._accessor(table, len(table), SHORT, "VEC4", VERTICES)
        return {"JOINTS_0": number, "WEIGHTS_0": self.numbers(weights, use=VERTICES)}

    def mesh(self, name: str, primitives: Sequence[JsonObject], **more: object) -> int:
        """Add a mesh."""
        self._meshes.append({"name": name, "primitives": list(primitives), **more})
        return len(self._meshes) - 1

    def skin(self, joints: Sequence[int], inverses: Array) -> int:
        """Add a skin: nodes, and the inverse (n, 4, 4) of where each stands undeformed."""
        by_columns = np.swapaxes(inverses, 1, 2).reshape(-1, 16)
        matrices = self.numbers(by_columns)
        self._skins.append({"joints": list(joints), "inverseBindMatrices": matrices})
        return len(self._skins) - 1

    def animate(self, node: int, path: str, times: int, values: Array) -> None:
        """Move a node along cubic splines.

        Args:
            node: Its number.
            path: As of :meth:`place`.
            times: Numbers of the keys (n,).
            values: At every key the slope before it, the value and the slope behind it
                (n, 3, k).
        """
        flat = values.reshape(-1) if path == "weights" else values.reshape(-1, values.shape[2])
        sampler = {"input": times, "output": self.numbers(flat), "interpolation": "CUBICSPLINE"}
        self._samplers.append(sampler)
        target = {"node": node, "path": path}
        self._channels.append({"sampler": len(self._samplers) - 1, "target": target})

    def content(self, extras: JsonObject) -> bytes:
        """The file.

        Args:
            extras: Plain data about the whole scene.
        """
        scene = {"name": self._name, "nodes": self._roots, "extras": extras}
        document: JsonObject = {
            "asset": {"version": "2.0", "generator": f"cardan {VERSION}"},
            "scene": 0,
            "scenes": [scene],
            "nodes": self._nodes,
            "meshes": self._meshes,
            "materials": [_material(color) for color in self._materials],
            "skins": self._skins,
            "accessors": self._accessors,
            "bufferViews": self._views,
            "buffers": [{"byteLength": len(self._block)}] if self._block else [],
        }
        if self._channels:
            motion = {"name": self._name, "samplers": self._samplers, "channels": self._channels}
            document["animations"] = [motion]
        # an empty list is not allowed
        stated = {name: part for name, part in document.items() if part not in ([], {})}
        text = json.dumps(stated, separators=(",", ":"), allow_nan=False).encode()
        text += b" " * (-len(text) % 4)
        block = bytes(self._block) + b"\0" * (-len(self._block) % 4)
        chunks = struct.pack("<I4s", len(text), b"JSON") + text
        chunks += struct.pack("<I4s", len(block), b"BIN\0") + block if block else b""
        return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def _material(color: Color) -> JsonObject:
    red, green, blue, opacity = color
    linear = [_linear(x) for x in (red, green, blue)]
    surface = {"baseColorFactor": [*linear, opacity], "metallicFactor": METALLIC}
    entry: JsonObject = {"pbrMetallicRoughness": surface | {"roughnessFactor": ROUGH}}
    # meshes of others may be open, or mirrored by their scales
    entry["doubleSided"] = True
    return entry | ({"alphaMode": "BLEND"} if opacity < 1 else {})


def _linear(x: float) -> float:
    """Intensity of a color of a screen.

    Source: IEC 61966-2-1 (sRGB).
    """
    return x / 12.92 if x <= 0.04045 else ((x + 0.055) / 1.055) ** 2.4
