"""Every joint at a regular state, in many digits."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import sympy

import cardan as cd
from cardan.elements.joints import Joint
from cardan.ir.graph import Graph
from cardan.ir.matrix import Matrix
from cardan.spatial.rotations import ROTATIONS
from elements.written_of import converted
from spatial.numbers_of import block, moving, numbers

a, b, c = sympy.symbols("a b c")
TURN_AND_TILT = sympy.rot_axis3(-a) * sympy.rot_axis1(-b)
OBLIQUE, OTHER = (1.0, 2.0, -2.0), (0.3, -0.7, 0.1)
CURVE = [(0.1, 0, 0), (1, 0.5, -0.2), (1.5, 1.5, 0.4), (1, 2.5, 0.3), (0, 3, 0)]
INSTANCES: dict[str, Joint] = {
    "fixed": cd.Fixed(),
    "revolute z": cd.Revolute("z"),
    "revolute -y": cd.Revolute("-y"),
    "revolute oblique": cd.Revolute(OBLIQUE),
    "prismatic x": cd.Prismatic("x"),
    "prismatic oblique": cd.Prismatic(OBLIQUE),
    "cylindrical y": cd.Cylindrical("y"),
    "cylindrical oblique": cd.Cylindrical(OTHER),
    "screw -x": cd.Screw("-x", pitch=0.05),
    "screw oblique": cd.Screw(OBLIQUE, pitch=-0.2),
    "screw without pitch": cd.Screw("z"),
    "universal": cd.Universal(),
    "universal z x": cd.Universal("-z", "x"),
    "universal oblique": cd.Universal(OBLIQUE, OTHER),
    "planar": cd.Planar(),
    "planar -x": cd.Planar("-x"),
    "planar oblique": cd.Planar(OBLIQUE),
    "translation": cd.Translation(),
    "custom one": cd.Custom([a], position=(sympy.sin(a), 0, a**2), rotation=sympy.rot_axis2(a)),
    "custom two": cd.Custom([a, b], (b * sympy.cos(a) - b, a * b, 3 * b), TURN_AND_TILT),
    "custom three": cd.Custom([a, b, c], (0, c, a * c), TURN_AND_TILT),
    "constant velocity": cd.ConstantVelocity(),
    "constant velocity oblique": cd.ConstantVelocity(OBLIQUE),
    "point on plane": cd.PointOnPlane("y"),
    "point on plane oblique": cd.PointOnPlane(OTHER, "XYZ"),
    "point on curve": cd.PointOnCurve(CURVE),
    "point on closed curve": cd.PointOnCurve(CURVE, closed=True),
    "point on curve xyz": cd.PointOnCurve(CURVE[:2], rotation="xyz"),
    "distance": cd.Distance(0.8, "-z"),
    "distance oblique": cd.Distance(1.5, OTHER, "ZXZ"),
    "gear": cd.Gear("leader", -2.0, "x"),
    "gear oblique": cd.Gear("leader", 0.5, OBLIQUE, offset=0.3),
    "wheel": cd.Wheel(0.4, 0.1),
    "wheel oblique": cd.Wheel(0.4, 0.4, OBLIQUE, lateral_slip=True),
    "rolling disk": cd.RollingDisk(0.3, "-y"),
    "rolling disk oblique": cd.RollingDisk(0.3, OTHER, knife_edge=True),
    "free": cd.Free(),
    **{f"spherical {name}": cd.Spherical(name) for name in ROTATIONS},
    **{f"free {name}": cd.Free(name) for name in ("ZXZ", "xyz", "mrp", "dcm")},
}
OMEGA = [0.7, -0.4, 1.2, 0.5, -2.0, 0.3]


class Bench:
    """A joint at a regular state, everything in many digits."""

    def __init__(self, name: str) -> None:
        self.joint, self.graph = INSTANCES[name], Graph()
        self.nq, self.nu = len(self.joint.coordinates), len(self.joint.speeds)
        self.q, self.u = block(self.graph, "q", self.nq), block(self.graph, "u", self.nu)
        self.rate = block(self.graph, "rate", self.nq)
        self.data, self.parameters = converted(self.graph, self.joint.quantities())
        self.at = self._regular()
        self.speed = OMEGA[: self.nu]

    def _regular(self) -> list[Any]:
        """Coordinates on the constraint of those that have one, off every singular set."""
        start = Matrix.vector(self.graph, [x.default for x in self.joint.coordinates])
        moved = self.joint.integrate(start, block(self.graph, "du", self.nu), **self.data)
        step = [0.4, -0.7, 0.5, 0.8, 1.1, -0.6][: self.nu]
        return list(self.value(moved, du=step))

    def value(self, x: Matrix, **values: Any) -> Any:
        known = {"q": self.at, "u": self.speed} if hasattr(self, "at") else {}
        return numbers(x, "mp", **(self.parameters | known | values))

    def rates(self) -> list[Any]:
        return list(self.value(self.joint.rates(self.q, self.u, **self.data)))

    def along(self, x: Matrix) -> Callable[[Any], Any]:
        """Value of x on the path with the speeds of the bench."""
        path = moving(self.at, self.rates())
        return lambda t: self.value(x, q=path(t))
