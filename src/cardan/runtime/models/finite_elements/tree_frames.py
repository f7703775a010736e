"""Frames on the bodies of rigid trees, which move with the coordinates of their joints."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ....arrays import Array
from ....schema.finite_elements import MOTION_NUMBERS
from ....schema.mechanism import FrameRow
from .elements import State
from .mesh import Mesh

FORM = "bodies"


class TreeFrames:
    """Frames by the bodies of trees that carry them.

    Args:
        mesh: Elements of the model.
        rows: Frames of the manifest.
        rotations: Axes of every frame in those of its body (n, 3, 3).
        positions: Its origin there (n, 3).
    """

    def __init__(
        self, mesh: Mesh, rows: Sequence[FrameRow], rotations: Array, positions: Array
    ) -> None:
        self._mesh = mesh
        self._at = {
            row.name: (row.tree, R, p)
            for row, R, p in zip(rows, rotations, positions, strict=True)
            if row.tree is not None
        }

    def __contains__(self, frame: str) -> bool:
        return frame in self._at

    def _body(self, frame: str, at: State) -> tuple[Array, Array, Array, Array]:
        """R (3, 3), p (3,), velocity and acceleration (6,) in ground axes of the body."""
        (group, member, number), _, _ = self._at[frame]
        groups = self._mesh.tables.groups
        having = [k for k, table in enumerate(groups) if FORM in table.kind.functions]
        bodies = self._mesh.results(FORM, at)[having.index(group)][member]
        row = bodies.reshape(-1, MOTION_NUMBERS)[number]
        return row[:9].reshape(3, 3), row[9:12], row[12:18], row[18:]

    def _arm(self, frame: str, R: Array) -> Array:
        return np.asarray(R @ self._at[frame][2])

    def pose(self, frame: str, at: State) -> Array:
        """Transform (4, 4) from the axes of a frame to those of the ground."""
        R, p, _, _ = self._body(frame, at)
        T = np.eye(4)
        T[:3, :3] = R @ self._at[frame][1]
        T[:3, 3] = p + self._arm(frame, R)
        return T

    def velocity(self, frame: str, at: State) -> Array:
        """Angular velocity and velocity of the origin (6,), ground axes."""
        R, _, velocity, _ = self._body(frame, at)
        omega, v = velocity[:3], velocity[3:]
        return np.concatenate([omega, v + np.cross(omega, self._arm(frame, R))])

    def acceleration(self, frame: str, at: State) -> Array:
        """Angular acceleration and acceleration of the origin (6,), ground axes."""
        R, _, velocity, acceleration = self._body(frame, at)
        arm, omega, alpha = self._arm(frame, R), velocity[:3], acceleration[:3]
        a = acceleration[3:] + np.cross(alpha, arm) + np.cross(omega, np.cross(omega, arm))
        return np.concatenate([alpha, a])

    def jacobian(self, frame: str, at: State) -> Array:
        """J (6, nu) with velocity = J u + what is prescribed."""
        (group, member, _), _, _ = self._at[frame]
        tables = self._mesh.tables
        J, still = np.zeros((6, tables.nu)), np.zeros(tables.nu)
        offset = self.velocity(frame, replace(at, u=still))
        for column in tables.columns(tables.groups[group])[member]:
            still[column] = 1.0
            J[:, column] = self.velocity(frame, replace(at, u=still)) - offset
            still[column] = 0.0
        return J
