"""Paths of positions of mechanisms against closed forms: dead points and what drives."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from cardan.errors import ArgumentError, ModelError
from mechanisms.change_points import POINT, TURN, kinds, linkage, turns, two_arms
from mechanisms.closed_planar import (
    FOUR_BAR,
    four_bar,
    four_bar_angles,
    slider_crank,
    slider_crank_coordinates,
)
from mechanisms.closed_spatial import bricard, bricard_angles
from mechanisms.overconstrained import bennett, bennett_angles

EXACT = 1e-9


# of rigid longerons of length b on a radius r, and elastic diagonals of stiffness k; the slope by
# the series of the closed form
LOAD, SLOPE = 3188.9763779527566, -8578.7738747690014
LIMITS = ((-1.709319385621514, 18703.387035128068), (0.7895296517370188, -445.90001645966066))
FOLDED = (
    (0.08726646259971647, 0.9996574641628573, 2472.4267100368743),
    (0.17453292519943295, 0.9986317617331212, 1823.602569263077),
    (0.3490658503988659, 0.9945575256069723, 748.7527031214021),
    (0.6981317007977318, 0.9787175280750907, -392.0577556760856),
    (0.8726646259971648, 0.9673167887220696, -400.4145124939492),
    (1.0122909661567112, 0.9567577893918486, -113.97461014370263),
)


def test_a_bay_of_rigid_longerons_buckles_and_folds() -> None:
    """V = 3 k (d - d0)^2 / 2 over h^2 + 2 r^2 (1 - cos phi) = b^2; F = -V' / h'."""
    r, b, k = 0.3, 1.0, 20000.0
    scene = cd.Scene("bay", gravity=(0, 0, 0))
    load, lift = scene.parameter("F", 0.0), scene.body("lift", **POINT)
    top = scene.body("top", **POINT)
    scene.joint("h", cd.Prismatic("z"), scene.ground, lift, q0=b)
    scene.joint("phi", cd.Revolute("z"), lift, top)
    h, phi = scene.q("h"), scene.q("phi")
    scene.constraint("longerons", h**2 + 2 * r**2 * (1 - sp.cos(phi)) - b**2, unit="m^2")
    third, length = TURN / 3, math.sqrt(b**2 + 3 * r**2)
    for n in range(3):
        low, high = n * third, (n + 1) * third
        scene.force(
            f"diagonal{n}",
            cd.SpringDamper(
                scene.ground.at(r * math.cos(low), r * math.sin(low), 0),
                top.at(r * math.cos(high), r * math.sin(high), 0),
                stiffness=k,
                rest_length=length,
            ),
        )
    scene.force("load", cd.Force(top, (0, 0, -1 * load)))
    path = cd.compile(scene).continuation(
        F=(0, 20000.0), branches=1, bounds={"phi": (-1.9, 1.03)}, events={"phi": FOLDED[0][0]}
    )
    point = path.point("branch point 1")
    assert point.values["F"] == pytest.approx(LOAD, rel=1e-8)
    column = path.model.speeds.index("phi.u")
    for tangent in point.tangents:
        assert tangent[-1] * 20000 / tangent[column] == pytest.approx(SLOPE, rel=1e-9)
    special = [p for name in ("1a", "1b") for p in path.branches[name].points]
    for angle, force in LIMITS:
        (fold,) = (p for p in special if p.kind == "fold" and abs(p["phi"] - angle) < 0.1)
        assert fold["phi"] == pytest.approx(angle, abs=1e-8)
        assert fold.values["F"] == pytest.approx(force, rel=1e-8)
    (event,) = (p for p in special if p.name.startswith("phi = 0.087"))
    assert (event["h"], event["F"]) == pytest.approx(FOLDED[0][1:], rel=1e-8)
    model = path.model
    for angle, height, force in FOLDED:
        begin = {"h": height, "phi": angle}
        prescribed = model.continuation(locked={"phi": (angle, angle - 0.05)}, q=begin)
        assert prescribed["h"][0] == pytest.approx(height, rel=1e-8)
        slope = -(r**2) * math.sin(angle) / height
        assert prescribed["phi.holding_force"][0] / slope == pytest.approx(-force, rel=1e-8)


def test_dead_points_of_a_slider_crank() -> None:
    """The slider stands still where crank and rod lie on one line: at l + r and l - r."""
    begin = slider_crank_coordinates(0.5)
    model = cd.compile(slider_crank())
    begin = {name: begin[name] for name in model.coordinates}
    path = model.continuation(guide=(begin["guide"], 0.5), of="positions", q=begin)
    assert path.main.status == "closed"
    values = [point.values["guide"] for point in path.points]
    np.testing.assert_allclose(values, [0.4, 0.2], atol=EXACT)
    np.testing.assert_allclose(turns([point["A"] for point in path.points]), [0, -math.pi])


@pytest.mark.parametrize("end", [4.0, -4.0])
def test_dead_points_of_a_rocker(end: float) -> None:
    """Driven at the rocker: triangles with sides b + a and b - a."""
    model = cd.compile(four_bar())
    path = model.continuation(D=(2.0, end), of="positions", q={"A": 0.5, "B": -0.1, "D": 2.0})
    a, b, c, d = (FOUR_BAR[name] for name in ("crank", "coupler", "rocker", "ground"))
    wanted = [math.pi - math.acos((d**2 + c**2 - s**2) / (2 * d * c)) for s in (b + a, b - a)]
    wanted = wanted[::-1] if end > 0 else wanted
    np.testing.assert_allclose([p["D"] for p in path.points], wanted, atol=EXACT)
    assert kinds(path) == ["fold", "fold"]
    # a full turn of the crank
    assert path.main.status == "closed"
    assert abs(path["A"][-1] - path["A"][0]) == pytest.approx(TURN, abs=0.3)


def test_an_overconstrained_loop() -> None:
    """G. T. Bennett (1903): five conditions, two of which are independent."""
    model = cd.compile(bennett())
    begin = {name: bennett_angles(0.5)[name] for name in model.coordinates}
    path = model.continuation(j0=(0.5, 0.5 + TURN), of="positions", q=begin, branches=True)
    assert kinds(path) == ["event"]
    family = path.main.solutions.family
    assert family.drivers.solver(0.0).record.hard > family.positions
    for k in range(len(path)):
        angles = bennett_angles(path["j0"][k])
        for name in model.coordinates:
            assert turns(path[name][k] - angles[name]) == pytest.approx(0, abs=EXACT)
    assert path["j0"][-1] == pytest.approx(0.5 + TURN)


def test_a_bricard_linkage_turns_back() -> None:
    """Six revolutes at right angles (R. Bricard, 1927): one condition is redundant."""
    model = cd.compile(bricard())
    begin = {name: bricard_angles(0.3)[name] for name in model.coordinates}
    path = model.continuation(J0=(begin["J0"], 7.0), of="positions", q=begin)
    assert path.main.status == "closed"
    # sin(J1) = -sin(J0) / (1 + sin(J0)) ends at sin(J0) = -1/2
    ends = [point["J0"] for point in path.points]
    np.testing.assert_allclose(ends, [7 * math.pi / 6, -math.pi / 6], atol=EXACT)
    assert kinds(path) == ["fold", "fold"]


@pytest.mark.parametrize("driver", ["input", "time"])
def test_an_input_or_the_time_drives(driver: str) -> None:
    scene = cd.Scene("prescribed", gravity=(0, 0, 0))
    a, b, c = (scene.body(name, **POINT) for name in ("crank", "coupler", "rocker"))
    turn, ground = cd.Revolute("z"), scene.ground
    angle = scene.input("angle") if driver == "input" else 2 * cd.t
    scene.joint("A", turn, ground, a, prescribed=angle)
    scene.joint("B", turn, a.at(FOUR_BAR["crank"], 0, 0), b)
    scene.joint("D", turn, ground.at(FOUR_BAR["ground"], 0, 0), c)
    scene.joint("C", turn, b.at(FOUR_BAR["coupler"], 0, 0), c.at(FOUR_BAR["rocker"], 0, 0))
    model = cd.compile(scene)
    begin = {"B": 0.0, "D": 1.6}
    swept = {"angle": (0.5, 3.0)} if driver == "input" else {"t": (0.25, 1.5)}
    path = model.continuation(swept, of="positions", q=begin)
    angles = path["angle"] if driver == "input" else 2 * path["t"]
    for angle, follower in zip(angles, path["D"], strict=True):
        assert turns(four_bar_angles(angle)["D"] - follower) == pytest.approx(0, abs=EXACT)


def test_a_position_starts_a_run() -> None:
    model = cd.compile(four_bar())
    path = model.continuation(A=(0.5, 3.0), of="positions", q={"A": 0.5, "D": 1.8})
    position = path[-1]
    motion = model.simulate(0.01, x0=position)
    np.testing.assert_allclose(motion.q[0], path.main.q[-1], atol=EXACT)
    np.testing.assert_array_equal(model.simulate(0.01, q=position.q).q[0], motion.q[0])
    assert path.main.stable == [None] * len(path)
    assert path.main.n_negative.max() == -1


def test_two_freedoms_and_two_drivers() -> None:
    scene = cd.Scene("five", gravity=(0, 0, 0))
    one, two, three, four = (scene.body(name, **POINT) for name in "abcd")
    turn = cd.Revolute("z")
    scene.joint("left", turn, scene.ground, one)
    scene.joint("J2", turn, one.at(1, 0, 0), two)
    scene.joint("right", turn, scene.ground.at(1, 0, 0), three)
    scene.joint("J4", turn, three.at(1, 0, 0), four)
    scene.joint("J5", turn, two.at(1.2, 0, 0), four.at(1.2, 0, 0))
    model = cd.compile(scene)
    with pytest.raises(ModelError, match=r"has 2 freedoms .* locked=.*among left, J2, right, J4"):
        model.continuation(left=(1.5, 2.5), of="positions")
    both = model.continuation(left=(1.5, 2.5), right=(1.2, 2.2), of="positions")
    np.testing.assert_allclose(both["left"] - both["right"], 0.3, atol=EXACT)
    # the other crank is locked: its tip is within 2.4 of that of the first
    path = model.continuation(left=(1.5, 4.0), locked={"right": 1.2}, of="positions")
    np.testing.assert_allclose(path["right"], 1.2, atol=EXACT)
    assert kinds(path) == ["fold", "fold"]
    for fold in path.points:
        away = np.exp(1j * fold["left"]) - 1 - np.exp(1.2j)
        assert abs(away) == pytest.approx(2.4, abs=EXACT)


@pytest.mark.parametrize(
    ("call", "kind", "message"),
    [
        (lambda m: m.continuation(of="positions"), ModelError, "say what is swept"),
        (lambda m: m.continuation(AA=(0, 1), of="positions"), ModelError, "Did you mean 'A'"),
        (lambda m: m.continuation(A=(0, 1), of="position"), ModelError, "Did you mean 'positions'"),
        (lambda m: m.continuation(A=(1, 1), of="positions"), ArgumentError, "two different"),
        (lambda m: m.continuation(A=(0, 1, 2), of="positions"), ArgumentError, "two different"),
        (
            lambda m: m.continuation(A=(0.4, 1), of="positions", locked={"E": 1}),
            ModelError,
            "there is no joint or coordinate 'E'",
        ),
        (
            lambda m: m.continuation(L=(1, 2), of="positions", locked={"A": 0.4, "D": 0.4}),
            ModelError,
            "determine the whole position",
        ),
        (
            lambda m: m.continuation(A=(0.4, 1), of="positions", until={"E": 1}, q={"D": 0.4}),
            ModelError,
            "there is no 'E' to watch",
        ),
    ],
)
def test_nonsense_is_refused(
    call: Callable[[Any], Any], kind: type[Exception], message: str
) -> None:
    with pytest.raises(kind, match=message):
        call(linkage(1.0, 2.0, 1.0, 2.0))


def test_models_without_loops_to_follow_are_refused() -> None:
    solved = cd.compile(four_bar(), constraints="closed_form")
    with pytest.raises(ModelError, match="solves loops in closed form"):
        solved.continuation(A=(0, 1), of="positions")
    nodes = cd.compile(four_bar(), coordinates="absolute")
    with pytest.raises(ModelError, match="in absolute coordinates"):
        nodes.continuation(A=(0, 1), of="positions")


def test_picture(tmp_path: Path) -> None:
    path = two_arms(1.0).continuation(
        s=(0.4, -2), of="positions", branches=True, q={"theta": 1.3, "elbow": -2.6}
    )
    figure = path.plot("s", "theta", tmp_path / "arms.svg")
    (axis,) = figure.axes
    lines = [line for line in axis.lines if len(line.get_xdata()) > 1]
    assert {line.get_linestyle() for line in lines} == {"-"}


def test_a_robot_whose_hand_stays_where_it_is() -> None:
    """Three links of 1 m: the first turns back where the others are in line, 2 m long."""
    scene = cd.Scene("arm", gravity=(0, 0, 0))
    last: Any = scene.ground
    for k in range(3):
        link = scene.body(f"link{k}", **POINT)
        scene.joint(f"J{k}", cd.Revolute("z"), last, link)
        last = link.at(1, 0, 0)
    scene.joint("wrist", cd.Fixed(), last, scene.body("hand", **POINT))
    path = cd.compile(scene).continuation(
        J0=(0.3, 5.0),
        locked={"hand": (1.5, 0, 0)},
        of="positions",
        q={"J0": 0.3, "J1": 0.5, "J2": -1.5},
    )
    assert path.main.status == "closed"
    limit = math.acos((1 + 1.5**2 - 4) / 3)
    np.testing.assert_allclose([p["J0"] for p in path.points], [limit, -limit], atol=EXACT)
    hands = path.model.pose("hand", path.main.q)[:, :3, 3]
    np.testing.assert_allclose(hands, np.tile([1.5, 0, 0], (len(path), 1)), atol=EXACT)
