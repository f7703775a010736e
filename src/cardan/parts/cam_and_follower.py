"""A cam with a follower that it lifts by a prescribed law."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from ..api.scene import Scene
from ..arguments import checked
from ..elements.forces.joint_damper import JointDamper
from ..elements.forces.joint_force import JointForce
from ..elements.forces.joint_spring import JointSpring
from ..elements.joints.prismatic import Prismatic
from ..elements.joints.revolute import Revolute
from ..errors import ModelError
from ..scene import inertia, shape
from ..scene.body import Body
from .building import BLUE, DARK, ORANGE, PLANE, declared

if TYPE_CHECKING:
    import sympy

EDGES = 90  # of the cam, as it is drawn
DRAWN = 0.012  # thickness of the cam [m]
# of the parameters: unit -> names
UNITS = {
    "m": "base_radius lift",
    "rad": "rise dwell fall",
    "kg": "cam_mass follower_mass",
    "N/m": "stiffness",
    "N": "preload",
    "N*s/m": "damping",
}


@checked
def cam_and_follower(
    *,
    base_radius: float = 0.04,
    lift: float = 0.015,
    rise: float = 1.5,
    dwell: float = 0.6,
    fall: float = 1.5,
    cam_mass: float = 0.8,
    follower_mass: float = 0.2,
    stiffness: float = 4000.0,
    preload: float = 60.0,
    damping: float = 2.0,
) -> Scene:
    """Cam that lifts a follower along z by cycloidal motion: rise, dwell, fall, dwell.

    The follower's knife edge stays on the cam; a spring presses it there. Acceleration is
    continuous: ``lift (turn / rise - sin(2 pi turn / rise) / (2 pi))`` over the rise, and so for
    the fall. Input ``torque`` drives the cam. Outputs: ``lift``, ``lift_rate`` and
    ``spring_force``. The multiplier ``contact`` is the force between cam and follower: where it
    turns negative a real follower would leave the cam. Frame: ``tip``.

    Args:
        base_radius: Radius of the cam where nothing is lifted [m].
        lift: Of the follower [m].
        rise, dwell, fall: Angles of the cam, which turns from x towards z [rad].
        cam_mass, follower_mass: Masses; the cam is a disk of the base radius [kg].
        stiffness, preload: Of the spring, and its force where nothing is lifted [N/m, N].
        damping: Of the follower in its guide [N s/m].

    Returns:
        The scene; joints ``cam`` and ``follower``, constraint ``contact``.

    Raises:
        ModelError: angles that are not positive, or more than a turn together.

    Source: R. L. Norton, Cam Design and Manufacturing Handbook, 2009, chapter 3 (cycloidal
        displacement).
    """
    if min(rise, fall) <= 0 or dwell < 0 or rise + dwell + fall > 2 * math.pi:
        raise ModelError(
            f"cam_and_follower: rise={rise:g}, dwell={dwell:g} and fall={fall:g} rad are positive "
            "and at most one turn together, 6.283 rad"
        )
    scene = Scene("cam_and_follower")
    p = declared(scene, UNITS, locals())
    turns = [2 * math.pi * k / EDGES for k in range(EDGES)]
    profile = [base_radius + lift * _share(turn, rise, dwell, fall) for turn in turns]
    cam = scene.body(
        "cam",
        mass=p["cam_mass"],
        inertia=inertia.cylinder(p["cam_mass"], p["base_radius"], DRAWN, axis="y"),
        shape=[
            shape.cylinder(0.15 * base_radius, 2 * DRAWN, axis="y", color=DARK),
            *_spokes(profile),
        ],
    )
    scene.joint("cam", Revolute(PLANE), scene.ground, cam)
    guide = scene.ground.at(0, 0, p["base_radius"])
    scene.joint(
        "follower", Prismatic("z"), guide, _follower(scene, p["follower_mass"], base_radius)
    )
    scene.constraint("contact", scene.q("follower") - _law(scene.q("cam"), p), "m")
    scene.force("drive", JointForce("cam", scene.input("torque", unit="N*m")))
    unloaded = -p["preload"] / p["stiffness"]
    scene.force("spring", JointSpring("follower", stiffness=p["stiffness"], rest=unloaded))
    scene.force("guide", JointDamper("follower", p["damping"]))

    scene.output("lift", scene.q("follower"), "m")
    scene.output("lift_rate", scene.u("follower"), "m/s")
    scene.output("spring_force", p["preload"] + p["stiffness"] * scene.q("follower"), "N")
    scene.settings.update(t=1.0, u={"cam": 20.0})
    return scene


def _law(angle: sympy.Symbol, p: dict[str, sympy.Symbol]) -> sympy.Expr:
    """Lift at an angle of the cam [m]."""
    from sympy import Mod, Piecewise, pi, sin

    def cycloid(share: sympy.Expr) -> sympy.Expr:
        return share - sin(2 * pi * share) / (2 * pi)

    turn, down = Mod(angle, 2 * pi), p["rise"] + p["dwell"]
    return p["lift"] * Piecewise(
        (cycloid(turn / p["rise"]), turn < p["rise"]),
        (1, turn < down),
        (1 - cycloid((turn - down) / p["fall"]), turn < down + p["fall"]),
        (0, True),
    )


def _follower(scene: Scene, mass: sympy.Symbol, size: float) -> Body:
    """A stem above its knife edge."""
    stem = 1.5 * size
    follower = scene.body(
        "follower",
        mass=mass,
        com=(0, 0, stem / 2),
        inertia=inertia.rod(mass, stem, axis="z"),
        shape=[
            shape.capsule(0.12 * size, stem, position=(0, 0, 0.62 * stem), color=BLUE),
            shape.sphere(0.07 * size, color=DARK),
        ],
    )
    follower.at(name="tip")
    return follower


def _share(turn: float, rise: float, dwell: float, fall: float) -> float:
    """Lift over its largest value, at a turn of the cam."""
    share = min(turn / rise, 1.0)
    if turn > rise + dwell:
        share = max(0.0, 1 - (turn - rise - dwell) / fall)
    return share - math.sin(2 * math.pi * share) / (2 * math.pi)


def _spokes(profile: list[float]) -> list[shape.Shape]:
    """Boxes from the axis to the outline, side by side; the tip above meets radius after radius."""
    step = 2 * math.pi / EDGES
    spokes = []
    for k, radius in enumerate(profile):
        # the follower stands at a quarter turn: what it meets after a turn lies that far behind it
        angle = math.pi / 2 - k * step
        middle = (radius / 2 * math.cos(angle), 0.0, radius / 2 * math.sin(angle))
        rotation = ("XYZ", 0.0, -angle, 0.0)
        size = radius, DRAWN, 1.1 * step * radius
        spokes.append(shape.box(*size, position=middle, rotation=rotation, color=ORANGE))
    return spokes
