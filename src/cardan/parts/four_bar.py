"""A four-bar linkage."""

from __future__ import annotations

import math

from ..api.scene import Scene
from ..arguments import checked
from ..elements.forces.joint_force import JointForce
from ..elements.joints.revolute import Revolute
from ..scene import shape
from .building import BLUE, DARK, GREEN, ORANGE, PLANE, declared, elbow, link

START = 0.5  # angle of the crank [rad]
# of the parameters: unit -> names
UNITS = {
    "m": "ground_length crank_length coupler_length rocker_length point_along point_across",
    "kg": "crank_mass coupler_mass rocker_mass",
}


@checked
def four_bar(
    *,
    ground_length: float = 0.3,
    crank_length: float = 0.1,
    coupler_length: float = 0.25,
    rocker_length: float = 0.2,
    crank_mass: float = 0.1,
    coupler_mass: float = 0.25,
    rocker_mass: float = 0.2,
    point_along: float = 0.125,
    point_across: float = 0.08,
) -> Scene:
    """Four-bar linkage: crank, coupler and rocker between two pivots, with a point on the coupler.

    Input ``torque`` drives the crank. Outputs: ``point.x``, ``point.z`` in axes of the ground and
    ``transmission_angle`` between coupler and rocker. Frames: ``rocker_pivot``, ``point``. The
    branch is the one in which the coupler lies above the line from crank pin to rocker pivot.

    Args:
        ground_length: Distance of the pivots [m].
        crank_length, coupler_length, rocker_length: Lengths of the links [m].
        crank_mass, coupler_mass, rocker_mass: Masses of the links, slender rods [kg].
        point_along, point_across: Point of the coupler, along it from the crank and across [m].

    Returns:
        The scene; joints ``crank``, ``coupler``, ``rocker`` and ``pin``.

    Raises:
        ModelError: lengths that do not close.

    Source: F. Freudenstein, Approximate synthesis of four-bar linkages, 1955.
    """
    scene = Scene("four_bar")
    p = declared(scene, UNITS, locals())
    crank = link(scene, "crank", p["crank_mass"], p["crank_length"], ORANGE, 0.02)
    along, across = p["point_along"], p["point_across"]
    arm = (
        shape.box(0.01, 0.01, across, position=(along, 0, across / 2), color=BLUE),
        shape.sphere(0.01, position=(along, 0, across), color=DARK),
    )
    coupler = link(scene, "coupler", p["coupler_mass"], p["coupler_length"], BLUE, 0.014, arm)
    rocker = link(scene, "rocker", p["rocker_mass"], p["rocker_length"], GREEN, 0.02)
    pivot = scene.ground.at(p["ground_length"], 0, 0, name="rocker_pivot")
    point = coupler.at(along, 0, across, name="point")

    # the start closes: coupler and rocker are the sides of a triangle over the crank pin
    pin = crank_length * math.cos(START), crank_length * math.sin(START)
    way = math.atan2(-pin[1], ground_length - pin[0])
    reach = math.hypot(ground_length - pin[0], pin[1])
    up, bend = elbow(reach, coupler_length, rocker_length, "four_bar")
    coupler_angle = way + up
    rocker_angle = coupler_angle + bend + math.pi

    turn = Revolute(PLANE)
    scene.joint("crank", turn, scene.ground, crank, q0=START)
    joint = crank.at(p["crank_length"], 0, 0)
    scene.joint("coupler", turn, joint, coupler, q0=coupler_angle - START)
    scene.joint("rocker", turn, pivot, rocker, q0=rocker_angle)
    ends = coupler.at(p["coupler_length"], 0, 0), rocker.at(p["rocker_length"], 0, 0)
    scene.joint("pin", turn, *ends, q0=rocker_angle - coupler_angle)
    scene.force("drive", JointForce("crank", scene.input("torque", unit="N*m")))

    place = point.position(wrt=scene.ground, in_=scene.ground)
    scene.output("point.x", place[0], "m")
    scene.output("point.z", place[2], "m")
    angle = scene.q("rocker") - scene.q("crank") - scene.q("coupler")
    scene.output("transmission_angle", angle, "rad")
    scene.settings.update(t=2.0, u={"crank": 14.0})
    return scene
