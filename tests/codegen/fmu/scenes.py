"""Scenes that become FMUs: one for everything that an importer has to treat in its own way."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import sympy as sp

import cardan as cd

SCENES = Path(cd.__file__).parent / "scenes"


@dataclass(frozen=True)
class Case:
    """A scene, where it starts, and how long it moves.

    Attributes:
        build: Makes it.
        end: Of the motion [s].
        q, u: Named start.
        inputs: Values by name, held.
        integrator: Of co-simulation, and the method of ``simulate``; "" for the usual one.
        elements: Whether it is one of finite elements.
    """

    build: Callable[[], cd.Scene]
    end: float = 1.0
    q: Mapping[str, float | Sequence[float]] = field(default_factory=dict)
    u: Mapping[str, float | Sequence[float]] = field(default_factory=dict)
    inputs: Mapping[str, float] = field(default_factory=dict)
    elements: bool = False


def arm() -> cd.Scene:
    """Three hinges about different axes, with springs."""
    scene = cd.Scene("arm")
    place = scene.ground
    for k, axis in enumerate("zyx"):
        link = scene.body(f"link{k}", mass=1.0 + k, com=(0.2, 0, 0.1), inertia=(0.03, 0.02, 0.04))
        scene.joint(f"joint{k}", cd.Revolute(axis), place, link)
        scene.force(f"spring{k}", cd.JointSpring(f"joint{k}", 5.0 + k))
        place = link.at(0.5, 0, 0)
    return scene


def pendulum() -> cd.Scene:
    return cd.load(SCENES / "double_pendulum.yaml")


def four_bar() -> cd.Scene:
    return cd.load(SCENES / "four_bar.yaml")


def tumbling() -> cd.Scene:
    """A free body, held by a spring away from its center: quaternions."""
    scene = cd.Scene("tumbling", gravity=(0, 0, 0))
    body = scene.body("body", mass=2.0, inertia=(0.02, 0.05, 0.04))
    scene.joint("free", cd.Free(), scene.ground, body)
    scene.force(
        "spring", cd.SpringDamper(scene.ground, body.at(0.1, 0.05, 0), 30.0, 0.2, rest_length=0.3)
    )
    return scene


def bouncing() -> cd.Scene:
    """A mass that falls on a stop, again and again."""
    scene = cd.Scene("bouncing")
    scene.joint("x", cd.Prismatic("z"), scene.ground, scene.body("mass", mass=1.0))
    scene.force("floor", cd.Stop("x", lower=0.0, restitution=0.7, settle=0.05))
    return scene


def sticking() -> cd.Scene:
    """A block on a rail with dry friction, pulled by a spring: it sticks and slips."""
    scene = cd.Scene("sticking", gravity=(0, 0, 0))
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("block", mass=1.0))
    scene.force("rail", cd.Friction("x", coulomb=2.0, static=2.5, viscous=0.1))
    scene.force("pull", cd.JointForce("x", 3.0 * sp.sin(3.0 * cd.t)))
    return scene


def controlled() -> cd.Scene:
    """A hinge that a sampled controller turns."""
    scene = cd.Scene("controlled")
    link = scene.body("link", mass=1.0, com=(0.3, 0, 0), inertia=(0.02, 0.05, 0.05))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, link)
    q, u = scene.q("hinge"), scene.u("hinge")
    law = cd.Controller.pid("hinge", q, u, target=0.8, kp=40, ki=30, kd=6, sample=0.02)
    scene.force("pid", law)
    return scene


def cart(name: str = "cart") -> cd.Scene:
    """A cart with a pendulum; two forces are inputs."""
    scene = cd.Scene(name)
    cart_body = scene.body("cart", mass=2.0)
    rod = scene.body("rod", mass=0.5, com=(0, 0, -0.4), inertia=(0.03, 0.03, 0.001))
    scene.joint("track", cd.Prismatic("x"), scene.ground, cart_body)
    scene.joint("pin", cd.Revolute("y"), cart_body, rod)
    push = scene.input("push", default=1.0, unit="N")
    wind = scene.input("wind", default=0.0, unit="N")
    scene.force("push", cd.JointForce("track", push))
    tip = rod.at(0, 0, -0.8)
    scene.force("wind", cd.Force(tip, (wind, 0, 0)))
    if name == "gauges":
        scene.output("swing", scene.q("pin") * scene.u("pin"), unit="rad/s")
        scene.output("height", tip.position()[2], unit="m")
        scene.output("felt", tip.acceleration()[0] + 0.1 * wind, unit="m/s^2")
    return scene


def gauges() -> cd.Scene:
    """Outputs by expressions: products, positions, accelerations."""
    return cart("gauges")


def pushed() -> cd.Scene:
    """A mass that is pushed shortly and pulled back from a later time on."""
    scene = cd.Scene("pushed")
    first, last, later = (
        scene.parameter(name, value, unit="s")
        for name, value in (("first", 0.37), ("last", 0.372), ("later", 0.7000000000000001))
    )
    scene.joint("rail", cd.Prismatic("x"), scene.ground, scene.body("mass", mass=2.0))
    force = sp.Piecewise((0, cd.t < first), (40, cd.t < last), (0, cd.t <= later), (-1, True))
    scene.force("push", cd.JointForce("rail", force))
    return scene


def door() -> cd.Scene:
    """Friction, stops and a sampled controller at once, with an input."""
    scene = cd.Scene("door")
    body = scene.body("door", mass=20.0, com=(0, 0, -1), inertia=(7.0, 8.0, 1.5))
    lamp = scene.body("lamp", mass=1.2, com=(0, 0, -0.4), inertia=(0.02, 0.02, 0.005))
    scene.joint("rail", cd.Prismatic("x"), scene.ground, body)
    scene.joint("hook", cd.Revolute("y"), body.at(0.3, 0, -0.5), lamp)
    scene.force("friction", cd.Friction("rail", coulomb=12.0, static=18.0, viscous=4.0))
    scene.force("ends", cd.Stop("rail", lower=0.0, upper=0.9, restitution=0.4, settle=0.02))
    goal = scene.input("goal", default=0.9, unit="m")
    error, learned = goal - scene.q("rail"), sp.Symbol("learned")
    scene.force(
        "motor",
        cd.Controller(
            "rail",
            states=(learned,),
            changes=(learned + 2.0 * error,),
            force=60.0 * error - 30.0 * scene.u("rail") + learned,
            sample=0.02,
        ),
    )
    return scene


def rubber() -> cd.Scene:
    """A bar of rubber that falls around its pin."""
    scene = cd.Scene("rubber")
    material = cd.material(E=5e6, nu=0.45, rho=1100)
    bar = scene.beam(
        "bar", (0, 0, 0), (1, 0, 0), cd.section.rectangle(0.02, 0.02), material, elements=2
    )
    scene.joint("pin", cd.Revolute("y"), scene.ground, bar.start)
    return scene


def robot() -> cd.Scene:
    """A rigid hub on a hinge with a controller, an elastic link on it, a load at the tip."""
    scene = cd.Scene("robot")
    dural = cd.material(E=7e10, nu=0.3, rho=2700, damping=2e-4)
    hub = scene.body("hub", mass=0.4, inertia=(1e-3, 1e-3, 1e-3))
    scene.joint("shoulder", cd.Revolute("y"), scene.ground, hub)
    link = scene.beam(
        "link", hub, (0.6, 0, 0), cd.section.tube(outer=0.008, inner=0.007), dural, elements=1
    )
    load = scene.body("load", mass=0.5, inertia=(2e-4, 2e-4, 2e-4))
    scene.joint("grip", cd.Fixed(), link.end, load)
    goal = scene.input("goal", default=-0.3, unit="rad")
    torque = 60.0 * (goal - scene.q("shoulder")) - 12.0 * scene.u("shoulder")
    scene.force("motor", cd.JointForce("shoulder", torque))
    scene.output("height", load.position()[2], unit="m")
    return scene


HALF = float(np.sqrt(0.5))
CASES: dict[str, Case] = {
    "arm": Case(arm, q={"joint1": 0.4, "joint2": -0.3}, u={"joint0": 1.0}),
    "pendulum": Case(pendulum, q={"shoulder": 1.0}),
    "four_bar": Case(four_bar, q={"A": 0.470659}, u={"A": 2.0}),
    "tumbling": Case(
        tumbling,
        q={"free": [HALF, 0.0, HALF, 0.0, 0.5, 0.1, 0.0]},
        u={"free": [3.0, 0.2, -1.0, 0.0, 0.5, 0.1]},
    ),
    "bouncing": Case(bouncing, end=1.5, q={"x": 0.5}),
    "sticking": Case(sticking, end=3.0),
    "controlled": Case(controlled),
    "cart": Case(cart, inputs={"push": 3.0, "wind": -0.5}),
    "gauges": Case(gauges, q={"pin": 0.5}),
    "pushed": Case(pushed),
    "door": Case(door, end=2.0, inputs={"goal": 0.8}),
    "rubber": Case(rubber, end=0.3, elements=True),
    "robot": Case(robot, end=0.3, elements=True),
}
