"""Body quantities, checked against an independent motion of the tree."""

from __future__ import annotations

import numpy as np

from .differences import relative
from .evaluation import Trial
from .joint_motion import Array, cross, times
from .newton_euler import joint_rows, momenta, momenta_of_bodies, moving


def _frame(trial: Trial, name: str) -> tuple[int, Array, Array]:
    """Number of the body of a frame behind the ground, rotation and place in its axes."""
    manifest, numbers = trial.model.manifest, trial.scene.numbers
    bodies = {body.name: k for k, body in enumerate(manifest.bodies)}
    for k, row in enumerate(manifest.frames):
        if row.name == name:
            body = bodies.get(row.body, -1) + 1
            return body, numbers["frame_rotation"][k], numbers["frame_position"][k]
    raise ValueError(f"no frame '{name}'")


def _twist(trial: Trial, name: str, u: Array, udot: Array | None = None) -> Array:
    """Angular velocity and velocity of a frame; with ``udot`` the accelerations."""
    q, _, _, motion = trial.tree
    body, _, position = _frame(trial, name)
    m = moving(trial.scene, q, u, np.zeros_like(u) if udot is None else udot, motion, pull=0.0)
    arm, w = times(m.rotations[body], position), m.omega[body]
    if udot is None:
        return np.concatenate([w, m.velocity[body] + cross(w, arm)], axis=-1)
    alpha = m.alpha[body]
    moved = m.accel[body] + cross(alpha, arm) + cross(w, cross(w, arm))
    return np.concatenate([alpha, moved], axis=-1)


def pose(trial: Trial, of: str) -> float:
    """Transform of a frame."""
    body, rotation, position = _frame(trial, of)
    body_rotation, place = trial.moving.rotations[body], trial.moving.place[body]
    expected = np.zeros((len(place), 4, 4))
    expected[:, :3, :3] = body_rotation @ rotation
    expected[:, :3, 3] = place + times(body_rotation, position)
    expected[:, 3, 3] = 1.0
    value, at = trial.call("pose", of), np.broadcast_to(position, place.shape)
    lengths = relative(value[:, :3, 3] - expected[:, :3, 3], expected[:, :3, 3], at)
    # where everything lies at the origin, rounding of its parts is left
    if np.abs(expected[:, :3, 3]).max(initial=0.0) < 1e-9:
        lengths = _largest(value[:, :3, 3] - expected[:, :3, 3])
    rotation_error = _largest(value[:, :3, :3] - expected[:, :3, :3])
    return max(lengths, rotation_error, _largest(value[:, 3] - expected[:, 3]))


def _largest(difference: Array) -> float:
    """The largest difference of numbers without a unit."""
    return relative(difference, np.ones_like(difference))


def velocity(trial: Trial, of: str) -> float:
    """Angular velocity and velocity of a frame."""
    expected = _twist(trial, of, trial.tree[1])
    return _halves(trial, trial.call("velocity", of), expected, np.abs(trial.reference.u))


def acceleration(trial: Trial, of: str) -> float:
    """Angular acceleration and acceleration of a frame."""
    _, u, udot, _ = trial.tree
    expected = _twist(trial, of, u, udot)
    return _halves(trial, trial.call("acceleration", of), expected, u * u, udot)


def _halves(trial: Trial, value: Array, expected: Array, *terms: Array) -> float:
    """Rotation and translation have units of their own."""
    angular_error = relative(value[:, :3] - expected[:, :3], expected[:, :3], *terms)
    # of a point that rests rounding of turning times distances is left
    swept = expected[:, :3] * float(max(np.abs(p).max(initial=0.0) for p in trial.moving.place))
    return max(angular_error, relative(value[:, 3:] - expected[:, 3:], expected[:, 3:], swept))


def frame_jacobian(trial: Trial, of: str) -> float:
    """Velocity of a frame per speed."""
    value, n = trial.call("frame_jacobian", of), trial.scene.nu
    drift = _twist(trial, of, np.zeros((len(value), n)))
    columns = [
        _twist(trial, of, np.broadcast_to(row, (len(value), n))) - drift for row in np.eye(n)
    ]
    expected = np.stack(columns, axis=-1) if n else np.zeros((len(value), 6, 0))
    if trial.reference.bound is not None:
        expected = expected @ trial.reference.bound.carries
    angular_error = _largest(value[:, :3] - expected[:, :3])
    return max(angular_error, relative(value[:, 3:] - expected[:, 3:], expected[:, 3:]))


def com(trial: Trial, of: str | None) -> float:
    """Center of mass of everything that moves."""
    m, numbers = trial.moving, trial.scene.numbers
    mass, moment = 0.0, np.zeros_like(m.place[0])
    most = moment
    for i in range(len(trial.scene.parents)):
        mass += float(numbers["mass"][i])
        part = numbers["mass"][i] * m.place[i + 1]
        part = part + times(m.rotations[i + 1], numbers["first_moment"][i])
        moment, most = moment + part, np.maximum(most, np.abs(part))
    return relative(trial.call("com") - moment / mass, moment / mass, most / mass)


def momentum(trial: Trial, of: str | None) -> float:
    """Angular momentum about the origin of the ground, and momentum."""
    m = trial.moving
    expected, most = np.zeros((len(trial.reference.q), 6)), np.zeros((len(trial.reference.q), 6))
    for i, (spin, push) in enumerate(zip(*momenta_of_bodies(trial.scene, m), strict=True)):
        part = np.concatenate([spin + cross(m.place[i + 1], push), push], axis=-1)
        expected, most = expected + part, np.maximum(most, np.abs(part))
    value = trial.call("momentum")
    halves = (slice(0, 3), slice(3, 6))
    return max(relative(value[:, h] - expected[:, h], expected[:, h], most[:, h]) for h in halves)


def kinetic(trial: Trial) -> Array:
    """Kinetic energy (n,)."""
    m, total = trial.moving, np.zeros(len(trial.reference.q))
    for i, (spin, push) in enumerate(zip(*momenta_of_bodies(trial.scene, m), strict=True)):
        total = total + 0.5 * ((spin * m.omega[i + 1]).sum(-1) + (push * m.velocity[i + 1]).sum(-1))
    _, u, _, motion = trial.tree
    for i, (_, along) in enumerate(m.rotors):
        rate = joint_rows(trial.scene, i, trial.tree[0], (u,), motion)[1]
        total = total + 0.5 * (along * rate).sum(axis=-1)
    return total


def weight(trial: Trial) -> Array:
    """Potential energy of gravity, zero at the origin of the ground (n,)."""
    m, numbers = trial.moving, trial.scene.numbers
    total = np.zeros(len(trial.reference.q))
    for i in range(len(trial.scene.parents)):
        moment = numbers["mass"][i] * m.place[i + 1]
        moment = moment + times(m.rotations[i + 1], numbers["first_moment"][i])
        total = total - moment @ numbers["gravity"]
    return total


def canonical(trial: Trial) -> Array:
    """p = dT/du (n, nu) along the speeds of the model."""
    return trial.along(momenta(trial.scene, trial.moving))


def momenta_of(trial: Trial, of: str | None) -> float:
    """Momenta along the speeds."""
    expected, fastest = canonical(trial), np.abs(trial.reference.u).max(axis=-1, initial=0.0)
    return relative(
        trial.call("momenta") - expected, expected, (trial.reference.largest * fastest)[:, None]
    )


JUDGES = {
    "pose": pose,
    "velocity": velocity,
    "acceleration": acceleration,
    "frame_jacobian": frame_jacobian,
    "com": com,
    "momentum": momentum,
    "momenta": momenta_of,
}
