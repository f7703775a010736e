"""Branched trees, fixed joints, point masses and massless frames."""

from __future__ import annotations

import cardan as cd

from .mechanism import Mechanism, State


def branched() -> cd.Scene:
    """A turning trunk with two arms of two links, one arm ending in a welded tool."""
    scene = cd.Scene("branched", gravity=(0, 0, -9.81))
    trunk = scene.body("trunk", mass=4.0, com=(0, 0.05, 0.3), inertia=(0.3, 0.3, 0.1))
    scene.joint("waist", cd.Revolute("z"), scene.ground, trunk)
    for side, y in (("left", 0.3), ("right", -0.3)):
        upper = scene.body(
            f"{side}_upper", mass=1.0, com=(0, 0, -0.2), inertia=(0.01, 0.012, 0.003)
        )
        lower = scene.body(
            f"{side}_lower", mass=0.6, com=(0.02, 0, -0.2), inertia=(0.006, 0.007, 0.002)
        )
        scene.joint(f"{side}_shoulder", cd.Revolute("x"), trunk.at(0, y, 0.6), upper)
        scene.joint(f"{side}_elbow", cd.Revolute("y"), upper.at(0, 0, -0.4), lower)
    tool = scene.body("tool", mass=0.3, com=(0.05, 0, 0), inertia=(0.001, 0.002, 0.002))
    grip = lower.at(0, 0, -0.4, rotation=("ZYX", 0.4, 0.2, -0.1))
    scene.joint("weld", cd.Fixed(), grip, tool)
    return scene


def satellite() -> cd.Scene:
    """A free hub with a hinged panel on either side and a sliding mass inside."""
    scene = cd.Scene("satellite", gravity=(0, 0, 0))
    hub = scene.body("hub", mass=10.0, com=(0.01, 0, 0.02), inertia=(1.0, 1.2, 0.9))
    scene.joint("float", cd.Free(), scene.ground, hub)
    for side, y in (("port", 0.5), ("starboard", -0.5)):
        panel = scene.body(f"{side}_panel", mass=1.0, com=(0, 2 * y, 0), inertia=(0.09, 0.01, 0.1))
        scene.joint(f"{side}_hinge", cd.Revolute("y"), hub.at(0, y, 0), panel)
    damper = scene.body("damper", mass=0.2)
    scene.joint("slot", cd.Prismatic((1, 1, 0)), hub.at(0.1, 0, 0.3), damper)
    return scene


def point_masses() -> cd.Scene:
    """Point masses on massless gimbal rings: only the whole has inertia."""
    scene = cd.Scene("point_masses", gravity=(0, 0, -9.81))
    ring = scene.body("ring", mass=0)
    stem = scene.body("stem", mass=0.5, com=(0.1, 0, -0.4))
    scene.joint("roll", cd.Revolute("x"), scene.ground, ring)
    scene.joint("pitch", cd.Revolute("y"), ring, stem)
    # a second mass welded beside the first
    side = scene.body("side", mass=0.2, com=(0, 0.3, -0.1))
    scene.joint("weld", cd.Fixed(), stem.at(0, 0, -0.3), side)
    return scene


def heavy_tip() -> cd.Scene:
    """A light two-link arm with a load ten thousand times its mass on a ball joint."""
    scene = cd.Scene("heavy_tip", gravity=(0, 0, -9.81))
    inertia = cd.inertia.rod(0.001, 0.5, axis="z")
    first = scene.body("first", mass=0.001, com=(0, 0, -0.25), inertia=inertia)
    second = scene.body("second", mass=0.001, com=(0, 0, -0.25), inertia=inertia)
    load = scene.body("load", mass=10.0, com=(0, 0, -0.2), inertia=(0.4, 0.5, 0.3))
    scene.joint("base", cd.Revolute("x"), scene.ground, first)
    scene.joint("middle", cd.Revolute("y"), first.at(0, 0, -0.5), second)
    scene.joint("hook", cd.Spherical(), second.at(0, 0, -0.5), load)
    return scene


MEMBERS = (
    Mechanism(
        "branched",
        branched,
        (
            State({"left_shoulder": 0.5, "right_elbow": -0.6}, {"waist": 1.0}),
            State({"left_elbow": 1.5, "right_shoulder": 0.7}, {"left_elbow": -2, "waist": -1}),
        ),
    ),
    Mechanism(
        "satellite",
        satellite,
        (
            State({}, {"float": (0.2, 0.1, -0.3, 0, 0, 0.1), "port_hinge": 0.5, "slot": 0.02}),
            State({"starboard_hinge": 1.0}, {"float": (1, -1, 2, 0.3, 0, 0), "slot": -0.2}),
        ),
    ),
    Mechanism(
        "point_masses",
        point_masses,
        (State({"roll": 0.5, "pitch": 0.4}), State({"pitch": -0.8}, {"roll": 1.0})),
    ),
    Mechanism(
        "heavy_tip",
        heavy_tip,
        (
            State({"base": 0.3, "middle": -0.2}, {"hook": (0.1, 0.2, 0.5)}),
            State({"base": -0.5, "middle": 0.9}, {"base": 1.0, "hook": (1, -1, 0.5)}),
        ),
    ),
)
