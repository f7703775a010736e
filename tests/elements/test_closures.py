"""What joints hold: closing conditions against their own motion, and the slip of wheels."""

from __future__ import annotations

from typing import Any

import mpmath
import numpy as np
import pytest

from cardan.elements.joints import Joint
from cardan.ir.matrix import Matrix
from elements.joint_bench import INSTANCES, Bench
from spatial.numbers_of import DIGITS, block, close, difference

CUT = [name for name, joint in INSTANCES.items() if not joint.closes_by_coordinates]


@pytest.fixture(params=CUT)
def cut(request: pytest.FixtureRequest) -> Cut:
    return Cut(request.param)


class Cut(Bench):
    """A joint that closes a loop: relative poses beside those of its coordinates."""

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
        return np.stack(columns, axis=-1) if len(self.joint.locked) else np.zeros((0, 6))

    def near(self, t: Any, spin: Any, drift: Any) -> Any:
        R, x = self.at_R + t * spin, self.at_x + t * drift
        return self.value(self.closure, R=list(R.ravel()), place=list(x))


def skew(v: Any) -> Any:
    x, y, z = v
    return np.array([[0 * x, -z, y], [z, 0 * x, -x], [-y, x, 0 * x]], dtype=object)


@pytest.mark.parametrize("seed", range(3))
def test_closure_vanishes_at_every_pose_of_the_joint(cut: Cut, seed: int) -> None:
    joint, rng = cut.joint, np.random.default_rng(seed)
    held = joint.locked
    assert cut.closure.rows == len(held) == 6 - cut.nu
    start = Matrix.vector(cut.graph, [x.default for x in joint.coordinates])
    q = joint.integrate(start, block(cut.graph, "du", cut.nu), **cut.data)
    R, p = joint.pose(q, **cut.data)
    # more than half a turn too, where that is inside the domain
    reach = 1.2 if joint.domain else 5.0
    du = [mpmath.mpf(x) for x in rng.uniform(-reach, reach, cut.nu)]
    assert close(cut.value(joint.closure(R, p, **cut.data), du=du), 0, 60)
    assembly_signs = joint.assembly_signs(R, p, **cut.data)
    assert all(x > 0 for x in cut.value(assembly_signs, du=du)) or joint.domain


def test_closure_leaves_the_motion_free_and_holds_the_rest(cut: Cut) -> None:
    gradient = cut.gradient()
    S = cut.value(cut.joint.motion(cut.q, **cut.data)).reshape(6, cut.nu)
    T = cut.value(cut.joint.constrained(cut.q, **cut.data)).reshape(6, 6 - cut.nu)
    assert close(gradient @ S, 0)
    held = np.array(gradient @ T, float)
    assert not held.size or np.linalg.cond(held) < 100


def test_rows_of_the_closure_are_angles_and_lengths(cut: Cut) -> None:
    """A row in m grows with the length of a translation, a row in rad with an angle only."""
    for row, component in zip(cut.gradient(), cut.joint.locked, strict=True):
        angular, linear = (float(sum(x * x for x in part)) for part in (row[:3], row[3:]))
        assert component.unit in ("m", "rad")
        if component.unit == "m":
            assert linear == pytest.approx(1, abs=1e-15)
        else:
            assert linear < 1e-70
            assert 0.1 < angular < 1 + 1e-15
    names = [component.name for component in cut.joint.locked]
    assert len(set(names)) == len(names)
    assert all(names)


OTHER_BRANCH = {
    "revolute z": [1.0, -1.0, -1.0],
    "prismatic x": [-1.0, -1.0, 1.0],
    "cylindrical y": [1.0, -1.0, -1.0],
    "screw -x": [-1.0, -1.0, 1.0],
    "planar": [-1.0, 1.0, -1.0],
    "fixed": [1.0, -1.0, -1.0],
    "translation": [-1.0, -1.0, 1.0],
}


@pytest.mark.parametrize("name", OTHER_BRANCH)
def test_an_axis_turned_round_does_not_face(name: str) -> None:
    cut = Cut(name)
    R, x = np.diag(OTHER_BRANCH[name]).ravel(), np.zeros(3)
    assert close(cut.value(cut.closure, R=R, place=x), 0)
    assembly_signs = cut.joint.assembly_signs(cut.R, cut.x, **cut.data)
    assert min(cut.value(assembly_signs, R=R, place=x)) <= 0


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
