"""A differential gear with bevel wheels."""

from __future__ import annotations

from ..api.scene import Scene
from ..arguments import checked
from ..elements.forces.torque import Torque
from ..elements.joints.revolute import Revolute
from ..elements.quantity import Value
from ..scene import inertia, shape
from ..scene.body import Body
from .building import BLUE, DARK, GREEN, ORANGE, STEEL, Color, declared, disk

THICK = 0.02  # of the wheels [m]
# of the parameters: unit -> names
UNITS = {
    "": "final_drive side_teeth spider_teeth",
    "m": "crown_radius side_radius",
    "kg": "carrier_mass side_mass spider_mass pinion_mass",
}


@checked
def differential(
    *,
    final_drive: float = 3.5,
    side_teeth: float = 16.0,
    spider_teeth: float = 10.0,
    crown_radius: float = 0.1,
    side_radius: float = 0.04,
    carrier_mass: float = 4.0,
    side_mass: float = 1.2,
    spider_mass: float = 0.15,
    pinion_mass: float = 0.8,
) -> Scene:
    """Open differential: a pinion turns the carrier, spider gears divide its torque between shafts.

    The shafts lie along y, the pinion along x. Speeds: that of the carrier is the mean of those of
    the shafts, and the pinion turns ``final_drive`` times as fast. Inputs: ``pinion_torque``,
    ``left_torque``, ``right_torque``, which act from outside on pinion and shafts. Outputs:
    ``pinion_speed``, ``carrier_speed``, ``left_speed``, ``right_speed``. Frames: ``left_flange``,
    ``right_flange``, ``pinion_flange``.

    Args:
        final_drive: Turns of the pinion for one of the carrier.
        side_teeth, spider_teeth: Teeth of the gears on the shafts and of the spider gears.
        crown_radius, side_radius: Radii of the crown wheel and of the gears on the shafts [m].
        carrier_mass: Of carrier and crown wheel, a disk of the crown radius [kg].
        side_mass, spider_mass, pinion_mass: Masses of one gear each, disks [kg].

    Returns:
        The scene, a tree with two degrees of freedom: joints ``carrier`` and ``spider`` lead,
        ``opposite``, ``left``, ``right`` and ``pinion`` follow.

    Source: R. Willis, Principles of Mechanism, 1841 (epicyclic trains, of which this is one with
        equal wheels).
    """
    scene = Scene("differential")
    p = declared(scene, UNITS, locals())
    teeth = p["spider_teeth"] / p["side_teeth"]
    carrier = scene.body(
        "carrier",
        mass=p["carrier_mass"],
        inertia=inertia.cylinder(p["carrier_mass"], p["crown_radius"], THICK, axis="y"),
        shape=[
            shape.cylinder(
                p["crown_radius"], THICK / 2, axis="y", position=(0, 0.09, 0), color=STEEL
            ),
            shape.box(THICK, 0.12, THICK, position=(0.07, 0.03, 0), color=STEEL),
            shape.box(THICK, 0.12, THICK, position=(-0.07, 0.03, 0), color=STEEL),
        ],
    )
    scene.joint("carrier", Revolute("y"), scene.ground, carrier)
    # two spider gears at the ends of a pin turn against each other
    for name, side, couple in (("spider", 1, None), ("opposite", -1, ("spider", -1))):
        radius = p["side_radius"] * teeth
        gear = disk(scene, name, p["spider_mass"], radius, THICK, "x", ORANGE)
        pin = carrier.at(side * p["side_radius"], 0, 0)
        scene.joint(name, Revolute("x"), pin, gear, couple=couple)
    for name, side, color in (("left", 1, BLUE), ("right", -1, GREEN)):
        shaft = _shaft(scene, name, p["side_mass"], p["side_radius"], "y", side, color)
        # wheels that roll on the spider turn to opposite sides in the carrier
        scene.joint(name, Revolute("y"), carrier, shaft, couple=("spider", -side * teeth))
    pinion = _shaft(scene, "pinion", p["pinion_mass"], p["crown_radius"] / 3, "x", 1, DARK)
    place = scene.ground.at(p["crown_radius"], 0.06, 0)
    scene.joint("pinion", Revolute("x"), place, pinion, couple=("carrier", p["final_drive"]))
    scene.output("carrier_speed", scene.u("carrier"), "rad/s")
    scene.settings.update(t=1.0, u={"carrier": 20.0, "spider": 5.0})
    return scene


def _shaft(
    scene: Scene, name: str, mass: Value, radius: Value, axis: str, side: int, color: Color
) -> Body:
    """A wheel on a shaft with a flange, a torque on it from outside, and its speed."""
    way = tuple(float(axis == letter) for letter in "xyz")

    def along(distance: float) -> tuple[float, float, float]:
        x, y, z = (side * distance * part for part in way)
        return x, y, z

    drawn = [
        shape.cylinder(radius, THICK, axis=axis, position=along(0.035), color=color),
        shape.cylinder(0.012, 0.16, axis=axis, position=along(0.12), color=color),
    ]
    moments = inertia.cylinder(mass, radius, THICK, axis=axis)
    body = scene.body(name, mass=mass, inertia=moments, shape=drawn)
    body.at(*along(0.2), name=f"{name}_flange")
    torque = scene.input(f"{name}_torque", unit="N*m")
    pushed = tuple(torque if axis == letter else 0 for letter in "xyz")
    scene.force(f"{name}_torque", Torque(body, pushed, in_=body))
    speed = body.angular_velocity(wrt=scene.ground, in_=scene.ground)
    scene.output(f"{name}_speed", speed["xyz".index(axis)], "rad/s")
    return body
