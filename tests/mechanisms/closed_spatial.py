"""Spatial closed mechanisms: Bricard's, a Stewart platform of six legs, a Delta robot."""

from __future__ import annotations

import math

import numpy as np
from scipy.spatial.transform import Rotation

import cardan as cd

G = 9.81
Coordinates = dict[str, float | tuple[float, ...]]


def turn(axis: str, angle: float) -> np.ndarray:
    return Rotation.from_euler(axis, angle).as_matrix()


def quaternion(rotation: np.ndarray) -> tuple[float, ...]:
    """Scalar first, with a positive scalar."""
    x, y, z, w = Rotation.from_matrix(rotation).as_quat()
    sign = 1.0 if w >= 0 else -1.0
    return float(sign * w), float(sign * x), float(sign * y), float(sign * z)


# Bricard: rod k from joint k to k + 1; bodies parallel to the ground where all angles are 0

CORNERS = np.array([[0, 0, 0], [1, 0, 0], [1, -1, 0], [1, -1, 1], [0, -1, 1], [0, 0, 1]], float)
AXES = "yzxyzx"


def bricard() -> cd.Scene:
    """Six perpendicular hinges and five rods: one freedom and one redundant constraint.

    Source: IFToMM library of multibody benchmarks, problem A04 (Bricard).
    """
    scene = cd.Scene("bricard", gravity=(0, -G, 0))
    slender, across = 2 * 0.01 / 12, (1 + 0.01) / 12
    place = scene.ground
    for k in range(5):
        along = CORNERS[k + 1] - CORNERS[k]
        inertia = [slender if x else across for x in along]
        rod = scene.body(f"rod{k}", mass=1.0, com=tuple(along / 2), inertia=inertia)
        scene.joint(f"J{k}", cd.Revolute(AXES[k]), place, rod)
        place = rod.at(*along)
    scene.joint("J5", cd.Revolute(AXES[5]), place, scene.ground.at(*CORNERS[5]))
    return scene


def bricard_angles(first: float) -> Coordinates:
    """Angles of all joints where joint J0 is turned, above -30 degrees: they alternate."""
    second = -math.asin(math.sin(first) / (1 + math.sin(first)))
    return {f"J{k}": second if k % 2 else first for k in range(6)}


# Stewart platform: legs of universal, sliding and spherical joints

BASE = [
    (0.6 * math.cos(a), 0.6 * math.sin(a), 0.0) for a in np.radians([-10, 10, 110, 130, 230, 250])
]
TOP = [
    (0.4 * math.cos(a), 0.4 * math.sin(a), -0.02) for a in np.radians([-50, 50, 70, 170, 190, 290])
]
SHORTEST = 0.5


def stewart() -> cd.Scene:
    """Six legs carry a platform: universal joint at the base, slide, ball joint at the top."""
    scene = cd.Scene("stewart", gravity=(0, 0, -G))
    platform = scene.body("platform", mass=5.0, com=(0, 0, 0.03), inertia=(0.22, 0.25, 0.4))
    for k in range(6):
        cylinder = scene.body(
            f"cylinder{k}", mass=1.2, com=(0, 0, 0.2), inertia=cd.inertia.cylinder(1.2, 0.03, 0.4)
        )
        piston = scene.body(
            f"piston{k}", mass=0.5, com=(0, 0, -0.2), inertia=cd.inertia.cylinder(0.5, 0.015, 0.4)
        )
        scene.joint(f"hooke{k}", cd.Universal("x", "y"), scene.ground.at(*BASE[k]), cylinder)
        scene.joint(f"slide{k}", cd.Prismatic("z"), cylinder.at(0, 0, SHORTEST), piston)
        scene.joint(f"ball{k}", cd.Spherical(), piston, platform.at(*TOP[k]))
    return scene


def stewart_coordinates(s: float) -> Coordinates:
    """Coordinates of all joints as the platform heaves, sways and turns with s."""
    place = np.array([0.05 * math.sin(s), 0.03 * s, 0.75 + 0.05 * math.cos(s)])
    rotation = turn("x", 0.1 * s) @ turn("y", 0.2 * math.sin(s)) @ turn("z", 0.15 + 0.1 * s)
    found: Coordinates = {}
    for k in range(6):
        span = place + rotation @ np.array(TOP[k]) - np.array(BASE[k])
        length = float(np.linalg.norm(span))
        x, y, z = span / length
        first, second = math.atan2(-y, z), math.asin(x)
        leg = turn("x", first) @ turn("y", second)
        found[f"hooke{k}"] = (first, second)
        found[f"slide{k}"] = length - SHORTEST
        found[f"ball{k}"] = quaternion(leg.T @ rotation)
    return found


# Delta: three arms turning about horizontal axes, forearms between universal joints

ARM, FOREARM, SHOULDER, WRIST = 0.2, 0.45, 0.15, 0.05


def delta() -> cd.Scene:
    """Three driven arms hold a platform that stays parallel to the ground."""
    scene = cd.Scene("delta", gravity=(0, 0, -G))
    platform = scene.body("platform", mass=0.3, com=(0, 0, -0.01), inertia=(4e-4, 4e-4, 6e-4))
    for k in range(3):
        about = ("XYZ", 0, 0, 2 * math.pi * k / 3)
        x, y = SHOULDER * math.cos(about[3]), SHOULDER * math.sin(about[3])
        arm = scene.body(
            f"arm{k}",
            mass=0.4,
            com=(ARM / 2, 0, 0),
            inertia=cd.inertia.cylinder(0.4, 0.01, ARM, "x"),
        )
        forearm = scene.body(
            f"forearm{k}",
            mass=0.15,
            com=(0, 0, -FOREARM / 2),
            inertia=cd.inertia.cylinder(0.15, 0.006, FOREARM),
        )
        shoulder = scene.ground.at(x, y, 0, rotation=about)
        wrist = platform.at(x * WRIST / SHOULDER, y * WRIST / SHOULDER, 0, rotation=about)
        scene.joint(f"shoulder{k}", cd.Revolute("y"), shoulder, arm)
        scene.joint(f"elbow{k}", cd.Universal("y", "x"), arm.at(ARM, 0, 0), forearm)
        scene.joint(f"wrist{k}", cd.Universal("x", "y"), forearm.at(0, 0, -FOREARM), wrist)
    return scene


def delta_coordinates(s: float) -> Coordinates:
    """Coordinates of all joints as the platform moves along a curve."""
    place = np.array([0.05 * math.sin(s), 0.04 * s, -0.4 + 0.05 * math.cos(2 * s)])
    found: Coordinates = {}
    for k in range(3):
        # the wrist seen from the shoulder, in axes of this arm
        x, y, z = turn("z", 2 * math.pi * k / 3).T @ place
        x += WRIST - SHOULDER
        # arm and projected forearm close a triangle in the plane of the arm
        reach, planar = math.hypot(x, z), math.sqrt(FOREARM**2 - y**2)
        corner = math.acos((ARM**2 + reach**2 - planar**2) / (2 * ARM * reach))
        angle = math.atan2(-z, x) - corner
        px, pz = x - ARM * math.cos(angle), z + ARM * math.sin(angle)
        second = math.asin(y / FOREARM)
        total = math.atan2(-px, -pz)
        found[f"shoulder{k}"] = angle
        found[f"elbow{k}"] = (total - angle, second)
        found[f"wrist{k}"] = (-second, -total)
    return found
