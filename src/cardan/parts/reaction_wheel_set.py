"""A set of reaction wheels."""

from __future__ import annotations

import math

from ..api.scene import Scene
from ..arguments import Count, checked
from ..elements.forces.joint_force import JointForce
from ..elements.joints.revolute import Revolute
from ..scene import inertia, shape
from .building import BLUE, DARK, ORANGE, STEEL, declared

# of the parameters: unit -> names
UNITS = {"rad": "cant", "m": "ring_radius wheel_radius wheel_thickness", "kg": "wheel_mass"}


@checked
def reaction_wheel_set(
    *,
    wheels: Count = 4,
    cant: float = 0.6155,
    ring_radius: float = 0.12,
    wheel_mass: float = 1.5,
    wheel_radius: float = 0.07,
    wheel_thickness: float = 0.03,
) -> Scene:
    """Reaction wheels around z, evenly spaced, with axes that rise from the plane by an angle.

    Include it at a frame of a spacecraft: the ground of the set is its mounting. Four wheels make a
    pyramid; three with ``cant=0.6155`` (35.26 degrees) have axes at right angles. Inputs:
    ``torque1`` ...: of the motors between mounting and wheels. Outputs: ``speed1`` ... against the
    mounting and ``momentum.x``, ``momentum.y``, ``momentum.z``: what the wheels store against the
    mounting, in its axes.

    Args:
        wheels: How many there are, at least one.
        cant: Angle of the axes above the plane [rad].
        ring_radius: Distance of the wheels from z [m].
        wheel_mass, wheel_radius, wheel_thickness: Of one wheel, a disk [kg, m, m].

    Returns:
        The scene; joints ``wheel1`` ...

    Source: J. R. Wertz (ed.), Spacecraft Attitude Determination and Control, 1978, 6.6 and 18.
    """
    import sympy

    scene = Scene("reaction_wheel_set")
    p = declared(scene, UNITS, locals())
    size = p["wheel_radius"], p["wheel_thickness"]
    axial, stored = inertia.cylinder(p["wheel_mass"], *size)[2], [sympy.Integer(0)] * 3
    for k in range(wheels):
        name, azimuth = f"wheel{k + 1}", 2 * math.pi * (k + 0.5) / wheels
        c, s = math.cos(azimuth), math.sin(azimuth)
        wheel = scene.body(
            name,
            mass=p["wheel_mass"],
            inertia=inertia.cylinder(p["wheel_mass"], *size),
            shape=[
                shape.cylinder(*size, color=(ORANGE, BLUE)[k % 2]),
                shape.box(1.6 * wheel_radius, 0.01, 1.1 * wheel_thickness, color=DARK),
                shape.cylinder(0.008, 2 * wheel_thickness, color=STEEL),
            ],
        )
        # z of the frame: outward by the azimuth, up by the angle
        rotation = ("ZYX", azimuth, sympy.pi / 2 - p["cant"], 0)
        mount = scene.ground.at(p["ring_radius"] * c, p["ring_radius"] * s, 0, rotation=rotation)
        scene.joint(name, Revolute("z"), mount, wheel)
        torque = scene.input(f"torque{k + 1}", unit="N*m")
        scene.force(f"motor{k + 1}", JointForce(name, torque))
        speed = scene.u(name)
        scene.output(f"speed{k + 1}", speed, "rad/s")
        level, up = sympy.cos(p["cant"]), sympy.sin(p["cant"])
        for i, part in enumerate((level * c, level * s, up)):
            stored[i] += axial * speed * part
    for letter, momentum in zip("xyz", stored, strict=True):
        scene.output(f"momentum.{letter}", momentum, "N*m*s")
    scene.settings.update(t=1.0, u={f"wheel{k + 1}": 100.0 * (-1) ** k for k in range(wheels)})
    return scene
