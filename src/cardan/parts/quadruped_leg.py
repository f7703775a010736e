"""A leg of a quadruped robot."""

from __future__ import annotations

from ..api.scene import Scene
from ..arguments import checked
from ..elements.forces.joint_force import JointForce
from ..elements.joints.fixed import Fixed
from ..elements.joints.revolute import Revolute
from ..scene import inertia, shape
from .building import BLUE, DARK, GREEN, ORANGE, declared

START = {"abduction": 0.1, "hip": 0.7, "knee": -1.4}  # [rad]
# of the parameters: unit -> names
UNITS = {
    "m": "hip_offset thigh_length shank_length foot_radius",
    "kg": "hip_mass thigh_mass shank_mass foot_mass",
}


@checked
def quadruped_leg(
    *,
    hip_offset: float = 0.08,
    thigh_length: float = 0.21,
    shank_length: float = 0.21,
    hip_mass: float = 0.7,
    thigh_mass: float = 1.0,
    shank_mass: float = 0.2,
    foot_mass: float = 0.06,
    foot_radius: float = 0.02,
) -> Scene:
    """Leg of a quadruped: abduction about x, hip and knee about y, and a foot.

    The trunk is the ground: include it at a frame of yours. The hip lies to the left, along y; a
    negative ``hip_offset`` makes a right leg. At zero angles the leg hangs straight down; positive
    angles of hip and knee swing it back, as turning about y does. Inputs: ``abduction_torque``,
    ``hip_torque``, ``knee_torque``. Outputs: ``foot.x``, ``foot.y``, ``foot.z`` in axes of the
    trunk. Frame: ``foot``.

    Args:
        hip_offset: From the axis of abduction to the plane of the leg, along y [m].
        thigh_length, shank_length: Lengths [m].
        hip_mass, thigh_mass, shank_mass: Masses; thigh and shank are slender rods [kg].
        foot_mass: Mass of the foot, a point [kg].
        foot_radius: Of the foot, as it is drawn [m].

    Returns:
        The scene; joints ``abduction``, ``hip`` and ``knee``.

    Source: M. Hutter et al., ANYmal: a highly mobile and dynamic quadrupedal robot, IROS 2016 (the
        arrangement of joints).
    """
    scene = Scene("quadruped_leg")
    p = declared(scene, UNITS, locals())
    motor = 0.045  # radius of a motor [m]
    hip = scene.body(
        "hip",
        mass=p["hip_mass"],
        inertia=inertia.sphere(p["hip_mass"], motor),
        shape=shape.cylinder(motor, 0.06, axis="x", color=DARK),
    )
    bodies = {}
    for name, color, radius in (("thigh", BLUE, 0.022), ("shank", GREEN, 0.013)):
        mass, length = p[f"{name}_mass"], p[f"{name}_length"]
        middle = (0, 0, -length / 2)
        drawn = [shape.capsule(radius, length, axis="z", position=middle, color=color)]
        if name == "thigh":
            drawn += [shape.cylinder(motor, 0.06, axis="y", color=DARK)]
        else:
            drawn += [shape.sphere(p["foot_radius"], position=(0, 0, -length), color=ORANGE)]
        rod = inertia.rod(mass, length, axis="z")
        bodies[name] = scene.body(name, mass=mass, com=middle, inertia=rod, shape=drawn)
    toe = scene.body("toe", mass=p["foot_mass"])
    foot = bodies["shank"].at(0, 0, -p["shank_length"], name="foot")

    scene.joint("abduction", Revolute("x"), scene.ground, hip, q0=START["abduction"])
    side = hip.at(0, p["hip_offset"], 0)
    scene.joint("hip", Revolute("y"), side, bodies["thigh"], q0=START["hip"])
    knee = bodies["thigh"].at(0, 0, -p["thigh_length"])
    scene.joint("knee", Revolute("y"), knee, bodies["shank"], q0=START["knee"])
    scene.joint("toe", Fixed(), foot, toe)
    for name in START:
        torque = scene.input(f"{name}_torque", unit="N*m")
        scene.force(name, JointForce(name, torque))

    place = foot.position(wrt=scene.ground, in_=scene.ground)
    for k, axis in enumerate("xyz"):
        scene.output(f"foot.{axis}", place[k], "m")
    scene.settings.update(t=1.0)
    return scene
