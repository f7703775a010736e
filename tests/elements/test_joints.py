"""Laws of every joint: modes of motion against poses differenced in many digits, and so on."""

from __future__ import annotations

from collections.abc import Callable
from math import nan

import mpmath
import numpy as np
import pytest
import sympy

import cardan as cd
from cardan.elements.joints import JOINTS, Joint
from cardan.scene.units import unit
from elements.joint_bench import CURVE, INSTANCES, Bench, a
from elements.written_of import converted
from spatial.numbers_of import block, close, difference, unskew
from table import each


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
    assert close(bench.value(position, q=defaults), np.zeros(3), 70) == bench.joint.coincident


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


def test_reversed_joints_tell_the_same_pose_backwards(bench: Bench) -> None:
    """Pose and modes of the exchanged frames, in the same coordinates, from the same data."""
    joint, back = bench.joint, bench.joint.reversed()
    assert (back.kind, back.coordinates, back.speeds) == (
        joint.kind,
        joint.coordinates,
        joint.speeds,
    )
    data, parameters = converted(bench.graph, back.quantities())
    R, p = (bench.value(x) for x in joint.pose(bench.q, **bench.data))
    turned = back.pose(bench.q, **data)
    assert close(bench.value(turned[0], **parameters), R.T, 60)
    assert close(bench.value(turned[1], **parameters), -(R.T @ p), 60)
    # the velocity of the pose told backwards
    S, T = back.motion(bench.q, **data), back.constrained(bench.q, **data)
    path = [bench.along(x) for x in joint.pose(bench.q, **bench.data)]
    spin = R @ difference(lambda t: path[0](t).T)
    drift = R @ difference(lambda t: -(path[0](t).T @ path[1](t)))
    assert close(bench.value(S @ bench.u, **parameters), [*unskew(spin), *drift])
    assert close(bench.value(T.T @ S, **parameters), 0, 60)
    if not joint.closes_by_coordinates:
        closure = back.closure(*turned, **data)
        assert closure.rows == len(back.locked) == len(joint.locked)
        assert close(bench.value(closure, **parameters), 0, 60)
    if not joint.line:
        assert back.reversed() is joint


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


def test_a_reversed_kind_is_declared_by_exchanged_ends() -> None:
    scene = cd.Scene("m")
    body = scene.body("b", mass=1)
    with pytest.raises(cd.ModelError, match=r"'j' \(spherical\): .* exchange parent and child"):
        scene.joint("j", cd.Spherical().reversed(), scene.ground, body)
    assert cd.Revolute("-y").reversed() == cd.Revolute("y")


BAD: dict[str, tuple[Callable[[], Joint], str]] = {
    "letter": (lambda: cd.Revolute("w"), "revolute joint: axis 'w' is not a direction; give 'x'"),
    "zero": (lambda: cd.Prismatic((0, 0, 0)), "prismatic joint: axis is the zero vector"),
    "nan": (lambda: cd.Cylindrical((0, nan, 1)), r"cylindrical joint: axis\[1\] is nan; give a fi"),
    "two": (lambda: cd.Planar((0, 1)), "planar joint: normal has 2 entries; give 3"),
    "second": (lambda: cd.Universal("x", "a"), "universal joint: axis2 'a' is not a direction"),
    "scalar": (lambda: cd.Revolute(3), "revolute joint: axis is 3; give 3 numbers"),
    "pitch": (lambda: cd.Screw("z", pitch="M8"), "screw joint: pitch is 'M8'; give a finite"),
    "name": (lambda: cd.Spherical("zyxx"), "spherical joint: parametrization 'zyxx' does not ex"),
    "free": (lambda: cd.Free("quat"), "free joint: parametrization 'quat'"),
    "none": (lambda: cd.Custom([]), r"custom joint: coordinates are .*; give one to six"),
    "twice": (lambda: cd.Custom([a, a]), r"coordinates are .*; give one to six diff"),
    "seven": (lambda: cd.Custom(sympy.symbols("x0:7")), "give one to six different symbols"),
    "rows": (lambda: cd.Custom([a], rotation=[[1, 0, 0]]), "rotation must have 3 rows of 3"),
    "row": (lambda: cd.Custom([a], rotation=[[1, 0]] * 3), r"rotation\[0\] has 2 entries; give 3"),
    "radius": (lambda: cd.Wheel(0), "wheel: radius is 0; give a number above 0"),
    "crown": (lambda: cd.Wheel(0.3, 0.4), "crown is 0.4; give a length from 0 to the radius 0.3"),
    "hollow": (lambda: cd.Wheel(0.3, -0.1), "wheel: crown is -0.1"),
    "disk": (lambda: cd.RollingDisk(-1.0), "rolling disk: radius is -1; give a number above 0"),
    "rod": (lambda: cd.Distance("long"), "distance: length is 'long'; give a finite number"),
    "rod axis": (lambda: cd.Distance(1, (0, 0, 0)), "distance: axis is the zero vector"),
    "ratio": (lambda: cd.Gear("a", None), "gear: ratio is None; give a finite number"),
    "shaft": (lambda: cd.ConstantVelocity("w"), "constant-velocity joint: axis 'w' is not a dir"),
    "plane": (lambda: cd.PointOnPlane("n"), "point on a plane: normal 'n' is not a direction"),
    "turn": (lambda: cd.PointOnPlane("z", "quat"), "point on a plane: parametrization 'quat'"),
    "point": (lambda: cd.PointOnCurve([(0, 0, 0)]), "points must be at least 2 rows of 3"),
    "words": (lambda: cd.PointOnCurve("line"), "points must be at least 2 rows of 3 numbers"),
    "flat": (lambda: cd.PointOnCurve([(0, 0), (1, 1)]), r"points\[0\] has 2 entries; give 3"),
    "stays": (lambda: cd.PointOnCurve([(0, 0, 0)] * 2), r"points\[1\] is the point before it"),
    "ring": (lambda: cd.PointOnCurve(CURVE[:2], closed=True), "at least 3 rows"),
    "again": (lambda: cd.PointOnCurve([*CURVE, CURVE[0]], True), "the first again; leave it out"),
    "symbol": (lambda: cd.PointOnCurve([(0, 0, 0), (a, 0, 1)]), r"points\[1\] must be numbers"),
    "place": (lambda: cd.Custom([a], position=(a, 0)), "position has 2 entries; give 3"),
}


@each("make", BAD)
def test_bad_input_is_named(make: str) -> None:
    call, message = BAD[make]
    with pytest.raises(cd.ModelError, match=message):
        call()
