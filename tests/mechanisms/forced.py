"""Springs, drives, dampers, motors, coupled and prescribed joints."""

from __future__ import annotations

import sympy

import cardan as cd

from .mechanism import COUPLED, Mechanism, State


def two_links(name: str) -> cd.Scene:
    """A slanted base joint and a second link, to hang forces on."""
    scene = cd.Scene(name, gravity=(0, 0, -9.81))
    first = scene.body("first", mass=1.0, com=(0.2, 0, 0.05), inertia=(0.01, 0.02, 0.025))
    second = scene.body("second", mass=0.6, com=(0, 0.1, -0.2), inertia=(0.01, 0.008, 0.004))
    scene.joint("base", cd.Revolute((0, 3, 4)), scene.ground, first)
    scene.joint("elbow", cd.Revolute("x"), first.at(0.4, 0, 0), second)
    return scene


def gripper() -> cd.Scene:
    """A swinging hand whose second finger mirrors the first and whose thumb follows by a gear."""
    scene = cd.Scene("gripper", gravity=(0, 0, -9.81))
    hand = scene.body("hand", mass=1.5, com=(0, 0, -0.2), inertia=(0.02, 0.02, 0.01))
    left = scene.body("left", mass=0.2, com=(0, 0.01, -0.05), inertia=(2e-4, 2e-4, 1e-4))
    right = scene.body("right", mass=0.2, com=(0, -0.01, -0.05), inertia=(2e-4, 2e-4, 1e-4))
    thumb = scene.body("thumb", mass=0.1, com=(0.05, 0, 0), inertia=(1e-5, 1e-4, 1e-4))
    scene.joint("wrist", cd.Revolute("y"), scene.ground, hand)
    scene.joint("left_slide", cd.Prismatic("y"), hand.at(0, 0, -0.4), left)
    scene.joint(
        "right_slide", cd.Prismatic("y"), hand.at(0, 0, -0.4), right, couple=("left_slide", -1)
    )
    scene.joint("gear", cd.Revolute("z"), right, thumb, couple=("wrist", 2.5, 0.3))
    # without it nothing holds the fingers
    scene.force("return", cd.JointSpring("left_slide", stiffness=30.0, rest=0.02))
    return scene


def crane() -> cd.Scene:
    """A slewing column on a prescribed path, a boom and a swinging load."""
    scene = cd.Scene("crane", gravity=(0, 0, -9.81))
    column = scene.body("column", mass=20.0, com=(0.1, 0, 1.0), inertia=(8.0, 8.0, 0.5))
    boom = scene.body("boom", mass=5.0, com=(1.0, 0, 0), inertia=(0.02, 1.7, 1.7))
    load = scene.body("load", mass=8.0, com=(0, 0, -1.0), inertia=(0.1, 0.1, 0.1))
    path = sympy.Rational(2, 5) * sympy.sin(sympy.Rational(3, 2) * cd.t)
    scene.joint("slew", cd.Revolute("z"), scene.ground, column, prescribed=path)
    scene.joint("luff", cd.Revolute("y"), column.at(0, 0, 2.0), boom)
    scene.joint("rope", cd.Universal("x", "y"), boom.at(2.0, 0, 0), load)
    scene.force("jack", cd.JointSpring("luff", stiffness=900.0, rest=-0.4))
    return scene


def springs() -> cd.Scene:
    """A straight spring to the ground, one between links, one in a joint: all energy is kept."""
    scene = two_links("springs")
    first, second = scene.bodies["first"], scene.bodies["second"]
    anchor = scene.ground.at(0.3, 0.8, 0.2)
    tip = second.at(0, 0.1, -0.4)
    scene.force("cable", cd.SpringDamper(anchor, tip, stiffness=40.0, rest_length=0.3))
    scene.force("band", cd.SpringDamper(first.at(0.1, 0, 0.1), tip, stiffness=15.0))
    scene.force("coil", cd.JointSpring("elbow", stiffness=3.0, rest=0.4))
    return scene


def mounts() -> cd.Scene:
    """A coupled bushing with a curve between links, a flexible hinge, and a taut cable."""
    scene = two_links("mounts")
    first, second = scene.bodies["first"], scene.bodies["second"]
    coupled = [[9 - abs(i - j) + 20 * (i == j) for j in range(6)] for i in range(6)]
    ends = (first.at(0.4, 0, 0, rotation=("XYZ", 0.2, 0.3, -0.1)), second.at(0.02, 0, 0))
    curve = cd.table([-2.0, -0.3, 0.0, 0.2, 2.0], [-30.0, -2.0, 0.0, 3.0, 40.0])
    rest = (0, 0.1, 0, 0, 0, 0.05)
    scene.force("mount", cd.Bushing(*ends, stiffness=coupled, rest=rest, tables={"rx": curve}))
    hinge = cd.FlexibleHinge(scene.ground, first.at(0, 0, 0.1), (0, 3, 4), 2.0, 30.0, 50.0, 40.0)
    scene.force("hinge", hinge)
    anchor, tip = scene.ground.at(0.3, 0.8, 0.2), second.at(0, 0.1, -0.4)
    scene.force("guy", cd.Cable(anchor, tip, EA=15.0, length=0.2))
    return scene


def drives() -> cd.Scene:
    """A rigid geared rotor, one that feels gyroscopic moments, and one on an elastic shaft."""
    scene = two_links("drives")
    tool = scene.body("tool", mass=0.3, com=(0.05, 0, 0), inertia=(0.001, 0.002, 0.002))
    scene.joint("wrist", cd.Revolute("z"), scene.bodies["second"].at(0, 0, -0.4), tool)
    scene.force("base_drive", cd.Drive("base", inertia=2e-4, ratio=30.0))
    scene.force("elbow_drive", cd.Drive("elbow", inertia=1e-4, ratio=-20.0, gyroscopic=True))
    scene.force("wrist_drive", cd.Drive("wrist", inertia=5e-5, ratio=10.0, stiffness=2.0))
    return scene


def damped() -> cd.Scene:
    """Dampers of three kinds, motor friction and a force that depends on place and speed."""
    scene = two_links("damped")
    tip = scene.bodies["second"].at(0, 0.1, -0.4)
    shock = cd.SpringDamper(
        scene.ground.at(0, 0.9, 0.1), tip, stiffness=20, damping=3, rest_length=0.5
    )
    scene.force("shock", shock)
    scene.force("bearing", cd.JointDamper("base", 0.05))
    scene.force("coil", cd.JointSpring("elbow", stiffness=2.0, damping=0.02))
    scene.force("motor", cd.Drive("base", inertia=1e-4, ratio=25.0, torque=0.01, friction=1e-4))
    drag = [-sympy.Rational(1, 5) * v for v in tip.velocity()]
    scene.force("drag", cd.Force(tip, drag))
    return scene


def driven() -> cd.Scene:
    """A motor law over time and angle, measured data, a turning torque and an input."""
    scene = two_links("driven")
    push = scene.input("push", default=0.7)
    angle, speed = scene.q("elbow"), scene.u("elbow")
    law = push * sympy.sin(2 * cd.t) - sympy.Rational(1, 10) * speed - sympy.tanh(angle)
    scene.force("law", cd.JointForce("elbow", law))
    measured = cd.table([-7.0, -1.0, 0.0, 1.5, 7.0], [0.9, 0.4, 0.0, -0.6, -1.0], kind="akima")
    scene.force("muscle", cd.JointForce("base", measured(scene.q("base"))))
    second = scene.bodies["second"]
    scene.force("fan", cd.Torque(second, (0, 0.02, 0.01), in_=second))
    return scene


MEMBERS = (
    Mechanism(
        "gripper",
        gripper,
        (
            State({"wrist": 0.5, "left_slide": 0.03}),
            State({"wrist": -1.0}, {"wrist": 2.0, "left_slide": 0.3}),
        ),
        methods=COUPLED,
    ),
    Mechanism(
        "crane",
        crane,
        (State({"luff": -0.5}), State({"luff": -0.2, "rope": (0.4, -0.3)}, {"luff": 0.5})),
        conservative=False,
    ),
    Mechanism(
        "springs",
        springs,
        (
            State({"base": 0.5, "elbow": -0.3}),
            State({"base": 1.2, "elbow": 0.8}, {"base": -1, "elbow": 2}),
        ),
    ),
    Mechanism(
        "mounts",
        mounts,
        (
            State({"base": 0.3, "elbow": -0.4}),
            State({"base": 0.5, "elbow": 0.6}, {"base": -1, "elbow": 2}),
        ),
    ),
    Mechanism(
        "drives",
        drives,
        (
            State({"base": 0.4, "elbow": 0.5}),
            State({"base": -0.6, "wrist": 0.2}, {"elbow": 1.5, "wrist": 2.0}),
        ),
        methods=COUPLED,
    ),
    Mechanism(
        "damped",
        damped,
        (State({"base": 0.9, "elbow": 0.6}), State({"elbow": -0.8}, {"base": 2.0, "elbow": -3.0})),
        conservative=False,
    ),
    Mechanism(
        "driven",
        driven,
        (State({"base": 0.3, "elbow": -0.5}), State({"base": -0.9}, {"base": 1.0, "elbow": 1.5})),
        conservative=False,
    ),
)
