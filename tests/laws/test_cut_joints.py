"""Every joint as a tree joint and closing a loop: the same accelerations and reactions."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
import pytest
import sympy as sp
from scipy.spatial.transform import Rotation

import cardan as cd
from cardan.elements.joints import JOINTS, Joint
from laws.cases import EPS, call

OBLIQUE, OTHER = (1.0, 2.0, -2.0), (0.3, -0.7, 0.1)
A, B = sp.symbols("a b")
TURN = ((sp.cos(A), -sp.sin(A), 0), (sp.sin(A), sp.cos(A), 0), (0, 0, 1))
WAVE = ((0.0, 0, 0), (0.2, 0.1, 0), (0.4, 0.05, 0.1), (0.6, 0.2, 0.1))
ROUND = ((0.3, 0, 0), (0, 0.3, 0.05), (-0.3, 0, 0), (0, -0.3, 0.02))
INSTANCES: dict[str, Joint] = {
    "fixed": cd.Fixed(),
    "revolute": cd.Revolute("y"),
    "revolute oblique": cd.Revolute(OBLIQUE),
    "prismatic": cd.Prismatic("-x"),
    "cylindrical": cd.Cylindrical(OTHER),
    "screw": cd.Screw("z", pitch=0.07),
    "universal": cd.Universal(OBLIQUE, OTHER),
    "constant velocity": cd.ConstantVelocity("x"),
    "spherical": cd.Spherical("XYZ"),
    "planar": cd.Planar("y"),
    "translation": cd.Translation(),
    "point on plane": cd.PointOnPlane(OTHER),
    "distance": cd.Distance(0.6, "y"),
    "wheel": cd.Wheel(0.4, 0.1),
    "wheel that drifts": cd.Wheel(0.4, 0.0, OBLIQUE, lateral_slip=True),
    "rolling disk": cd.RollingDisk(0.3, "x"),
    "knife edge": cd.RollingDisk(0.3, knife_edge=True),
    "point on curve": cd.PointOnCurve(WAVE),
    "point on closed curve": cd.PointOnCurve(ROUND, closed=True, rotation="XYZ"),
    "custom": cd.Custom((A,), (0, 0.3 * A, A**2 / 5), TURN),
    "custom of two": cd.Custom((A, B), (B**2 / 3, 0.3 * A * B, 0.2 * B + A**2 / 5), TURN),
    "gear": cd.Gear("pivot", -0.7, OBLIQUE, 0.2),
}
# what holds nothing
APART = {"free"}
INERTIA = ((0.3, 0.02, -0.01), (0.02, 0.4, 0.03), (-0.01, 0.03, 0.2))
STEP = 1e-5


def machine(kind: Joint, cut: bool, back: bool = False) -> cd.Scene:
    """A pendulum that carries a body by the joint; cut, the body floats and the joint binds it."""
    scene = cd.Scene("machine", gravity=(0.3, 0.5, -9.81))
    arm = scene.body("arm", mass=2.0, com=(0.1, 0, -0.3), inertia=INERTIA)
    load = scene.body("load", mass=1.0, com=(0.05, -0.1, 0.2), inertia=INERTIA)
    scene.joint("pivot", cd.Revolute((1, 1, 0)), scene.ground, arm)
    one, other = arm.at(0.1, 0.2, -0.5, rotation=("XYZ", 0.2, -0.3, 0.5)), load.at(0, 0.1, 0.1)
    if cut:
        scene.joint("float", cd.Free(), scene.ground, load)
    made = scene.joint("tested", kind, one, other, cut=cut)
    if back:
        ends = {"parent": made.child, "child": made.parent}
        scene.joints["tested"] = dataclasses.replace(made, kind=kind.reversed(), **ends)
    return scene


class Pair:
    """Both machines at the same regular state."""

    def __init__(self, name: str, back: bool) -> None:
        self.kind, self.back = INSTANCES[name], back
        self.tree = cd.derive(machine(self.kind, False))
        self.cut = cd.derive(machine(self.kind, True, back))
        # what follows another joint has no coordinates of its own
        own = self.kind.follows is None
        start = [c.default for c in self.kind.coordinates if own]
        n = len(self.kind.speeds) * own
        rng = np.random.default_rng(5)
        q, du = np.array([0.4, *start]), np.array([0.1, *rng.uniform(0.2, 0.5, n)])
        self.q = self._whole("integrate", q=q, du=du)
        u = rng.uniform(-1, 1, 1 + n)
        if self.kind.slips:
            u = self._whole("close_velocity", q=self.q, u=u)[: 1 + n]
        self.u = u
        self.floating = self._floating()

    @property
    def carried(self) -> bool:
        """Whether the joint closes the loop with coordinates of its own."""
        return self.kind.closes_by_coordinates or self.kind.follows is not None

    def _whole(self, function: str, **given: Any) -> np.ndarray:
        return np.concatenate([x.ravel() for x in call(self.tree, function, **given).values()])

    def _floating(self) -> tuple[np.ndarray, np.ndarray]:
        """The state of the machine in which the load floats."""
        (pose,) = call(self.tree, "pose", "load", q=self.q).values()
        (twist,) = call(self.tree, "velocity", "load", q=self.q, u=self.u).values()
        x, y, z, w = Rotation.from_matrix(pose[:3, :3]).as_quat()
        q = np.array([self.q[0], w, x, y, z, *pose[:3, 3]])
        u = np.array([self.u[0], *(pose[:3, :3].T @ twist[:3]), *twist[3:]])
        if self.carried:
            # the joint keeps its coordinates
            return np.append(q, self.q[1:]), np.append(u, self.u[1:])
        return q, u

    def accelerations(self) -> tuple[np.ndarray, np.ndarray]:
        """Of both bodies (12,), in the tree and with the loop."""
        found = []
        for e, (q, u) in ((self.tree, (self.q, self.u)), (self.cut, self.floating)):
            (udot,) = call(e, "forward_dynamics", q=q, u=u).values()
            parts = [
                next(iter(call(e, "acceleration", body, q=q, u=u, udot=udot).values()))
                for body in ("arm", "load")
            ]
            found.append(np.concatenate(parts))
        return found[0], found[1]


@pytest.fixture(scope="module", params=INSTANCES)
def name(request: pytest.FixtureRequest) -> str:
    return str(request.param)


@pytest.fixture(scope="module", params=[False, True], ids=["forth", "back"])
def pair(request: pytest.FixtureRequest, name: str) -> Pair:
    return Pair(name, request.param)


def test_every_joint_is_tested() -> None:
    assert {kind.kind for kind in INSTANCES.values()} == set(JOINTS) - APART


def gears(relation: bool) -> cd.Scene:
    """Two unbalanced wheels that mesh, by a gear or by a relation between two hinges."""
    scene = cd.Scene("gears", gravity=(0.5, 0, -9.81))
    one = scene.body("one", mass=1.0, com=(0.1, 0, 0.03), inertia=(0.1, 0.2, 0.1))
    other = scene.body("other", mass=2.0, com=(0.1, 0.1, 0.3), inertia=INERTIA)
    lead = scene.joint("lead", cd.Revolute("y"), scene.ground, one)
    wheel = cd.Revolute((0, 3, 4)) if relation else cd.Gear(lead, -0.7, (0, 3, 4), 0.2)
    scene.joint("wheel", wheel, one.at(0.4, 0, 0), other)
    if relation:
        scene.constraint("mesh", scene.q("wheel") + 0.7 * scene.q("lead") - 0.2, unit="rad")
    return scene


def test_a_gear_is_a_relation_between_two_joints() -> None:
    one, two = cd.derive(gears(False)), cd.derive(gears(True))
    q, u = 0.4, 1.3
    (udot,) = call(one, "forward_dynamics", q=np.array([q]), u=np.array([u])).values()
    given = {"q": np.array([q, -0.7 * q + 0.2]), "u": np.array([u, -0.7 * u])}
    (both,) = call(two, "forward_dynamics", **given).values()
    np.testing.assert_allclose(both, [udot[0], -0.7 * udot[0]], rtol=1e-12)


def test_the_state_is_on_the_constraints(pair: Pair) -> None:
    q, u = pair.floating
    (g,) = call(pair.cut, "constraints", q=q).values()
    (rates,) = call(pair.cut, "constraint_rates", q=q, u=u).values()
    assert len(g) == (6 if pair.carried else len(pair.kind.locked))
    assert len(rates) == len(g) + len(pair.kind.slips)
    assert np.abs([*g, *rates]).max() < 100 * EPS


def test_accelerations_are_those_of_the_tree(pair: Pair) -> None:
    tree, cut = pair.accelerations()
    # the mass matrices have condition numbers of some hundreds
    assert np.abs(tree - cut).max() < 1e4 * EPS * np.abs(tree).max()


def test_reactions_are_those_of_the_tree(pair: Pair) -> None:
    (wanted,) = call(
        pair.tree, "reaction", "tested", q=pair.q, u=pair.u, wrench=np.zeros(12)
    ).values()
    q, u = pair.floating
    (found,) = call(pair.cut, "reaction", "tested", q=q, u=u, wrench=np.zeros(12)).values()
    if pair.back:
        # the wrench on the arm, at its frame in its axes
        frames = [
            next(iter(call(pair.cut, "pose", f"tested.{end}", q=q).values()))
            for end in ("child", "parent")
        ]
        turn = frames[0][:3, :3].T @ frames[1][:3, :3]
        arm = frames[0][:3, :3].T @ (frames[1] - frames[0])[:3, 3]
        moment, force = turn @ wanted[:3], turn @ wanted[3:]
        wanted = -np.concatenate([moment + np.cross(arm, force), force])
    assert np.abs(found - wanted).max() < 1e5 * EPS * (1 + np.abs(wanted).max())


@pytest.mark.parametrize("cut", [False, True], ids=["tree", "cut"])
def test_reactions_balance_the_load(pair: Pair, cut: bool) -> None:
    """Newton and Euler for the free body: besides the joint only gravity acts on it."""
    equations = pair.cut if cut else pair.tree
    q, u = pair.floating if cut else (pair.q, pair.u)
    (udot,) = call(equations, "forward_dynamics", q=q, u=u).values()
    (wrench,) = call(equations, "reaction", "tested", q=q, u=u, wrench=np.zeros(12)).values()
    (pose,) = call(equations, "pose", "load", q=q).values()
    (twist,) = call(equations, "velocity", "load", q=q, u=u).values()
    (change,) = call(equations, "acceleration", "load", q=q, u=u, udot=udot).values()
    (child,) = call(equations, "pose", "tested.child", q=q).values()
    R, omega, alpha = pose[:3, :3], twist[:3], change[:3]
    com, inertia = R @ [0.05, -0.1, 0.2], R @ np.array(INERTIA) @ R.T
    acceleration = change[3:] + np.cross(alpha, com) + np.cross(omega, np.cross(omega, com))
    force = 1.0 * (acceleration - np.array([0.3, 0.5, -9.81]))
    moment = inertia @ alpha + np.cross(omega, inertia @ omega)
    # declared the other way round it is the wrench on the arm, of which the load feels the opposite
    sign = -1 if cut and pair.back else 1
    turned, pushed = (sign * child[:3, :3] @ wrench[k : k + 3] for k in (0, 3))
    arm = child[:3, 3] - pose[:3, 3] - com
    found, wanted = np.array([turned + np.cross(arm, pushed), pushed]), np.array([moment, force])
    assert np.abs(found - wanted).max() < 1e5 * EPS * (1 + np.abs(wanted).max())


def test_constraints_do_no_work(pair: Pair) -> None:
    """Nothing drives the machine: its energy stays, to second order of a central difference."""
    q, u = pair.floating
    (udot,) = call(pair.cut, "forward_dynamics", q=q, u=u).values()

    def energy(h: float) -> float:
        (moved,) = call(pair.cut, "integrate", q=q, du=u * h + udot * (h * h / 2)).values()
        return float(call(pair.cut, "energy", q=moved, u=u + h * udot)["total"])

    rate = (energy(STEP) - energy(-STEP)) / (2 * STEP)
    assert abs(rate) < 1e3 * STEP**2 + 1e2 * EPS / STEP
