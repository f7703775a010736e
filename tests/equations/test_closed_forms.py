"""Loops in closed form against the same loops with multipliers."""

from __future__ import annotations

import dataclasses
from functools import cache

import numpy as np
import pytest

import cardan as cd
from cardan.errors import ModelError, TopologyError
from mechanisms.closed import CLOSED, four_bar
from spread import some

# loops that close by dyads or legs, and the joints that stay free
SOLVED = {
    "four_bar": ("A",),
    "slider_crank": ("A",),
    "parallelogram": ("A0",),
    "andrews": ("beta",),
    "stewart": ("hooke0", "slide0", "ball0"),
}


def spherical_four_bar() -> cd.Scene:
    """Four revolute joints whose axes meet in the origin."""
    scene = cd.Scene("spherical", gravity=(0, 0, -9.81))
    axes = {"A": (0, 0, 1), "B": (0.5, 0, 1), "C": (0.6, 0.9, 1), "D": (0, 1, 1)}
    made = {}
    for name, com in (
        ("crank", (0.2, 0, 0.5)),
        ("rod", (0.3, 0.4, 0.6)),
        ("rocker", (0, 0.5, 0.4)),
    ):
        inertia = (0.02, 0.03, 0.025)
        made[name] = scene.body(name, mass=1.0, com=com, inertia=inertia, pose=(0, 0, 0))
    ends = {
        "A": (scene.ground, made["crank"]),
        "B": (made["crank"], made["rod"]),
        "C": (made["rod"], made["rocker"]),
        "D": (scene.ground, made["rocker"]),
    }
    for name, (parent, child) in ends.items():
        scene.joint(name, cd.Revolute(axes[name]), parent, child)
    return scene


def both(scene: cd.Scene) -> tuple[cd.CompiledModel, cd.CompiledModel]:
    return cd.compile(scene), cd.compile(scene, constraints="closed_form")


def started(name: str, s: float) -> tuple[cd.Scene, dict[str, object], dict[str, object]]:
    """A mechanism with initial values on its motion, and a state there."""
    mechanism = CLOSED[name]
    scene, state = mechanism.build(), mechanism.state(s)
    for joint in scene.joints.values():
        if joint.name in state.q:
            start = tuple(np.atleast_1d(state.q[joint.name]))
            scene.joints[joint.name] = dataclasses.replace(joint, q0=start)
    return scene, state.q, state.u


@cache
def bars() -> tuple[cd.Scene, dict[str, object], cd.CompiledModel, cd.CompiledModel]:
    """The four-bar as it is, coordinates on its motion, with multipliers and in closed form."""
    scene, q, _ = started("four_bar", 0.3)
    return scene, q, *both(scene)


@pytest.mark.parametrize("name", some(SOLVED, 4, 1))
def test_the_same_accelerations_and_reactions(name: str) -> None:
    scene, q, u = started(name, 0.3)
    whole, solved = both(scene)
    full = whole.split(
        whole.initial({n: q[n] for n in tree(whole)}, {n: u[n] for n in tree(whole)})
    )
    free = {n: q[n] for n in SOLVED[name]}, {n: u[n] for n in SOLVED[name]}
    x = solved.split(solved.initial(*free))
    assert tree(solved) == list(SOLVED[name])
    assert solved.nlam == 0
    places = [whole.speeds.index(n) for n in solved.speeds]
    wanted = whole.forward_dynamics(*full)[places]
    # the condition of the loops enters: some are near their dead points
    np.testing.assert_allclose(solved.forward_dynamics(*x), wanted, rtol=1e-10, atol=1e-10)
    for frame in whole.frames:
        np.testing.assert_allclose(
            solved.pose(frame, x[0]), whole.pose(frame, full[0]), rtol=0, atol=1e-13
        )
    for joint in whole.joints:
        expected = whole.reaction(joint, *full)
        size = max(1.0, np.abs(expected).max())
        np.testing.assert_allclose(solved.reaction(joint, *x), expected, rtol=0, atol=1e-10 * size)


def tree(model: cd.CompiledModel) -> list[str]:
    return [j["name"] for j in model.manifest["joints"] if j["q"]]


def test_spherical_circuits() -> None:
    scene = spherical_four_bar()
    whole, solved = both(scene)
    assert solved.coordinates == ("A",)
    assert len(whole.multipliers_of) == 2
    start = whole.assemble({"A": 0.2})
    q, u = whole.split(start.x)
    u = whole.close_velocity(q, [1.0, 0.0, 0.0])[: whole.nu]
    own = solved.split(solved.initial({"A": q[0]}, {"A": u[0]}))
    np.testing.assert_allclose(
        solved.forward_dynamics(*own), whole.forward_dynamics(q, u)[:1], rtol=1e-10
    )
    others = solved.dependents(*own)
    np.testing.assert_allclose(others, [*q[1:], *u[1:]], rtol=1e-10)


def test_the_branch_is_what_is_asked_for() -> None:
    scene, q, whole, near = bars()
    other = cd.compile(scene, constraints="closed_form", branches={"C": "-"})
    assert near.dependents([q["A"]], [0.0])[0] == pytest.approx(q["B"], abs=1e-13)
    assert abs(other.dependents([q["A"]], [0.0])[0] - q["B"]) > 0.1
    coordinates = [q["A"], *other.dependents([q["A"]], [0.0])[:2]]
    np.testing.assert_allclose(whole.constraints(coordinates), 0, atol=1e-14)


def test_branches_that_do_not_exist() -> None:
    scene = CLOSED["four_bar"].build()
    with pytest.raises(TopologyError, match=r"branch of 'E': it closes no loop.*C"):
        cd.derive(scene, branches={"E": "+"})
    with pytest.raises(TopologyError, match="branch of 'C' is 'up'"):
        cd.derive(scene, branches={"C": "up"})
    with pytest.raises(TopologyError, match="not solved in closed form"):
        cd.derive(CLOSED["bricard"].build(), branches={"J3": "+"})


def test_a_run_shows_the_joints_of_its_circuits() -> None:
    _, q, whole, solved = bars()
    start = {n: q[n] for n in tree(whole)}
    long = whole.simulate(2.0, q=start, rtol=1e-12, atol=1e-13)
    short = solved.simulate(2.0, q={"A": q["A"]}, rtol=1e-12, atol=1e-13)
    t = np.linspace(0, 2, 41)
    for name in ("A", "B", "D", "B.u", "D.u"):
        one, two = long.resample(t)[name], short.resample(t)[name]
        # the crank swings fast where the other links are nearly in line
        np.testing.assert_allclose(two, one, rtol=0, atol=1e-7)
    # what follows from the loop may be named where it fits, and says where the crank stands
    named = solved.simulate(0.1, q={"B": q["B"]})
    assert named["B"][0] == pytest.approx(q["B"], abs=1e-9)
    with pytest.raises(ModelError, match="loop that 'C' closes gives"):
        solved.simulate(1.0, q={"A": q["A"], "B": 0.1})


def test_a_dead_point_ends_the_run() -> None:
    """All links of a folding four-bar are in line at pi: there its two solutions meet."""
    scene = four_bar(ground=0.3, crank=0.1, coupler=0.3, rocker=0.1)
    solved = cd.compile(scene, constraints="closed_form")
    with pytest.warns(cd.SolveWarning, match="loop that 'C' closes is at a dead point"):
        motion = solved.simulate(0.25, q={"A": 0.5}, u={"A": 20.0}, rtol=1e-6)
    assert motion.status == "not_finite"
    assert motion["A"][-1] == pytest.approx(np.pi, abs=0.01)


def test_a_driven_circuit_has_no_coordinates_left() -> None:
    scene, q, _ = started("four_bar", 0.3)
    crank = scene.joints["A"]
    scene.joints["A"] = dataclasses.replace(crank, prescribed=q["A"] + 2 * cd.t, q0=None)
    whole, solved = both(scene)
    assert (solved.nq, solved.nu, whole.nu) == (0, 0, 2)
    t = np.linspace(0, 3, 7)
    one, two = (model.simulate(t, rtol=1e-10) for model in (whole, solved))
    for name in ("A", "B", "D", "D.u"):
        np.testing.assert_allclose(two[name], one[name], rtol=0, atol=1e-8)
    # the drive that keeps the crank at its speed
    drive = [m.outputs(x.q, x.u, t=t) for m, x in ((whole, one), (solved, two))]
    np.testing.assert_allclose(drive[1], drive[0], rtol=1e-7, atol=1e-9)


def test_prescribed_motion_and_forces_on_dependent_joints() -> None:
    scene, q, _ = started("four_bar", 0.3)
    scene.force("spring", cd.JointSpring("D", stiffness=5.0, damping=0.3))
    scene.output("angle", scene.q("D") + 2 * scene.u("B"))
    whole, solved = both(scene)
    u = whole.close_velocity([q["A"], q["B"], q["D"]], [1.0, 0.0, 0.0])[: whole.nu]
    full = [q["A"], q["B"], q["D"]], u
    own = [q["A"]], u[:1]
    np.testing.assert_allclose(
        solved.forward_dynamics(*own), whole.forward_dynamics(*full)[:1], rtol=1e-11
    )
    np.testing.assert_allclose(solved.outputs(*own), whole.outputs(*full), rtol=1e-11)
    np.testing.assert_allclose(solved.power(*own), whole.power(*full), rtol=1e-11)


def same(scene: cd.Scene, q: dict[str, float], speed: str) -> None:
    """The free speed of a scene in closed form accelerates as with multipliers."""
    whole, solved = both(scene)
    full, rates = whole.split(whole.assemble(q, u={speed: 1.0}).x)
    places = [whole.coordinates.index(n) for n in solved.coordinates]
    wanted = whole.forward_dynamics(full, rates)[places]
    found = solved.forward_dynamics(full[places], rates[places])
    np.testing.assert_allclose(found, wanted, rtol=1e-9)


def test_a_universal_joint_and_a_slide_on_two_branches_are_no_leg() -> None:
    scene = cd.Scene("apart")
    arm = scene.body("arm", mass=1.0, com=(0.1, 0.2, 0.3), inertia=(0.1, 0.2, 0.3))
    turret = scene.body("turret", mass=2.0, com=(0.1, 0, 0.3), inertia=(0.2, 0.1, 0.3))
    slide = scene.body("slide", mass=2.0, com=(0.1, 0, 0.3), inertia=(0.2, 0.1, 0.3))
    scene.joint("U", cd.Universal("x", "y"), scene.ground, arm)
    scene.joint("R", cd.Revolute("z"), scene.ground.at(0.3, 0.1, 1.0), turret)
    scene.joint("P", cd.Prismatic("x"), turret.at(0, 0.4, 0), slide)
    scene.joint("S", cd.Spherical(), arm.at(0.3, 0.5, 1.0), slide, cut=True)
    same(scene, {"R": 0.2}, "R")


def test_a_joint_that_others_follow_stays_a_coordinate() -> None:
    scene = cd.Scene("geared", gravity=(0, -9.81, 0))
    made = {}
    for name, length in {"crank": 0.1, "rod": 0.25, "rocker": 0.2, "wheel": 0.1}.items():
        inertia = cd.inertia.rod(length, length, axis="x")
        made[name] = scene.body(name, mass=length, com=(length / 2, 0.01, 0), inertia=inertia)
    crank, rod, rocker, wheel = made.values()
    scene.joint("A", cd.Revolute("z"), scene.ground, crank, q0=-0.1135)
    scene.joint("B", cd.Revolute("z"), crank.at(0.1, 0, 0), rod, q0=0.9035)
    scene.joint("D", cd.Revolute("z"), scene.ground.at(0.3, 0, 0), rocker, q0=2.2909)
    scene.joint("E", cd.Revolute("z"), rocker.at(0.1, 0, 0), wheel, couple=("D", -0.5))
    scene.joint("C", cd.Revolute("z"), rod.at(0.25, 0, 0), wheel.at(0.1, 0, 0), cut=True)
    same(scene, {"D": 2.2909}, "D")


def test_a_leg_may_be_drawn_out_backwards() -> None:
    """A slide told along the opposite direction moves its bodies as before."""
    scene, q, _ = started("stewart", 0.3)
    other = started("stewart", 0.3)[0]
    slide = other.joints["slide1"]
    back = tuple(-x for x in slide.kind.axis)
    start = tuple(-x for x in slide.q0)
    other.joints["slide1"] = dataclasses.replace(slide, kind=cd.Prismatic(back), q0=start)
    one, two = (cd.compile(s, constraints="closed_form") for s in (scene, other))
    free = np.concatenate([np.atleast_1d(q[n]) for n in SOLVED["stewart"]])
    for body in one.bodies:
        np.testing.assert_allclose(two.pose(body, free), one.pose(body, free), atol=1e-12)
