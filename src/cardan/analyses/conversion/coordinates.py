"""Our coordinates in those of other programs, and back.

Programs differ in the order of joints and, for a free joint, in three things: whether position or
quaternion comes first and where its scalar stands, whether linear or angular speeds come first,
and whether the linear ones are given in the axes of the body or of its parent. Some write angles
without limits as cosine and sine, and give followers of other joints coordinates of their own.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from ...arrays import Array
from ...records import dataclass
from ...runtime.verification.rotations import PARAMETERS

SIZES = {
    "revolute": (1, 1),
    "prismatic": (1, 1),
    "screw": (1, 1),
    "universal": (2, 2),
    "cylindrical": (2, 2),
    "planar": (3, 3),
    "translation": (3, 3),
    "spherical": (4, 3),
    "free": (7, 6),
}


@dataclass(frozen=True)
class Convention:
    """Conventions of a program for free, spherical and planar joints.

    Attributes:
        scalar_last: Quaternions are (x, y, z, w).
        position_first: Of a free joint: position before quaternion.
        linear_first: Of a free joint: linear speeds before angular ones.
        body_axes: Linear speeds of free and planar joints are given in the axes of the body.
    """

    scalar_last: bool
    position_first: bool
    linear_first: bool
    body_axes: bool


class Pair(NamedTuple):
    """A joint in both programs, or one of the coordinates that it has in the other.

    Attributes:
        kind: One of ``SIZES``.
        q, u: First entries in ours.
        q_theirs, u_theirs: First entries in theirs.
        cosine: Its angle is (cos, sin) there.
    """

    kind: str
    q: int
    u: int
    q_theirs: int
    u_theirs: int
    cosine: bool = False


class Follower(NamedTuple):
    """A joint without coordinates of ours: ratio times one of them plus offset.

    Attributes:
        q, u: Entries of the joint that it follows, in ours.
        q_theirs, u_theirs: First entries in theirs.
        ratio, offset: Numbers of the coupling.
        cosine: Its angle is (cos, sin) there.
    """

    q: int
    u: int
    q_theirs: int
    u_theirs: int
    ratio: float
    offset: float
    cosine: bool = False


class Sizes(NamedTuple):
    """Lengths of q and u, ours and theirs."""

    nq: int
    nu: int
    nq_theirs: int
    nu_theirs: int


@dataclass(frozen=True)
class Coordinates:
    """The map between our states and those of a program, over leading axes.

    Attributes:
        sizes: Lengths of q and u.
        q_ours, q_theirs: Equal entries of our q and theirs, both in joint order.
        u_ours, u_theirs: The same for speeds.
        free: (first of our q, first of our u) of free joints with linear speeds in axes of the
            body there.
        planar: (angle in our q, first of our u) of planar joints of that kind.
        angles: (our q, first of theirs) of angles that are (cos, sin) there.
        followers: Joints that have no coordinates of ours.
    """

    sizes: Sizes
    q_ours: tuple[int, ...]
    q_theirs: tuple[int, ...]
    u_ours: tuple[int, ...]
    u_theirs: tuple[int, ...]
    free: tuple[tuple[int, int], ...] = ()
    planar: tuple[tuple[int, int], ...] = ()
    angles: tuple[tuple[int, int], ...] = ()
    followers: tuple[Follower, ...] = ()

    def q(self, q: Array) -> Array:
        """Their coordinates (..., nq_theirs)."""
        theirs = np.zeros((*q.shape[:-1], self.sizes.nq_theirs))
        theirs[..., self.q_theirs] = q[..., self.q_ours]
        for ours, first in self.angles:
            theirs[..., first], theirs[..., first + 1] = np.cos(q[..., ours]), np.sin(q[..., ours])
        for f in self.followers:
            angle = f.ratio * q[..., f.q] + f.offset
            if f.cosine:
                theirs[..., f.q_theirs], theirs[..., f.q_theirs + 1] = np.cos(angle), np.sin(angle)
            else:
                theirs[..., f.q_theirs] = angle
        return theirs

    def q_back(self, q: Array) -> Array:
        """Our coordinates of theirs (..., nq); angles of (cos, sin) within half a turn."""
        ours = np.zeros((*q.shape[:-1], self.sizes.nq))
        ours[..., self.q_ours] = q[..., self.q_theirs]
        for entry, first in self.angles:
            ours[..., entry] = np.arctan2(q[..., first + 1], q[..., first])
        return ours

    def speeds(self, q: Array, u: Array) -> Array:
        """Their speeds X u of our q and u, and forces X tau, which is a rotation (..., nu_theirs).

        Followers move in proportion; they take no forces.
        """
        rotated = self._rotated(q, u, inverse=False)
        theirs = np.zeros((*rotated.shape[:-1], self.sizes.nu_theirs))
        theirs[..., self.u_theirs] = rotated[..., self.u_ours]
        for f in self.followers:
            theirs[..., f.u_theirs] = f.ratio * rotated[..., f.u]
        return theirs

    def accelerations(self, q: Array, u: Array, udot: Array) -> Array:
        """Their accelerations X udot + Xdot u (..., nu_theirs)."""
        return self.speeds(q, udot + self._drift(q, u))

    def back(self, q: Array, x: Array) -> Array:
        """Our speeds of theirs at our q, and without followers our forces X^T x (..., nu)."""
        ours = np.zeros((*x.shape[:-1], self.sizes.nu))
        ours[..., self.u_ours] = x[..., self.u_theirs]
        return self._rotated(q, ours, inverse=True)

    def accelerations_back(self, q: Array, u: Array, x: Array) -> Array:
        """Our accelerations of theirs (..., nu)."""
        return self.back(q, x) - self._drift(q, u)

    def matrix_back(self, q: Array, m: Array) -> Array:
        """Our mass matrix of theirs, X^T m X (n, nu, nu)."""
        rows = [self.back(q, m[:, :, j]) for j in range(m.shape[2])]
        half = np.stack(rows, axis=2)
        return np.stack([self.back(q, half[:, i, :]) for i in range(m.shape[1])], axis=1)

    def _rotated(self, q: Array, x: Array, inverse: bool) -> Array:
        """Linear entries of free and planar joints in axes of the body, or back in the parent's."""
        lead = np.broadcast_shapes(q.shape[:-1], x.shape[:-1])
        rotated = np.broadcast_to(x, (*lead, x.shape[-1])).copy()
        for start, first in self.free:
            r = PARAMETERS["quaternion"].matrix(q[..., start : start + 4])
            r = r if inverse else np.swapaxes(r, -1, -2)
            linear = x[..., first + 3 : first + 6]
            rotated[..., first + 3 : first + 6] = (r @ linear[..., None])[..., 0]
        for angle, first in self.planar:
            c, s = np.cos(q[..., angle]), np.sin(q[..., angle]) * (-1 if inverse else 1)
            along, across = x[..., first], x[..., first + 1]
            rotated[..., first] = c * along + s * across
            rotated[..., first + 1] = c * across - s * along
        return rotated

    def _drift(self, q: Array, u: Array) -> Array:
        """X^T Xdot u: -omega x v of free and planar joints, v in axes of the parent."""
        drift = np.zeros_like(u)
        for start, first in self.free:
            r = PARAMETERS["quaternion"].matrix(q[..., start : start + 4])
            omega = (r @ u[..., first : first + 3, None])[..., 0]
            drift[..., first + 3 : first + 6] = -np.cross(omega, u[..., first + 3 : first + 6])
        for _, first in self.planar:
            drift[..., first] = u[..., first + 2] * u[..., first + 1]
            drift[..., first + 1] = -u[..., first + 2] * u[..., first]
        return drift


def paired(
    pairs: Sequence[Pair], how: Convention, sizes: Sizes, followers: Sequence[Follower] = ()
) -> Coordinates:
    """The map that joints, one by one, make up."""
    q: list[tuple[int, int]] = []
    u: list[tuple[int, int]] = []
    angles: list[tuple[int, int]] = []
    free: list[tuple[int, int]] = []
    planar: list[tuple[int, int]] = []
    for pair in pairs:
        q_order, u_order = _orders(pair.kind, how)
        u += [(pair.u + k, pair.u_theirs + n) for n, k in enumerate(u_order)]
        if pair.cosine:
            # the angle is the last entry; a plane has two lengths before it
            last = q_order.pop()
            angles.append((pair.q + last, pair.q_theirs + last))
        q += [(pair.q + k, pair.q_theirs + n) for n, k in enumerate(q_order)]
        if how.body_axes and pair.kind == "free":
            free.append((pair.q, pair.u))
        if how.body_axes and pair.kind == "planar":
            planar.append((pair.q + 2, pair.u))
    return Coordinates(
        sizes,
        q_ours=tuple(ours for ours, _ in q),
        q_theirs=tuple(theirs for _, theirs in q),
        u_ours=tuple(ours for ours, _ in u),
        u_theirs=tuple(theirs for _, theirs in u),
        free=tuple(free),
        planar=tuple(planar),
        angles=tuple(angles),
        followers=tuple(followers),
    )


def _orders(kind: str, how: Convention) -> tuple[list[int], list[int]]:
    """Our entry behind each of theirs, within one joint."""
    nq, nu = SIZES[kind]
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
