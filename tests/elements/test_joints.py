"""Laws of every joint: modes of motion against poses differenced in many digits, and so on."""

from __future__ import annotations

from collections.abc import Callable
from math import nan
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy

import cardan as cd
from cardan.elements.joints import JOINTS, Joint
from cardan.ir.graph import Graph
from cardan.ir.matrix import Matrix
from cardan.model.units import unit
from cardan.spatial.rotations import ROTATIONS
from elements.written_of import converted
from spatial.numbers_of import block, close, difference, moving, numbers, unskew

a, b, c = sympy.symbols("a b c")
TURN_AND_TILT = sympy.rot_axis3(-a) * sympy.rot_axis1(-b)
OBLIQUE, OTHER = (1.0, 2.0, -2.0), (0.3, -0.7, 0.1)
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
    "custom one": cd.Custom([a], position=(sympy.sin(a), 0, a**2), rotation=sympy.rot_axis2(a)),
    "custom two": cd.Custom([a, b], (b * sympy.cos(a) - b, a * b, 3 * b), TURN_AND_TILT),
    "custom three": cd.Custom([a, b, c], (0, c, a * c), TURN_AND_TILT),
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


@pytest.fixture(params=INSTANCES)
def bench(request: pytest.FixtureRequest) -> Bench:
    return Bench(request.param)


def test_every_joint_is_tested() -> None:
    assert {joint.kind for joint in INSTANCES.values()} == set(JOINTS)
    assert all(JOINTS[joint.kind] is type(joint) and joint.source for joint in INSTANCES.values())


def test_frames_coincide_at_the_default_coordinates(bench: Bench) -> None:
    defaults = [x.default for x in bench.joint.coordinates]
    rotation, position = bench.joint.pose(bench.q, **bench.data)
    assert close(bench.value(rotation, q=defaults), np.eye(3), 70)
    assert close(bench.value(position, q=defaults), np.zeros(3), 70)


def test_modes_of_motion_are_the_velocity_of_the_pose(bench: Bench) -> None:
    rotation, position = bench.joint.pose(bench.q, **bench.data)
    R = bench.value(rotation)
    assert close(R.T @ R, np.eye(3), 60)
    turning = R.T @ difference(bench.along(rotation))
    linear = R.T @ difference(bench.along(position))
    S = bench.joint.motion(bench.q, **bench.data)
    assert (S.rows, S.columns) == (6, bench.nu)
    assert close(bench.value(S @ bench.u), [*unskew(turning), *linear])


def test_complementary_modes(bench: Bench) -> None:
    S = bench.joint.motion(bench.q, **bench.data)
    T = bench.joint.constrained(bench.q, **bench.data)
    assert (T.rows, T.columns) == (6, 6 - bench.nu)
    assert close(bench.value(T.T @ S), 0, 60)
    both = np.column_stack([bench.value(S), bench.value(T)]).astype(float)
    assert np.linalg.cond(both) < 100


def test_convective_acceleration(bench: Bench) -> None:
    """What the pose accelerates by without udot, or None: then it is derived from S."""
    convective = bench.joint.convective(bench.q, bench.u, **bench.data)
    declared = type(bench.joint).convective is not Joint.convective
    assert declared or convective is None
    S = bench.joint.motion(bench.q, **bench.data)
    velocity = bench.value(S @ bench.u)
    wanted = difference(bench.along(S @ bench.u))
    if convective is not None:
        wanted[3:] += np.cross(velocity[:3], velocity[3:])
        assert close(bench.value(convective), wanted)


def test_rates_and_speeds_are_inverse(bench: Bench) -> None:
    again = bench.joint.speeds_of(bench.q, bench.rate, **bench.data)
    assert close(bench.value(again, rate=bench.rates()), bench.speed, 60)


def test_increments_are_inverse_and_begin_along_the_speeds(bench: Bench) -> None:
    joint, data = bench.joint, bench.data
    du, end = block(bench.graph, "du", bench.nu), block(bench.graph, "end", bench.nq)
    moved = joint.integrate(bench.q, du, **data)
    step = [0.3 * x for x in bench.speed]
    back = joint.difference(bench.q, end, **data)
    # logarithms of small rotations have a series for doubles
    assert close(bench.value(back, end=bench.value(moved, du=step)), step, 14)
    begins = difference(lambda t: bench.value(moved, du=[mpmath.mpf(x) * t for x in bench.speed]))
    assert close(begins, bench.rates(), 20)


def test_names_and_units(bench: Bench) -> None:
    for components in (bench.joint.coordinates, bench.joint.speeds):
        names = [x.name for x in components]
        assert len(set(names)) == len(names)
        assert all(names) if len(names) > 1 else names in ([], [""])
        for component in components:
            unit(component.unit)
    k = bench.joint.quaternion
    uses = getattr(bench.joint, "rotation", None) == "quaternion"
    assert k == (0 if uses else None)
    assert k is None or bench.joint.coordinates[k].default == 1.0
    assert isinstance(bench.joint.domain, str)


BAD: dict[str, tuple[Callable[[], Joint], str]] = {
    "letter": (lambda: cd.Revolute("w"), "revolute joint: axis 'w' is no direction; give 'x'"),
    "zero": (lambda: cd.Prismatic((0, 0, 0)), "prismatic joint: axis is the zero vector"),
    "nan": (lambda: cd.Cylindrical((0, nan, 1)), r"cylindrical joint: axis\[1\] is nan; give a fi"),
    "two": (lambda: cd.Planar((0, 1)), "planar joint: normal has 2 entries; give 3"),
    "second": (lambda: cd.Universal("x", "a"), "universal joint: axis2 'a' is no direction"),
    "scalar": (lambda: cd.Revolute(3), "revolute joint: axis is 3; give 3 numbers"),
    "pitch": (lambda: cd.Screw("z", pitch="M8"), "screw joint: pitch is 'M8'; give a finite"),
    "name": (lambda: cd.Spherical("zyxx"), "spherical joint: parametrization 'zyxx' does not ex"),
    "free": (lambda: cd.Free("quat"), "free joint: parametrization 'quat'"),
    "none": (lambda: cd.Custom([]), r"custom joint: coordinates are .*; give one to six"),
    "twice": (lambda: cd.Custom([a, a]), r"coordinates are .*; give one to six diff"),
    "seven": (lambda: cd.Custom(sympy.symbols("x0:7")), "give one to six different symbols"),
    "rows": (lambda: cd.Custom([a], rotation=[[1, 0, 0]]), "rotation must have 3 rows of 3"),
    "row": (lambda: cd.Custom([a], rotation=[[1, 0]] * 3), r"rotation\[0\] has 2 entries; give 3"),
    "place": (lambda: cd.Custom([a], position=(a, 0)), "position has 2 entries; give 3"),
}


@pytest.mark.parametrize("make", BAD)
def test_bad_input_is_named(make: str) -> None:
    call, message = BAD[make]
    with pytest.raises(cd.ModelError, match=message):
        call()
