"""Nodes that stay in a plane of the ground: x, y, angle in place of a pose.

The plane goes through the origin of the ground across one of its axes, the normal. x and y run
along the two axes that follow it, as those of a planar joint do: y, z for "x"; z, x for "y"; x, y
for "z". The angle turns about the normal; at angle 0 the axes of a node are those of ``axes``.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

import numpy as np

from ..arrays import Array
from ..records import dataclass

NORMALS = ("x", "y", "z")


@dataclass(frozen=True)
class Plane:
    """Plane of a node in space.

    Attributes:
        normal: Axis of the ground across the plane, 0, 1 or 2.
        axes: Rotation matrix (9) from axes of the node to those of the ground at angle 0; one of
            the axes of the node is along the normal.
    """

    normal: int
    axes: tuple[float, ...]

    @property
    def along(self) -> tuple[int, int]:
        """Axes of the ground along x and y."""
        return (self.normal + 1) % 3, (self.normal + 2) % 3

    @cached_property
    def rotation(self) -> Array:
        """The axes as a matrix (3, 3)."""
        return np.array(self.axes).reshape(3, 3)

    @cached_property
    def to_space(self) -> Array:
        """Speeds in space, angular ones in axes of the node first, from those here (6, 3)."""
        E = np.zeros((6, 3))
        E[:3, 2] = self.rotation[self.normal]
        for k, axis in enumerate(self.along):
            E[3 + axis, k] = 1.0
        return E

    @cached_property
    def across(self) -> Array:
        """Components of the speeds of a node in space that leave the plane (6, 3)."""
        E = np.zeros((6, 3))
        E[3 + self.normal, 2] = 1.0
        for k, axis in enumerate(self.along):
            E[:3, k] = self.rotation[axis]
        return E

    @property
    def home(self) -> Array:
        """Unit quaternion of the node at angle 0 (4,)."""
        from scipy.spatial.transform import Rotation

        x, y, z, w = Rotation.from_matrix(self.rotation).as_quat()
        return np.array([w, x, y, z])

    def pose(self, q: Array) -> Array:
        """Unit quaternions and positions (n, 7) from x, y, angle (n, 3)."""
        (w, *v), n = self.home, self.to_space[:3, 2]
        c, s = np.cos(0.5 * q[:, 2:]), np.sin(0.5 * q[:, 2:])
        rotated = np.hstack([c * w - s * (n @ v), c * v + s * (w * n + np.cross(v, n))])
        return np.hstack([rotated, q[:, :2] @ self.to_space[3:, :2].T])

    def coordinates_of(self, poses: Array) -> Array:
        """x, y, angle (n, 3) at unit quaternions and positions (n, 7) that turn gradually."""
        (w, *v), n = self.home, self.to_space[:3, 2]
        vector_parts, p = poses[:, 1:4], poses[:, :1]
        cosine = p[:, 0] * w + vector_parts @ v
        sine = (vector_parts * w - p * np.array(v) - np.cross(v, vector_parts)) @ n
        angle = np.unwrap(2 * np.arctan2(sine, cosine))
        if len(angle):
            angle -= 2 * np.pi * np.round(angle[0] / (2 * np.pi))
        return np.column_stack([poses[:, 4:] @ self.to_space[3:, :2], angle])

    def first(self, pose: Sequence[float]) -> tuple[float, ...]:
        """x, y, angle of a node at a unit quaternion and a position (7,)."""
        return tuple(self.coordinates_of(np.array([pose], dtype=np.float64))[0].tolist())


def upright(normal: int, rotation: Array, tolerance: float) -> Plane | None:
    """The plane of a node as it stands, None where none of its axes is along the normal."""
    row = rotation[normal]
    k = int(np.argmax(np.abs(row)))
    if abs(row[k]) < 1 - tolerance:
        return None
    # the axis of the node along the normal, or against it, and any two that go with it
    axes = np.zeros((3, 3))
    a, b = (normal + 1) % 3, (normal + 2) % 3
    if row[k] > 0:
        axes[normal, k] = axes[a, (k + 1) % 3] = axes[b, (k + 2) % 3] = 1.0
    else:
        axes[normal, k], axes[a, (k + 2) % 3], axes[b, (k + 1) % 3] = -1.0, 1.0, 1.0
    return Plane(normal, tuple(axes.ravel().tolist()))
