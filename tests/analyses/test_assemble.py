"""Assembly and inverse kinematics: what is held, what is near, and why it cannot be."""

from __future__ import annotations

import math

import numpy as np
import pytest

import cardan as cd
from mechanisms.closed_planar import FOUR_BAR, four_bar, four_bar_angles, slider_crank
from mechanisms.closed_spatial import stewart, stewart_coordinates

# positions are solved to the rounding of their residuals, lengths of 0.3 m and less
EXACT = {"rtol": 0, "atol": 1e-12}


@pytest.fixture(scope="module")
def bars() -> cd.CompiledModel:
    return cd.compile(four_bar())


@pytest.fixture(scope="module")
def platform() -> cd.CompiledModel:
    return cd.compile(stewart())


@pytest.mark.parametrize("side", [1, -1])
def test_a_named_coordinate_is_held_to_the_bit(bars: cd.CompiledModel, side: int) -> None:
    for crank in (0.1, 1.0, 2.5, -2.0):
        found = bars.assemble({"A": crank}, branch={"D": "+" if side > 0 else "-"})
        expected = four_bar_angles(crank, side)
        assert found["A"] == crank
        away = [math.remainder(found[name] - expected[name], 2 * math.pi) for name in "BD"]
        np.testing.assert_allclose(away, 0, **EXACT)
        assert found.solutions == 2
        assert found.freedoms == 0
        assert max(found.gaps["C"]) < 1e-15


def test_the_position_next_to_the_start_is_taken(bars: cd.CompiledModel) -> None:
    for side in (1, -1):
        near = four_bar_angles(1.0, side)
        start = {name: near[name] + 0.1 for name in "ABD"}
        found = bars.assemble({"A": 1.0}, start=start)
        np.testing.assert_allclose(
            [found[n] for n in "ABD"], [near[n] for n in "ABD"], rtol=0, atol=1e-12
        )


def test_without_targets_something_near_the_default(bars: cd.CompiledModel) -> None:
    found = bars.assemble()
    assert np.abs(bars.constraints(found.q)).max() < 1e-15
    assert found.solutions is None
    assert found.freedoms == 1
    assert "one of many positions" in repr(found)


def test_speeds_and_accelerations_are_consistent(bars: cd.CompiledModel) -> None:
    found = bars.assemble({"A": 0.7}, u={"A": 5.0}, udot={"A": -3.0}, branch={"D": "+"})
    assert found["A.u"] == 5.0
    assert found.udot is not None
    assert found.udot[0] == -3.0
    np.testing.assert_allclose(bars.constraint_rates(found.q, found.u), 0, atol=1e-14)
    # against differences of positions along s(t) = 0.7 + 5 t - 1.5 t^2, of sixth order
    h, weights = 1e-3, {1: 3 / 4, 2: -3 / 20, 3: 1 / 60}

    def rocker(t: float) -> float:
        return four_bar_angles(0.7 + 5 * t - 1.5 * t**2)["D"]

    rate = sum(w * (rocker(k * h) - rocker(-k * h)) for k, w in weights.items()) / h
    assert found["D.u"] == pytest.approx(rate, rel=1e-10)
    second = {1: 3 / 2, 2: -3 / 20, 3: 1 / 90}
    bend = sum(w * (rocker(k * h) + rocker(-k * h) - 2 * rocker(0)) for k, w in second.items())
    assert found.udot[bars.speeds.index("D.u")] == pytest.approx(bend / h**2, rel=1e-8)
    # without given ones: the accelerations under gravity, speeds of least energy
    rest = bars.assemble({"A": 0.7}, branch={"D": "+"})
    assert rest.udot is not None
    assert not rest.u.any()
    np.testing.assert_array_equal(rest.udot, bars.forward_dynamics(rest.q, rest.u))


def test_a_frame_is_brought_to_its_place(bars: cd.CompiledModel) -> None:
    goal = bars.pose("C.parent", bars.assemble({"A": 1.2}, branch={"D": "+"}).q)
    for target in (goal, goal[:3, 3]):
        found = bars.assemble({"C.parent": target}, branch={"D": "+"})
        np.testing.assert_allclose(bars.pose("C.parent", found.q)[:3, 3], goal[:3, 3], **EXACT)
        assert not found.unreached


def test_what_cannot_be_reached_is_approached(bars: cd.CompiledModel) -> None:
    # the rocker's tip is 0.2 m from its pivot: the nearest point of its circle is on the ray
    pivot = np.array([FOUR_BAR["ground"], 0, 0])
    goal = pivot + 0.35 * np.array([math.cos(1.9), math.sin(1.9), 0])
    found = bars.assemble({"C.parent": goal}, weights={"C.parent": 1.0})
    reached = bars.pose("C.parent", found.q)[:3, 3]
    ray = (goal - pivot) / np.linalg.norm(goal - pivot)
    np.testing.assert_allclose(reached, pivot + 0.2 * ray, rtol=0, atol=1e-9)
    assert "0.15 m away" in found.unreached["C.parent"]
    assert "target 'C.parent' not reached" in repr(found)


def test_inverse_kinematics_of_a_parallel_robot(platform: cd.CompiledModel) -> None:
    """Any pose of a Stewart platform: six legs follow from it."""
    known = stewart_coordinates(0.3)
    slots = {row["joint"] for row in platform.manifest["coordinates"]}
    named = {joint: value for joint, value in known.items() if joint in slots}
    q = platform.initial(q=named)[: platform.nq]
    goal = platform.pose("platform", q)
    start = {joint: value for joint, value in stewart_coordinates(0.0).items() if joint in slots}
    found = platform.assemble({"platform": goal}, start=start, starts=4)
    np.testing.assert_allclose(platform.pose("platform", found.q), goal, **EXACT)
    np.testing.assert_allclose(found.q, q, rtol=0, atol=1e-11)
    assert found.freedoms == 0


def test_inverse_kinematics_of_a_tree() -> None:
    scene = cd.Scene("arm")
    a = scene.body("a", mass=1.0, com=(0.5, 0, 0), inertia=(0.01, 0.1, 0.1))
    b = scene.body("b", mass=1.0, com=(0.4, 0, 0), inertia=(0.01, 0.1, 0.1))
    scene.joint("first", cd.Revolute("z"), scene.ground, a)
    scene.joint("second", cd.Revolute("z"), a.at(1, 0, 0), b)
    model = cd.compile(scene)
    found = model.assemble({"b": (0.6, 0.8, 0.0)})
    np.testing.assert_allclose(model.pose("b", found.q)[:3, 3], [0.6, 0.8, 0], **EXACT)
    assert found["first"] == pytest.approx(math.atan2(0.8, 0.6), abs=1e-12)
    assert found.gaps == {}


def test_prescribed_joints_take_their_time() -> None:
    model = cd.compile(driven_four_bar())
    for t in (0.0, 0.4):
        found = model.assemble(t=t, branch={"D": "+"})
        expected = four_bar_angles(1 + 2 * t)
        away = math.remainder(found["D"] - expected["D"], 2 * math.pi)
        assert away == pytest.approx(0, abs=1e-12)
        # the drive turns at 2 rad/s, and the rest with it
        near = [four_bar_angles(1 + 2 * (t + sign * 1e-5))["D"] for sign in (1, -1)]
        slope = (near[0] - near[1]) / 2e-5
        assert found["D.u"] == pytest.approx(slope, rel=1e-8)


# what cannot be


def test_a_circuit_that_cannot_be_assembled() -> None:
    model = cd.compile(four_bar(ground=1.0))
    said = (
        r"loop that joint 'C' closes \('A', 'B', 'D'\) cannot be assembled: the least residual "
        r"found is 0\.45 m, between frames 'C.parent' and .*16 starts"
    )
    with pytest.raises(cd.ModelError, match=said):
        model.assemble()
    with pytest.raises(cd.ModelError, match=r"least residual found is 0\.45 m"):
        model.simulate(1.0)


def test_targets_in_conflict(bars: cd.CompiledModel) -> None:
    said = r"'A' \(asked 1; reached .*\) and 'D' \(asked 2\.5; reached .*\) are inconsistent"
    with pytest.raises(cd.ModelError, match=said):
        bars.assemble({"A": 1.0, "D": 2.5})
    # one of them alone is out of reach; the other is not blamed
    with pytest.raises(cd.ModelError, match=r"'D' \(asked 1; reached .*\) is out of reach") as one:
        bars.assemble({"A": 1.0, "D": 1.0})
    assert "'A'" not in str(one.value).partition(". ")[0]


def test_a_branch_that_does_not_exist(bars: cd.CompiledModel) -> None:
    said = r"has 'D' between 0 and 1\. 2 positions were found, with D = -?\d.*; D = -?\d"
    with pytest.raises(cd.ModelError, match=said):
        bars.assemble({"A": 1.0}, branch={"D": (0, 1)})
    crank = cd.compile(slider_crank())
    with pytest.raises(cd.ModelError, match=r"no assembled position has 'guide' > 0\.5|between"):
        crank.assemble({"A": 1.0}, branch={"guide": (0.5, 1)})


def test_speeds_that_cannot_hold_together(bars: cd.CompiledModel) -> None:
    said = r"speeds of 'A', 'D' are inconsistent: joint 'C' would come apart .* 'C\.p"
    with pytest.raises(cd.ModelError, match=said):
        bars.assemble({"A": 1.0}, u={"A": 1.0, "D": 1.0})
    with pytest.raises(cd.ModelError, match=r"accelerations of 'A', 'D' are inconsistent"):
        bars.assemble({"A": 1.0}, udot={"A": 1.0, "D": 1.0})


def test_mistakes(bars: cd.CompiledModel) -> None:
    cases = [
        (cd.ModelError, "no joint or coordinate 'E'", ({"E": 1.0},), {}),
        (cd.ModelError, "weights: 'B' is not a target", ({"A": 1.0},), {"weights": {"B": 1}}),
        (cd.ModelError, "weights are positive", ({"A": 1.0},), {"weights": {"A": -1}}),
        (cd.ArgumentError, "give numbers by name", ({"A": 1.0},), {"weights": {"A": "x"}}),
        (cd.ArgumentError, "weights=3: give numbers by name", ({"A": 1.0},), {"weights": 3}),
        (cd.ModelError, "locked: 'B' is not a target", ({"A": 1.0},), {"locked": ["B"]}),
        (cd.ModelError, "locked: 'B' is not a target", ({"A": 1.0},), {"locked": "B"}),
        (cd.ArgumentError, "locked=3: give a list of names", ({"A": 1.0},), {"locked": 3}),
        (
            cd.ArgumentError,
            "starts=0: give a whole number of at least 1",
            ({"A": 1.0},),
            {"starts": 0},
        ),
        (cd.ModelError, "no coordinate 'C'", ({"A": 1.0},), {"branch": {"C": "+"}}),
        (cd.ModelError, r"u=\{'C': ...\}", ({"A": 1.0},), {"u": {"C": 1.0}}),
        (cd.ArgumentError, r"give '\+', '-' or", ({"A": 1.0},), {"branch": {"D": "up"}}),
        (cd.ArgumentError, "2 values, expected 1: A", ({"A": [1.0, 2.0]},), {}),
        (cd.ArgumentError, "not a number", ({"A": "one"},), {}),
        (cd.ArgumentError, "takes its position", ({"C.parent": [1.0, 2.0]},), {}),
        (cd.ArgumentError, "this is not a pose", ({"C.parent": np.zeros((4, 4))},), {}),
        (cd.SolveError, "must be finite", ({"A": math.nan},), {}),
        (cd.SolveError, "must be finite", ({"A": 1.0},), {"u": {"A": math.inf}}),
    ]
    for kind, said, positional, named in cases:
        with pytest.raises(kind, match=said):
            bars.assemble(*positional, **named)


def driven_four_bar() -> cd.Scene:
    """The four-bar with its crank moved at 2 rad/s from an angle of 1."""
    scene = cd.Scene("driven", gravity=(0, 0, 0))
    bodies = {}
    for name in ("crank", "coupler", "rocker"):
        length = FOUR_BAR[name]
        inertia = cd.inertia.box(length, length, 0.02, 0.01)
        bodies[name] = scene.body(name, mass=length, com=(length / 2, 0, 0), inertia=inertia)
    a, b, c = bodies.values()
    turn, ground = cd.Revolute("z"), scene.ground
    scene.joint("A", turn, ground, a, prescribed=1 + 2 * cd.t)
    scene.joint("B", turn, a.at(FOUR_BAR["crank"], 0, 0), b)
    scene.joint("D", turn, ground.at(FOUR_BAR["ground"], 0, 0), c)
    scene.joint("C", turn, b.at(FOUR_BAR["coupler"], 0, 0), c.at(FOUR_BAR["rocker"], 0, 0))
    return scene


def test_named_angles_stay_beyond_half_a_turn(bars: cd.CompiledModel) -> None:
    for angle in (3.5, -4.0, 7.0):
        assert bars.assemble({"A": angle}, branch={"D": "+"})["A"] == angle
