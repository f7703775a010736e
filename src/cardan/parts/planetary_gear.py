"""A planetary gear."""

from __future__ import annotations

import math

from ..api.scene import Scene
from ..arguments import Count, checked
from ..elements.forces.torque import Torque
from ..elements.joints.fixed import Fixed
from ..elements.joints.revolute import Revolute
from ..errors import ModelError, near
from ..scene import inertia, shape
from ..scene.body import Body
from .building import BLUE, DARK, GREEN, ORANGE, STEEL, declared, disk

FIXED = ("none", "ring", "sun", "carrier")
THICK = 0.02  # of the wheels [m]
# of the parameters: unit -> names
UNITS = {
    "": "sun_teeth planet_teeth",
    "m": "gear_module",
    "kg": "sun_mass planet_mass ring_mass carrier_mass",
}


@checked
def planetary_gear(
    *,
    fixed: str = "ring",
    planets: Count = 3,
    sun_teeth: float = 24.0,
    planet_teeth: float = 18.0,
    gear_module: float = 0.003,
    sun_mass: float = 0.5,
    planet_mass: float = 0.3,
    ring_mass: float = 1.2,
    carrier_mass: float = 0.8,
) -> Scene:
    """Planetary gear about z: sun, planets on a carrier, and a ring.

    The ring has ``sun_teeth + 2 planet_teeth`` teeth. Speeds obey Willis' equation: against the
    carrier the sun turns ``-ring_teeth / sun_teeth`` times as fast as the ring. Inputs:
    ``sun_torque``, ``ring_torque``, ``carrier_torque``, which act from outside. Outputs:
    ``sun_speed``, ``ring_speed``, ``carrier_speed``. Frames: ``sun_flange``, ``ring_flange``,
    ``carrier_flange``.

    Args:
        fixed: What is held by the ground: ``"ring"``, ``"sun"``, ``"carrier"`` or ``"none"``, which
            leaves two degrees of freedom.
        planets: How many there are.
        sun_teeth, planet_teeth: Teeth of the sun and of a planet.
        gear_module: Diameter of a wheel per tooth [m].
        sun_mass, planet_mass, ring_mass, carrier_mass: Masses, of one planet; the ring is a tube,
            the others are disks [kg].

    Returns:
        The scene, a tree: joints ``carrier``, ``planet1`` ..., ``sun`` and ``ring``, of which one,
        or two where nothing is fixed, lead the others.

    Raises:
        ModelError: an unknown wheel to fix.

    Source: R. Willis, Principles of Mechanism, 1841 (epicyclic trains).
    """
    if fixed not in FIXED:
        raise ModelError(f"planetary_gear: fixed='{fixed}' is not a wheel.{near(fixed, FIXED)}")
    scene = Scene("planetary_gear")
    p = declared(scene, UNITS, locals())
    ring_teeth = p["sun_teeth"] + 2 * p["planet_teeth"]
    # turns against the carrier for one of a planet: wheels that mesh outside turn the other way
    ratios = {"sun": -p["planet_teeth"] / p["sun_teeth"], "ring": p["planet_teeth"] / ring_teeth}
    sun_radius, planet_radius, ring_radius = (
        p["gear_module"] * teeth / 2 for teeth in (p["sun_teeth"], p["planet_teeth"], ring_teeth)
    )
    axis_radius = sun_radius + planet_radius

    carrier = disk(scene, "carrier", p["carrier_mass"], axis_radius, THICK / 2, "z", STEEL)
    above = scene.ground.at(0, 0, -THICK)
    kind = Fixed() if fixed == "carrier" else Revolute("z")
    scene.joint("carrier", kind, above, carrier)
    # a wheel that stands still turns against the carrier as that turns; a planet follows both
    leads = "planet1" if fixed in ("none", "carrier") else "carrier"
    planet = 1 if leads == "planet1" else -1 / ratios[fixed]
    for k in range(planets):
        name, angle = f"planet{k + 1}", 2 * math.pi * k / planets
        wheel = disk(scene, name, p["planet_mass"], planet_radius, THICK, "z", ORANGE)
        wheel_pin = carrier.at(axis_radius * math.cos(angle), axis_radius * math.sin(angle), THICK)
        couple = None if name == leads else (leads, planet)
        scene.joint(name, Revolute("z"), wheel_pin, wheel, couple=couple)

    sun = disk(scene, "sun", p["sun_mass"], sun_radius, THICK, "z", BLUE)
    outer = ring_radius + 4 * p["gear_module"]
    ring = scene.body(
        "ring",
        mass=p["ring_mass"],
        inertia=inertia.tube(p["ring_mass"], outer, ring_radius, THICK),
        shape=_ring(gear_module * (sun_teeth + 2 * planet_teeth) / 2 + 2 * gear_module),
    )
    center = carrier.at(0, 0, THICK)
    for wheel in (sun, ring):
        turns = planet * ratios[wheel.name]
        scene.joint(wheel.name, Revolute("z"), center, wheel, couple=(leads, turns))
    for body, height in ((sun, 2 * THICK), (ring, 2 * THICK), (carrier, -2 * THICK)):
        _flange(scene, body, height)
    scene.settings.update(t=1.0, u={leads: 10.0})
    return scene


def _flange(scene: Scene, body: Body, height: float) -> None:
    """A place for a shaft, a torque on it from outside, and its speed."""
    body.at(0, 0, height, name=f"{body.name}_flange")
    torque = scene.input(f"{body.name}_torque", unit="N*m")
    scene.force(f"{body.name}_torque", Torque(body, (0, 0, torque), in_=body))
    speed = body.angular_velocity(wrt=scene.ground, in_=scene.ground)
    scene.output(f"{body.name}_speed", speed[2], "rad/s")


def _ring(radius: float) -> list[shape.Shape]:
    """A ring of boxes."""
    count = 24
    width = 2.05 * radius * math.tan(math.pi / count)
    return [
        shape.box(
            radius / 12, width, THICK,
            position=(radius * math.cos(angle), radius * math.sin(angle), 0.0),
            rotation=("XYZ", 0.0, 0.0, angle),
            color=GREEN if k else DARK,
        )
        for k in range(count)
        for angle in [2 * math.pi * k / count]
    ]  # fmt: skip
