"""Linkages whose branches meet, and what tests of their paths measure."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

import numpy as np

import cardan as cd

POINT = {"mass": 1.0, "inertia": (1.0, 1.0, 1.0)}
TURN = 2 * math.pi


def linkage(
    crank: float, coupler: float, rocker: float, ground: float, unit: float = 1.0
) -> cd.CompiledModel:
    """Four bars with the length of the rocker as a parameter L."""
    scene = cd.Scene("linkage", gravity=(0, 0, 0))
    length = scene.parameter("L", rocker * unit)
    a, b, c = (scene.body(name, **POINT) for name in ("crank", "coupler", "rocker"))
    turn = cd.Revolute("z")
    scene.joint("A", turn, scene.ground, a)
    scene.joint("B", turn, a.at(crank * unit, 0, 0), b)
    scene.joint("D", turn, scene.ground.at(ground * unit, 0, 0), c)
    scene.joint("C", turn, b.at(coupler * unit, 0, 0), c.at(length, 0, 0))
    return cd.compile(scene)


def windows(count: int, crank: float, ground: float) -> cd.CompiledModel:
    """Parallelograms in a row, each with the next crank as its follower."""
    scene = cd.Scene("windows", gravity=(0, 0, 0))
    turn, cranks = cd.Revolute("z"), list[Any]()
    for k in range(count + 1):
        cranks.append(scene.body(f"crank{k}", **POINT))
        scene.joint(f"A{k}", turn, scene.ground.at(k * ground, 0, 0), cranks[k])
    for k in range(count):
        coupler = scene.body(f"coupler{k}", **POINT)
        scene.joint(f"B{k}", turn, cranks[k].at(crank, 0, 0), coupler)
        scene.joint(f"C{k}", turn, coupler.at(ground, 0, 0), cranks[k + 1].at(crank, 0, 0))
    return cd.compile(scene)


def two_arms(arm: float) -> cd.CompiledModel:
    """Two equal arms whose tip slides on a line through their base."""
    scene = cd.Scene("two_arms", gravity=(0, 0, 0))
    one, two, tip = (scene.body(name, **POINT) for name in ("one", "two", "tip"))
    scene.joint("theta", cd.Revolute("z"), scene.ground, one)
    scene.joint("elbow", cd.Revolute("z"), one.at(arm, 0, 0), two)
    scene.joint("s", cd.Prismatic("x"), scene.ground, tip)
    scene.joint("pin", cd.Revolute("z"), two.at(arm, 0, 0), tip)
    return cd.compile(scene)


def turns(angle: Any) -> Any:
    """An angle up to full turns, between -pi and pi."""
    return np.remainder(np.asarray(angle) + math.pi, TURN) - math.pi


def kinds(path: Any) -> list[str]:
    return [point.kind for point in path.points]


def travelled(branches: Iterable[Any], name: str) -> float:
    """How far a coordinate that does not turn back goes on branches."""
    return sum(abs(float(branch[name][-1] - branch[name][0])) for branch in branches)
