"""Newton and Euler in NumPy over the flat scene of a manifest: the judge of every build.

Classical relative kinematics in ground axes, batched over states. It knows the joints by name and
writes their motion down once more; nothing of spatial, elements or equations is used.

Source: Roberson, Schwertassek, Dynamics of Multibody Systems, chapters 4 and 6.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .rotations import PARAMETERS, about

Array = NDArray[Any]
JOINTS = "revolute prismatic cylindrical screw universal spherical planar free"
KINDS = tuple(JOINTS.split())


@dataclass(frozen=True)
class Scene:
    """A tree with numbers, made from a manifest and the saved Function ``scene``.

    Attributes:
        parents: Body each body is jointed to, -1 for the ground.
        kinds, rotations: Joint kind and parametrization by body.
        q, u: (first, size) of each joint in q and u; size 0 without slots.
        leaders: Joint a coupled joint follows, -1 for the others.
        prescribed: Whether the joint's coordinate is given.
        numbers: gravity (3,), mass (nb,), first_moment (nb, 3), inertia (nb, 3, 3), rotation
            (nb, 3, 3), position, axis, axis2 (nb, 3), pitch, ratio, offset (nb,); rotor
            (nb,) where there are any.
    """

    parents: tuple[int, ...]
    kinds: tuple[str, ...]
    rotations: tuple[str | None, ...]
    q: tuple[tuple[int, int], ...]
    u: tuple[tuple[int, int], ...]
    leaders: tuple[int, ...]
    prescribed: tuple[bool, ...]
    numbers: Mapping[str, Array]
    nu: int


@dataclass(frozen=True)
class JointMotion:
    """Motion of a joint frame C against its parent-side frame J, for states (...).

    Attributes:
        rotation: (..., 3, 3), axes C to axes J.
        position: (..., 3), in J.
        turn: Angular velocity per speed, columns in axes C, (..., 3, n).
        shift: Velocity per speed, columns in axes J, (..., 3, n).
        turn_rate: What the derivative of ``turn`` adds to the angular acceleration, (..., 3).
    """

    rotation: Array
    position: Array
    turn: Array
    shift: Array
    turn_rate: Array


def cross(a: Array, b: Array) -> Array:
    """a x b over leading axes."""
    return np.asarray(a[..., [1, 2, 0]] * b[..., [2, 0, 1]] - a[..., [2, 0, 1]] * b[..., [1, 2, 0]])


def normalized(v: Array) -> Array:
    """v / |v|."""
    return np.asarray(v / np.linalg.norm(v))


def joint_motion(scene: Scene, i: int, q: Array, u: Array) -> JointMotion:
    """How joint i moves; the coordinates may be complex.

    Args:
        q, u: Its own coordinates and speeds, (..., n).
    """
    kind, lead = scene.kinds[i], q.shape[:-1]
    zero, fixed = np.zeros((3, 1)), np.zeros((*lead, 3))
    if kind in ("spherical", "free"):
        parameters = PARAMETERS[scene.rotations[i] or ""]
        rotation = parameters.matrix(q[..., : parameters.size])
        if kind == "spherical":
            return JointMotion(rotation, fixed, np.eye(3), np.zeros((3, 3)), fixed)
        turn = np.hstack([np.eye(3), np.zeros((3, 3))])
        shift = np.hstack([np.zeros((3, 3)), np.eye(3)])
        return JointMotion(rotation, q[..., parameters.size :], turn, shift, fixed)
    a = normalized(scene.numbers["axis"][i])
    column = a[:, None]
    if kind == "revolute":
        return JointMotion(about(a, q[..., 0]), fixed, column, zero, fixed)
    if kind == "prismatic":
        still = np.broadcast_to(np.eye(3), (*lead, 3, 3))
        return JointMotion(still, q[..., :1] * a, zero, column, fixed)
    if kind == "cylindrical":
        both = np.hstack([column, zero]), np.hstack([zero, column])
        return JointMotion(about(a, q[..., 0]), q[..., 1:2] * a, *both, fixed)
    if kind == "screw":
        lift = float(scene.numbers["pitch"][i]) * a
        return JointMotion(about(a, q[..., 0]), q[..., :1] * lift, column, lift[:, None], fixed)
    b = normalized(scene.numbers["axis2"][i])
    if kind == "universal":
        return _universal(a, b, q, u)
    # planar: two displacements in the plane, then a turn about its normal
    plane = np.stack([b, cross(a, b)], axis=-1)
    turn = np.hstack([np.zeros((3, 2)), column])
    shift = np.hstack([plane, zero])
    place = (plane @ q[..., :2, None])[..., 0]
    return JointMotion(about(a, q[..., 2]), place, turn, shift, fixed)


def _universal(a: Array, b: Array, q: Array, u: Array) -> JointMotion:
    """First about a, fixed in the parent, then about b, fixed in the child."""
    second = about(b, q[..., 1])
    first = np.swapaxes(second, -1, -2) @ a
    turn = np.stack([first, np.broadcast_to(b, first.shape)], axis=-1)
    # the first axis is seen to turn backwards from the child
    rate = -cross(b * u[..., 1:2], first) * u[..., :1]
    fixed = np.zeros(first.shape)
    return JointMotion(about(a, q[..., 0]) @ second, fixed, turn, np.zeros((3, 2)), rate)


def own(
    scene: Scene, i: int, q: Array, rows: tuple[Array, ...], motion: Array | None
) -> tuple[Array, ...]:
    """Coordinates of joint i, then its part of every row (u, udot): own, coupled or prescribed."""
    if scene.prescribed[i]:
        if motion is None:
            raise ValueError("a scene with prescribed joints needs their motion")
        return tuple(motion[..., i, k : k + 1] for k in range(1 + len(rows)))
    leader = scene.leaders[i]
    if leader >= 0:
        ratio, offset = scene.numbers["ratio"][i], scene.numbers["offset"][i]
        first, *rest = own(scene, leader, q, rows, motion)
        return (ratio * first + offset, *(ratio * row for row in rest))
    (start, size), (begin, length) = scene.q[i], scene.u[i]
    return (q[..., start : start + size], *(row[..., begin : begin + length] for row in rows))


def inverse_dynamics(
    scene: Scene, q: Array, u: Array, udot: Array, motion: Array | None = None, pull: float = 1.0
) -> Array:
    """M udot + h (..., nu).

    Args:
        q, u, udot: (..., nq), (..., nu), (..., nu); leading axes broadcast.
        motion: Value, rate and acceleration of prescribed joints, (..., nb, 3).
        pull: Factor on gravity.
    """
    n, numbers = len(scene.parents), scene.numbers
    lead = np.broadcast_shapes(q.shape[:-1], u.shape[:-1], udot.shape[:-1])
    q, u, udot = (np.broadcast_to(x, (*lead, x.shape[-1])) for x in (q, u, udot))
    rotor = numbers.get("rotor", np.zeros(n))
    turned = [np.broadcast_to(np.eye(3), (*lead, 3, 3))]
    omega, alpha = [np.zeros((*lead, 3))], [np.zeros((*lead, 3))]
    accel = [np.broadcast_to(-pull * numbers["gravity"], (*lead, 3))]
    arms, axes, moments, forces, rotors = [], [], [], [], []
    for i in range(n):
        k = scene.parents[i] + 1
        qi, ui, udoti = own(scene, i, q, (u, udot), motion)
        joint = joint_motion(scene, i, qi, ui)
        side = turned[k] @ numbers["rotation"][i]
        body = side @ joint.rotation
        arm = turned[k] @ numbers["position"][i] + _times(side, joint.position)
        # relative motion, then the sum with the motion of the parent
        spin = _times(body, _times(joint.turn, ui))
        drift = _times(side, _times(joint.shift, ui))
        spin_up = _times(body, _times(joint.turn, udoti) + joint.turn_rate)
        w = omega[k]
        omega.append(w + spin)
        alpha.append(alpha[k] + spin_up + cross(w, spin))
        carried = cross(alpha[k], arm) + cross(w, cross(w, arm)) + 2 * cross(w, drift)
        accel.append(accel[k] + carried + _times(side, _times(joint.shift, udoti)))
        turned.append(body)
        arms.append(arm)
        axes.append((body @ joint.turn, side @ joint.shift))
        moment, force = _rates_of_momentum(numbers, i, body, omega[-1], alpha[-1], accel[-1])
        moments.append(moment)
        forces.append(force)
        rotors.append(rotor[i] * udoti)
    return _backward(scene, lead, arms, axes, moments, forces, rotors)


def _rates_of_momentum(
    numbers: Mapping[str, Array], i: int, body: Array, w: Array, alpha: Array, a: Array
) -> tuple[Array, Array]:
    """Moment about the origin and force that move body i."""
    s = _times(body, numbers["first_moment"][i])
    inertia = body @ numbers["inertia"][i] @ np.swapaxes(body, -1, -2)
    force = numbers["mass"][i] * a + cross(alpha, s) + cross(w, cross(w, s))
    moment = _times(inertia, alpha) + cross(w, _times(inertia, w)) + cross(s, a)
    return moment, force


def _backward(
    scene: Scene,
    lead: tuple[int, ...],
    arms: list[Array],
    axes: list[tuple[Array, Array]],
    moments: list[Array],
    forces: list[Array],
    rotors: list[Array],
) -> Array:
    """Joint by joint from the tips: the part of the transmitted wrench along the joint."""
    tau = np.zeros((*lead, scene.nu))
    for i in range(len(scene.parents) - 1, -1, -1):
        turn, shift = axes[i]
        along = _times(np.swapaxes(turn, -1, -2), moments[i])
        along = along + _times(np.swapaxes(shift, -1, -2), forces[i]) + rotors[i]
        j = i
        while scene.leaders[j] >= 0:
            along, j = along * scene.numbers["ratio"][j], scene.leaders[j]
        start, size = scene.u[j]
        if not scene.prescribed[j]:
            tau[..., start : start + size] += along
        k = scene.parents[i]
        if k >= 0:
            moments[k] = moments[k] + moments[i] + cross(arms[i], forces[i])
            forces[k] = forces[k] + forces[i]
    return tau


def mass_matrix(scene: Scene, q: Array, motion: Array | None = None) -> Array:
    """M (..., nu, nu), column by column."""
    still = None if motion is None else motion * [1.0, 0.0, 0.0]
    still = None if still is None else still[..., None, :, :]
    columns = inverse_dynamics(
        scene, q[..., None, :], np.zeros(scene.nu), np.eye(scene.nu), still, pull=0.0
    )
    return np.swapaxes(columns, -1, -2)


def _times(matrix: Array, vector: Array) -> Array:
    """Matrix times vector over leading axes."""
    return np.asarray((matrix @ vector[..., None])[..., 0])
