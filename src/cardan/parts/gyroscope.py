"""A gyroscope in gimbals, or a top."""

from __future__ import annotations

import math

from ..api.scene import Scene
from ..arguments import checked
from ..elements.forces.joint_force import JointForce
from ..elements.joints.revolute import Revolute
from ..scene import inertia, shape
from .building import BLUE, DARK, ORANGE, STEEL, declared

TILT = 1.0  # of the axis from the vertical at the start [rad]
EDGES = 32  # of a ring, as it is drawn
# of the parameters: unit -> names
UNITS = {
    "kg": "rotor_mass inner_mass outer_mass",
    "m": "rotor_radius rotor_thickness arm inner_radius outer_radius",
}


@checked
def gyroscope(
    *,
    rotor_mass: float = 1.0,
    rotor_radius: float = 0.06,
    rotor_thickness: float = 0.02,
    arm: float = 0.02,
    inner_mass: float = 0.05,
    outer_mass: float = 0.08,
    inner_radius: float = 0.08,
    outer_radius: float = 0.1,
    spin: float = 200.0,
) -> Scene:
    """Gyroscope: a rotor in two gimbals whose axes meet, with its mass off that point.

    The outer gimbal turns about z (precession), the inner one about y (nutation, the tilt of the
    axis from z), the rotor about its axis (spin). It starts in slow steady precession under
    gravity. Without mass of the gimbals it is Lagrange's top; with ``arm=0`` it is free of the
    weight. Inputs: ``outer_torque``, ``inner_torque``, ``rotor_torque``. Outputs: ``axis.x``,
    ``axis.y``, ``axis.z``: the direction of the rotor's axis in axes of the ground. Frame:
    ``rotor_center``.

    Args:
        rotor_mass, rotor_radius, rotor_thickness: The rotor, a disk [kg, m, m].
        arm: Distance of its center from the point where the axes meet, along its axis [m].
        inner_mass, outer_mass: Masses of the gimbals, thin rings [kg].
        inner_radius, outer_radius: Their radii [m].
        spin: Speed of the rotor at the start [rad/s]; a start, not a parameter.

    Returns:
        The scene; joints ``outer``, ``inner`` and ``rotor``.

    Source: H. Goldstein, Classical Mechanics, 1980, 5-7 (the heavy symmetrical top).
    """
    scene = Scene("gyroscope")
    p = declared(scene, UNITS, locals())
    # a thin ring: m r^2 about its axis, half of it across
    rings = {}
    for name, color, axis in (("outer", BLUE, "x"), ("inner", STEEL, "z")):
        mass, radius = p[f"{name}_mass"], p[f"{name}_radius"]
        about = {key: mass * radius**2 / (1 if key == axis else 2) for key in "xyz"}
        drawn = _ring(outer_radius if name == "outer" else inner_radius, axis, color)
        moments = (about["x"], about["y"], about["z"])
        rings[name] = scene.body(name, mass=mass, inertia=moments, shape=drawn)
    center = (0, 0, p["arm"])
    rotor = scene.body(
        "rotor",
        mass=p["rotor_mass"],
        com=center,
        inertia=inertia.cylinder(p["rotor_mass"], p["rotor_radius"], p["rotor_thickness"]),
        shape=[
            shape.cylinder(p["rotor_radius"], p["rotor_thickness"], position=center, color=ORANGE),
            shape.box(
                2.1 * rotor_radius, 0.006, 0.5 * rotor_thickness, position=center, color=DARK
            ),
            shape.cylinder(0.003, 2 * inner_radius, color=DARK),
        ],
    )
    rotor.at(*center, name="rotor_center")

    sizes = rotor_mass, rotor_radius, rotor_thickness, arm, inner_mass, inner_radius
    scene.joint("outer", Revolute("z"), scene.ground, rings["outer"], u0=_precession(*sizes, spin))
    scene.joint("inner", Revolute("y"), rings["outer"], rings["inner"], q0=TILT)
    scene.joint("rotor", Revolute("z"), rings["inner"], rotor, u0=spin)
    for name in ("outer", "inner", "rotor"):
        torque = scene.input(f"{name}_torque", unit="N*m")
        scene.force(f"{name}_torque", JointForce(name, torque))
    axis_direction = rotor.rotation(wrt=scene.ground)
    for k, letter in enumerate("xyz"):
        scene.output(f"axis.{letter}", axis_direction[k, 2])
    scene.settings.update(t=2.0)
    return scene


def _precession(
    mass: float, radius: float, thickness: float, arm: float, ring: float, reach: float, spin: float
) -> float:
    """Slow steady precession at the tilt of the start [rad/s]; 0 where there is none.

    (A + A' - C' - C) cos(tilt) w^2 - C spin w + m g arm = 0, with the moments A of the rotor about
    the point and C about its axis, and those of the inner ring, A' and C'.
    """
    axial, ring_axial = mass * radius**2 / 2, ring * reach**2
    across = mass * (3 * radius**2 + thickness**2) / 12 + mass * arm**2
    a = (across + ring_axial / 2 - ring_axial - axial) * math.cos(TILT)
    b, c = axial * spin, mass * 9.81 * arm
    root = b * b - 4 * a * c
    return 2 * c / (b + math.copysign(math.sqrt(root), b)) if b and root >= 0 else 0.0


def _ring(radius: float, axis: str, color: tuple[float, float, float]) -> list[shape.Shape]:
    """A ring of rods about an axis."""
    length = 2.1 * radius * math.tan(math.pi / EDGES)
    rods = []
    for k in range(EDGES):
        angle = 2 * math.pi * k / EDGES
        c, s = radius * math.cos(angle), radius * math.sin(angle)
        # rods lie along y before they are turned to their place
        place = (0.0, c, s) if axis == "x" else (c, s, 0.0)
        turn = ("XYZ", angle + math.pi / 2, 0.0, 0.0) if axis == "x" else ("XYZ", 0.0, 0.0, angle)
        rods.append(
            shape.cylinder(0.003, length, axis="y", position=place, rotation=turn, color=color)
        )
    return rods
