"""Machines with beams next to joints, loops, controllers, events and friction."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import sympy

import cardan as cd

from .robots import panda

DURAL = cd.material(E=7e10, nu=0.3, rho=2700, damping=1e-4)
SOFT = cd.material(E=2e8, nu=0.3, rho=1200, damping=2e-3)

Vector = tuple[float, float, float]


@dataclass(frozen=True)
class Machine:
    """A scene, its start, and what is watched of its motion.

    Attributes:
        build: Makes the scene.
        q, u: Where it starts, and how fast.
        end: Time [s].
        watched: Names of coordinates or outputs.
    """

    build: Callable[[], cd.Scene]
    end: float
    watched: tuple[str, ...]
    q: Mapping[str, Any] = field(default_factory=dict)
    u: Mapping[str, Any] = field(default_factory=dict)


def folded_array() -> cd.Scene:
    """Three flexible panels, with hinges between them that springs open and latches hold."""
    scene = cd.Scene("folded_array", gravity=(0, 0, 0))
    strip = cd.section.rectangle(0.1, 0.004)
    place: Any = scene.ground
    for k in range(3):
        root = scene.body(f"root{k}", mass=0.2, inertia=(1e-3, 1e-3, 1e-3))
        scene.joint(f"hinge{k}", cd.Revolute("y"), place, root)
        scene.force(f"spring{k}", cd.JointSpring(f"hinge{k}", stiffness=2.0, damping=0.05))
        if k:
            when = scene.q(f"hinge{k}") * (1 if k == 2 else -1)
            scene.force(f"latch{k}", cd.Lock(f"hinge{k}", when=when))
        panel = scene.beam(f"panel{k}", root, (0.5 * (k + 1), 0, 0), strip, DURAL, elements=1)
        place = panel.end
    scene.output("tip", panel.end.position()[2])
    return scene


def slider_crank_with_friction() -> cd.Scene:
    """A slider-crank with a flexible rod and Coulomb friction in the slider."""
    scene = cd.Scene("slider_crank_with_friction", gravity=(0, -9.81, 0))
    crank = scene.body("crank", mass=0.5, com=(0.1, 0, 0), inertia=(1e-3, 5e-3, 5e-3))
    slider = scene.body("slider", mass=0.8, inertia=(1e-3, 1e-3, 1e-3))
    scene.joint("A", cd.Revolute("z"), scene.ground, crank)
    scene.joint("guide", cd.Prismatic("x"), scene.ground.at(0.8, 0, 0), slider)
    rod = cd.section.rectangle(0.012, 0.012)
    scene.beam(
        *("rod", crank.at(0.2, 0, 0), slider, rod, SOFT),
        elements=2,
        release_start="rz",
        release_end="rz",
    )
    scene.force("rub", cd.Friction("guide", coulomb=2.0))
    scene.force("motor", cd.JointForce("A", 1.5 - 0.1 * scene.u("A")))
    return scene


def beam_on_a_stop(stop: bool) -> cd.Scene:
    """A rod on a hinge falls on a stop: compliant at its tip, or rigid at its hinge."""
    scene = cd.Scene("beam_on_a_stop", gravity=(0, 0, -9.81))
    hub = scene.body("hub", mass=0.3, inertia=(1e-3, 2e-3, 1e-3))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, hub)
    rod = scene.beam("rod", hub, (0.6, 0, 0), cd.section.circle(0.01), SOFT, elements=2)
    if stop:
        scene.force("stop", cd.Stop("hinge", upper=0.4, restitution=0.0))
    else:
        ball = scene.body("ball", mass=0.05, inertia=(1e-5, 1e-5, 1e-5))
        scene.joint("weld", cd.Fixed(), rod.end, ball)
        floor = scene.ground.at(0, 0, -0.25)
        contact = cd.Contact(ball, floor, radius=0.02, stiffness=2e4, damping=0.2, exponent=1.5)
        scene.force("floor", contact)
    scene.output("tip", rod.end.position()[2])
    return scene


def controlled_arm(sample: float | None) -> cd.Scene:
    """A flexible arm that a PID controller turns, continuous or sampled."""
    scene = cd.Scene("controlled_arm", gravity=(0, 0, 0))
    hub = scene.body("hub", mass=1.0, inertia=(0.01, 0.01, 0.02))
    scene.joint("motor", cd.Revolute("z"), scene.ground, hub)
    arm = scene.beam(
        "arm",
        hub.at(0.05, 0, 0),
        (0.85, 0, 0),
        cd.section.rectangle(0.03, 0.004),
        DURAL,
        elements=2,
    )
    error, rate, integral = 0.6 - scene.q("motor"), scene.u("motor"), sympy.Symbol("integral")
    change = error if sample is None else integral + error * sample
    force = 9.0 * error + 4.0 * integral - 2.2 * rate
    pid = cd.Controller("motor", (integral,), (change,), force, sample=sample)
    scene.force("pid", pid)
    scene.output("tip", arm.end.position()[1])
    return scene


def spacecraft() -> cd.Scene:
    """A free satellite with a reaction wheel and a flexible panel, in the field of the Earth."""
    scene = cd.Scene("spacecraft", gravity=(0, 0, 0))
    hub = scene.body("hub", mass=50.0, inertia=(6.0, 8.0, 7.0))
    scene.joint("orbit", cd.Free(), scene.ground, hub)
    wheel = scene.body("wheel", mass=1.0, inertia=(5e-3, 5e-3, 9e-3))
    scene.joint("wheel", cd.Revolute("z"), hub.at(0, 0.1, 0), wheel)
    torque = scene.input("torque", default=0.02, unit="N*m")
    scene.force("drive", cd.JointForce("wheel", torque))
    earth = scene.ground.at(-6.878e6, 0, 0)
    field = cd.GravityGradient(earth, 3.986e14, bodies=("hub", "wheel"), force=False)
    scene.force("field", field)
    strip = cd.section.rectangle(0.4, 0.003)
    panel = scene.beam("panel", hub.at(0.5, 0, 0), (3.0, 0.2, 0), strip, DURAL, elements=2)
    scene.output("bent", panel.end.position(wrt=hub, in_=hub)[1])
    return scene


def stick_slip() -> cd.Scene:
    """A mass on a belt, held by the tip of a leaf spring."""
    scene = cd.Scene("stick_slip", gravity=(0, 0, 0))
    guide = scene.body("guide", mass=0.1, inertia=(1e-3, 1e-3, 1e-3))
    scene.joint("along", cd.Prismatic("x"), scene.ground.at(0.5, 0, 0), guide)
    block = scene.body("block", mass=1.0, inertia=(1e-3, 1e-3, 1e-3))
    scene.joint("rail", cd.Prismatic("y"), guide, block)
    leaf = cd.section.rectangle(0.006, 0.02)
    scene.beam("leaf", scene.ground, block, leaf, SOFT, elements=2, release_end="rz")
    scene.force("belt", cd.Friction("rail", coulomb=0.6, static=1.0, against=0.05))
    return scene


def shaft(speed: float = 60.0) -> cd.Scene:
    """A disk amid a flexible shaft whose material damps, turned at a speed."""
    scene = cd.Scene("shaft", gravity=(0, 0, -9.81))
    drum = scene.body("drum", mass=0.1, inertia=(1e-4, 1e-4, 1e-4))
    scene.joint("bearing", cd.Revolute("x"), scene.ground, drum, prescribed=speed * cd.t)
    disk = scene.body("disk", mass=1.0, inertia=(2e-3, 1e-3, 1e-3), pose=(0.3, 0, 0))
    section = cd.section.circle(0.005)
    lossy = cd.material(E=2e11, nu=0.3, rho=7800, damping=2e-4)
    scene.beam("near", drum, disk, section, lossy, elements=2)
    end = scene.body("end", mass=0.1, inertia=(1e-4, 1e-4, 1e-4))
    scene.joint("other", cd.Cylindrical("x"), scene.ground.at(0.6, 0, 0), end)
    scene.beam("far", disk, end, section, lossy, elements=2)
    scene.output("whirl", disk.position()[1])
    return scene


def four_bar() -> cd.Scene:
    """A four-bar with a flexible coupler, turned by a motor with inductance."""
    scene = cd.Scene("four_bar", gravity=(0, -9.81, 0))
    crank = scene.body("crank", mass=0.4, com=(0.1, 0, 0), inertia=(1e-3, 3e-3, 3e-3))
    rocker = scene.body("rocker", mass=0.6, com=(0.25, 0, 0), inertia=(1e-3, 0.02, 0.02))
    scene.joint("A", cd.Revolute("z"), scene.ground, crank)
    pivot = scene.ground.at(0.6, 0, 0, rotation=("XYZ", 0, 0, sympy.pi / 2))
    scene.joint("D", cd.Revolute("z"), pivot, rocker)
    current = sympy.Symbol("current")
    change = (24.0 - 2.0 * current - 0.5 * scene.u("A")) / 0.05
    scene.force("motor", cd.Controller("A", (current,), (change,), 0.5 * current))
    bar = cd.section.rectangle(0.01, 0.01)
    scene.beam(
        *("coupler", crank.at(0.2, 0, 0), rocker.at(0.5, 0, 0), bar, DURAL),
        elements=2,
        release_start="rz",
        release_end="rz",
    )
    return scene


def with_tool(build: Callable[[], cd.Scene], hand: str, along: Vector) -> cd.Scene:
    """A robot from a file with a flexible tool in its hand, held by springs at its joints."""
    scene, robot = build(), cd.compile(build())
    for name, joint in scene.joints.items():
        if joint.kind == "revolute":
            scene.force(f"hold {name}", cd.JointSpring(name, stiffness=80.0, damping=4.0))
    pose = robot.pose(hand, np.zeros(robot.nq))
    tip = pose[:3, 3] + pose[:3, :3] @ along
    rod = cd.section.circle(0.008)
    tool = scene.beam("tool", hand, tuple(tip.tolist()), rod, DURAL, elements=2)
    scene.output("tip", tool.end.position()[2])
    return scene


def desk_arm() -> cd.Scene:
    """The desk arm of the examples, from its URDF file."""
    return cd.load(Path(__file__).parents[2] / "examples" / "arm.urdf")


def swing() -> cd.Scene:
    """Two hinged bars, from a MJCF file."""
    rod = '<geom type="capsule" size="0.02" fromto="0 0 0 0.3 0 0"/>'
    text = f"""<mujoco model="swing"><worldbody><body name="arm">
        <joint name="root" axis="0 1 0" damping="0.1"/>{rod}<body name="hand" pos="0.3 0 0">
        <joint name="wrist" axis="0 0 1" damping="0.1"/>{rod}</body></body></worldbody></mujoco>"""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "swing.xml"
        file.write_text(text, encoding="utf-8")
        return cd.load(file)


MACHINES: dict[str, Machine] = {
    "folded_array": Machine(
        *(folded_array, 1.2, ("hinge0", "hinge1", "hinge2", "tip")),
        q={"hinge0": 0.3, "hinge1": -0.6, "hinge2": 0.6},
    ),
    "slider_crank_with_friction": Machine(
        *(slider_crank_with_friction, 0.6, ("A", "guide")), u={"A": 3.0}
    ),
    "beam_on_a_compliant_stop": Machine(*(lambda: beam_on_a_stop(False), 0.4, ("hinge", "tip"))),
    "beam_on_a_rigid_stop": Machine(*(lambda: beam_on_a_stop(True), 0.4, ("hinge", "tip"))),
    "controlled_arm": Machine(*(lambda: controlled_arm(None), 1.0, ("motor", "tip"))),
    "sampled_arm": Machine(*(lambda: controlled_arm(0.01), 1.0, ("motor", "tip"))),
    "spacecraft": Machine(*(spacecraft, 20.0, ("wheel",)), u={"orbit": (0, 0, 0.02, 0, 0, 0)}),
    "stick_slip": Machine(*(stick_slip, 1.5, ("rail",))),
    "shaft": Machine(*(shaft, 0.4, ("whirl",)), u={"disk.u.py": 1.0}),
    "four_bar": Machine(*(four_bar, 0.5, ("A", "D", "motor.current"))),
    "panda": Machine(*(lambda: with_tool(panda, "panda_hand", (0, 0, 0.4)), 0.4, ("tip",))),
    "urdf_arm": Machine(*(lambda: with_tool(desk_arm, "hand", (0.4, 0, 0)), 0.5, ("elbow", "tip"))),
    "mjcf_arm": Machine(*(lambda: with_tool(swing, "hand", (0.3, 0, 0)), 0.5, ("root", "tip"))),
}
