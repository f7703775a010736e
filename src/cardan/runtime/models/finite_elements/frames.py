"""Frames that are fixed to nodes: where they are and how they move."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from ....arrays import Array
from ....errors import ModelError
from ....schema.mechanism import FrameRow
from .node_pose import Plane, pose, speeds
from .tables import Tables

if TYPE_CHECKING:
    from ..loaded_model import LoadedModel


def rotation(q: Array) -> Array:
    """Rotation matrices (..., 3, 3) of unit quaternions (..., 4), w x y z."""
    w, x, y, z = np.moveaxis(np.asarray(q, dtype=np.float64), -1, 0)
    rows = (
        (w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z),
    )
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def rotate(R: Array, vectors: Array) -> Array:
    """R v, of matrices (..., 3, 3) and vectors (..., 3)."""
    return np.asarray(np.einsum("...ij,...j->...i", R, vectors))


class Frames:
    """Frames by where they stand on their places: nodes, or the ground."""

    def __init__(self, rows: Sequence[FrameRow], rotations: Array, positions: Array) -> None:
        """Args:
        rows: Of the manifest.
        rotations: Axes of every frame in those of its place (n, 3, 3).
        positions: Its origin there (n, 3).
        """
        self._rotation = dict(zip((r.name for r in rows), rotations, strict=True))
        self._position = dict(zip((r.name for r in rows), positions, strict=True))
        # first coordinate and speed of the node
        self._starts = {row.name: row.node for row in rows}
        self._planes = {row.name: Plane.of(row.plane) for row in rows}

    def place(self, frame: str) -> tuple[Array, Array]:
        """Axes (3, 3) and origin (3,) of a frame on its place."""
        return self._rotation[frame], self._position[frame]

    @classmethod
    def of(cls, model: LoadedModel) -> Frames:
        """The frames of a model at its parameters."""
        return cls(model.manifest.frames, *node_frames(model))

    def _node(self, frame: str, q: Array) -> tuple[Array, Array]:
        """R (..., 3, 3) and origin (..., 3) of the node that carries a frame."""
        start, plane = self._starts[frame], self._planes[frame]
        if start is None:
            return np.eye(3), np.zeros(3)
        size = 7 if plane is None else 3
        node_pose = pose(plane, q[..., start[0] : start[0] + size])
        return rotation(node_pose[..., :4]), node_pose[..., 4:]

    def _speeds(self, frame: str, u: Array) -> tuple[Array, Array]:
        """Angular velocity in its axes and velocity in ground axes of the node, (..., 3) each."""
        (_, start), plane = self._starts[frame] or (0, 0), self._planes[frame]
        size = 6 if plane is None else 3
        twist = speeds(plane, u[..., start : start + size])
        return twist[..., :3], twist[..., 3:]

    def pose(self, frame: str, q: Array) -> Array:
        """Transforms (..., 4, 4) from the axes of a frame to those of the ground."""
        R, p = self._node(frame, q)
        T = np.tile(np.eye(4), (*q.shape[:-1], 1, 1))
        T[..., :3, :3] = R @ self._rotation[frame]
        T[..., :3, 3] = p + R @ self._position[frame]
        return T

    def velocity(self, frame: str, q: Array, u: Array) -> Array:
        """Angular velocity and velocity of the origin (..., 6), ground axes."""
        start = self._starts[frame]
        if start is None:
            return np.zeros((*u.shape[:-1], 6))
        R, _ = self._node(frame, q)
        omega_node, v = self._speeds(frame, u)
        omega = rotate(R, omega_node)
        return np.concatenate([omega, v + np.cross(omega, R @ self._position[frame])], axis=-1)

    def acceleration(self, frame: str, q: Array, u: Array, udot: Array) -> Array:
        """Angular acceleration and acceleration of the origin (..., 6), ground axes."""
        start = self._starts[frame]
        if start is None:
            return np.zeros((*u.shape[:-1], 6))
        R, _ = self._node(frame, q)
        arm, (alpha_node, a) = R @ self._position[frame], self._speeds(frame, udot)
        omega, alpha = rotate(R, self._speeds(frame, u)[0]), rotate(R, alpha_node)
        a = a + np.cross(alpha, arm) + np.cross(omega, np.cross(omega, arm))
        return np.concatenate([alpha, a], axis=-1)

    def jacobian(self, frame: str, q: Array, nu: int) -> Array:
        """J (6, nu) with velocity = J u."""
        J, start = np.zeros((6, nu)), self._starts[frame]
        if start is None:
            return J
        R, _ = self._node(frame, q)
        x, y, z = R @ self._position[frame]
        skew = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
        zero, one = np.zeros((3, 3)), np.eye(3)
        block, plane = np.block([[R, zero], [-skew @ R, one]]), self._planes[frame]
        block = block if plane is None else block @ plane.to_space
        J[:, start[1] : start[1] + block.shape[1]] = block
        return J


def numbers(model: LoadedModel) -> dict[str, Array]:
    """``frame_rotation`` and ``frame_position`` on the places of all frames."""
    return dict(zip(("frame_rotation", "frame_position"), node_frames(model), strict=True))


def node_frames(model: LoadedModel) -> tuple[Array, Array]:
    """Rotations (n, 3, 3) and origins (n, 3) of all frames on their places."""
    at = model._evaluate_saved(model.manifest.elements.frames, p=model.parameters.vector)
    rotations, positions = (np.asarray(at[k], dtype=np.float64) for k in ("rotation", "position"))
    rotations, positions = rotations.reshape(-1, 3, 3), positions.reshape(-1, 3)
    count = len(model.manifest.frames)
    if len(rotations) != count:
        raise ModelError(
            f"{model.directory}: the manifest has {count} frames, functions.json {len(rotations)}. "
            "Compile the model again"
        )
    return rotations, positions


def rotation_vectors(matrices: Array) -> Array:
    """Rotation vectors (..., 3) [rad] of rotation matrices (..., 3, 3)."""
    from scipy.spatial.transform import Rotation

    if not matrices.size:
        return np.zeros(matrices.shape[:-1])
    return np.asarray(Rotation.from_matrix(matrices).as_rotvec())


def increments_from(tables: Tables, q0: Array, q: Array) -> Array:
    """Increments (nu,) along the speeds that lead from coordinates to others (nq,)."""
    change: Array = np.zeros(tables.nu)
    for k, kind in enumerate(tables.kinds):
        places = np.flatnonzero(tables.kind == k)
        a = q0[tables.q[places][:, None] + np.arange(kind.nq)]
        b = q[tables.q[places][:, None] + np.arange(kind.nq)]
        spots = tables.u[places][:, None] + np.arange(kind.nu)
        if kind.nq == kind.nu:
            change[spots] = b - a
        elif kind.quaternion is not None:
            at = kind.quaternion
            start, end = (rotation(block[:, at : at + 4]) for block in (a, b))
            change[spots[:, :3]] = rotation_vectors(np.einsum("nji,njk->nik", start, end))
            translational = [n for n in range(kind.nq) if not at <= n < at + 4]
            change[spots[:, 3:]] = (b - a)[:, translational]
    return change
