"""What bodies do, judged by a motion of the tree of the judge's own."""

from __future__ import annotations

import numpy as np

from .differences import relative
from .evaluation import Asked
from .joint_motion import Array, cross, times
from .newton_euler import momenta, momenta_of_bodies, moving, own


def _frame(asked: Asked, name: str) -> tuple[int, Array, Array]:
    """Number of the body of a frame behind the ground, rotation and place in its axes."""
    manifest, numbers = asked.model.manifest, asked.scene.numbers
    bodies = {body.name: k for k, body in enumerate(manifest.bodies)}
    for k, row in enumerate(manifest.frames):
        if row.name == name:
            body = bodies.get(row.body, -1) + 1
            return body, numbers["frame_rotation"][k], numbers["frame_position"][k]
    raise ValueError(f"no frame '{name}'")


def _twist(asked: Asked, name: str, u: Array, udot: Array | None = None) -> Array:
    """Angular velocity and velocity of a frame; with ``udot`` the accelerations."""
    q, _, _, motion = asked.tree
    body, _, position = _frame(asked, name)
    m = moving(asked.scene, q, u, np.zeros_like(u) if udot is None else udot, motion, pull=0.0)
    arm, w = times(m.turned[body], position), m.omega[body]
    if udot is None:
        return np.concatenate([w, m.velocity[body] + cross(w, arm)], axis=-1)
    alpha = m.alpha[body]
    moved = m.accel[body] + cross(alpha, arm) + cross(w, cross(w, arm))
    return np.concatenate([alpha, moved], axis=-1)


def pose(asked: Asked, of: str) -> float:
    """Transform of a frame."""
    body, rotation, position = _frame(asked, of)
    turned, place = asked.moving.turned[body], asked.moving.place[body]
    known = np.zeros((len(place), 4, 4))
    known[:, :3, :3] = turned @ rotation
    known[:, :3, 3] = place + times(turned, position)
    known[:, 3, 3] = 1.0
    value, at = asked.call("pose", of), np.broadcast_to(position, place.shape)
    lengths = relative(value[:, :3, 3] - known[:, :3, 3], known[:, :3, 3], at)
    # where everything lies at the origin, rounding of its parts is left
    if np.abs(known[:, :3, 3]).max(initial=0.0) < 1e-9:
        lengths = _apart(value[:, :3, 3] - known[:, :3, 3])
    rest = _apart(value[:, :3, :3] - known[:, :3, :3])
    return max(lengths, rest, _apart(value[:, 3] - known[:, 3]))


def _apart(difference: Array) -> float:
    """The largest difference of numbers without a unit."""
    return relative(difference, np.ones_like(difference))


def velocity(asked: Asked, of: str) -> float:
    """Angular velocity and velocity of a frame."""
    known = _twist(asked, of, asked.tree[1])
    return _halves(asked, asked.call("velocity", of), known, np.abs(asked.truth.u))


def acceleration(asked: Asked, of: str) -> float:
    """Angular acceleration and acceleration of a frame."""
    _, u, udot, _ = asked.tree
    known = _twist(asked, of, u, udot)
    return _halves(asked, asked.call("acceleration", of), known, u * u, udot)


def _halves(asked: Asked, value: Array, known: Array, *terms: Array) -> float:
    """Rotation and translation have units of their own."""
    turning = relative(value[:, :3] - known[:, :3], known[:, :3], *terms)
    # of a point that rests rounding of turning times distances is left
    swept = known[:, :3] * float(max(np.abs(p).max(initial=0.0) for p in asked.moving.place))
    return max(turning, relative(value[:, 3:] - known[:, 3:], known[:, 3:], swept))


def frame_jacobian(asked: Asked, of: str) -> float:
    """Velocity of a frame per speed."""
    value, n = asked.call("frame_jacobian", of), asked.scene.nu
    rest = _twist(asked, of, np.zeros((len(value), n)))
    columns = [_twist(asked, of, np.broadcast_to(row, (len(value), n))) - rest for row in np.eye(n)]
    known = np.stack(columns, axis=-1) if n else np.zeros((len(value), 6, 0))
    if asked.truth.bound is not None:
        known = known @ asked.truth.bound.carries
    turning = _apart(value[:, :3] - known[:, :3])
    return max(turning, relative(value[:, 3:] - known[:, 3:], known[:, 3:]))


def com(asked: Asked, of: str | None) -> float:
    """Center of mass of everything that moves."""
    m, numbers = asked.moving, asked.scene.numbers
    mass, moment = 0.0, np.zeros_like(m.place[0])
    most = moment
    for i in range(len(asked.scene.parents)):
        mass += float(numbers["mass"][i])
        part = numbers["mass"][i] * m.place[i + 1]
        part = part + times(m.turned[i + 1], numbers["first_moment"][i])
        moment, most = moment + part, np.maximum(most, np.abs(part))
    return relative(asked.call("com") - moment / mass, moment / mass, most / mass)


def momentum(asked: Asked, of: str | None) -> float:
    """Angular momentum about the origin of the ground, and momentum."""
    m = asked.moving
    known, most = np.zeros((len(asked.truth.q), 6)), np.zeros((len(asked.truth.q), 6))
    for i, (spin, push) in enumerate(zip(*momenta_of_bodies(asked.scene, m), strict=True)):
        part = np.concatenate([spin + cross(m.place[i + 1], push), push], axis=-1)
        known, most = known + part, np.maximum(most, np.abs(part))
    value = asked.call("momentum")
    halves = (slice(0, 3), slice(3, 6))
    return max(relative(value[:, h] - known[:, h], known[:, h], most[:, h]) for h in halves)


def kinetic(asked: Asked) -> Array:
    """Kinetic energy (n,)."""
    m, total = asked.moving, np.zeros(len(asked.truth.q))
    for i, (spin, push) in enumerate(zip(*momenta_of_bodies(asked.scene, m), strict=True)):
        total = total + 0.5 * ((spin * m.omega[i + 1]).sum(-1) + (push * m.velocity[i + 1]).sum(-1))
    _, u, _, motion = asked.tree
    for i, (_, along) in enumerate(m.rotors):
        rate = own(asked.scene, i, asked.tree[0], (u,), motion)[1]
        total = total + 0.5 * (along * rate).sum(axis=-1)
    return total


def weight(asked: Asked) -> Array:
    """Potential energy of gravity, zero at the origin of the ground (n,)."""
    m, numbers = asked.moving, asked.scene.numbers
    total = np.zeros(len(asked.truth.q))
    for i in range(len(asked.scene.parents)):
        moment = numbers["mass"][i] * m.place[i + 1]
        moment = moment + times(m.turned[i + 1], numbers["first_moment"][i])
        total = total - moment @ numbers["gravity"]
    return total


def canonical(asked: Asked) -> Array:
    """p = dT/du (n, nu) along the speeds of the model."""
    return asked.along(momenta(asked.scene, asked.moving))


def momenta_of(asked: Asked, of: str | None) -> float:
    """Momenta along the speeds."""
    known, fastest = canonical(asked), np.abs(asked.truth.u).max(axis=-1, initial=0.0)
    return relative(asked.call("momenta") - known, known, (asked.truth.largest * fastest)[:, None])


JUDGES = {
    "pose": pose,
    "velocity": velocity,
    "acceleration": acceleration,
    "frame_jacobian": frame_jacobian,
    "com": com,
    "momentum": momentum,
    "momenta": momenta_of,
}
