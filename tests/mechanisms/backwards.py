"""Trees whose joints are declared from the body that is carried to the one that carries it."""

from __future__ import annotations

import cardan as cd

from .mechanism import Mechanism, State

INERTIA = ((0.03, 0.002, -0.001), (0.002, 0.04, 0.003), (-0.001, 0.003, 0.02))


def _body(scene: cd.Scene, name: str, mass: float = 1.0) -> cd.Body:
    return scene.body(name, mass=mass, com=(0.02, 0.05, -0.2), inertia=INERTIA)


def backwards() -> cd.Scene:
    """A chain of a ball joint, a Hooke joint, a thread and a table, told from its tip."""
    scene = cd.Scene("backwards", gravity=(0, 0.5, -9.81))
    ball, hooke, nut, puck = (_body(scene, name) for name in ("ball", "hooke", "nut", "puck"))
    scene.joint("table", cd.Planar((0, 1, 2)), puck.at(0.1, 0, 0.1), nut)
    scene.joint("thread", cd.Screw((1, 2, 2), pitch=0.1), nut.at(0, 0.1, 0), hooke.at(0, 0, -0.2))
    scene.joint("cross", cd.Universal("x", (0, 1, 1)), hooke, ball.at(0.1, 0, -0.3))
    scene.joint("ball", cd.Spherical(), ball.at(0, 0, 0.1), scene.ground.at(0, 0, 1))
    return scene


def backwards_guided() -> cd.Scene:
    """A carriage that is the parent of the ground, and bodies that carry what holds them."""
    scene = cd.Scene("backwards_guided", gravity=(0.2, 0, -9.81))
    names = ("base", "collar", "shaft", "box", "slider")
    base, collar, shaft, box, slider = (_body(scene, name) for name in names)
    scene.joint("float", cd.Free(), base, scene.ground)
    scene.joint("sleeve", cd.Cylindrical((0, 3, 4)), collar.at(0, 0.1, 0), base.at(0.2, 0, 0))
    scene.joint("bend", cd.ConstantVelocity("x"), shaft, collar.at(0, 0, -0.1))
    scene.joint("rod", cd.Distance(0.5, "z", "XYZ"), box.at(0, 0, 0.1), base.at(0, -0.1, 0))
    scene.joint("track", cd.PointOnPlane("y"), slider, base.at(0, 0, 0.3))
    scene.force("spring", cd.SpringDamper(slider, base, stiffness=20))
    return scene


MEMBERS = (
    Mechanism(
        "backwards",
        backwards,
        (
            State({"cross": (0.3, -0.2), "thread": 0.5}, {"ball": (0.2, 0.1, 0.3)}),
            State(
                {"ball": (0.8, 0.0, 0.6, 0.0), "cross": (-0.4, 0.7), "table": (0.1, 0.2, 1.0)},
                {"ball": (1.0, -0.5, 0.4), "cross": (0.3, 2.0), "thread": -1.0},
            ),
        ),
    ),
    Mechanism(
        "backwards_guided",
        backwards_guided,
        (
            State({"rod": (0.1, 0.2, -0.1, 0.2, 0.1)}, {"bend": (0.1, -0.05)}),
            State(
                {
                    "float": (0.8, 0.0, 0.0, 0.6, 0.3, 0.1, -0.2),
                    "sleeve": (0.5, 0.2),
                    "bend": (0.6, -0.4),
                    "rod": (0.1, 0.2, -0.1, 0.2, 0.1),
                },
                {"float": (0.1, 0.5, -0.2, 0.3, 0.1, 0.4), "bend": (1.0, 0.5)},
            ),
        ),
    ),
)
