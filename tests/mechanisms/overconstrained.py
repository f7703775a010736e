"""Linkages that move although the count of their freedoms says that they do not, in closed form.

Source: G. T. Bennett, A new mechanism, Engineering 76 (1903); K. J. Waldron, Hybrid overconstrained
linkages, J. Mechanisms 3 (1968): loops of two that share a joint (Goldberg, Myard).
"""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

import cardan as cd

Array = NDArray[np.float64]
Sides = tuple[tuple[float, float], ...]

# twist and length of opposite links: a / sin(alpha) = b / sin(beta)
ALPHA, BETA, A = 0.7, 1.2, 0.5
B = A * math.sin(BETA) / math.sin(ALPHA)
BENNETT: Sides = ((A, ALPHA), (B, BETA), (A, ALPHA), (B, BETA))


def bennett(gravity: tuple[float, float, float] = (0.0, 0.0, -9.81)) -> cd.Scene:
    """Four revolutes about skew axes; links 1 to 3 move, link 4 is the ground."""
    scene = cd.Scene("bennett", gravity=gravity)
    ends = [scene.ground]
    for k, (length, _) in enumerate(BENNETT[:3]):
        ends.append(
            scene.body(f"l{k}", mass=1.0, com=(length / 2, 0, 0), inertia=(0.02, 0.05, 0.06))
        )
    for k in range(4):
        length, twist = BENNETT[k - 1]
        # the frame of the next joint on the link before it: Denavit and Hartenberg's
        near = ends[k].at(length, 0, 0, rotation=("XYZ", twist, 0.0, 0.0)) if k else None
        if k == 0:
            scene.joint("j0", cd.Revolute("z"), scene.ground, ends[1])
        elif k < 3:
            scene.joint(f"j{k}", cd.Revolute("z"), near, ends[k + 1])
        else:
            last = scene.ground.at(*_ground(), rotation=_turned())
            scene.joint("j3", cd.Revolute("z"), near, last)
    return scene


def _ground() -> tuple[float, float, float]:
    """Where joint 3 stands against joint 0: the fourth link, told backwards."""
    return (-B, 0.0, 0.0)


def _turned() -> tuple[str, float, float, float]:
    return ("XYZ", -BETA, 0.0, 0.0)


def bennett_angles(first: float) -> dict[str, float]:
    """Angles of all joints: tan(j0/2) tan(j1/2) is constant, opposite ones differ by their sign."""
    ratio = math.sin((BETA + ALPHA) / 2) / math.sin((BETA - ALPHA) / 2)
    half = math.atan2(ratio * math.cos(first / 2), math.sin(first / 2))
    second = 2 * half
    return {"j0": first, "j1": second, "j2": -first, "j3": -second}


def _five(a: float, alpha: float, c: float, gamma: float) -> Sides:
    """Links of two Bennett linkages that shared one: (a, alpha), which is gone, and its joint.

    Beside the first, (a, alpha) and (b, beta), the second has (c, gamma) and the shared link, which
    it goes along the other way. The last link is one of each, along one line.
    """
    b, beta = a / math.sin(alpha) * math.sin(BETA), BETA
    return ((a, alpha), (b, beta), (c, gamma), (-a, -alpha), (b + c, beta + gamma))


GAMMA = 0.45
FIVE: dict[str, Sides] = {
    "goldberg": _five(A, ALPHA, A / math.sin(ALPHA) * math.sin(GAMMA), GAMMA),
    "myard": _five(A, math.pi / 2, -A * math.sin(BETA), BETA + math.pi),
}
"""Length and twist of the links by the linkage. Myard's is its own mirror image: c = -b."""


def five_revolutes(name: str, gravity: tuple[float, float, float] = (0.0, 0.0, -9.81)) -> cd.Scene:
    """Goldberg's or Myard's linkage of five revolutes; its last link is the ground."""
    scene = cd.Scene(name, gravity=gravity)
    *moving, (length, twist) = FIVE[name]
    near = scene.ground.at(0, 0, 0)
    for k, (side, turned) in enumerate(moving):
        link = scene.body(f"l{k}", mass=1.0, com=(side / 2, 0, 0), inertia=(0.02, 0.05, 0.06))
        scene.joint(f"j{k}", cd.Revolute("z"), near, link)
        near = link.at(side, 0, 0, rotation=("XYZ", turned, 0.0, 0.0))
    last = scene.ground.at(-length, 0, 0, rotation=("XYZ", -twist, 0.0, 0.0))
    scene.joint("j4", cd.Revolute("z"), near, last)
    return scene


def five_angles(name: str, first: float) -> dict[str, float]:
    """Angles of all joints: those of both Bennett linkages, which turn alike at the joint gone."""
    (_, alpha), (_, beta), (_, gamma), *_ = FIVE[name]
    one = math.sin((beta + alpha) / 2) / math.sin((beta - alpha) / 2)
    two = -math.sin((gamma - alpha) / 2) / math.sin((gamma + alpha) / 2)
    sine, cosine = math.sin(first / 2), math.cos(first / 2)
    second = 2 * math.atan2(one * cosine, sine)
    other = 2 * math.atan2(-two * sine, one * cosine)
    return {"j0": first, "j1": second, "j2": other - first, "j3": -second, "j4": -other}


def closure(sides: Sides, angles: Iterable[float]) -> Array:
    """What is left of the identity once round the loop, as a matrix of 4 x 4."""
    whole = np.eye(4)
    for (length, twist), angle in zip(sides, angles, strict=True):
        c, s, ct, st = math.cos(angle), math.sin(angle), math.cos(twist), math.sin(twist)
        turn = [[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
        link = [[1, 0, 0, length], [0, ct, -st, 0], [0, st, ct, 0], [0, 0, 0, 1]]
        whole = whole @ turn @ link
    return whole - np.eye(4)
