"""Pendulums and chains: revolute and prismatic joints, declared parameters, mass ratios."""

from __future__ import annotations

import cardan as cd

from .mechanism import Mechanism, State


def pendulum() -> cd.Scene:
    """A rod on a hinge, described by two declared parameters."""
    scene = cd.Scene("pendulum", gravity=(0, 0, -9.81))
    m = scene.parameter("m", 1.2, unit="kg")
    length = scene.parameter("l", 800, unit="mm")
    rod = scene.body(
        "rod", mass=m, com=(0, 0, -length / 2), inertia=cd.inertia.rod(m, length, axis="z")
    )
    scene.joint("pivot", cd.Revolute("y"), scene.ground, rod)
    return scene


def double_pendulum() -> cd.Scene:
    """Two rods of different size in one plane."""
    scene = cd.Scene("double_pendulum", gravity=(0, 0, -9.81))
    upper = scene.body(
        "upper", mass=1.0, com=(0, 0, -0.3), inertia=cd.inertia.rod(1.0, 0.6, axis="z")
    )
    lower = scene.body(
        "lower", mass=0.4, com=(0, 0, -0.25), inertia=cd.inertia.rod(0.4, 0.5, axis="z")
    )
    scene.joint("shoulder", cd.Revolute("y"), scene.ground, upper)
    scene.joint("elbow", cd.Revolute("y"), upper.at(0, 0, -0.6), lower)
    return scene


def cart_pole() -> cd.Scene:
    """A sliding cart with a pole whose hinge and center of mass are off the track."""
    scene = cd.Scene("cart_pole", gravity=(0, 0, -9.81))
    cart = scene.body("cart", mass=2.0, inertia=(0.1, 0.2, 0.3))
    pole = scene.body("pole", mass=0.5, com=(0, 0.02, -0.4), inertia=(0.03, 0.03, 0.001))
    scene.joint("track", cd.Prismatic("x"), scene.ground, cart)
    scene.joint("hinge", cd.Revolute("y"), cart.at(0.1, 0, 0.2), pole)
    return scene


def spatial_chain() -> cd.Scene:
    """Four bodies with general axes, rotated frames and full inertia tensors."""
    scene = cd.Scene("spatial_chain", gravity=(1.0, -2.0, -9.0))
    axes = ((1, 2, 2), (0, -1, 0), (2, -1, 2), (-0.6, 0.8, 0))
    parent = scene.ground
    for i, axis in enumerate(axes):
        moments = {"xx": 0.03 + 0.01 * i, "yy": 0.05, "zz": 0.04}
        inertia = {**moments, "xy": 0.004, "xz": -0.003, "yz": 0.002 * i}
        link = scene.body(f"link{i}", mass=1.0 + 0.3 * i, com=(0.1, -0.05, 0.2), inertia=inertia)
        scene.joint(f"joint{i}", cd.Revolute(axis), parent, link)
        parent = link.at(0.05, 0.1, 0.4, rotation=("XYZ", 0.3, -0.5, 0.2 * i))
    return scene


def mass_ratios() -> cd.Scene:
    """A chain of five rods, every one a hundred times heavier or lighter than the one before."""
    scene = cd.Scene("mass_ratios", gravity=(0, 0, -9.81))
    parent = scene.ground
    for i, mass in enumerate((1.0, 0.01, 1.0, 0.01, 1.0)):
        inertia = cd.inertia.rod(mass, 0.5, axis="z")
        rod = scene.body(f"rod{i}", mass=mass, com=(0, 0, -0.25), inertia=inertia)
        # a thin rod does not turn about itself: both axes stand across it
        scene.joint(f"joint{i}", cd.Revolute("y" if i % 2 == 0 else "x"), parent, rod)
        parent = rod.at(0, 0, -0.5)
    return scene


MEMBERS = (
    Mechanism("pendulum", pendulum, (State({"pivot": 1.0}), State({"pivot": 2.5}, {"pivot": -1}))),
    Mechanism(
        "double_pendulum",
        double_pendulum,
        (State({"shoulder": 1.0, "elbow": -0.5}), State({"elbow": 2.0}, {"shoulder": 3.0})),
    ),
    Mechanism(
        "cart_pole",
        cart_pole,
        (State({"hinge": 1.2}), State({"track": -0.5, "hinge": 0.3}, {"track": 1.0, "hinge": -2})),
    ),
    Mechanism(
        "spatial_chain",
        spatial_chain,
        (
            State({"joint0": 0.4, "joint1": -0.6, "joint3": 0.8}, {"joint2": 0.5}),
            State({"joint1": 1.1, "joint2": -2.0}, {"joint0": 1.0, "joint3": -1.5}),
        ),
    ),
    Mechanism(
        "mass_ratios",
        mass_ratios,
        (State({"joint0": 0.3, "joint1": 0.2}), State({"joint2": -0.7}, {"joint4": 1.0})),
    ),
)
