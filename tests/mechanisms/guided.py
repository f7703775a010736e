"""Scenes for the joints that guide a point, and for those that follow."""

from __future__ import annotations

import cardan as cd

from .mechanism import COUPLED, Mechanism, State

VALLEY = [
    (-2, 0, 1.6),
    (-1.2, 0.2, 0.5),
    (-0.4, 0.1, 0.1),
    (0.5, -0.2, 0.1),
    (1.3, 0, 0.7),
    (2, 0, 2),
]
TRACK = [(4, 0, 0), (2, 3, 0.8), (-2, 3, 0.2), (-4, 0, 1.0), (-2, -3, 0.3), (2, -3, 0.5)]


def constant_velocity() -> cd.Scene:
    """A driven shaft, a bent one behind a constant-velocity joint, and a flap on that."""
    scene = cd.Scene("constant_velocity", gravity=(0.5, 0, -9.81))
    shaft = scene.body("shaft", mass=2.0, inertia=(0.02, 0.02, 0.03))
    bent = scene.body("bent", mass=1.5, com=(0.01, 0, -0.25), inertia=(0.04, 0.05, 0.01))
    flap = scene.body("flap", mass=0.3, com=(0.1, 0, -0.1), inertia=(0.002, 0.003, 0.002))
    scene.joint("bearing", cd.Revolute("z"), scene.ground, shaft)
    scene.joint("coupling", cd.ConstantVelocity("z"), shaft.at(0, 0, -0.1), bent)
    scene.joint("hinge", cd.Revolute("y"), bent.at(0.05, 0, -0.5), flap)
    return scene


def point_on_plane() -> cd.Scene:
    """A body hung from a tilted table by one sliding point, with a pendulum on it."""
    scene = cd.Scene("point_on_plane", gravity=(0, 0, -9.81))
    hung = scene.body("hung", mass=1.2, com=(0.02, 0.05, -0.3), inertia=(0.03, 0.04, 0.02))
    bob = scene.body("bob", mass=0.4, com=(0, 0, -0.2), inertia=(0.004, 0.004, 0.001))
    slide = cd.PointOnPlane((0.1, -0.05, 1.0))
    scene.joint("slide", slide, scene.ground.at(0.1, 0, 1), hung)
    scene.joint("hinge", cd.Revolute("x"), hung.at(0, 0.1, -0.4), bob)
    return scene


def point_on_curve() -> cd.Scene:
    """A lamp on a ring that slides along a bent wire, with a tassel."""
    scene = cd.Scene("point_on_curve", gravity=(0, 0, -9.81))
    lamp = scene.body("lamp", mass=0.8, com=(0.01, 0.02, -0.2), inertia=(0.02, 0.03, 0.01))
    tassel = scene.body("tassel", mass=0.1, com=(0, 0, -0.1), inertia=(4e-4, 4e-4, 1e-4))
    scene.joint("wire", cd.PointOnCurve(VALLEY), scene.ground.at(0, 0, 3), lamp)
    scene.joint("knot", cd.Revolute("y"), lamp.at(0, 0, -0.4), tassel)
    return scene


def roller_coaster() -> cd.Scene:
    """A car that hangs below a closed track, with a swing."""
    scene = cd.Scene("roller_coaster", gravity=(0, 0, -9.81))
    car = scene.body("car", mass=3.0, com=(0, 0.02, -0.2), inertia=(0.2, 0.3, 0.25))
    seat = scene.body("seat", mass=1.0, com=(0.02, 0, -0.1), inertia=(0.02, 0.02, 0.01))
    scene.joint("track", cd.PointOnCurve(TRACK, closed=True), scene.ground, car)
    scene.joint("swing", cd.Revolute("y"), car.at(0, 0, -0.3), seat)
    return scene


def distance() -> cd.Scene:
    """A box on a light rod, and a pendulum on another rod below it."""
    scene = cd.Scene("distance", gravity=(0, 0.4, -9.81))
    box = scene.body("box", mass=1.0, com=(0.05, 0, -0.1), inertia=(0.02, 0.015, 0.01))
    bob = scene.body("bob", mass=0.5, com=(0, 0.02, -0.05), inertia=(0.002, 0.003, 0.002))
    scene.joint("rod", cd.Distance(0.8, "-z"), scene.ground, box)
    scene.joint("string", cd.Distance(0.5, (0.1, 0, -1), "XYZ"), box.at(0, 0.1, -0.2), bob)
    return scene


def gear() -> cd.Scene:
    """Two unbalanced wheels that mesh, and a crown wheel on the second."""
    scene = cd.Scene("gear", gravity=(0, 0, -9.81))
    small = scene.body("small", mass=1.0, com=(0.05, 0, 0.02), inertia=(0.003, 0.004, 0.003))
    large = scene.body("large", mass=3.0, com=(0.02, 0, 0.1), inertia=(0.02, 0.03, 0.02))
    crown = scene.body("crown", mass=0.5, com=(0, 0.03, 0), inertia=(0.001, 0.001, 0.002))
    first = scene.joint("first", cd.Revolute("y"), scene.ground, small)
    scene.joint("second", cd.Gear(first, -0.4, "y", 0.2), scene.ground.at(0.4, 0, 0), large)
    scene.joint("third", cd.Gear("second", 1.5, (1, 0, 1)), large.at(0.1, 0.05, 0), crown)
    return scene


MEMBERS = (
    Mechanism(
        "constant_velocity",
        constant_velocity,
        (
            State({"coupling": (0.4, -0.3)}, {"bearing": 1.0}),
            State({"bearing": 1.0, "coupling": (-0.7, 0.9)}, {"coupling": (1.0, -2.0)}),
        ),
    ),
    Mechanism(
        "point_on_plane",
        point_on_plane,
        (
            State({"hinge": 0.5}, {"slide": (0.3, 0.2, 1.0, 0.1, -0.2)}),
            State(
                {"slide": (0.8, 0.0, 0.6, 0.0, 0.3, -0.1), "hinge": -1.0},
                {"slide": (1.0, -0.5, 0.2, 0.4, 0.3), "hinge": 2.0},
            ),
        ),
    ),
    Mechanism(
        "point_on_curve",
        point_on_curve,
        (
            State({"wire": (1.0, 0.0, 0.0, 0.0, 1.9), "knot": 0.3}),
            State({"wire": (0.8, 0.0, 0.6, 0.0, 2.9)}, {"wire": (0.3, 0.2, 1.0, -0.5)}),
        ),
    ),
    Mechanism(
        "roller_coaster",
        roller_coaster,
        (
            State({"track": (1.0, 0.0, 0.0, 0.0, 1.0)}, {"track": (0.0, 0.0, 0.0, 5.0)}),
            State(
                {"track": (0.8, 0.0, 0.0, 0.6, 60.0), "swing": 0.1},
                {"track": (0.1, 0.2, 0.3, -4.0), "swing": 0.5},
            ),
        ),
    ),
    Mechanism(
        "distance",
        distance,
        (
            State({"rod": (1.0, 0.0, 0.0, 0.0, 0.2, -0.15)}),
            State(
                {"rod": (0.8, 0.6, 0.0, 0.0, 0.3, 0.4), "string": (0.1, -0.2, 0.3, 0.5, -0.2)},
                {"rod": (0.3, 0.2, 0.1, -0.5, 0.4), "string": (0.2, 0.3, -0.1, 1.0, -0.7)},
            ),
        ),
    ),
    Mechanism(
        "gear",
        gear,
        (State({"first": 0.5}), State({"first": 2.0}, {"first": -3.0})),
        methods=COUPLED,
    ),
)
