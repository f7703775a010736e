"""A slider-crank mechanism."""

from __future__ import annotations

import math

from ..api.scene import Scene
from ..arguments import checked
from ..elements.forces.joint_force import JointForce
from ..elements.joints.prismatic import Prismatic
from ..elements.joints.revolute import Revolute
from ..errors import ModelError
from ..scene import shape
from .building import BLUE, ORANGE, PLANE, STEEL, declared, link

START = 0.6  # angle of the crank [rad]
# of the parameters: unit -> names
UNITS = {"m": "crank_length rod_length offset bore", "kg": "crank_mass rod_mass piston_mass"}


@checked
def slider_crank(
    *,
    crank_length: float = 0.05,
    rod_length: float = 0.16,
    offset: float = 0.0,
    crank_mass: float = 0.6,
    rod_mass: float = 0.4,
    piston_mass: float = 0.5,
    bore: float = 0.08,
) -> Scene:
    """Slider-crank: a crank, a connecting rod and a piston that slides along x.

    Inputs: ``torque`` on the crank, ``force`` on the piston along x. Outputs: ``piston.x`` from
    the crank's axis and ``rod_angle`` against x. Frame: ``piston_pin``.

    Args:
        crank_length, rod_length: Lengths of crank and connecting rod [m].
        offset: Height of the line of the piston pin above the crank's axis [m].
        crank_mass, rod_mass, piston_mass: Masses; crank and rod are slender rods [kg].
        bore: Diameter of the piston, as it is drawn [m].

    Returns:
        The scene; joints ``crank``, ``rod``, ``piston`` and ``pin``.

    Raises:
        ModelError: lengths that do not close.

    Source: P. E. Nikravesh, Planar Multibody Dynamics, 2007.
    """
    scene = Scene("slider_crank")
    p = declared(scene, UNITS, locals())
    height = crank_length * math.sin(START) - offset
    if not abs(height) < rod_length:
        raise ModelError(
            f"slider_crank: a rod of {rod_length:g} m does not reach from the crank pin to the "
            f"piston, {abs(height):g} m above or below; give other lengths"
        )
    crank = link(scene, "crank", p["crank_mass"], p["crank_length"], ORANGE, 0.022)
    rod = link(scene, "rod", p["rod_mass"], p["rod_length"], BLUE, 0.014)
    drawn = shape.cylinder(p["bore"] / 2, p["bore"], axis="x", color=STEEL)
    # a point mass: it slides and does not turn
    piston = scene.body("piston", mass=p["piston_mass"], shape=drawn)
    pin = piston.at(name="piston_pin")

    angle = -math.asin(height / rod_length)
    along = crank_length * math.cos(START) + rod_length * math.cos(angle)
    turn = Revolute(PLANE)
    scene.joint("crank", turn, scene.ground, crank, q0=START)
    scene.joint("rod", turn, crank.at(p["crank_length"], 0, 0), rod, q0=angle - START)
    line = scene.ground.at(0, 0, p["offset"])
    scene.joint("piston", Prismatic("x"), line, piston, q0=along)
    scene.joint("pin", turn, rod.at(p["rod_length"], 0, 0), pin, q0=-angle)
    scene.force("drive", JointForce("crank", scene.input("torque", unit="N*m")))
    scene.force("gas", JointForce("piston", scene.input("force", unit="N")))

    scene.output("piston.x", scene.q("piston"), "m")
    scene.output("rod_angle", scene.q("crank") + scene.q("rod"), "rad")
    scene.settings.update(t=1.0, u={"crank": 20.0})
    return scene
