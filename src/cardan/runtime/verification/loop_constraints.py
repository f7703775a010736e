"""Loop constraints of a tree, in NumPy, for the verification of every build.

A joint that closes a loop gets coordinates and speeds of its own, behind those of the tree: its
two frames must lie and move against each other as :mod:`.joint_motion` says the joint does. These
are six conditions per joint, whatever its kind; no closing condition of the catalogue is used.

Source: Roberson, Schwertassek, Dynamics of Multibody Systems, chapters 4 and 8.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ...records import dataclass
from ...schema.manifest import Manifest
from .joint_motion import Array, JointData, JointMotion, cross, joint_motion, joint_motions, times
from .newton_euler import Scene, joint_rows
from .rotations import PARAMETERS, vector_of

STEP = 1e-30
SLIPS = ("longitudinal", "lateral")


@dataclass(frozen=True)
class End:
    """A frame of a body (-1: the ground), in its axes."""

    body: int
    rotation: Array
    position: Array


@dataclass(frozen=True)
class Closer:
    """A joint that closes a loop.

    Attributes:
        name: Of the joint.
        joint: What is known about it; its rotation is described by a quaternion.
        parent, child: Its frames.
        q, u: (first, size) of its own coordinates and speeds.
    """

    name: str
    joint: JointData
    parent: End
    child: End
    q: tuple[int, int]
    u: tuple[int, int]


@dataclass(frozen=True)
class Slip:
    """Slip that must vanish.

    Attributes:
        name: Of the joint.
        wheel: Wheel or disk, as declared.
        axes: The normal of its plane, and where it heads at first, (2, 3).
        joint: Number of the tree joint, or of the closer behind them.
        rows: Of 0 (along the heading) and 1 (sideways).
    """

    name: str
    wheel: JointData
    axes: Array
    joint: int
    rows: tuple[int, ...]


@dataclass(frozen=True)
class Circuits:
    """A tree, what closes its loops, and what may not slip.

    Attributes:
        scene: The tree; the system's own coordinates and speeds come first.
        closers: The joints that close loops; those solved in closed form first.
        slips: Velocities that vanish.
        nq, nu: Number of coordinates and speeds, those of the closers included.
    """

    scene: Scene
    closers: tuple[Closer, ...]
    slips: tuple[Slip, ...]
    nq: int
    nu: int


@dataclass(frozen=True)
class Moving:
    """A frame of the ground or of a body: R (..., 3, 3), place, angular velocity, velocity."""

    rotation: Array
    position: Array
    omega: Array
    moving: Array

    def on_body(self, rotation: Array, position: Array) -> Moving:
        """A frame fixed to this one."""
        arm = times(self.rotation, position)
        moving = self.moving + cross(self.omega, arm)
        return Moving(self.rotation @ rotation, self.position + arm, self.omega, moving)

    def after(self, joint: JointMotion, u: Array) -> Moving:
        """The child frame of a joint whose parent frame this is."""
        arm, rotation = times(self.rotation, joint.position), self.rotation @ joint.rotation
        drift = times(self.rotation, times(joint.shift, u))
        omega = self.omega + times(rotation, times(joint.turn, u))
        moving = self.moving + cross(self.omega, arm) + drift
        return Moving(rotation, self.position + arm, omega, moving)


def frames(scene: Scene, joints: Sequence[JointMotion], u: Sequence[Array]) -> list[Moving]:
    """The ground, then the bodies that the first joints of a tree carry with these speeds."""
    none = np.zeros(3)
    bodies, numbers = [Moving(np.eye(3), none, none, none)], scene.numbers
    for i, joint in enumerate(joints):
        inboard = bodies[scene.parents[i] + 1]
        seat = inboard.on_body(numbers["rotation"][i], numbers["position"][i])
        bodies.append(seat.after(joint, u[i]))
    return bodies


def conditions(circuits: Circuits, q: Array, u: Array, motion: Array | None) -> tuple[Array, Array]:
    """Residuals that vanish where loops are closed, and rates that vanish while they move.

    Args:
        circuits: The system.
        q, u: (..., nq), (..., nu) of everything; leading axes broadcast.
        motion: Value and rate of prescribed joints, (..., nb, 2 or more).

    Returns:
        (..., 6 closers): rotation vector [rad] and place [m] by which every child frame misses its
        place; (..., 6 closers + slips): velocities, the first are the rates of the former.
    """
    scene = circuits.scene
    rows = [joint_rows(scene, i, q, (u,), motion) for i in range(len(scene.parents))]
    for closer in circuits.closers:
        rows.append(tuple(x[..., s : s + n] for x, (s, n) in ((q, closer.q), (u, closer.u))))
    qs, us = [row[0] for row in rows], [row[1] for row in rows]
    kinds = [*scene.joints, *(closer.joint for closer in circuits.closers)]
    # nothing is asked that depends on their speeds
    joints = joint_motions(kinds, qs, [np.zeros(ui.shape[-1]) for ui in us])
    bodies = frames(scene, joints[: len(scene.parents)], us)
    missed: list[Array] = []
    rates: list[Array] = []
    for i, closer in enumerate(circuits.closers, len(scene.parents)):
        parent, child = (
            bodies[end.body + 1].on_body(end.rotation, end.position)
            for end in (closer.parent, closer.child)
        )
        separation = _separation(parent, child, parent.after(joints[i], us[i]))
        missed += separation[:2]
        rates += separation[2:]
    for slip in circuits.slips:
        velocity = _slipping(slip, qs[slip.joint], us[slip.joint])
        rates.append(velocity[..., list(slip.rows)])
    lead = np.broadcast_shapes(q.shape[:-1], u.shape[:-1])
    return _joined(missed, lead), _joined(rates, lead)


def _separation(parent: Moving, child: Moving, there: Moving) -> tuple[Array, Array, Array, Array]:
    """By which rotation and way a frame misses its place, and the rates of both.

    Args:
        parent, child: Frames of a joint that closes a loop.
        there: Where the joint carries the child frame.
    """
    back, axes = (np.swapaxes(x.rotation, -1, -2) for x in (parent, child))
    relative = np.swapaxes(there.rotation, -1, -2) @ child.rotation
    away = child.position - there.position
    drift = child.moving - there.moving - cross(parent.omega, away)
    spin = child.omega - there.omega
    return vector_of(relative), times(back, away), times(axes, spin), times(back, drift)


def _joined(rows: Sequence[Array], lead: tuple[int, ...]) -> Array:
    if not rows:
        return np.zeros((*lead, 0))
    lead = np.broadcast_shapes(*(row.shape[:-1] for row in rows))
    return np.concatenate([np.broadcast_to(r, (*lead, r.shape[-1])) for r in rows], axis=-1)


def _slipping(slip: Slip, q: Array, u: Array) -> Array:
    """Velocity (..., 2) of the material point of contact, along the heading and across it."""
    joint = joint_motion(slip.wheel, q, u)
    normal, x = slip.axes / np.linalg.norm(slip.axes, axis=-1, keepdims=True)
    y = cross(normal, x)
    contact = q[..., :1] * x + q[..., 1:2] * y
    spin = times(joint.rotation @ joint.turn, u)
    velocity = times(joint.shift, u) + cross(spin, contact - joint.position)
    c, s = np.cos(q[..., 2:3]), np.sin(q[..., 2:3])
    heading, sideways = c * x + s * y, c * y - s * x
    return np.stack([(velocity * d).sum(axis=-1) for d in (heading, sideways)], axis=-1)


def jacobian(circuits: Circuits, q: Array, motion: Array | None) -> tuple[Array, Array, Array]:
    """G (..., m, nu), the rates at rest (..., m) of prescribed motion, and what is missed."""
    wide = None if motion is None else motion[..., None, :, :]
    columns = np.vstack([np.zeros(circuits.nu), np.eye(circuits.nu)])
    missed, rates = conditions(circuits, q[..., None, :], columns, wide)
    rates = np.broadcast_to(rates, (*q.shape[:-1], *rates.shape[-2:]))
    G = np.swapaxes(rates[..., 1:, :] - rates[..., :1, :], -1, -2)
    return G, rates[..., 0, :], missed[..., 0, :] if missed.ndim > 1 else missed


def rates_of(circuits: Circuits, q: Array, u: Array) -> Array:
    """Rates of the coordinates (..., nq) of speeds."""
    qdot = np.zeros_like(q)
    rotations: dict[str, list[tuple[int, int]]] = {}
    for (first, size), (start, count), rotation in _blocks(circuits):
        n = PARAMETERS[rotation].size if rotation else 0
        k = 3 if rotation else 0
        qdot[..., first + n : first + size] = u[..., start + k : start + count]
        if rotation:
            rotations.setdefault(rotation, []).append((first, start))
    for rotation, begins in rotations.items():
        # all rotations of one kind at once: (joints, coordinates) and (joints, 3)
        firsts, starts = np.array(begins).T[..., None]
        at = firsts + np.arange(PARAMETERS[rotation].size)
        qdot[..., at] = _coordinate_rates(rotation, q[..., at], u[..., starts + np.arange(3)])
    return qdot


def _blocks(circuits: Circuits) -> list[tuple[tuple[int, int], tuple[int, int], str | None]]:
    """Slots in q and u of every joint that has some, and how its rotation is described."""
    scene = circuits.scene
    blocks = [
        (scene.q[i], scene.u[i], scene.rotations[i])
        for i in range(len(scene.parents))
        if scene.leaders[i] < 0 and not scene.prescribed[i]
    ]
    return [*blocks, *((c.q, c.u, c.joint.rotation) for c in circuits.closers)]


def _coordinate_rates(rotation: str, q: Array, omega: Array) -> Array:
    """Rates of the coordinates of a rotation: R [omega] = sum of dR/dq qdot, the shortest."""
    matrix = PARAMETERS[rotation].matrix
    steps = 1j * STEP * np.eye(q.shape[-1])
    slopes = matrix(q[..., None, :] + steps).imag / STEP
    slopes = np.swapaxes(slopes.reshape(*slopes.shape[:-2], 9), -1, -2)
    columns = np.swapaxes(cross(omega[..., None, :], np.eye(3)), -1, -2)
    target = (matrix(q) @ columns).reshape(*q.shape[:-1], 9)
    return times(np.linalg.pinv(slopes, rcond=1e-9), target)


def normalized(circuits: Circuits, q: Array) -> Array:
    """Coordinates whose quaternions and direction cosines are those of rotations again."""
    q = q.copy()
    for (first, _), _, rotation in _blocks(circuits):
        if rotation == "quaternion":
            part = q[..., first : first + 4]
            q[..., first : first + 4] = part / np.linalg.norm(part, axis=-1, keepdims=True)
        elif rotation == "dcm":
            a, b = q[..., first : first + 3], q[..., first + 3 : first + 6]
            a = a / np.linalg.norm(a, axis=-1, keepdims=True)
            b = b - a * (a * b).sum(axis=-1, keepdims=True)
            b = b / np.linalg.norm(b, axis=-1, keepdims=True)
            q[..., first : first + 6] = np.concatenate([a, b], axis=-1)
    return q


def circuits_of(manifest: Manifest, scene: Scene, nq: int) -> Circuits:
    """The loops of a model by its manifest and flat scene with ``nq`` tree coordinates."""
    numbers = scene.numbers
    bodies = {body.name: k for k, body in enumerate(manifest.bodies)}
    ends = {
        f.name: End(
            bodies.get(f.body, -1), numbers["frame_rotation"][k], numbers["frame_position"][k]
        )
        for k, f in enumerate(manifest.frames)
    }
    closers, nu = [], scene.nu
    rows = manifest.scene.closers
    for cut, joint, row in zip(manifest.cuts, scene.closers, rows, strict=True):
        sides = ends[cut.parent_frame], ends[cut.child_frame]
        size, count = row.q, row.u
        closers.append(Closer(cut.name, joint, *sides, (nq, size), (nu, count)))
        nq, nu = nq + size, nu + count
    return Circuits(scene, tuple(closers), _slips(manifest, scene, closers), nq, nu)


def _slips(manifest: Manifest, scene: Scene, closers: Sequence[Closer]) -> tuple[Slip, ...]:
    """Slips that must vanish, by the names of the velocity constraints."""
    names = [joint.name for joint in manifest.joints]
    joints = [*scene.joints, *(closer.joint for closer in closers)]
    lines = [np.stack([scene.numbers[k] for k in ("axis", "axis2")], axis=1)]
    if closers:
        lines.append(np.stack([scene.numbers[k] for k in ("cut_axis", "cut_axis2")], axis=1))
    axes = np.concatenate(lines)
    names += [closer.name for closer in closers]
    rows: dict[str, list[int]] = {}
    for row in manifest.multipliers:
        if row.level == "velocity" and row.joint in names:
            component = row.name.rpartition(".")[2]
            rows.setdefault(row.joint, []).append(SLIPS.index(component))
    slips = []
    for name, which in rows.items():
        at = names.index(name)
        # coordinates and speeds of a joint that is told backwards are those of the declared one
        declared = replace(joints[at], reversed=False)
        slips.append(Slip(name, declared, axes[at], at, tuple(which)))
    return tuple(slips)
