"""A scene in plain numbers: its tree with all frames, at the values of the parameters."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

import numpy as np

from ...arrays import Array
from ...elements.quantity import Direction, Value
from ...elements.validation import AXES
from ...ir.function import Function, Output
from ...ir.interpreter import evaluate
from ...scene.body import Body as SceneBody
from ...scene.checks import is_number
from ...scene.scene import SceneRecord
from ..build import build
from ..rigid_body import ENTRIES
from ..system import GROUND, Frame, Nodes, Part

ROUNDED = 4e-16  # entries of rotations and, against their sizes, of positions that are 0
COM = tuple("xyz")


class NumericScene:
    """The system graph of a scene, and the values of its expressions."""

    def __init__(self, scene: SceneRecord) -> None:
        self.scene = scene
        self.system = build(scene)
        self._values = dict(self.system.structural)
        self._values |= {row.name: row.value for row in self.system.parameters}

    def numbers(self, nodes: Sequence[int]) -> Array:
        """Values of expressions of the parameters."""
        output = Output("values", (len(nodes),), tuple(nodes))
        function = Function("values", self.system.graph, (), (output,))
        p = [row.value for row in self.system.parameters]
        return np.array(evaluate(function, {"p": p})["values"], dtype=np.float64)

    def number(self, value: Value, name: str = "") -> float:
        """What the user wrote: a number that may have been set by its dotted name, or a formula."""
        if is_number(value):
            return self._values.get(name, float(value))
        symbols = getattr(value, "free_symbols", ())
        return float(value.subs({s: self._parameter(s.name) for s in symbols}))  # type: ignore[union-attr]

    def _parameter(self, name: str) -> float:
        declared = self.scene.parameters[name].value
        return self._values.get(name, self.scene.values.get(name, float(declared)))

    def constant(self, value: Value, name: str) -> float | None:
        """A number, or None where it is a formula in more than parameters."""
        symbols = getattr(value, "free_symbols", ())
        if any(symbol.name not in self.scene.parameters for symbol in symbols):
            return None
        return self.number(value, name)

    def direction(self, axis: Direction) -> tuple[float, ...]:
        """An axis as written."""
        entries = AXES[axis] if isinstance(axis, str) else axis
        return tuple(self.number(entry) for entry in entries)

    def mass(self, body: SceneBody) -> tuple[float, list[float], list[float]]:
        """Mass, center of mass and inertia about it (xx xy xz yy yz zz), in axes of the body."""
        com, inertia = (
            [
                self.number(entry, f"{body.name}.{word}.{label}")
                for label, entry in zip(labels, entries, strict=True)
            ]
            for word, labels, entries in (
                ("com", COM, body.com),
                ("inertia", ENTRIES, body.inertia),
            )
        )
        return self.number(body.mass, f"{body.name}.mass"), com, inertia

    # frames

    @cached_property
    def _poses(self) -> Array:
        """Transforms (frames, 4, 4) from frames to the axes of their bodies."""
        nodes = [node for row in self.system.frames for node in (*row.rotation, *row.position)]
        table = self.numbers(nodes).reshape(-1, 12)
        poses = np.tile(np.eye(4), (len(table), 1, 1))
        poses[:, :3, :3], poses[:, :3, 3] = table[:, :9].reshape(-1, 3, 3), table[:, 9:]
        return poses

    def parts(self, body: int) -> tuple[Part, ...]:
        """The user's bodies in a body of the system, or on the ground."""
        return self.system.ground_parts if body == GROUND else self.system.bodies[body].parts

    def part(self, frame: int) -> Part:
        """The user's body that carries a frame."""
        row: Frame = self.system.frames[frame]
        return self.parts(row.body)[row.part]

    def on_part(self, frame: int) -> Array:
        """Transform (4, 4) from a frame to the axes of the user's body that carries it."""
        return self.against(frame, self.part(frame).frame)

    def in_axes(self, frame: int) -> Array:
        """Transform (4, 4) from a frame to the axes of the system's body that carries it."""
        return relative(np.eye(4), self._poses[frame])

    def against(self, frame: int, base: int) -> Array:
        """Transform (4, 4) from a frame to another one of the same body."""
        return relative(self._poses[base], self._poses[frame])

    def in_body(self, rotation: Nodes, position: Nodes, base: int) -> Array:
        """A frame that is given in axes of its body, against another frame of that (4, 4)."""
        values, pose = self.numbers([*rotation, *position]), np.eye(4)
        pose[:3, :3], pose[:3, 3] = values[:9].reshape(3, 3), values[9:]
        return relative(self._poses[base], pose)


def relative(base: Array, pose: Array) -> Array:
    """A transform as seen from another one, without what only rounding makes of zeros."""
    R, aside = base[:3, :3], pose[:3, 3] - base[:3, 3]
    total = np.eye(4)
    total[:3, :3], total[:3, 3] = R.T @ pose[:3, :3], R.T @ aside
    size = float(np.abs(pose[:3, 3]).max() + np.abs(base[:3, 3]).max())
    total[:3, 3][np.abs(total[:3, 3]) < ROUNDED * size] = 0.0
    rotation = total[:3, :3]
    rotation[np.abs(rotation) < ROUNDED] = 0.0
    near = np.abs(np.abs(rotation) - 1) < ROUNDED
    rotation[near] = np.sign(rotation[near])
    return total


def roll_pitch_yaw(R: Array) -> list[float]:
    """Angles about the fixed axes x, y, z of a rotation (3, 3), also where they are not unique.

    Source: J. Diebel, Representing Attitude, 2006, section 8.2.
    """
    yaw = float(np.arctan2(R[1, 0], R[0, 0]))
    c, s = np.cos(yaw), np.sin(yaw)
    first, second = c * R[0] + s * R[1], c * R[1] - s * R[0]
    # adding 0 makes a zero of a negative one
    return [
        float(np.arctan2(-second[2], second[1])) + 0.0,
        float(np.arctan2(-R[2, 0], first[0])) + 0.0,
        yaw + 0.0,
    ]
