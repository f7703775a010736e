"""One body per rotation parametrization, moving where its parameters are regular."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from itertools import product

import numpy as np

import cardan as cd

from .mechanism import Mechanism, State

UNIT = {"x": np.array([1, 0, 0]), "y": np.array([0, 1, 0]), "z": np.array([0, 0, 1])}
SEQUENCES = tuple(
    "".join(letters)
    for letters in (*product("XYZ", repeat=3), *product("xyz", repeat=3))
    if letters[0] != letters[1] != letters[2]
)

# rotation by phi about n -> coordinates, and the phi at which they break down
VECTORS: dict[str, tuple[Callable[[float], float], float]] = {
    "rodrigues": (lambda phi: np.tan(phi / 2), np.pi),
    "mrp": (lambda phi: np.tan(phi / 4), 2 * np.pi),
    "conformal": (lambda phi: 4 * np.tan(phi / 4), 2 * np.pi),
    "rotation_vector": (lambda phi: phi, 2 * np.pi),
    "euler_rodrigues": (lambda phi: 2 * np.sin(phi / 2), np.pi),
    "linear": (np.sin, np.pi / 2),
}
REGULAR = ("quaternion", "dcm")
ROTATIONS = (*SEQUENCES, *VECTORS, *REGULAR)


def intrinsic(rotation: str) -> str:
    """The body-fixed sequence of a space-fixed or body-fixed one, in small letters."""
    return rotation.lower() if rotation.isupper() else rotation[::-1]


def is_proper(rotation: str) -> bool:
    """True for Euler sequences proper, such as ZXZ, singular where the middle angle is 0."""
    return rotation[0] == rotation[2]


def hanging(rotation: str) -> tuple[np.ndarray, np.ndarray]:
    """Direction of gravity and of the center of mass in the body.

    Hanging at rest is as far from the singularity as can be, and turning about the vertical
    keeps that distance: the vertical is the first axis of the sequence.
    """
    if rotation not in SEQUENCES:
        return -UNIT["z"], -UNIT["z"]
    first, middle = (UNIT[letter] for letter in intrinsic(rotation)[:2])
    if not is_proper(rotation):
        return -first, -first
    # at rest the middle angle is a right one: turn the downward direction back by it
    return -first, middle * (middle @ -first) - np.cross(middle, -first)


def margin(rotation: str, matrix: np.ndarray) -> float:
    """Distance [rad] of a rotation matrix to where the parameters break down."""
    if rotation in REGULAR:
        return np.inf
    if rotation in VECTORS:
        phi = np.arccos(np.clip((np.trace(matrix) - 1) / 2, -1, 1))
        return float(VECTORS[rotation][1] - phi)
    axes = intrinsic(rotation)
    cosine = np.clip(UNIT[axes[0]] @ matrix @ UNIT[axes[2]], -1, 1)
    middle = np.arccos(cosine) if is_proper(rotation) else np.arcsin(cosine)
    return float(min(middle, np.pi - middle) if is_proper(rotation) else np.pi / 2 - abs(middle))


def start(rotation: str) -> tuple[float, ...]:
    """Coordinates of a posture 0.4 rad or less off the resting one; 0.2 for the small domain."""
    if rotation in SEQUENCES:
        return (0.3, np.pi / 2 + 0.3 if is_proper(rotation) else 0.3, -0.2)
    phi, n = 0.2 if rotation == "linear" else 0.4, np.array([2.0, -2.0, 1.0]) / 3
    if rotation in VECTORS:
        return tuple(VECTORS[rotation][0](phi) * n)
    if rotation == "quaternion":
        return (float(np.cos(phi / 2)), *(np.sin(phi / 2) * n))
    cross = np.cross(np.eye(3), n).T
    matrix = np.eye(3) + np.sin(phi) * cross + (1 - np.cos(phi)) * cross @ cross
    return (*matrix[:, 0], *matrix[:, 1])


def spherical(rotation: str) -> cd.Scene:
    """A body of general inertia hanging from a ball joint."""
    down, com = hanging(rotation)
    scene = cd.Scene(f"spherical_{rotation}", gravity=tuple(9.81 * down))
    inertia = {"xx": 0.06, "yy": 0.05, "zz": 0.07, "xy": 0.004, "xz": -0.002, "yz": 0.003}
    top = scene.body("top", mass=1.5, com=tuple(0.4 * com), inertia=inertia)
    scene.joint("ball", cd.Spherical(rotation=rotation), scene.ground, top)
    return scene


def free(rotation: str) -> cd.Scene:
    """A body drifting and slowly turning in space, a small pendulum hinged to it."""
    scene = cd.Scene(f"free_{rotation}", gravity=(0, 0, 0))
    bus = scene.body("bus", mass=5.0, com=(0.1, 0, -0.05), inertia=(0.5, 0.4, 0.6))
    boom = scene.body("boom", mass=0.5, com=(0.3, 0, 0), inertia=(0.001, 0.02, 0.02))
    scene.joint("float", cd.Free(rotation=rotation), scene.ground, bus)
    scene.joint("hinge", cd.Revolute("z"), bus.at(0.5, 0, 0.1), boom)
    return scene


def spherical_member(rotation: str) -> Mechanism:
    slow = State({"ball": start(rotation)}, {"ball": (0.1, -0.05, 0.0)})
    fast = State({"ball": start(rotation)}, {"ball": (2.0, -1.0, 3.0)})
    return Mechanism(
        f"spherical_{rotation}",
        partial(spherical, rotation),
        (slow, fast),
        margin=partial(margin, rotation),
        guarded="ball",
        frame="top",
    )


def free_member(rotation: str) -> Mechanism:
    place = (0.5, -0.3, 0.2)
    speeds = {"float": (0.03, -0.04, 0.05, 0.1, 0.2, -0.1), "hinge": 0.1}
    calm = State({"float": (*start(rotation), *place)}, speeds)
    quick = State(
        {"float": (*start(rotation), *place), "hinge": 0.7},
        {"float": (1.0, -2.0, 1.5, 0.4, -1.0, 2.0), "hinge": -3.0},
    )
    return Mechanism(
        f"free_{rotation}",
        partial(free, rotation),
        (calm, quick),
        margin=partial(margin, rotation),
        guarded="float",
        frame="bus",
    )


MEMBERS = (
    *(spherical_member(rotation) for rotation in ROTATIONS),
    *(free_member(rotation) for rotation in ("ZYX", "XZX", "mrp", *REGULAR)),
)
