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
from spatial.numbers_of import DIGITS, block, close, difference, moving, numbers, unskew

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


CUT = [name for name, joint in INSTANCES.items() if joint.cuttable]


@pytest.fixture(params=CUT)
def cut(request: pytest.FixtureRequest) -> Cut:
    return Cut(request.param)


class Cut(Bench):
    """A joint that closes a circuit: relative poses beside those of its coordinates."""

    def __init__(self, name: str) -> None:
        super().__init__(name)
        pose, place = block(self.graph, "R", 9), block(self.graph, "place", 3)
        self.R, self.x = Matrix(self.graph, 3, 3, pose.nodes), place
        self.closure = self.joint.closure(self.R, self.x, **self.data)
        rotation, position = self.joint.pose(self.q, **self.data)
        self.at_R, self.at_x = self.value(rotation), self.value(position)

    def gradient(self) -> Any:
        """d closure / d twist of C at its origin, in C axes, (m, 6), by differences."""
        columns = []
        for k in range(6):
            turn, shift = np.zeros(3, object), np.zeros(3, object)
            (turn if k < 3 else shift)[k % 3] = mpmath.mpf(1)
            spin, drift = self.at_R @ skew(turn), self.at_R @ shift
            columns.append(difference(lambda t, s=spin, d=drift: self.near(t, s, d)))
        return np.stack(columns, axis=-1) if len(self.joint.held) else np.zeros((0, 6))

    def near(self, t: Any, spin: Any, drift: Any) -> Any:
        R, x = self.at_R + t * spin, self.at_x + t * drift
        return self.value(self.closure, R=list(R.ravel()), place=list(x))


def skew(v: Any) -> Any:
    x, y, z = v
    return np.array([[0 * x, -z, y], [z, 0 * x, -x], [-y, x, 0 * x]], dtype=object)


@pytest.mark.parametrize("seed", range(3))
def test_closure_vanishes_at_every_pose_of_the_joint(cut: Cut, seed: int) -> None:
    joint, rng = cut.joint, np.random.default_rng(seed)
    held = joint.held
    assert cut.closure.rows == len(held) == 6 - cut.nu
    start = Matrix.vector(cut.graph, [x.default for x in joint.coordinates])
    q = joint.integrate(start, block(cut.graph, "du", cut.nu), **cut.data)
    R, p = joint.pose(q, **cut.data)
    # more than half a turn too, where that is inside the domain
    reach = 1.2 if joint.domain else 5.0
    du = [mpmath.mpf(x) for x in rng.uniform(-reach, reach, cut.nu)]
    assert close(cut.value(joint.closure(R, p, **cut.data), du=du), 0, 60)
    facing = joint.facing(R, p, **cut.data)
    assert all(x > 0 for x in cut.value(facing, du=du)) or joint.domain


def test_closure_leaves_the_motion_free_and_holds_the_rest(cut: Cut) -> None:
    gradient = cut.gradient()
    S = cut.value(cut.joint.motion(cut.q, **cut.data)).reshape(6, cut.nu)
    T = cut.value(cut.joint.constrained(cut.q, **cut.data)).reshape(6, 6 - cut.nu)
    assert close(gradient @ S, 0)
    held = np.array(gradient @ T, float)
    assert not held.size or np.linalg.cond(held) < 100


def test_rows_of_the_closure_are_angles_and_lengths(cut: Cut) -> None:
    """A row in m grows with the length of a translation, a row in rad with an angle only."""
    for row, component in zip(cut.gradient(), cut.joint.held, strict=True):
        angular, linear = (float(sum(x * x for x in part)) for part in (row[:3], row[3:]))
        assert component.unit in ("m", "rad")
        if component.unit == "m":
            assert linear == pytest.approx(1, abs=1e-15)
        else:
            assert linear < 1e-70
            assert 0.1 < angular < 1 + 1e-15
    names = [component.name for component in cut.joint.held]
    assert len(set(names)) == len(names)
    assert all(names)


OTHER_BRANCH = {
    "revolute z": [1.0, -1.0, -1.0],
    "prismatic x": [-1.0, -1.0, 1.0],
    "cylindrical y": [1.0, -1.0, -1.0],
    "screw -x": [-1.0, -1.0, 1.0],
    "planar": [-1.0, 1.0, -1.0],
    "fixed": [1.0, -1.0, -1.0],
}


@pytest.mark.parametrize("name", OTHER_BRANCH)
def test_an_axis_turned_round_does_not_face(name: str) -> None:
    cut = Cut(name)
    R, x = np.diag(OTHER_BRANCH[name]).ravel(), np.zeros(3)
    assert close(cut.value(cut.closure, R=R, place=x), 0)
    facing = cut.joint.facing(cut.R, cut.x, **cut.data)
    assert min(cut.value(facing, R=R, place=x)) <= 0


def test_a_screw_closes_after_whole_turns() -> None:
    cut = Cut("screw oblique")
    R, p = cut.joint.pose(cut.q, **cut.data)
    closure = cut.joint.closure(R, p, **cut.data)
    for turns in (-3, 0.4, 2.6, 100):
        assert close(cut.value(closure, q=[2 * mpmath.pi * turns]), 0, 60)
    # half a lead off is as far as it gets
    shifted = cut.joint.closure(R, p + p / (p.dot(p) ** 0.5) * 0.1, **cut.data)
    row = cut.value(shifted, q=[mpmath.mpf(1)])[-1]
    assert abs(abs(row) - mpmath.mpf("0.1")) < 1e-60


def test_a_custom_joint_says_why_it_is_not_cut() -> None:
    custom = INSTANCES["custom two"]
    graph = Graph()
    assert not custom.cuttable
    assert custom.held == ()
    with pytest.raises(cd.TopologyError, match="choose another joint of the loop to cut"):
        custom.closure(Matrix.identity(graph, 3), Matrix.zeros(graph, 3))


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
    if joint.cuttable:
        closure = back.closure(*turned, **data)
        assert closure.rows == len(back.held) == len(joint.held)
        assert close(bench.value(closure, **parameters), 0, 60)
    if not joint.line:
        assert back.reversed() is joint


ROLLING = [name for name, joint in INSTANCES.items() if joint.slips]


@pytest.mark.parametrize("name", ROLLING)
@mpmath.workdps(DIGITS)
def test_slip_is_the_velocity_of_the_point_of_contact(name: str) -> None:
    """The lowest material point of the turning wheel, seen from the plane, along its heading."""
    cut = Cut(name)
    joint, S = cut.joint, cut.joint.motion(cut.q, **cut.data)
    given = joint.slip(*joint.pose(cut.q, **cut.data), S @ cut.u, **cut.data)
    short = joint.sliding(cut.q, cut.u, **cut.data)
    assert given is not None
    assert short is not None
    assert given.rows == short.rows == len(joint.slips)
    assert close(cut.value(given), cut.value(short), 60)
    # of a torus about the axle at the center: the contact in axes that turn with the wheel
    n = np.array(cut.value(joint.constrained(cut.q, **cut.data)))[3:]
    R, x = cut.at_R, cut.at_x
    plane = R @ n
    crown = cut.value(cut.data["crown"])[0] if "crown" in cut.data else 0
    large = cut.value(cut.data["radius"])[0] - crown
    height = plane @ x
    lean = cut.at[3]
    assert abs(height - crown - large * mpmath.cos(lean)) < 1e-60
    velocity = cut.value(S @ cut.u)
    heading, axle = heading_and_axle(joint, cut)
    up = plane * 1 / mpmath.cos(lean) - axle * mpmath.tan(lean)
    arm = R.T @ -(large * up + crown * plane)
    point = R @ (velocity[3:] + np.cross(velocity[:3], arm))
    wanted = {"longitudinal": heading @ point, "lateral": np.cross(plane, heading) @ point}
    assert close(cut.value(given), [wanted[c.name] for c in joint.slips], 60)


def heading_and_axle(joint: Joint, cut: Cut) -> tuple[Any, Any]:
    """Of a wheel: where x goes by yaw, and where y goes with the wheel, of its own axes."""
    yawed = [0, 0, cut.at[2], 0, 0]
    spun = joint.pose(cut.q, **cut.data)[0]
    x, y = (joint.pose(cut.q, **cut.data)[1], [[1, 0, 0, 0, 0], [0, 1, 0, 0, 0], [0] * 5])
    at = [cut.value(x, q=q) for q in y]
    return cut.value(spun, q=yawed) @ (at[0] - at[2]), cut.at_R @ (at[1] - at[2])


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
    scene = cd.Model("m")
    body = scene.body("b", mass=1)
    with pytest.raises(cd.ModelError, match=r"'j' \(spherical\): .* exchange parent and child"):
        scene.joint("j", cd.Spherical().reversed(), scene.ground, body)
    assert cd.Revolute("-y").reversed() == cd.Revolute("y")


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
    "radius": (lambda: cd.Wheel(0), "wheel: radius is 0.0; give a number above 0"),
    "crown": (lambda: cd.Wheel(0.3, 0.4), "crown is 0.4; give a length from 0 to the radius 0.3"),
    "hollow": (lambda: cd.Wheel(0.3, -0.1), "wheel: crown is -0.1"),
    "disk": (lambda: cd.RollingDisk(-1.0), "rolling disk: radius is -1.0; give a number above 0"),
    "rod": (lambda: cd.Distance("long"), "distance: length is 'long'; give a finite number"),
    "rod axis": (lambda: cd.Distance(1, (0, 0, 0)), "distance: axis is the zero vector"),
    "ratio": (lambda: cd.Gear("a", None), "gear: ratio is None; give a finite number"),
    "shaft": (lambda: cd.ConstantVelocity("w"), "constant-velocity joint: axis 'w' is no dir"),
    "plane": (lambda: cd.PointOnPlane("n"), "point on a plane: normal 'n' is no direction"),
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


@pytest.mark.parametrize("make", BAD)
def test_bad_input_is_named(make: str) -> None:
    call, message = BAD[make]
    with pytest.raises(cd.ModelError, match=message):
        call()
