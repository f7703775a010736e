"""Constraints are derivatives of each other: g, G u + g_t, G udot - gamma, whatever binds.

Every joint closes a loop and stands as a constraint between nodes, from either side, with the
ground as its parent or child, with and without offsets; so do relations that the user wrote, and
the joints of the zoo. States do not fulfil the constraints: the law holds everywhere.
"""

from __future__ import annotations

import dataclasses
import itertools
from collections.abc import Callable

import pytest
import sympy as sp

import cardan as cd
from cardan.elements.joints import JOINTS
from cardan.errors import CardanError
from laws.levels import ROUNDING, of_elements, of_tree
from laws.test_cut_joints import APART, INERTIA, INSTANCES
from mechanisms import ZOO
from mechanisms.carried import CARRIED
from mechanisms.closed import CLOSED
from mechanisms.flexible import FLEXIBLE
from mechanisms.superelements import FLYERS
from spread import some

WAYS = tuple(itertools.product(("body", "ground"), ("forth", "back"), ("offsets", "plain")))


def machine(name: str, other: str, way: str, place: str) -> cd.Scene:
    """A floating body that a joint binds to the ground or to a pendulum."""
    scene = cd.Scene("machine", gravity=(0.3, 0.5, -9.81))
    arm = scene.body("arm", mass=2.0, com=(0.1, 0, -0.3), inertia=INERTIA)
    load = scene.body("load", mass=1.0, com=(0.05, -0.1, 0.2), inertia=INERTIA)
    scene.joint("pivot", cd.Revolute((1, 1, 0)), scene.ground, arm)
    scene.joint("float", cd.Free(), arm if other == "ground" else scene.ground, load)
    one, two = (scene.ground if other == "ground" else arm), load
    if place == "offsets":
        one = one.at(0.1, 0.2, -0.5, rotation=("XYZ", 0.2, -0.3, 0.5))
        two = two.at(0.03, 0.1, 0.1, rotation=("XYZ", -0.4, 0.1, 0.2))
    ends = (one, two) if way == "forth" else (two, one)
    scene.joint("tested", INSTANCES[name], *ends, cut=True)
    return scene


def reversed_machine(name: str) -> cd.Scene:
    """The same with the joint told by its reversed kind, as readers of files may tell it."""
    scene = machine(name, "body", "forth", "offsets")
    made = scene.joints["tested"]
    ends = {"parent": made.child, "child": made.parent}
    scene.joints["tested"] = dataclasses.replace(made, kind=made.kind.reversed(), **ends)
    return scene


def relations() -> cd.Scene:
    """Relations that the user wrote: of coordinates, frames, speeds, time and an input."""
    scene = cd.Scene("relations", gravity=(0, 0, -9.81))
    arm, tip = (scene.body(n, mass=1.0, com=(0, 0, -0.3), inertia=INERTIA) for n in ("arm", "tip"))
    puck = scene.body("puck", mass=1.0, inertia=INERTIA)
    scene.joint("hip", cd.Revolute("y"), scene.ground, arm)
    scene.joint("knee", cd.Revolute("x"), arm.at(0, 0, -0.6), tip)
    scene.joint("slide", cd.Free(), scene.ground, puck)
    lift, t = scene.input("lift"), sp.Symbol("t")
    gap = puck.position() - tip.at(0.1, 0, -0.4).position()
    scene.constraint("rod", sum(x**2 for x in gap) - (1 + lift) ** 2, unit="m^2")
    scene.constraint("belt", scene.q("hip") - 0.3 * sp.sin(scene.q("knee")) - 0.1 * t**2)
    scene.constraint("skate", puck.velocity(in_=puck)[1] - 0.2 * sp.cos(t), unit="m/s")
    return scene


def test_every_joint_is_here() -> None:
    tested = {kind.kind for kind in INSTANCES.values()}
    assert tested | APART == set(JOINTS)


@pytest.mark.parametrize("coordinates", ["relative", "absolute"])
@pytest.mark.parametrize("name", some(INSTANCES, 21, first=1))
def test_joints(name: str, coordinates: str) -> None:
    """All ways to stand in a scene; a joint that binds nothing to the ground is refused."""
    levels, cases = (of_tree if coordinates == "relative" else of_elements), 0
    for way in WAYS:
        count, worst = levels(machine(name, *way))
        cases += count > 0
        assert worst < ROUNDING, way
    count, worst = levels(reversed_machine(name))
    assert worst < ROUNDING
    print(f"{name}, {coordinates}: {cases + (count > 0)} cases")
    assert cases == len(WAYS)


@pytest.mark.parametrize("levels", [of_tree, of_elements])
def test_relations(levels: Callable[[cd.Scene], tuple[int, float]]) -> None:
    count, worst = levels(relations())
    assert count >= 3
    assert worst < ROUNDING


SCENES = {
    **{name: member.build for name, member in ZOO.items()},
    **{name: member.build for name, member in (CLOSED | CARRIED).items()},
    **FLEXIBLE,
    **{name: flyer.build for name, flyer in FLYERS.items()},
}


@pytest.mark.parametrize("levels", [of_tree, of_elements])
@pytest.mark.parametrize("name", some(SCENES, 21))
def test_zoo(name: str, levels: Callable[[cd.Scene], tuple[int, float]]) -> None:
    try:
        count, worst = levels(SCENES[name]())
    except CardanError as refused:
        pytest.skip(str(refused))
    print(f"{name}: {count} rows, {worst:.1e}")
    assert worst < ROUNDING
