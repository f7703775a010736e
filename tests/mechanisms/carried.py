"""Mechanisms of joints that close loops with coordinates of their own."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable
from functools import partial

import numpy as np
import sympy as sp
from scipy.interpolate import CubicSpline
from scipy.optimize import brentq

import cardan as cd

from .closed import Closed
from .closed_planar import G, four_bar, four_bar_angles, heading, meet
from .closed_spatial import Coordinates, quaternion, turn

A, B = sp.symbols("a b")
ABOUT_Z = ((sp.cos(A), -sp.sin(A), 0), (sp.sin(A), sp.cos(A), 0), (0, 0, 1))
# turned about x, then about the y axis of the child
CROSS = (
    (sp.cos(B), 0, sp.sin(B)),
    (sp.sin(A) * sp.sin(B), sp.cos(A), -sp.sin(A) * sp.cos(B)),
    (-sp.cos(A) * sp.sin(B), sp.sin(A), sp.cos(A) * sp.cos(B)),
)


# a cam of varying height turns about z; an arm on a cross of two axes follows its edge

EDGE = [
    (0.3 * math.cos(a), 0.3 * math.sin(a), 0.05 * math.cos(2 * a + 1))
    for a in np.radians([-45, 45, 135, 225])
]
POST, ARM = np.array([0.3, 0.35, 0.4]), 0.52


def cam(plain: bool = False) -> cd.Scene:
    """A cam with a follower in space; ``plain``: its cross as a universal joint."""
    scene = cd.Scene("cam", gravity=(0.5, 0, -G))
    disc = scene.body("disc", mass=2.0, com=(0.05, 0.02, 0), inertia=(0.04, 0.05, 0.09))
    rod = cd.inertia.cylinder(0.7, 0.02, ARM)
    arm = scene.body("arm", mass=0.7, com=(0, 0.01, -ARM / 2), inertia=rod)
    cross = cd.Universal("x", "y") if plain else cd.Custom((A, B), rotation=CROSS)
    scene.joint("shaft", cd.Revolute("z"), scene.ground, disc)
    scene.joint("post", cross, scene.ground.at(*POST), arm)
    scene.joint("edge", cd.PointOnCurve(EDGE, closed=True), disc, arm.at(0, 0, -ARM))
    spring = cd.SpringDamper(
        scene.ground.at(0.5, 0, 0.1), disc.at(0.2, 0.1, 0), 80.0, rest_length=0.2
    )
    scene.force("spring", spring)
    return scene


def cam_coordinates(s: float) -> Coordinates:
    """Coordinates of all joints as the cam turns with s."""
    angle = 0.3 * s
    back = turn("z", -angle)
    places = np.array([*EDGE, EDGE[0]])
    at = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(places, axis=0), axis=1))])
    edge = CubicSpline(at, places, bc_type="periodic")
    post = back @ POST

    def apart(along: float) -> float:
        return float(np.sum((edge(along) - post) ** 2)) - ARM**2

    along = brentq(apart, at[0], at[1], xtol=1e-16, rtol=1e-15)
    x, y, z = (back.T @ edge(along) - POST) / ARM
    first, second = math.atan2(y, -z), math.asin(-x)
    arm = turn("x", first) @ turn("y", second)
    return {"shaft": angle, "post": (first, second), "edge": (*quaternion(back @ arm), along)}


# a five-bar whose cranks are geared together: ground, one, two, three, four

SPAN, CRANK, LEFT, RIGHT, MESH = 0.3, 0.1, 0.3, 0.28, 2.0


def geared() -> cd.Scene:
    """A five-bar in the plane whose cranks turn against each other."""
    scene = cd.Scene("geared", gravity=(0, -G, 0))
    lengths = {"one": CRANK, "two": LEFT, "three": RIGHT, "four": CRANK}
    one, two, three, four = (
        scene.body(name, mass=3 * size, com=(size / 2, 0.01, 0), inertia=(1e-4, 2e-3, 2e-3))
        for name, size in lengths.items()
    )
    lead = scene.joint("lead", cd.Revolute("z"), scene.ground, one)
    scene.joint("B", cd.Revolute("z"), one.at(CRANK, 0, 0), two)
    scene.joint("C", cd.Revolute("z"), two.at(LEFT, 0, 0), three.at(RIGHT, 0, 0))
    scene.joint("D", cd.Revolute("z"), four.at(CRANK, 0, 0), three)
    scene.joint("wheel", cd.Gear(lead, -1.0, "z", MESH), scene.ground.at(SPAN, 0, 0), four)
    return scene


def geared_angles(s: float) -> Coordinates:
    """Angles of all joints as the first crank turns with s."""
    angle, other = 1 + s, MESH - 1 - s
    tip = (CRANK * math.cos(angle), CRANK * math.sin(angle))
    far = (SPAN + CRANK * math.cos(other), CRANK * math.sin(other))
    top = meet(tip, LEFT, far, RIGHT, 1)
    left, right = heading(tip, top), heading(far, top)
    return {"lead": angle, "B": left - angle, "C": right - left, "D": right - other, "wheel": other}


def custom(plain: bool = False) -> cd.Scene:
    """The four-bar of hinges that the user wrote; ``plain``: of revolute joints."""
    scene = four_bar()
    if not plain:
        for name, joint in scene.joints.items():
            kind = cd.Custom((A,), rotation=ABOUT_Z)
            scene.joints[name] = dataclasses.replace(joint, kind=kind)
    return scene


CARRIED: dict[str, Closed] = {
    member.name: member
    for member in (
        Closed("cam", cam, cam_coordinates, 1, 1, 0),
        Closed("geared", geared, geared_angles, 1, 1, 3),
        Closed("custom", custom, lambda s: dict(four_bar_angles(1 + s)), 1, 1, 3),
    )
}
# the same mechanisms of joints that need no coordinates to close
PLAIN: dict[str, Callable[[], cd.Scene]] = {
    "cam": partial(cam, plain=True),
    "custom": partial(custom, plain=True),
}
