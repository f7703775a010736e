"""Algebraic problems of stability with exact solutions: all branches, and how they leave."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from cardan.errors import ModelError

POINT = {"mass": 1.0, "inertia": (1.0, 1.0, 1.0)}
EXACT = 1e-10


def augusti(k2: float) -> cd.CompiledModel:
    """G. Augusti's column: V = (a1^2 + k2 a2^2) / 2 - P (1 - sqrt(1 - sin^2 a1 - sin^2 a2))."""
    scene = cd.Scene("augusti", gravity=(0, 0, 0))
    load = scene.parameter("P", 0.0)
    for name in ("a1", "a2"):
        body = scene.body(f"{name}_body", **POINT)
        scene.joint(name, cd.Revolute("y"), scene.ground, body)
    angles = [scene.q(name) for name in ("a1", "a2")]
    root = sp.sqrt(1 - sp.sin(angles[0]) ** 2 - sp.sin(angles[1]) ** 2)
    for name, x, k in zip(("a1", "a2"), angles, (1.0, k2), strict=True):
        push = load * sp.sin(x) * sp.cos(x) / root
        scene.force(f"{name}_force", cd.JointForce(name, push - k * x))
    return cd.compile(scene)


def coupled(a: float) -> float:
    """P of the branches on which both angles have one size."""
    return a * np.sqrt(np.cos(2 * a)) / (np.sin(a) * np.cos(a))


def test_eight_branches_leave_augustis_point() -> None:
    limits = dict.fromkeys(("a1", "a2"), (-0.5, 0.5))
    path = augusti(1.0).continuation(P=(0, 1.5), branches=1, bounds=limits)
    point = path.point("branch point 1")
    assert point["P"] == pytest.approx(1.0, abs=EXACT)
    assert len(point.branches) == 8
    kinds = set[tuple[float, float]]()
    for name in point.branches:
        branch = path.branches[name]
        a1, a2, load = branch["a1"][-1], branch["a2"][-1], branch["P"][-1]
        kinds.add((round(a1, 6), round(a2, 6)))
        both = abs(a1) > 1e-6 and abs(a2) > 1e-6
        wanted = coupled(0.5) if both else 0.5 / np.sin(0.5)
        assert load == pytest.approx(wanted, abs=EXACT)
        assert not any(branch.stable[1:])
    ends = {(x, y) for x in (-0.5, 0.0, 0.5) for y in (-0.5, 0.0, 0.5)} - {(0.0, 0.0)}
    assert kinds == ends
    for name, (a, b) in point.postbuckling("a1").items():
        both = abs(path.branches[name]["a2"][-1]) > 1e-6
        if np.isnan(a):
            assert abs(path.branches[name]["a1"][-1]) < 1e-6
            continue
        assert a == pytest.approx(0.0, abs=1e-9)
        assert b == pytest.approx(-1 / 3 if both else 1 / 6, rel=1e-6)


def test_near_points_lead_to_a_secondary_branch() -> None:
    """2 a1 / sin 2 a1 = k2 at the point; values of the branch by its second angle."""
    limits = dict.fromkeys(("a1", "a2"), (-0.45, 0.45))
    seconds = {
        0.05: (0.17907134229840385, 1.0040668486576352),
        0.2: (0.2631885811110073, 0.9899933210242625),
        0.4: (0.43393080693355807, 0.9321917388654245),
    }
    path = augusti(1.02).continuation(P=(0, 1.5), branches=2, bounds=limits)
    loads = [point["P"] for point in path.points if point.kind == "branch point"]
    np.testing.assert_allclose(loads, [1.0, 1.02], atol=EXACT)
    (name,) = (n for n, b in path.branches.items() if n in ("1a", "1b") and b["a1"][-1] > 0)
    second = path.branches[name].points[0]
    assert second["a1"] == pytest.approx(0.17200680958902514, abs=1e-9)
    assert second["P"] == pytest.approx(1.0049481310777237, abs=EXACT)
    # none twice: 1 + 4 + 4
    assert len(path.branches) == 9
    start = path.branches[second.branches[0]]
    side = float(np.sign(start["a2"][-1]))
    for a2, (a1, load) in seconds.items():
        again = augusti(1.02).continuation(
            P=(start["P"][1], 0.9), q=start[1].q, until={"a2": side * a2}
        )
        assert again["a1"][-1] == pytest.approx(a1, abs=1e-9)
        assert again["P"][-1] == pytest.approx(load, abs=EXACT)


def test_slope_of_the_inclined_spring() -> None:
    """W. T. Koiter (1945): dP / dt = -3 k L / 8 where P = k L / 2, in two sets of units."""
    for L, k in ((1.0, 1.0), (1.4, 3.0)):
        scene = cd.Scene("bar", gravity=(0, 0, 0))
        load, body = scene.parameter("P", 0.0), scene.body("bar", **POINT)
        scene.joint("theta", cd.Revolute("y"), scene.ground, body)
        spring = cd.SpringDamper(
            scene.ground.at(-L, 0, 0), body.at(0, 0, L), stiffness=k, rest_length=L * 2**0.5
        )
        scene.force("spring", spring)
        scene.force("load", cd.Force(body.at(0, 0, L), (0, 0, -1 * load)))
        path = cd.compile(scene).continuation(
            P=(0, 2 * k * L), branches=1, bounds={"theta": (-1.25, 1.25)}
        )
        point = path.point("branch point 1")
        for a, _ in point.postbuckling("theta").values():
            assert a * point["P"] == pytest.approx(-3 * k * L / 8, rel=1e-6)
        for name in point.branches:
            t = path.branches[name]["theta"][1:]
            wanted = k * L / np.tan(t) * (1 - 1 / np.sqrt(1 + np.sin(t)))
            np.testing.assert_allclose(path.branches[name]["P"][1:], wanted, atol=EXACT * k * L)


def test_coefficients_are_parts_of_a_load() -> None:
    """x'' = mu x - x^3 branches at mu = 0."""
    scene = cd.Scene("pitchfork", gravity=(0, 0, 0))
    mu = scene.parameter("mu", -0.5)
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("body", **POINT))
    scene.force("force", cd.JointForce("x", mu * scene.q("x") - scene.q("x") ** 3))
    point = cd.compile(scene).continuation(mu=(-0.5, 0.5)).point("branch point 1")
    with pytest.raises(ModelError, match=r"'mu' is 0 at the point"):
        point.postbuckling("x")


def three_bars(e: float) -> cd.CompiledModel:
    """Two bars between supports at -1 and 1 and an apex at e; a spring from there to the load."""
    scene = cd.Scene("three_bars", gravity=(0, 0, 0))
    rise, k, load = 0.3, 0.02, scene.parameter("P", 0.0)
    slide, apex, top = (scene.body(name, **POINT) for name in ("slide", "apex", "top"))
    scene.joint("u", cd.Prismatic("x"), scene.ground.at(e, 0, rise), slide)
    scene.joint("w", cd.Prismatic("-z"), slide, apex)
    scene.joint("v", cd.Prismatic("-z"), scene.ground.at(e, 0, rise), top)
    for name, x in (("left", -1.0), ("right", 1.0)):
        length = float(np.hypot(e - x, rise))
        bar = cd.SpringDamper(
            scene.ground.at(x, 0, 0), apex, stiffness=1 / length, rest_length=length
        )
        scene.force(name, bar)
    difference = scene.q("v") - scene.q("w")
    scene.force("spring_v", cd.JointForce("v", load - k * difference))
    scene.force("spring_w", cd.JointForce("w", k * difference))
    return cd.compile(scene)


# imperfection -> v and P at the first limit load; the second one lies opposite
LIMITS = {
    0.0: (0.6058029524552762, 0.009530291997895426),
    0.01: (0.6058860960581346, 0.009531967689482503),
    0.05: (0.6078877344892046, 0.009572309634869575),
}


@pytest.mark.parametrize("e", LIMITS)
def test_three_bars_snap_back(e: float) -> None:
    path = three_bars(e).continuation(P=(0, 0.02))
    folds = [point for point in path.points if point.kind == "fold"]
    v, load = LIMITS[e]
    for point, wanted in zip(folds, ((v, load), (0.6 - v, -load)), strict=True):
        assert point["P"] == pytest.approx(wanted[1], abs=1e-10)
        assert point["v"] == pytest.approx(wanted[0], abs=1e-7)
    # the load point turns back twice as well
    turns = np.sign(np.diff(path["v"]))
    assert np.sum(turns[1:] != turns[:-1]) == 2
    assert len(path) < 100


@pytest.mark.parametrize("rise", [0.4, 3.0, 5.0])
def test_truss_of_von_mises(rise: float) -> None:
    """l^3 = l0 at the limit load; l^3 - l0 l^2 + l0 = 0 where a steep one sways, exact beyond."""
    scene = cd.Scene("truss", gravity=(0, 0, 0))
    load, length = scene.parameter("P", 0.0), float(np.hypot(1.0, rise))
    slide, apex = scene.body("slide", **POINT), scene.body("apex", **POINT)
    scene.joint("u", cd.Prismatic("x"), scene.ground.at(0, 0, rise), slide)
    scene.joint("w", cd.Prismatic("-z"), slide, apex)
    for name, x in (("left", -1.0), ("right", 1.0)):
        bar = cd.SpringDamper(
            scene.ground.at(x, 0, 0), apex, stiffness=1 / length, rest_length=length
        )
        scene.force(name, bar)
    scene.force("load", cd.Force(apex, (0, 0, -1 * load)))
    path = cd.compile(scene).continuation(P=(0, 2), branches=1)

    def borne(l: float) -> float:
        return 2 * np.sqrt(l**2 - 1) * (1 / l - 1 / length)

    limit = path.point("fold 1")
    assert limit["P"] == pytest.approx(borne(length ** (1 / 3)), abs=EXACT)
    points = [point for point in path.points if point.kind == "branch point"]
    if rise < 1:
        assert not points
        return
    sway = max(root.real for root in np.roots([1, -length, 0, length]))
    assert points[0]["P"] == pytest.approx(borne(sway), abs=EXACT)
    # the other half leads back to this one, and is not followed twice
    for name in {*points[0].branches} & {*path.branches}:
        branch = path.branches[name]
        u, z = branch["u"], rise - branch["w"]
        bars = np.hypot(1 + u, z), np.hypot(1 - u, z)
        s, p = bars[0] + bars[1], bars[0] * bars[1]
        wanted = length * (s**2 - 4) / (2 * s)
        away = np.abs(u) > 1e-3
        np.testing.assert_allclose(p[away], wanted[away], atol=1e-9)
        np.testing.assert_allclose(branch["P"][away], ((s / p - 2 / length) * z)[away], atol=1e-9)


def test_an_imperfection_cuts_a_branch_off() -> None:
    """P = 2 (t - t0) / sin t; the other side is not connected, and turns at tan t = t - t0."""
    imperfection = 0.02
    scene = cd.Scene("two_links", gravity=(0, 0, 0))
    one, two, end = (scene.body(name, **POINT) for name in ("one", "two", "end"))
    scene.joint("theta", cd.Revolute("z"), scene.ground, one)
    scene.joint("middle", cd.Revolute("z"), one.at(1, 0, 0), two)
    scene.joint("pin", cd.Revolute("z"), two.at(1, 0, 0), end)
    scene.joint("slide", cd.Prismatic("x"), scene.ground, end)
    spring = -(scene.q("middle") + 2 * imperfection)
    scene.force("spring", cd.JointForce("middle", spring))
    scene.force("load", cd.Force(end, (-1 * scene.parameter("P", 0.0), 0, 0)))
    model = cd.compile(scene)
    limits = {"theta": (-2.5, 2.5)}
    path = model.continuation(P=(0, 4), q={"theta": imperfection}, search=1, bounds=limits)
    assert [*path.branches] == ["main", "other 1.1a"]
    for branch in path.branches.values():
        t = branch["theta"]
        np.testing.assert_allclose(branch["P"] * np.sin(t), 2 * (t - imperfection), atol=EXACT)
    assert path["theta"].min() > 0
    other = path.branches["other 1.1a"]
    assert other["theta"].max() < 0
    (fold,) = (point for point in other.points if point.kind == "fold")
    turn = fold["theta"]
    assert np.tan(turn) == pytest.approx(turn - imperfection, abs=1e-7)
    assert fold["P"] == pytest.approx(2 / np.cos(turn), abs=EXACT)


@pytest.mark.parametrize("coordinates", ["relative", "absolute"])
def test_a_governor_lifts_its_rod(coordinates: str) -> None:
    """J. Watt's: cos tilt = g / (l w^2) above w = sqrt(g / l), where hanging is unstable."""
    gravity, length = 9.81, 0.5
    scene = cd.Scene("governor", gravity=(0, 0, -gravity))
    post = scene.body("post", mass=1.0, inertia=(1.0,) * 3)
    rod = scene.body("rod", mass=2.0, com=(0, 0, -length), inertia=(0.0,) * 3)
    scene.joint("turn", cd.Revolute("z"), scene.ground, post)
    scene.joint("tilt", cd.Revolute("y"), post, rod)
    model = cd.compile(scene, coordinates=coordinates)
    path = model.continuation(u={"turn": (0, 10)}, branches=1)
    point = path.point("branch point 1")
    critical = np.sqrt(gravity / length)
    assert point["tilt"] == pytest.approx(0.0, abs=1e-9)
    assert point["turn"] == pytest.approx(critical, rel=1e-10)
    assert path.main.stable == [bool(w < critical) for w in path["turn"]]
    for name in point.branches:
        branch = path.branches[name]
        speed = branch["turn"]
        np.testing.assert_allclose(np.cos(branch["tilt"]) * length * speed**2, gravity, rtol=1e-9)
        assert all(branch.stable)
