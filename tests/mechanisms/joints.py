"""One scene for every joint with several coordinates or an unusual motion."""

from __future__ import annotations

import sympy

import cardan as cd

from .mechanism import Mechanism, State


def cylindrical() -> cd.Scene:
    """A collar turning and sliding along a slanted rod, with a pendulum on it."""
    scene = cd.Scene("cylindrical", gravity=(0, 0, -9.81))
    collar = scene.body("collar", mass=1.5, com=(0.1, 0, 0.05), inertia=(0.02, 0.03, 0.025))
    bob = scene.body("bob", mass=0.7, com=(0, 0, -0.3), inertia=(0.01, 0.01, 0.002))
    scene.joint("rod", cd.Cylindrical((3, 0, 4)), scene.ground, collar)
    scene.joint("hinge", cd.Revolute("y"), collar.at(0.2, 0, 0), bob)
    return scene


def screw() -> cd.Scene:
    """An unbalanced nut on a vertical screw carrying a hinged arm."""
    scene = cd.Scene("screw", gravity=(0, 1.5, -9.81))
    nut = scene.body("nut", mass=2.0, com=(0.15, 0, 0), inertia=(0.05, 0.04, 0.06))
    arm = scene.body("arm", mass=0.5, com=(0.3, 0, 0), inertia=(0.001, 0.02, 0.02))
    scene.joint("thread", cd.Screw("z", pitch=0.08), scene.ground, nut)
    scene.joint("hinge", cd.Revolute((0, 1, 0)), nut.at(0.2, 0, 0), arm)
    return scene


def universal() -> cd.Scene:
    """A Hooke joint between a driven shaft and a bent one."""
    scene = cd.Scene("universal", gravity=(0, 0, -9.81))
    shaft = scene.body("shaft", mass=3.0, inertia=(0.02, 0.02, 0.04))
    cross = scene.body("rotor", mass=2.0, com=(0.02, 0, -0.3), inertia=(0.05, 0.05, 0.01))
    scene.joint("bearing", cd.Revolute("z"), scene.ground, shaft)
    scene.joint("hooke", cd.Universal("x", "y"), shaft.at(0, 0, -0.1), cross)
    return scene


def planar() -> cd.Scene:
    """A puck sliding on a tilted table with a pendulum standing off it."""
    scene = cd.Scene("planar", gravity=(0.8, 0, -9.81))
    puck = scene.body("puck", mass=1.0, com=(0.05, 0.02, 0), inertia=(0.01, 0.01, 0.02))
    flag = scene.body("flag", mass=0.3, com=(0.1, 0, -0.2), inertia=(0.004, 0.005, 0.002))
    scene.joint("table", cd.Planar("z"), scene.ground, puck)
    scene.joint("hinge", cd.Revolute((1, 0, 1)), puck.at(0, 0.1, -0.1), flag)
    return scene


def translation() -> cd.Scene:
    """The carriage of a gantry with a load that swings from it."""
    scene = cd.Scene("translation", gravity=(0.3, 0, -9.81))
    carriage = scene.body("carriage", mass=2.0, com=(0.05, 0, 0), inertia=(0.02, 0.03, 0.02))
    load = scene.body("load", mass=1.2, com=(0, 0.02, -0.6), inertia=(0.05, 0.05, 0.01))
    scene.joint("gantry", cd.Translation(), scene.ground.at(0, 0, 2), carriage)
    scene.joint("hook", cd.Universal("x", "y"), carriage.at(0, 0, -0.1), load)
    return scene


def parabola() -> cd.Scene:
    """A user's joint: a sledge that slides along z = x²/2 and stays tangent to it."""
    scene = cd.Scene("parabola", gravity=(0, 0, -9.81))
    x = sympy.Symbol("x")
    # the tangent direction (1, x) turns the sledge about -y by atan(x)
    root = sympy.sqrt(1 + x**2)
    rotation = [[1 / root, 0, -x / root], [0, 1, 0], [x / root, 0, 1 / root]]
    slide = cd.Custom([x], position=(x, 0, x**2 / 2), rotation=rotation)
    sledge = scene.body("sledge", mass=1.0, com=(0, 0, 0.1), inertia=(0.02, 0.03, 0.04))
    bob = scene.body("bob", mass=0.4, com=(0, 0, -0.3), inertia=(0.004, 0.004, 0.001))
    scene.joint("slide", slide, scene.ground, sledge)
    scene.joint("hinge", cd.Revolute("y"), sledge, bob)
    return scene


MEMBERS = (
    Mechanism(
        "cylindrical",
        cylindrical,
        (
            State({"hinge": 0.7}, {"rod": (0.5, -0.2)}),
            State({"rod": (2.0, 0.3), "hinge": -1.0}, {"rod": (-1.0, 0.4), "hinge": 2.0}),
        ),
    ),
    Mechanism(
        "screw",
        screw,
        (State({"hinge": 0.4}, {"thread": 2.0}), State({"thread": -3.0}, {"hinge": 1.0})),
    ),
    Mechanism(
        "universal",
        universal,
        (
            State({"hooke": (0.3, -0.2)}, {"bearing": 1.0}),
            State({"bearing": 2.0, "hooke": (-0.6, 0.5)}, {"hooke": (1.0, -2.0)}),
        ),
    ),
    Mechanism(
        "planar",
        planar,
        (
            State({"table": (0.1, -0.2, 0.5)}, {"table": (0.3, 0.2, 1.0), "hinge": 0.4}),
            State({"table": (0.0, 1.0, -2.0), "hinge": 1.3}, {"hinge": -2.0}),
        ),
    ),
    Mechanism(
        "translation",
        translation,
        (
            State({"gantry": (0.1, -0.2, 0.5)}, {"gantry": (0.3, 0.2, 1.0), "hook": (0.4, 0.1)}),
            State({"gantry": (0.0, 1.0, -2.0), "hook": (1.3, -0.4)}, {"hook": (-2.0, 0.5)}),
        ),
    ),
    Mechanism(
        "parabola",
        parabola,
        (State({"slide": 0.6}), State({"slide": -0.4, "hinge": 1.0}, {"slide": 1.0})),
    ),
)
