"""Poses of nodes in space, whatever coordinates they have."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ....arrays import Array
from ....records import dataclass
from ....schema import finite_elements


@dataclass(frozen=True)
class Plane:
    """A node of a plane, told by x, y and angle.

    Attributes:
        to_space: Speeds in space, angular velocity in axes of the node and velocity in those of the
            ground, from the rates of x, y and angle (6, 3).
        home: Unit quaternion at x = y = angle = 0 (4,).
    """

    to_space: Array
    home: Array

    @staticmethod
    def of(row: finite_elements.Plane | None) -> Plane | None:
        """From the manifest, None of other places."""
        return None if row is None else Plane(np.array(row.spread), np.array(row.home))

    def pose(self, q: Array) -> Array:
        """Unit quaternions and positions (..., 7) of coordinates (..., 3)."""
        w, v, n = self.home[0], self.home[1:], self.to_space[:3, 2]
        c, s = np.cos(0.5 * q[..., 2:]), np.sin(0.5 * q[..., 2:])
        rotated = c * v + s * (w * n + np.cross(v, n))
        places = q[..., :2] @ self.to_space[3:, :2].T
        return np.concatenate([c * w - s * (n @ v), rotated, places], axis=-1)

    def coordinates_of(self, pose: Array, near: Array) -> Array:
        """x, y, angle (..., 3) of poses (..., 7); of equal angles the nearest to ``near``."""
        w, v, n = self.home[0], self.home[1:], self.to_space[:3, 2]
        cosine = pose[..., 0] * w + pose[..., 1:4] @ v
        sine = (pose[..., 1:4] * w - pose[..., :1] * v - np.cross(v, pose[..., 1:4])) @ n
        angle = 2 * np.arctan2(sine, cosine)
        angle -= 2 * np.pi * np.round((angle - near) / (2 * np.pi))
        return np.concatenate([pose[..., 4:] @ self.to_space[3:, :2], angle[..., None]], axis=-1)


def pose(plane: Plane | None, q: Sequence[float] | Array) -> Array:
    """Unit quaternions and positions (..., 7) of nodes by their coordinates."""
    coordinates = np.asarray(q, dtype=np.float64)
    return coordinates if plane is None else plane.pose(coordinates)


def speeds(plane: Plane | None, u: Array) -> Array:
    """Speeds of nodes in space (..., 6) by their own."""
    return u if plane is None else u @ plane.to_space.T
