"""A Stewart platform with six driven legs."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from ..api.scene import Scene
from ..arguments import checked
from ..elements.forces.joint_force import JointForce
from ..elements.joints.prismatic import Prismatic
from ..elements.joints.spherical import Spherical
from ..elements.joints.universal import Universal
from ..scene import inertia, shape
from .building import BLUE, DARK, ORANGE, STEEL, declared

if TYPE_CHECKING:
    from collections.abc import Mapping

    import sympy

    from ..elements.quantity import Value
    from ..scene.body import Body
    from ..scene.frame import Frame

LEGS = range(6)
# of the parameters: unit -> names
UNITS = {
    "m": "base_radius platform_radius platform_thickness leg_length",
    "rad": "base_half_angle platform_half_angle",
    "kg": "platform_mass tube_mass rod_mass",
    "N/m": "stiffness",
    "N*s/m": "damping",
}


@checked
def stewart_platform(
    *,
    base_radius: float = 0.6,
    platform_radius: float = 0.4,
    base_half_angle: float = 0.17,
    platform_half_angle: float = 0.17,
    height: float = 0.75,
    platform_mass: float = 5.0,
    platform_thickness: float = 0.04,
    leg_length: float = 0.45,
    tube_mass: float = 1.2,
    rod_mass: float = 0.5,
    stiffness: float = 1e5,
    damping: float = 2000.0,
) -> Scene:
    """Stewart platform: six legs, each a universal joint, a driven slide and a ball joint.

    Inputs ``length1`` ... command the lengths of the legs; their default is that of the level
    platform. Every drive is a stiff spring with a damper between command and length. Outputs:
    ``leg1`` ..., the lengths, and ``platform.x``, ``platform.y``, ``platform.z`` in axes of the
    ground. Frames: ``base1`` ..., ``top1`` ..., ``tool`` on the platform.

    Args:
        base_radius, platform_radius: Radii on which the joints lie [m].
        base_half_angle, platform_half_angle: Half the angle between two neighbors of a pair of
            joints; pairs of the platform stand between those of the base [rad].
        height: Of the platform above the base at the start [m]; a start, not a parameter.
        platform_mass, platform_thickness: The platform, a disk [kg, m].
        leg_length: Of tube and rod [m].
        tube_mass, rod_mass: Masses of the parts of a leg, slender rods [kg].
        stiffness, damping: Of the drives [N/m, N s/m].

    Returns:
        The scene; joints ``hooke1``, ``slide1``, ``ball1`` ...

    Source: D. Stewart, A platform with six degrees of freedom, 1965; J.-P. Merlet, Parallel Robots,
        2006, chapter 3 (lengths of legs for a pose).
    """
    scene = Scene("stewart_platform")
    p = declared(scene, UNITS, locals())
    size = p["platform_radius"], p["platform_thickness"]
    platform = scene.body(
        "platform",
        mass=p["platform_mass"],
        inertia=inertia.cylinder(p["platform_mass"], *size),
        shape=shape.cylinder(*size, color=ORANGE),
    )
    platform.at(0, 0, p["platform_thickness"], name="tool")

    for k in LEGS:
        low, high = (
            _angle(k, p["base_half_angle"], False),
            _angle(k, p["platform_half_angle"], True),
        )
        foot = _on_circle(scene.ground, p["base_radius"], low, f"base{k + 1}")
        top = _on_circle(platform, p["platform_radius"], high, f"top{k + 1}")
        # where it ends at the start, from where it begins
        a, b = float(_angle(k, base_half_angle, False)), float(_angle(k, platform_half_angle, True))
        way = (
            platform_radius * math.cos(b) - base_radius * math.cos(a),
            platform_radius * math.sin(b) - base_radius * math.sin(a),
            height,
        )
        _leg(scene, k + 1, p, foot, top, way)
    place = platform.position(wrt=scene.ground, in_=scene.ground)
    for i, letter in enumerate("xyz"):
        scene.output(f"platform.{letter}", place[i], "m")
    scene.settings.update(t=1.0)
    return scene


def _angle(k: int, half_angle: Value, above: bool) -> Value:
    """The direction of an end of leg k: pairs at 0, 120, 240 degrees, above at 60, 180, 300."""
    from sympy import Rational, pi

    side = 1 if k % 2 else -1
    if above:
        return Rational(2 * (k // 2) + side, 3) * pi - side * half_angle
    return Rational(2 * (k // 2), 3) * pi + side * half_angle


def _on_circle(body: Body, radius: sympy.Symbol, angle: sympy.Expr, name: str) -> Frame:
    from sympy import cos, sin

    return body.at(radius * cos(angle), radius * sin(angle), 0, name=name)


def _leg(
    scene: Scene,
    n: int,
    p: Mapping[str, sympy.Symbol],
    foot: Frame,
    top: Frame,
    way: tuple[float, float, float],
) -> None:
    """Tube and rod between two frames, with joints that close at the start, and a drive."""
    bodies = []
    # the tube begins below, the rod ends above
    for name, side, color, radius in (("tube", 1, BLUE, 0.025), ("rod", -1, STEEL, 0.014)):
        middle = (0, 0, side * p["leg_length"] / 2)
        drawn = [
            shape.cylinder(radius, p["leg_length"], position=middle, color=color),
            shape.sphere(0.03, color=DARK),
        ]
        mass = p[f"{name}_mass"]
        rod = inertia.rod(mass, p["leg_length"])
        bodies.append(scene.body(f"{name}{n}", mass=mass, com=middle, inertia=rod, shape=drawn))
    # angles of the universal joint along the leg, its length, and back to the level platform
    length = math.hypot(*way)
    first, second = math.atan2(-way[1], way[2]), math.asin(way[0] / length)
    slide = f"slide{n}"
    scene.joint(f"hooke{n}", Universal("x", "y"), foot, bodies[0], q0=(first, second))
    scene.joint(slide, Prismatic("z"), bodies[0], bodies[1], q0=length)
    scene.joint(f"ball{n}", Spherical(), bodies[1], top, q0=_back(first, second))
    command = scene.input(f"length{n}", default=length, unit="m")
    ahead = command - scene.q(slide)
    push = p["stiffness"] * ahead - p["damping"] * scene.u(slide)
    scene.force(f"drive{n}", JointForce(slide, push))
    scene.output(f"leg{n}", scene.q(slide), "m")


def _back(first: float, second: float) -> tuple[float, float, float, float]:
    """Quaternion that undoes a turn about x and then one about y."""
    ca, sa = math.cos(first / 2), math.sin(first / 2)
    cb, sb = math.cos(second / 2), math.sin(second / 2)
    return ca * cb, -sa * cb, -ca * sb, -sa * sb
