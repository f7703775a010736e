"""Motion of joints by their poses alone, in NumPy, for the verification of every build.

Whatever the kind of a joint, its pose is differentiated in the complex plane: modes of motion and
their rates follow. Nothing of spatial, elements or equations is used.

Source: Roberson, Schwertassek, Dynamics of Multibody Systems, chapters 4 and 8; Lyness, Moler,
Numerical differentiation of analytic functions (1967), for derivatives by means over circles.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import prod
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...records import dataclass
from .rotations import PARAMETERS, axial

Array = NDArray[Any]
# before the kind of a joint whose child carries its parent
REVERSED = "reversed "
# coordinates (n, k), real or complex -> rotations (n, 3, 3) and positions (n, 3)
Pose = Callable[[Array], tuple[Array, Array]]
# the axis after each
NEXT = np.array([1, 2, 0])
# radii of circles round coordinates, and points on each
CIRCLES, POINTS = tuple(0.2 * 0.25**k for k in range(7)), 16
# the upper half of a circle: poses are real on the real axis, below they are conjugate
ROUND = np.exp(2j * np.pi * np.arange(POINTS // 2 + 1) / POINTS)
SHARES = np.array([1, *[2] * (POINTS // 2 - 1), 1]) / POINTS
# first and second derivatives on a circle of radius 1: means over all points, over every other one
ORDERS, SKIPS = np.array([[1], [2], [1], [2]]), np.array([[1], [1], [2], [2]])
MEANS = np.where(np.arange(len(ROUND)) % SKIPS, 0, ORDERS * SKIPS * SHARES * ROUND**-ORDERS)
# means over all points of a circle and over every other one that differ by less, of the largest
# slope, are good
SURE = 1e-10


class Expansion:
    """A pose and its derivatives by the coordinates that describe no rotation.

    Args:
        pose: Differentiated.
        first: Coordinates before this one are not moved.
    """

    def __init__(self, pose: Pose, first: int = 0) -> None:
        self.pose, self.first = pose, first
        self._last: tuple[tuple[int, bytes], tuple[Array, Array, Array]] | None = None

    def __call__(self, q: Array) -> tuple[Array, Array]:
        """Rotation (..., 3, 3) and position (..., 3) at coordinates (..., n)."""
        rotation, shifted = self.pose(q.reshape(prod(q.shape[:-1]), q.shape[-1]))
        return rotation.reshape(*q.shape[:-1], 3, 3), shifted.reshape(*q.shape[:-1], 3)

    def derivatives(self, q: Array) -> tuple[Array, Array, Array]:
        """The pose (..., 12) and its first (..., k, 12) and second (..., k, k, 12) derivatives at
        real coordinates (..., n): the rotation, row by row, then the position.

        The last ones are known by heart.
        """
        lead = q.shape[:-1]
        key = prod(lead), q.tobytes()
        if self._last is None or self._last[0] != key:
            self._last = key, self._derivatives(q.reshape(prod(lead), q.shape[-1]))
        here, first, second = (x.reshape(*lead, *x.shape[1:]) for x in self._last[1])
        return here, first, second

    def _derivatives(self, q: Array) -> tuple[Array, Array, Array]:
        lead, n = q.shape[:-1], q.shape[-1]
        axes, k = np.eye(n)[self.first :], n - self.first
        # along every axis, and half way between every two, where nothing turns faster
        one, other = np.triu_indices(k, 1)
        ways = np.concatenate([axes, (axes[one] + axes[other]) / 2])
        if not k:
            return self._rows(q), np.zeros((*lead, 0, 12)), np.zeros((*lead, 0, 0, 12))
        slopes = settled(lambda radius: self._means(q, ways, radius), lead)
        here, slopes = slopes[..., :12], slopes[..., 12:]
        first, along = np.moveaxis(slopes.reshape(*lead, 2, len(ways), 12), -3, 0)
        second = np.zeros((*lead, k, k, 12))
        second[..., range(k), range(k), :] = along[..., :k, :]
        mixed = 2 * along[..., k:, :] - (along[..., one, :] + along[..., other, :]) / 2
        second[..., one, other, :] = second[..., other, one, :] = mixed
        return here, first[..., :k, :], second

    def _rows(self, q: Array) -> Array:
        """The pose (..., 12) in one row."""
        rotation, shifted = self(q)
        return np.concatenate([rotation.reshape(*q.shape[:-1], 9), shifted], axis=-1)

    def _means(self, q: Array, ways: Array, radius: float) -> tuple[Array, Array]:
        """The pose (..., 12), then first and second derivatives along ways (ways, n).

        By means over all points of a circle, and over every other one.
        """
        circle = np.append(0, radius * ROUND)
        rows = self._rows(q[..., None, None, :] + circle[:, None] * ways[:, None, :])
        here, rows = rows[..., 0, 0, :].real, rows[..., 1:, :]
        slopes = (MEANS @ rows).real / radius**ORDERS
        rows = slopes.swapaxes(-3, -2).reshape(*q.shape[:-1], 2, -1)
        full, half = (np.concatenate([here, rows[..., k, :]], axis=-1) for k in (0, 1))
        return full, half


def settled(means: Callable[[float], tuple[Array, Array]], lead: tuple[int, ...]) -> Array:
    """Means (*lead, k) over circles as large as they may be, state by state.

    Large ones lose no digits; in small ones a pose is a polynomial, and no case of it begins.
    """
    best, doubt = np.zeros((*lead, 1)), np.full(lead, np.inf)
    for radius in CIRCLES:
        with np.errstate(all="ignore"):
            full, half = means(radius)
            size = np.maximum(1.0, np.abs(full).max(axis=-1, initial=0.0))
            gap = np.abs(full - half).max(axis=-1, initial=0.0) / size
        gap = np.where(np.isfinite(gap), gap, np.inf)
        best = np.where((gap < doubt)[..., None], full, best)
        doubt = np.minimum(gap, doubt)
        if (doubt <= SURE).all():
            break
    return np.asarray(best)


@dataclass(frozen=True)
class JointData:
    """Data of one joint.

    Attributes:
        pose: Of its child in its parent by its coordinates, as declared.
        rotation: Parametrization of a rotation that its first coordinates describe. The first
            speeds are the angular velocity in child axes then; all others are rates.
        reversed: Whether the declared child carries the parent.
    """

    pose: Expansion
    rotation: str | None = None
    reversed: bool = False

    @property
    def turns(self) -> int:
        """Number of coordinates that describe a rotation."""
        return PARAMETERS[self.rotation].size if self.rotation else 0


def joint_data(pose: Pose, kind: str, rotation: str | None) -> JointData:
    """A joint whose kind may be told backwards."""
    turns = PARAMETERS[rotation].size if rotation else 0
    return JointData(Expansion(pose, turns), rotation, kind.startswith(REVERSED))


@dataclass(frozen=True)
class JointMotion:
    """Motion of a joint frame C against its parent-side frame J, for states (...).

    Attributes:
        rotation: (..., 3, 3), axes C to axes J.
        position: (..., 3), in J.
        turn: Angular velocity per speed, columns in axes C, (..., 3, n).
        shift: Velocity per speed, columns in axes J, (..., 3, n).
        turn_rate: What the derivative of ``turn`` adds to the angular acceleration, (..., 3).
        shift_rate: What the derivative of ``shift`` adds to the acceleration, (..., 3).
    """

    rotation: Array
    position: Array
    turn: Array
    shift: Array
    turn_rate: Array
    shift_rate: Array

    def of(self, k: int) -> JointMotion:
        """The motion of one of several joints, which are the last of the leading axes."""
        return JointMotion(
            self.rotation[..., k, :, :],
            self.position[..., k, :],
            self.turn[..., k, :, :],
            self.shift[..., k, :, :],
            self.turn_rate[..., k, :],
            self.shift_rate[..., k, :],
        )


def cross(a: Array, b: Array) -> Array:
    """a x b over leading axes."""
    product = a * b.take(NEXT, axis=-1) - a.take(NEXT, axis=-1) * b
    return np.asarray(product.take(NEXT, axis=-1))


def times(matrix: Array, vector: Array) -> Array:
    """Matrix times vector over leading axes."""
    return np.asarray((matrix @ vector[..., None])[..., 0])


def joint_pose(joint: JointData, q: Array) -> tuple[Array, Array]:
    """Rotation (..., 3, 3) and position (..., 3) of C in J; the coordinates may be complex."""
    rotation, position = joint.pose(q)
    if joint.rotation:
        rotation = PARAMETERS[joint.rotation].matrix(q[..., : joint.turns])
    if not joint.reversed:
        return rotation, position
    back = np.swapaxes(rotation, -1, -2)
    return back, -times(back, position)


# numbers of joints that are alike, their motions, and two rows of their speeds, (..., joints, n)
JointGroup = tuple[list[int], JointMotion, Array, Array]


def joint_groups(
    joints: Sequence[JointData], q: Sequence[Array], u: Sequence[Array], udot: Sequence[Array]
) -> list[JointGroup]:
    """Motions of joints, as :func:`joint_motion`; those that are alike in one evaluation."""
    alike: dict[JointData, list[int]] = {}
    for i, joint in enumerate(joints):
        alike.setdefault(joint, []).append(i)
    groups = list[JointGroup]()
    for joint, which in alike.items():
        here, rates, accelerations = (
            np.stack(np.broadcast_arrays(*(x[i] for i in which)), axis=-2) for x in (q, u, udot)
        )
        groups.append((which, joint_motion(joint, here, rates), rates, accelerations))
    return groups


def joint_motions(
    joints: Sequence[JointData], q: Sequence[Array], u: Sequence[Array]
) -> list[JointMotion]:
    """Motions of joints by number."""
    groups = joint_groups(joints, q, u, u)
    motions = {i: x.of(k) for which, x, _, _ in groups for k, i in enumerate(which)}
    return [motions[i] for i in range(len(joints))]


def joint_motion(joint: JointData, q: Array, u: Array) -> JointMotion:
    """Motion of a joint.

    Args:
        joint: The joint.
        q, u: Its own coordinates and speeds, (..., n). Coordinates may be a small complex step
            aside; what needs second derivatives of the pose is real then.
    """
    here, slopes, bends = joint.pose.derivatives(q.real)
    rates = u[..., u.shape[-1] - slopes.shape[-2] :]
    along = np.einsum("...k,...klx->...lx", rates, bends)
    second = np.einsum("...l,...lx->...x", rates, along)
    if np.iscomplexobj(q):
        aside = 1j * q.imag[..., joint.turns :]
        here = here + np.einsum("...k,...kx->...x", aside, slopes)
        slopes = slopes + np.einsum("...k,...klx->...lx", aside, bends)
    shift = np.moveaxis(slopes[..., 9:], -2, -1)
    rotation, position = here[..., :9].reshape(*here.shape[:-1], 3, 3), here[..., 9:]
    if joint.rotation:
        rotation = PARAMETERS[joint.rotation].matrix(q[..., : joint.turns])
        # an angular velocity moves no origin
        shift = np.concatenate([np.zeros((*shift.shape[:-1], 3)), shift], axis=-1)
        turn = np.broadcast_to(np.eye(3, shift.shape[-1]), shift.shape)
        turn_rate = np.zeros_like(second[..., 9:])
    else:
        back = np.swapaxes(rotation, -1, -2)
        turns = slopes[..., :9].reshape(*slopes.shape[:-1], 3, 3)
        turn = np.moveaxis(axial(back[..., None, :, :] @ turns), -2, -1)
        turn_rate = axial(back @ second[..., :9].reshape(*second.shape[:-1], 3, 3))
    forth = JointMotion(rotation, position, turn, shift, turn_rate, second[..., 9:])
    return _backwards(forth, u) if joint.reversed else forth


def _backwards(forth: JointMotion, u: Array) -> JointMotion:
    """The motion of the declared parent against the child: J seen from C."""
    back = np.swapaxes(forth.rotation, -1, -2)
    turn_columns, p = forth.rotation @ forth.turn, forth.position
    # rates in J of the place and of the turning, then as an observer in C sees them
    w, v = times(turn_columns, u), times(forth.shift, u)
    w_rate = times(forth.rotation, forth.turn_rate)
    transported = forth.shift_rate - cross(w_rate, p) - 2 * cross(w, v) + cross(w, cross(w, p))
    columns = np.swapaxes(cross(np.swapaxes(turn_columns, -1, -2), p[..., None, :]), -1, -2)
    return JointMotion(
        rotation=back,
        position=-times(back, p),
        turn=-turn_columns,
        shift=-(back @ (forth.shift - columns)),
        turn_rate=-w_rate,
        shift_rate=-times(back, transported),
    )
