"""Our coordinates in those of other programs, and back.

Programs differ in the order of joints and, for a free joint, in three things: whether position or
quaternion comes first and where its scalar stands, whether linear or angular speeds come first,
and whether the linear ones are given in the axes of the body or of its parent.
"""

from __future__ import annotations

from collections.abc import Container, Sequence
from dataclasses import dataclass

import numpy as np

from ..api.comparison import PARAMETERS, Scene
from ..arrays import Array

SIZES = {
    "revolute": (1, 1),
    "prismatic": (1, 1),
    "universal": (2, 2),
    "spherical": (4, 3),
    "free": (7, 6),
}
# joints that every program knows
COMMON = frozenset(SIZES) - {"universal"}


def refusal(scene: Scene, joints: Sequence[str], kinds: Container[str] = COMMON) -> str:
    """Why a tree cannot be handed to other programs, "" if it can.

    Args:
        joints: Their names, by body.
        kinds: Those that the program knows, of ``SIZES``.
    """
    for i, (name, kind) in enumerate(zip(joints, scene.kinds, strict=True)):
        if kind not in kinds:
            return f"joint '{name}' is {kind}"
        if kind in ("spherical", "free") and scene.rotations[i] != "quaternion":
            return f"joint '{name}' turns without a quaternion"
        if scene.leaders[i] >= 0:
            return f"joint '{name}' is coupled"
        if scene.prescribed[i]:
            return f"joint '{name}' is prescribed"
    if np.any(scene.numbers.get("rotor", np.zeros(1))):
        return "motors add inertia"
    return ""


@dataclass(frozen=True)
class Convention:
    """Conventions of a program for free and spherical joints.

    Attributes:
        scalar_last: Quaternions are (x, y, z, w).
        position_first: Of a free joint: position before quaternion.
        linear_first: Of a free joint: linear speeds before angular ones.
        body_axes: Linear speeds of a free joint are given in the axes of the body.
    """

    scalar_last: bool
    position_first: bool
    linear_first: bool
    body_axes: bool


@dataclass(frozen=True)
class Coordinates:
    """The map between our states and those of a program.

    Attributes:
        q_ours, q_theirs: Our entries of q and theirs, both in joint order.
        u_ours, u_theirs: The same for speeds.
        free: (first of our q, first of our u) of free joints.
    """

    q_ours: tuple[int, ...]
    q_theirs: tuple[int, ...]
    u_ours: tuple[int, ...]
    u_theirs: tuple[int, ...]
    free: tuple[tuple[int, int], ...]

    def q(self, q: Array) -> Array:
        """Their coordinates (n, nq)."""
        theirs = np.zeros_like(q)
        theirs[:, self.q_theirs] = q[:, self.q_ours]
        return theirs

    def speeds(self, q: Array, u: Array) -> Array:
        """Their speeds X u, and forces X tau, which is a rotation (n, nu)."""
        theirs = np.empty_like(u)
        theirs[:, self.u_theirs] = self._rotated(q, u, inverse=False)[:, self.u_ours]
        return theirs

    def accelerations(self, q: Array, u: Array, udot: Array) -> Array:
        """Their accelerations X udot + Xdot u (n, nu)."""
        return self.speeds(q, udot + self._drift(q, u))

    def back(self, q: Array, x: Array) -> Array:
        """Our forces of theirs, X^T x (n, nu)."""
        ours = np.empty_like(x)
        ours[:, self.u_ours] = x[:, self.u_theirs]
        return self._rotated(q, ours, inverse=True)

    def accelerations_back(self, q: Array, u: Array, x: Array) -> Array:
        """Our accelerations of theirs (n, nu)."""
        return self.back(q, x) - self._drift(q, u)

    def matrix_back(self, q: Array, m: Array) -> Array:
        """Our mass matrix of theirs, X^T m X (n, nu, nu)."""
        rows = [self.back(q, m[:, :, j]) for j in range(m.shape[2])]
        half = np.stack(rows, axis=2)
        return np.stack([self.back(q, half[:, i, :]) for i in range(m.shape[1])], axis=1)

    def _rotated(self, q: Array, x: Array, inverse: bool) -> Array:
        """Linear entries of free joints in axes of the body, or back in those of the parent."""
        rotated = x.copy()
        for start, first in self.free:
            r = PARAMETERS["quaternion"].matrix(q[:, start : start + 4])
            r = r if inverse else np.swapaxes(r, 1, 2)
            linear = x[:, first + 3 : first + 6]
            rotated[:, first + 3 : first + 6] = (r @ linear[..., None])[..., 0]
        return rotated

    def _drift(self, q: Array, u: Array) -> Array:
        """X^T Xdot u: -omega x v of free joints, v in axes of the parent."""
        drift = np.zeros_like(u)
        for start, first in self.free:
            r = PARAMETERS["quaternion"].matrix(q[:, start : start + 4])
            omega = (r @ u[:, first : first + 3, None])[..., 0]
            drift[:, first + 3 : first + 6] = -np.cross(omega, u[:, first + 3 : first + 6])
        return drift


def after_each_other(scene: Scene, order: Sequence[int]) -> list[tuple[int, int]]:
    """First entry of every body's joint in q and u of a program that numbers bodies so."""
    places, q, u = [(0, 0)] * len(order), 0, 0
    for body in order:
        places[body] = (q, u)
        nq, nu = SIZES[scene.kinds[body]]
        q, u = q + nq, u + nu
    return places


def coordinates(scene: Scene, how: Convention, places: Sequence[tuple[int, int]]) -> Coordinates:
    """The map for a program.

    Args:
        places: First entry of every body's joint in their q and u.
    """
    sizes = [SIZES[kind] for kind in scene.kinds]
    q_ours: list[int] = []
    q_theirs: list[int] = []
    u_ours: list[int] = []
    u_theirs: list[int] = []
    for i, (nq, nu) in enumerate(sizes):
        q_order, u_order = _orders(scene.kinds[i], nq, nu, how)
        q_ours += [scene.q[i][0] + k for k in q_order]
        q_theirs += [places[i][0] + k for k in range(nq)]
        u_ours += [scene.u[i][0] + k for k in u_order]
        u_theirs += [places[i][1] + k for k in range(nu)]
    free = tuple(
        (scene.q[i][0], scene.u[i][0])
        for i, kind in enumerate(scene.kinds)
        if kind == "free" and how.body_axes
    )
    return Coordinates(tuple(q_ours), tuple(q_theirs), tuple(u_ours), tuple(u_theirs), free)


def _orders(kind: str, nq: int, nu: int, how: Convention) -> tuple[list[int], list[int]]:
    """Our entry behind each of theirs, within one joint."""
    if nq == nu:
        return list(range(nq)), list(range(nu))
    turn = [1, 2, 3, 0] if how.scalar_last else [0, 1, 2, 3]
    if kind == "spherical":
        return turn, [0, 1, 2]
    place, angular, linear = [4, 5, 6], [0, 1, 2], [3, 4, 5]
    return (
        place + turn if how.position_first else turn + place,
        linear + angular if how.linear_first else angular + linear,
    )
