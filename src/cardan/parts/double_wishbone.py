"""A double wishbone suspension."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

from ..api.scene import Scene
from ..arguments import checked
from ..elements.forces.force_on_frame import Force
from ..elements.forces.spring_damper import SpringDamper
from ..elements.joints.distance import Distance
from ..elements.joints.prismatic import Prismatic
from ..elements.joints.revolute import Revolute
from ..elements.joints.spherical import Spherical
from ..errors import ModelError, near
from ..scene import inertia, shape
from .building import BLUE, DARK, GREEN, ORANGE, STEEL, declared

if TYPE_CHECKING:
    import sympy

    from ..scene.body import Body
    from ..scene.frame import Frame

    Symbols = Mapping[str, sympy.Symbol]
    Places = Mapping[str, tuple[sympy.Expr, ...]]
    Numbers = Mapping[str, tuple[float, float, float]]

Triple = Sequence[float]
SIDES = {"left": 1.0, "right": -1.0}
POINTS = (
    *("lower_front", "lower_rear", "lower_ball", "upper_front", "upper_rear", "upper_ball"),
    *("tie_inner", "tie_outer", "wheel_center", "spring_top", "spring_bottom"),
)
# of the parameters: unit -> names
UNITS = {
    "kg": "lower_mass upper_mass upright_mass wheel_mass",
    "m": "wheel_radius",
    "N/m": "stiffness",
    "N*s/m": "damping",
    "N": "preload",
}


@checked
def double_wishbone(
    *,
    side: str = "left",
    lower_front: Sequence[float] = (0.15, 0.32, -0.09),
    lower_rear: Sequence[float] = (-0.17, 0.32, -0.085),
    lower_ball: Sequence[float] = (0.005, 0.69, -0.11),
    upper_front: Sequence[float] = (0.1, 0.40, 0.14),
    upper_rear: Sequence[float] = (-0.13, 0.40, 0.125),
    upper_ball: Sequence[float] = (-0.015, 0.65, 0.17),
    tie_inner: Sequence[float] = (-0.11, 0.35, -0.05),
    tie_outer: Sequence[float] = (-0.12, 0.67, -0.055),
    wheel_center: Sequence[float] = (0.0, 0.75, 0.0),
    spring_top: Sequence[float] = (0.0, 0.45, 0.36),
    spring_bottom: Sequence[float] = (0.0, 0.55, -0.09),
    lower_mass: float = 4.0,
    upper_mass: float = 2.5,
    upright_mass: float = 9.0,
    wheel_mass: float = 16.0,
    wheel_radius: float = 0.3,
    stiffness: float = 35000.0,
    damping: float = 2500.0,
    preload: float = 4800.0,
) -> Scene:
    """Double wishbone suspension of a front wheel: two arms, upright, tie rod, spring and wheel.

    Include it at a frame of a chassis: x forward, y to the left, z up. Points are those of a left
    wheel in the design position, in which all joints are at zero; ``side="right"`` mirrors them.
    Inputs: ``rack``, the way of the steering rack to the left [m], and ``wheel_force``, up at the
    center of the wheel. Outputs: ``bump`` and ``half_track`` (z from the design position and
    distance from the middle of the wheel's center), ``camber`` (positive: the top leans outward),
    ``toe`` (positive: the front points inward) and ``spring_length``. Frames: ``hub`` on the
    upright, and points by their names.

    Args:
        side: ``"left"`` or ``"right"``.
        lower_front, lower_rear, lower_ball: Points of the lower arm: two on its axis, and its ball
            joint (3) [m].
        upper_front, upper_rear, upper_ball: The same of the upper arm (3) [m].
        tie_inner, tie_outer: Ends of the tie rod on rack and upright (3) [m].
        wheel_center: Of the wheel, whose axis lies along y (3) [m].
        spring_top, spring_bottom: Ends of the spring on chassis and lower arm (3) [m].
        lower_mass, upper_mass, upright_mass, wheel_mass: Masses [kg].
        wheel_radius: Of the wheel, a disk [m].
        stiffness, damping: Of the spring [N/m, N s/m].
        preload: Force of the spring in the design position [N].

    Returns:
        The scene; joints ``lower``, ``upper``, ``lower_ball``, ``upper_ball``, ``tie``, ``rack``
        and ``wheel``.

    Raises:
        ModelError: an unknown side, or points that are not three numbers.

    Source: W. F. Milliken and D. L. Milliken, Race Car Vehicle Dynamics, 1995, chapter 17.
    """
    if side not in SIDES:
        raise ModelError(f"double_wishbone: side='{side}'.{near(side, SIDES)}")
    values = locals()
    scene, sign = Scene("double_wishbone"), SIDES[side]
    points = {name: values[name] for name in POINTS}
    at = {name: _point(scene, name, numbers, sign) for name, numbers in points.items()}
    p = declared(scene, UNITS, values)

    # all bodies have the axes and the origin of the ground in the design position
    drawn = {name: _mirrored(numbers, sign) for name, numbers in points.items()}
    arms = _arms(scene, p, at, drawn, sign)
    upright = _upright(scene, p, at, drawn)
    for name, arm in arms.items():
        inner = arm.at(*at[f"{name}_ball"], name=f"{name}_ball")
        scene.joint(f"{name}_ball", Spherical(), inner, upright.at(*at[f"{name}_ball"]))
    _steering(scene, upright, at, drawn["tie_inner"])
    hub = upright.at(*at["wheel_center"], name="hub")
    scene.joint("wheel", Revolute("y"), hub, _wheel(scene, p, wheel_radius))
    _spring(scene, arms["lower"], p, at)
    load = scene.input("wheel_force", default=3200.0, unit="N")
    scene.force("load", Force(hub, (0, 0, load), in_=scene.ground))
    _outputs(scene, hub, sign, at["wheel_center"][2])
    scene.settings.update(t=1.0)
    return scene


def _arms(scene: Scene, p: Symbols, at: Places, drawn: Numbers, sign: float) -> dict[str, Body]:
    """Both arms on their hinges, each a triangle of two rods."""
    arms = {}
    for name, color in (("lower", BLUE), ("upper", GREEN)):
        mass = p[f"{name}_mass"]
        corners = [f"{name}_{where}" for where in ("front", "ball", "rear")]
        sides = pairwise([drawn[corner] for corner in corners])
        arms[name] = scene.body(
            name,
            mass=mass,
            com=[sum(at[corner][k] for corner in corners) / 3 for k in range(3)],
            inertia=inertia.rod(mass, abs(drawn[corners[1]][1]) / 2, axis="y"),
            shape=[_rod(a, b, 0.014, color) for a, b in sides],
        )
        hinge = at[corners[0]]
        # positive angles lift the wheel on both sides
        axis = tuple(sign * (a - b) for a, b in zip(hinge, at[corners[2]], strict=True))
        scene.joint(name, Revolute(axis), scene.ground.at(*hinge), arms[name].at(*hinge))
    return arms


def _upright(scene: Scene, p: Symbols, at: Places, drawn: Numbers) -> Body:
    """What carries the wheel, from ball joint to ball joint, with the steering arm."""
    points = at["wheel_center"], at["wheel_center"], at["lower_ball"], at["upper_ball"]
    length = _distance(at["lower_ball"], at["upper_ball"])
    return scene.body(
        "upright",
        mass=p["upright_mass"],
        com=[sum(point[k] for point in points) / 4 for k in range(3)],
        inertia=inertia.rod(p["upright_mass"], length, axis="z"),
        shape=[
            _rod(drawn["lower_ball"], drawn["upper_ball"], 0.02, STEEL),
            _rod(drawn["tie_outer"], drawn["lower_ball"], 0.012, STEEL),
        ],
    )


def _steering(scene: Scene, upright: Body, at: Places, drawn: Triple) -> None:
    """The rack, and the tie rod to the upright."""
    rack = scene.body("rack", shape=shape.sphere(0.02, position=drawn, color=DARK))
    steer = scene.input("rack", unit="m")
    scene.joint("rack", Prismatic("y"), scene.ground, rack, prescribed=steer)
    inner, outer = at["tie_inner"], at["tie_outer"]
    way = tuple(b - a for a, b in zip(inner, outer, strict=True))
    tie = Distance(_norm(way), axis=way)
    ends = rack.at(*inner, name="tie_inner"), upright.at(*outer, name="tie_outer")
    scene.joint("tie", tie, *ends)


def _spring(scene: Scene, arm: Body, p: Symbols, at: Places) -> None:
    """The spring with its damper between chassis and lower arm."""
    top = scene.ground.at(*at["spring_top"], name="spring_top")
    bottom = arm.at(*at["spring_bottom"], name="spring_bottom")
    free_length = _distance(at["spring_top"], at["spring_bottom"]) + p["preload"] / p["stiffness"]
    scene.force("spring", SpringDamper(top, bottom, p["stiffness"], p["damping"], free_length))
    scene.output("spring_length", _norm(top.position(wrt=bottom)), "m")


def _wheel(scene: Scene, p: Symbols, radius: float) -> Body:
    """A disk that is seen through, with a bar on it that shows how it turns."""
    mass, thick = p["wheel_mass"], 0.18
    return scene.body(
        "wheel",
        mass=mass,
        inertia=inertia.cylinder(mass, p["wheel_radius"], thick, axis="y"),
        shape=[
            shape.cylinder(p["wheel_radius"], thick, axis="y", color=(*DARK, 0.35)),
            shape.box(1.9 * radius, 0.02, 0.03, color=ORANGE),
        ],
    )


def _outputs(scene: Scene, hub: Frame, sign: float, height: sympy.Expr) -> None:
    """Place and angles of the wheel."""
    from sympy import asin, atan2

    center = hub.position(wrt=scene.ground, in_=scene.ground)
    scene.output("bump", center[2] - height, "m")
    scene.output("half_track", sign * center[1], "m")
    # the axis of the wheel, outward
    x, y, z = (sign * entry for entry in hub.rotation(wrt=scene.ground)[:, 1])
    scene.output("camber", -asin(z), "rad")
    scene.output("toe", atan2(x, sign * y), "rad")


def _norm(vector: Iterable[sympy.Expr]) -> sympy.Expr:
    from sympy import sqrt

    return sqrt(sum(x**2 for x in vector))


def _distance(one: Sequence[sympy.Expr], other: Sequence[sympy.Expr]) -> sympy.Expr:
    return _norm(a - b for a, b in zip(one, other, strict=True))


def _point(scene: Scene, name: str, numbers: Triple, sign: float) -> tuple[sympy.Expr, ...]:
    """A point as three parameters, mirrored on the right."""
    named = {f"{name}.{axis}": x for axis, x in zip("xyz", _three(name, numbers), strict=True)}
    x, y, z = declared(scene, {"m": " ".join(named)}, named).values()
    return x, y if sign > 0 else -y, z


def _three(name: str, numbers: Triple) -> tuple[float, float, float]:
    values = [float(x) for x in numbers]
    if len(values) != 3:
        raise ModelError(f"double_wishbone: {name} has {len(values)} numbers; give x, y, z [m]")
    return values[0], values[1], values[2]


def _mirrored(numbers: Triple, sign: float) -> tuple[float, float, float]:
    x, y, z = numbers
    return x, sign * y, z


def _rod(
    start: Triple, end: Triple, radius: float, color: tuple[float, float, float]
) -> shape.Shape:
    """A rod between two points."""
    way = [b - a for a, b in zip(start, end, strict=True)]
    middle = [(a + b) / 2 for a, b in zip(start, end, strict=True)]
    length = math.sqrt(sum(x * x for x in way))
    # z of the rod along the way: turned about z, then tilted about y
    turn = ("ZYX", math.atan2(way[1], way[0]), math.acos(way[2] / length), 0.0)
    return shape.capsule(radius, length, position=middle, rotation=turn, color=color)
