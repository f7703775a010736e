"""Newton and Euler in NumPy over the flat scene of a manifest: the judge of every build.

Classical relative kinematics in ground axes, batched over states; nothing of spatial, elements or
equations is used.

Source: Roberson, Schwertassek, Dynamics of Multibody Systems, chapters 4 and 6.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ...records import dataclass
from .joint_motion import Array, JointData, cross, joint_motions, joint_pose
from .joint_motion import times as _times


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
            (nb,) and sizes (nb, 2) where there are any.
        joints: What is known of every joint, by body.
        closers: The same of the joints that close loops.
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
    joints: tuple[JointData, ...] = ()
    closers: tuple[JointData, ...] = ()


EMPTY = Scene((), (), (), (), (), (), (), {}, 0)


def joint_rows(
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
        first, *remaining = joint_rows(scene, leader, q, rows, motion)
        return (ratio * first + offset, *(ratio * row for row in remaining))
    (start, size), (begin, length) = scene.q[i], scene.u[i]
    return (q[..., start : start + size], *(row[..., begin : begin + length] for row in rows))


@dataclass(frozen=True)
class Moving:
    """Motion of the bodies of a tree, in ground axes; the ground is entry 0 of every list.

    Attributes:
        rotations, place: Rotation (..., 3, 3) and origin (..., 3) of every body.
        omega, velocity: Angular velocity and velocity of its origin.
        alpha, accel: Their rates; ``accel`` with gravity taken off.
        arms: From the origin of the parent to that of the body, by joint.
        axes: Angular velocity and velocity of the body per speed of its joint, by joint.
        rotors: Rate of the momentum of rotors along the joints, and that momentum, by joint.
    """

    rotations: list[Array]
    place: list[Array]
    omega: list[Array]
    velocity: list[Array]
    alpha: list[Array]
    accel: list[Array]
    arms: list[Array]
    axes: list[tuple[Array, Array]]
    rotors: list[tuple[Array, Array]]


def moving(
    scene: Scene, q: Array, u: Array, udot: Array, motion: Array | None = None, pull: float = 1.0
) -> Moving:
    """The motion of all bodies; arguments as of :func:`inverse_dynamics`."""
    n, numbers = len(scene.parents), scene.numbers
    lead = np.broadcast_shapes(q.shape[:-1], u.shape[:-1], udot.shape[:-1])
    u, udot = (np.broadcast_to(x, (*lead, x.shape[-1])) for x in (u, udot))
    rotor, none = numbers.get("rotor", np.zeros(n)), np.zeros((*lead, 3))
    upright = np.broadcast_to(np.eye(3), (*lead, 3, 3))
    still = np.broadcast_to(-pull * numbers["gravity"], (*lead, 3))
    m = Moving([upright], [none], [none], [none], [none], [still], [], [], [])
    rows = [joint_rows(scene, i, q, (u, udot), motion) for i in range(n)]
    joints = joint_motions(scene.joints, [row[0] for row in rows], [row[1] for row in rows])
    for i, (joint, (_, ui, udoti)) in enumerate(zip(joints, rows, strict=True)):
        k = scene.parents[i] + 1
        side = m.rotations[k] @ numbers["rotation"][i]
        body = side @ joint.rotation
        arm = _times(m.rotations[k], numbers["position"][i]) + _times(side, joint.position)
        # relative motion, then the sum with the motion of the parent
        spin = _times(body, _times(joint.turn, ui))
        drift = _times(side, _times(joint.shift, ui))
        spin_up = _times(body, _times(joint.turn, udoti) + joint.turn_rate)
        w = m.omega[k]
        m.omega.append(w + spin)
        m.velocity.append(m.velocity[k] + cross(w, arm) + drift)
        m.alpha.append(m.alpha[k] + spin_up + cross(w, spin))
        convective = cross(m.alpha[k], arm) + cross(w, cross(w, arm)) + 2 * cross(w, drift)
        push = _times(joint.shift, udoti) + joint.shift_rate
        m.accel.append(m.accel[k] + convective + _times(side, push))
        m.rotations.append(body)
        m.place.append(m.place[k] + arm)
        m.arms.append(arm)
        m.axes.append((body @ joint.turn, side @ joint.shift))
        m.rotors.append((rotor[i] * udoti, rotor[i] * ui))
    return m


def poses(scene: Scene, q: Array) -> tuple[list[Array], list[Array]]:
    """Rotations (..., 3, 3) to ground axes and origins (..., 3) of all bodies.

    Args:
        scene: The tree, without prescribed joints.
        q: (..., nq).
    """
    numbers = scene.numbers
    rotations, place = [np.eye(3)], [np.zeros(3)]
    for i, joint in enumerate(scene.joints):
        k = scene.parents[i] + 1
        rotation, position = joint_pose(joint, joint_rows(scene, i, q, (), None)[0])
        side = rotations[k] @ numbers["rotation"][i]
        place.append(
            place[k] + _times(rotations[k], numbers["position"][i]) + _times(side, position)
        )
        rotations.append(side @ rotation)
    return rotations[1:], place[1:]


def inverse_dynamics(
    scene: Scene, q: Array, u: Array, udot: Array, motion: Array | None = None, pull: float = 1.0
) -> Array:
    """M udot + h (..., nu).

    Args:
        q, u, udot: (..., nq), (..., nu), (..., nu); leading axes broadcast.
        motion: Value, rate and acceleration of prescribed joints, (..., nb, 3).
        pull: Factor on gravity.
    """
    m = moving(scene, q, u, udot, motion, pull)
    pairs = [
        rates_of_momentum(scene.numbers, i, m.rotations[i + 1], m.omega[i + 1], a, b)
        for i, (a, b) in enumerate(zip(m.alpha[1:], m.accel[1:], strict=True))
    ]
    moments, forces = [moment for moment, _ in pairs], [force for _, force in pairs]
    return along_joints(scene, m, moments, forces, [rate for rate, _ in m.rotors])


def momenta_of_bodies(scene: Scene, m: Moving) -> tuple[list[Array], list[Array]]:
    """Angular momentum about its origin and momentum of every body."""
    numbers, spins, pushes = scene.numbers, [], []
    for i in range(len(scene.parents)):
        body, w, v = m.rotations[i + 1], m.omega[i + 1], m.velocity[i + 1]
        s = _times(body, numbers["first_moment"][i])
        inertia = body @ numbers["inertia"][i] @ np.swapaxes(body, -1, -2)
        spins.append(_times(inertia, w) + cross(s, v))
        pushes.append(numbers["mass"][i] * v + cross(w, s))
    return spins, pushes


def momenta(scene: Scene, m: Moving) -> Array:
    """p (..., nu): derivative of the kinetic energy by the speeds of the tree."""
    return along_joints(scene, m, *momenta_of_bodies(scene, m), [spin for _, spin in m.rotors])


def rates_of_momentum(
    numbers: Mapping[str, Array], i: int, body: Array, w: Array, alpha: Array, a: Array
) -> tuple[Array, Array]:
    """Moment about the origin and force that move body i."""
    s = _times(body, numbers["first_moment"][i])
    inertia = body @ numbers["inertia"][i] @ np.swapaxes(body, -1, -2)
    force = numbers["mass"][i] * a + cross(alpha, s) + cross(w, cross(w, s))
    moment = _times(inertia, alpha) + cross(w, _times(inertia, w)) + cross(s, a)
    return moment, force


def along_joints(
    scene: Scene, m: Moving, moments: list[Array], forces: list[Array], rotors: list[Array]
) -> Array:
    """Joint by joint from the tips: the part of the transmitted wrench along the joint (..., nu).

    Args:
        scene, m: The tree and its motion.
        moments, forces: On every body, the moment about its origin.
        rotors: Along every joint.
    """
    return transmitted(scene, m, moments, forces, rotors)[0]


def transmitted(
    scene: Scene, m: Moving, moments: list[Array], forces: list[Array], rotors: list[Array]
) -> tuple[Array, list[Array], list[Array]]:
    """Same as :func:`along_joints`; and moment and force that every joint hands on to its body."""
    moments, forces = [*moments], [*forces]
    lead = m.omega[0].shape[:-1]
    tau = np.zeros((*lead, scene.nu), dtype=np.result_type(*moments, float))
    for i in range(len(scene.parents) - 1, -1, -1):
        turn, shift = m.axes[i]
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
            moments[k] = moments[k] + moments[i] + cross(m.arms[i], forces[i])
            forces[k] = forces[k] + forces[i]
    return tau, moments, forces


def mass_matrix(scene: Scene, q: Array, motion: Array | None = None) -> Array:
    """M (..., nu, nu), column by column."""
    still = None if motion is None else motion * [1.0, 0.0, 0.0]
    still = None if still is None else still[..., None, :, :]
    columns = inverse_dynamics(
        scene, q[..., None, :], np.zeros(scene.nu), np.eye(scene.nu), still, pull=0.0
    )
    return np.swapaxes(columns, -1, -2)
