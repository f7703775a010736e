"""Newton and Euler in NumPy over the flat scene of a manifest: the judge of every build.

Classical relative kinematics in ground axes, batched over states; nothing of spatial, elements or
equations is used.

Source: Roberson, Schwertassek, Dynamics of Multibody Systems, chapters 4 and 6.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from .joint_motion import Array, Curve, Told, cross, joint_motion
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
        curves: Of points on curves, by body; () without any.
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
    curves: tuple[Curve | None, ...] = ()

    def told(self, i: int) -> Told:
        """What is known about joint i."""
        n = self.numbers
        return Told(
            self.kinds[i],
            self.rotations[i],
            n["axis"][i],
            n["axis2"][i],
            float(n["pitch"][i]),
            n["sizes"][i] if "sizes" in n else np.zeros(2),
            self.curves[i] if self.curves else None,
        )


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
        joint = joint_motion(scene.told(i), qi, ui)
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
        push = _times(joint.shift, udoti) + joint.shift_rate
        accel.append(accel[k] + carried + _times(side, push))
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
