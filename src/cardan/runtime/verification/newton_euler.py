"""Newton and Euler in NumPy over the flat scene of a manifest: the judge of every build.

Classical relative kinematics in ground axes, batched over states; nothing of spatial, elements or
equations is used.

Source: Roberson, Schwertassek, Dynamics of Multibody Systems, chapters 4 and 6.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from ...records import dataclass
from .joint_motion import (
    Array,
    JointData,
    JointGroup,
    JointMotion,
    cross,
    joint_groups,
    joint_pose,
    times,
)
from .tree_sums import BodyTree, Indices


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
        axes: Of joints that are alike their numbers, and angular velocity and velocity of the
            body per speed of its joint, (..., joints, 3, n).
        rotors: Rate of the momentum of rotors along the joints, and that momentum, by joint.
    """

    rotations: list[Array]
    place: list[Array]
    omega: list[Array]
    velocity: list[Array]
    alpha: list[Array]
    accel: list[Array]
    axes: list[tuple[list[int], Array, Array]]
    rotors: list[tuple[Array, Array]]


def moving(
    scene: Scene, q: Array, u: Array, udot: Array, motion: Array | None = None, pull: float = 1.0
) -> Moving:
    """The motion of all bodies; arguments as of :func:`inverse_dynamics`."""
    n, numbers, tree = len(scene.parents), scene.numbers, BodyTree(scene.parents)
    lead = np.broadcast_shapes(q.shape[:-1], u.shape[:-1], udot.shape[:-1])
    u, udot = (np.broadcast_to(x, (*lead, x.shape[-1])) for x in (u, udot))
    rows = [joint_rows(scene, i, q, (u, udot), motion) for i in range(n)]
    groups = joint_groups(scene.joints, *([row[k] for row in rows] for k in range(3)))
    # of every joint: rotation and place in its frame, then what its speeds do, the ground first
    parts = [_of_bodies(n, groups, name) for name in ("rotation", "position")]
    spin, spin_up, drift, push = (_of_bodies(n, groups, name) for name in RATES)
    frames = np.concatenate([np.eye(3)[None], numbers["rotation"].reshape(n, 3, 3)])
    position = np.concatenate([np.zeros((1, 3)), numbers["position"].reshape(n, 3)])
    above, inward = tree.parents, frames @ parts[0]
    inward[..., 0, :, :] = np.eye(3)
    rotations = tree.rotations(inward)
    carrier = rotations.take(above, axis=-3)
    side = carrier @ frames
    arm = times(carrier, position) + times(side, parts[1])
    # relative motion, then the sum with the motion of the ancestors
    spin, drift, push = times(rotations, spin), times(side, drift), times(side, push)
    omega = tree.sums(spin)
    w = omega.take(above, axis=-2)
    velocity = tree.sums(cross(w, arm) + drift)
    alpha = tree.sums(times(rotations, spin_up) + cross(w, spin))
    convective = cross(alpha.take(above, axis=-2), arm) + cross(w, cross(w, arm))
    accel = tree.sums(convective + 2 * cross(w, drift) + push) - pull * numbers["gravity"]
    rotor = numbers.get("rotor", np.zeros(n))
    axes = []
    for which, joint, _, _ in groups:
        turn = rotations[..., [i + 1 for i in which], :, :] @ joint.turn
        axes.append((which, turn, side[..., [i + 1 for i in which], :, :] @ joint.shift))
    rows_of = [tree.sums(arm), omega, velocity, alpha, accel]
    place, omegas, velocities, alphas, accels = (
        _by_body(x, (*lead, n + 1, 3), -2) for x in rows_of
    )
    return Moving(
        _by_body(rotations, (*lead, n + 1, 3, 3), -3),
        place,
        omegas,
        velocities,
        alphas,
        accels,
        axes,
        [(rotor[i] * row[2], rotor[i] * row[1]) for i, row in enumerate(rows)],
    )


# what the speeds of a joint and their rates do: angular velocity and acceleration of its child in
# child axes, velocity and acceleration in axes of the frame of the parent, at given motion of that
RATES: dict[str, Callable[[JointMotion, Array, Array], Array]] = {
    "spin": lambda joint, u, udot: times(joint.turn, u),
    "spin_up": lambda joint, u, udot: times(joint.turn, udot) + joint.turn_rate,
    "drift": lambda joint, u, udot: times(joint.shift, u),
    "push": lambda joint, u, udot: times(joint.shift, udot) + joint.shift_rate,
}


def _of_bodies(n: int, groups: Sequence[JointGroup], name: str) -> Array:
    """A quantity of all joints (..., 1 + n, 3) or (..., 1 + n, 3, 3), 0 for the ground."""
    values = [
        (which, RATES[name](joint, u, udot) if name in RATES else getattr(joint, name))
        for which, joint, u, udot in groups
    ]
    tail = 3 if name == "rotation" else 2
    shapes = [x.shape[: x.ndim - tail] for _, x in values]
    cell = (3, 3) if name == "rotation" else (3,)
    kind = np.result_type(float, *(x for _, x in values))
    result = np.zeros((*np.broadcast_shapes(*shapes), n + 1, *cell), dtype=kind)
    for which, x in values:
        at = [i + 1 for i in which]
        if name == "rotation":
            result[..., at, :, :] = x
        else:
            result[..., at, :] = x
    return result


def _by_body(x: Array, shape: tuple[int, ...], axis: int) -> list[Array]:
    """Views of an array by body."""
    return list(np.moveaxis(np.broadcast_to(x, shape), axis, 0))


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
        place.append(place[k] + times(rotations[k], numbers["position"][i]) + times(side, position))
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
    if not scene.parents:
        return along_joints(scene, m, [], [], [])
    rows = (np.stack(x[1:], axis=-2) for x in (m.omega, m.alpha, m.accel))
    bodies = np.stack(m.rotations[1:], axis=-3)
    pair = rates_of_momentum(scene.numbers, slice(None), bodies, *rows)
    moments, forces = (list(np.moveaxis(x, -2, 0)) for x in pair)
    return along_joints(scene, m, moments, forces, [rate for rate, _ in m.rotors])


def momenta_of_bodies(scene: Scene, m: Moving) -> tuple[list[Array], list[Array]]:
    """Angular momentum about its origin and momentum of every body."""
    numbers, spins, pushes = scene.numbers, [], []
    for i in range(len(scene.parents)):
        body, w, v = m.rotations[i + 1], m.omega[i + 1], m.velocity[i + 1]
        s = times(body, numbers["first_moment"][i])
        inertia = body @ numbers["inertia"][i] @ np.swapaxes(body, -1, -2)
        spins.append(times(inertia, w) + cross(s, v))
        pushes.append(numbers["mass"][i] * v + cross(w, s))
    return spins, pushes


def momenta(scene: Scene, m: Moving) -> Array:
    """p (..., nu): derivative of the kinetic energy by the speeds of the tree."""
    return along_joints(scene, m, *momenta_of_bodies(scene, m), [spin for _, spin in m.rotors])


def rates_of_momentum(
    numbers: Mapping[str, Array], i: int | slice, body: Array, w: Array, alpha: Array, a: Array
) -> tuple[Array, Array]:
    """Moment about the origin and force that move body i, or several bodies at once."""
    s = times(body, numbers["first_moment"][i])
    inertia = body @ numbers["inertia"][i] @ np.swapaxes(body, -1, -2)
    force = numbers["mass"][i][..., None] * a + cross(alpha, s) + cross(w, cross(w, s))
    moment = times(inertia, alpha) + cross(w, times(inertia, w)) + cross(s, a)
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
    lead = m.omega[0].shape[:-1]
    tau = np.zeros((*lead, scene.nu), dtype=np.result_type(*moments, float))
    if not moments:
        return tau, [], []
    place = np.stack(m.place, axis=-2)
    every = np.broadcast_arrays(np.zeros(3), *moments, *forces)
    end = len(moments) + 1
    rows = ([every[0], *every[1:end]], [every[0], *every[end:]])
    wrenches = np.concatenate([np.stack(row, axis=-2) for row in rows], axis=-1)

    def shift(wrench: Array, bodies: Indices, above: Indices) -> Array:
        """Wrenches about the origins of other bodies."""
        arms = place.take(bodies, axis=-2) - place.take(above, axis=-2)
        moment = wrench[..., :3] + cross(arms, wrench[..., 3:])
        return np.concatenate([moment, np.broadcast_to(wrench[..., 3:], moment.shape)], axis=-1)

    wrenches = BodyTree(scene.parents).subtree_sums(wrenches, shift)
    for which, turn, push in m.axes:
        at = wrenches[..., [i + 1 for i in which], :]
        several = times(np.swapaxes(turn, -1, -2), at[..., :3])
        several = several + times(np.swapaxes(push, -1, -2), at[..., 3:])
        for number, i in enumerate(which):
            along, j = several[..., number, :] + rotors[i], i
            while scene.leaders[j] >= 0:
                along, j = along * scene.numbers["ratio"][j], scene.leaders[j]
            start, size = scene.u[j]
            if not scene.prescribed[j]:
                tau[..., start : start + size] += along
    handed = list(np.moveaxis(wrenches[..., 1:, :], -2, 0))
    return tau, [x[..., :3] for x in handed], [x[..., 3:] for x in handed]


def mass_matrix(scene: Scene, q: Array, motion: Array | None = None) -> Array:
    """M (..., nu, nu), column by column."""
    still = None if motion is None else motion * [1.0, 0.0, 0.0]
    still = None if still is None else still[..., None, :, :]
    columns = inverse_dynamics(
        scene, q[..., None, :], np.zeros(scene.nu), np.eye(scene.nu), still, pull=0.0
    )
    return np.swapaxes(columns, -1, -2)
