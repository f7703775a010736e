"""Gimbal lock in every sequence: where a body has no three angles, and how a run passes it."""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

import cardan as cd
from cardan.spatial.rotations import SEQUENCES

from .case import DAMPED, Case, Cell, alike

SPIN = np.array([0.6, 1.0, -0.4])
TIMES = np.linspace(0, 2.0, 21)
MISS = 1e-3  # by how much the lock is missed [rad]
PROPER = tuple(name for name in SEQUENCES if name[0] == name[2])
OTHERS = tuple(name for name in SEQUENCES if name[0] != name[2])
FIXED = ("RK4", "RKMK4", "EnergyMidpoint")


def lock(sequence: str) -> float:
    """Middle angle at which the first and the third axis are one."""
    return 0.0 if sequence in PROPER else np.pi / 2


def balls(rotations: tuple[str, ...]) -> cd.Scene:
    """A ball on a ball joint for every kind of coordinates; all spin alike, for ever."""
    scene = cd.Scene("balls", gravity=(0, 0, 0))
    for name in rotations:
        ball = scene.body(f"ball_{name}", mass=1.0, com=(0, 0, 0), inertia=(1.0, 1.0, 1.0))
        scene.joint(name, cd.Spherical(rotation=name), scene.ground, ball)
    return scene


def turned(rotations: tuple[str, ...], miss: float, t: float) -> dict[str, Rotation]:
    """Attitudes at a time; after 1 s they are in lock but for a miss."""
    found = {}
    for name in rotations:
        sequence = name if name in SEQUENCES else "XYZ"
        at_lock = Rotation.from_euler(sequence, [0.3, abs(lock(sequence) - miss), -0.5])
        found[name] = at_lock * Rotation.from_rotvec((t - 1.0) * SPIN)
    return found


def start(rotations: tuple[str, ...], miss: float, t: float) -> dict[str, Any]:
    """Initial values of all joints."""
    found = turned(rotations, miss, t)
    q: dict[str, Any] = {}
    for name, attitude in found.items():
        quaternion = attitude.as_quat()[[3, 0, 1, 2]]
        q[name] = attitude.as_euler(name) if name in SEQUENCES else quaternion
    return {"q": q, "u": dict.fromkeys(found, SPIN)}


def error(rotations: tuple[str, ...], miss: float, motion: cd.Trajectory) -> float:
    """Largest error of an attitude [rad]."""
    worst = 0.0
    for k, t in enumerate(motion.t):
        for name, known in turned(rotations, miss, float(t)).items():
            values = motion[name][k]
            angles = name in SEQUENCES
            read = Rotation.from_euler(name, values) if angles else None
            found = read or Rotation.from_quat(values[[1, 2, 3, 0]])
            worst = max(worst, float((known.inv() * found).magnitude()))
    return worst


def nowhere(model: cd.CompiledModel, motion: cd.Trajectory) -> float:
    """How far a run came that cannot start [s]."""
    return float(motion.t[-1])


def at_rest_in_lock(rotations: tuple[str, ...]) -> dict[str, Any]:
    """Three angles, the middle one where it must not be."""
    q = {name: [0.3, lock(name), -0.5] for name in rotations}
    return {"q": q, "u": dict.fromkeys(rotations, SPIN)}


def all_sequences() -> cd.Scene:
    """The twelve."""
    return balls(SEQUENCES)


def quaternion() -> cd.Scene:
    """One without a lock."""
    return balls(("quaternion",))


def proper() -> cd.Scene:
    """Six whose lock is at zero."""
    return balls(PROPER)


def others() -> cd.Scene:
    """Six whose lock is at 90 degrees."""
    return balls(OTHERS)


CASES = (
    Case(
        name="gimbal lock, 12 sequences",
        hard="balls with three angles each, in all sequences, pass within 1e-3 rad of gimbal lock",
        oracle="steady rotation; largest error of an attitude [rad]",
        advice="use a quaternion, the default; with angles, take an adaptive method",
        build=all_sequences,
        t=TIMES,
        start=start(SEQUENCES, MISS, 0.0),
        error=lambda model, motion: error(SEQUENCES, MISS, motion),
        # errors are magnified by 1 / miss; a step of 1e-3 is as long as the miss
        expected=alike(
            explicit=1e-6,
            lower=1e-6,
            implicit=1e-6,
            damped=1e-2,
            fixed=1e-3,
            energy=1e-2,
            EnergyMidpoint=Cell(1e-2, {"step": 1e-3}),
        ),
        # a step must be shorter than the shortest distance from a lock to be told apart from it
        step=1e-4,
        slow=("Radau", "Rosenbrock", *DAMPED),
    ),
    Case(
        name="gimbal lock, quaternion",
        hard="the same ball with a quaternion, straight through the position of the lock",
        oracle="steady rotation; largest error of the attitude [rad]",
        advice="`RKMK853` is exact for steady spins; any other method works too",
        build=quaternion,
        t=TIMES,
        start=start(("quaternion",), 0.0, 0.0),
        error=lambda model, motion: error(("quaternion",), 0.0, motion),
        expected=alike(
            explicit=1e-8, lower=1e-8, implicit=1e-8, damped=1e-3, fixed=1e-10, energy=1e-5
        ),
    ),
    Case(
        name="gimbal lock, started in it, proper sequences",
        hard="the middle angle is 0, so the rates of the other two are undefined",
        oracle="the run must not start; final time [s]",
        advice="use a quaternion, or start elsewhere",
        build=proper,
        t=TIMES,
        start=at_rest_in_lock(PROPER),
        error=nowhere,
        slow=("Radau", "Rosenbrock", *DAMPED),
        expected={name: Cell(0.0, status="not_finite") for name in alike(0, 0, 0, 0, 0, 0)},
    ),
    Case(
        name="gimbal lock, started in it, other sequences",
        hard="the middle angle is 90 degrees; its cosine is 6e-17 and not 0",
        oracle="the run must not start; final time [s]",
        advice="use a quaternion, or start elsewhere",
        build=others,
        t=TIMES,
        start=at_rest_in_lock(OTHERS),
        error=nowhere,
        expected={
            name: Cell(0.0, status="singular_rotation" if name in FIXED else "step_too_small")
            for name in alike(0, 0, 0, 0, 0, 0)
        },
    ),
)
