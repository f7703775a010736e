"""How joints move, by their poses alone, in NumPy, for the judge of every build.

Whatever the kind of a joint, its pose is differentiated in the complex plane: modes of motion and
their rates follow. Nothing of spatial, elements or equations is used.

Source: Roberson, Schwertassek, Dynamics of Multibody Systems, chapters 4 and 8.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .circle_means import Expansion, Pose
from .rotations import PARAMETERS

Array = NDArray[Any]
# before the kind of a joint whose child carries its parent
REVERSED = "reversed "


@dataclass(frozen=True)
class JointData:
    """What is known about one joint.

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


def cross(a: Array, b: Array) -> Array:
    """a x b over leading axes."""
    return np.asarray(a[..., [1, 2, 0]] * b[..., [2, 0, 1]] - a[..., [2, 0, 1]] * b[..., [1, 2, 0]])


def times(matrix: Array, vector: Array) -> Array:
    """Matrix times vector over leading axes."""
    return np.asarray((matrix @ vector[..., None])[..., 0])


def placed(joint: JointData, q: Array) -> tuple[Array, Array]:
    """Rotation (..., 3, 3) and position (..., 3) of C in J; the coordinates may be complex."""
    rotation, position = joint.pose(q)
    if joint.rotation:
        rotation = PARAMETERS[joint.rotation].matrix(q[..., : joint.turns])
    if not joint.reversed:
        return rotation, position
    back = np.swapaxes(rotation, -1, -2)
    return back, -times(back, position)


def joint_motion(joint: JointData, q: Array, u: Array) -> JointMotion:
    """How a joint moves.

    Args:
        joint: The joint.
        q, u: Its own coordinates and speeds, (..., n). Coordinates may be a small complex step
            aside; what needs second derivatives of the pose is real then.
    """
    here, slopes, bends = joint.pose.derivatives(q.real)
    rates = u[..., u.shape[-1] - slopes.shape[-2] :]
    second = np.einsum("...k,...l,...klx->...x", rates, rates, bends)
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
        turn = np.concatenate([np.eye(3), np.zeros((3, rates.shape[-1]))], axis=-1)
        turn_rate = np.zeros_like(second[..., 9:])
    else:
        back = np.swapaxes(rotation, -1, -2)
        turns = slopes[..., :9].reshape(*slopes.shape[:-1], 3, 3)
        turn = np.moveaxis(_axial(back[..., None, :, :] @ turns), -2, -1)
        turn_rate = _axial(back @ second[..., :9].reshape(*second.shape[:-1], 3, 3))
    forth = JointMotion(rotation, position, turn, shift, turn_rate, second[..., 9:])
    return _backwards(forth, u) if joint.reversed else forth


def _backwards(forth: JointMotion, u: Array) -> JointMotion:
    """The motion of the declared parent against the child: J seen from C."""
    back = np.swapaxes(forth.rotation, -1, -2)
    turned, p = forth.rotation @ forth.turn, forth.position
    # rates in J of the place and of the turning, then as an observer in C sees them
    w, v = times(turned, u), times(forth.shift, u)
    w_rate = times(forth.rotation, forth.turn_rate)
    seen = forth.shift_rate - cross(w_rate, p) - 2 * cross(w, v) + cross(w, cross(w, p))
    columns = np.swapaxes(cross(np.swapaxes(turned, -1, -2), p[..., None, :]), -1, -2)
    return JointMotion(
        rotation=back,
        position=-times(back, p),
        turn=-turned,
        shift=-(back @ (forth.shift - columns)),
        turn_rate=-w_rate,
        shift_rate=-times(back, seen),
    )


def _axial(m: Array) -> Array:
    """What a matrix turns with: of its skew part."""
    pairs = ((2, 1), (0, 2), (1, 0))
    return np.asarray(np.stack([m[..., i, j] - m[..., j, i] for i, j in pairs], axis=-1) / 2)
