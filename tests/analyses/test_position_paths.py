"""Paths of positions of mechanisms against closed forms: dead points, and branches that meet."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from cardan.errors import ArgumentError, ModelError
from mechanisms.closed_planar import FOUR_BAR, four_bar, slider_crank, slider_crank_coordinates
from mechanisms.overconstrained import bennett, bennett_angles

POINT = {"mass": 1.0, "inertia": (1.0, 1.0, 1.0)}
TURN = 2 * math.pi
EXACT = 1e-9


def linkage(
    crank: float, coupler: float, rocker: float, ground: float, unit: float = 1.0
) -> cd.CompiledModel:
    """Four bars with the length of the rocker as a parameter L."""
    scene = cd.Scene("linkage", gravity=(0, 0, 0))
    length = scene.parameter("L", rocker * unit)
    a, b, c = (scene.body(name, **POINT) for name in ("crank", "coupler", "rocker"))
    turn = cd.Revolute("z")
    scene.joint("A", turn, scene.ground, a)
    scene.joint("B", turn, a.at(crank * unit, 0, 0), b)
    scene.joint("D", turn, scene.ground.at(ground * unit, 0, 0), c)
    scene.joint("C", turn, b.at(coupler * unit, 0, 0), c.at(length, 0, 0))
    return cd.compile(scene)


def windows(count: int, crank: float, ground: float) -> cd.CompiledModel:
    """Parallelograms in a row, each with the next crank as its follower."""
    scene = cd.Scene("windows", gravity=(0, 0, 0))
    turn, cranks = cd.Revolute("z"), list[Any]()
    for k in range(count + 1):
        cranks.append(scene.body(f"crank{k}", **POINT))
        scene.joint(f"A{k}", turn, scene.ground.at(k * ground, 0, 0), cranks[k])
    for k in range(count):
        coupler = scene.body(f"coupler{k}", **POINT)
        scene.joint(f"B{k}", turn, cranks[k].at(crank, 0, 0), coupler)
        scene.joint(f"C{k}", turn, coupler.at(ground, 0, 0), cranks[k + 1].at(crank, 0, 0))
    return cd.compile(scene)


def two_arms(arm: float) -> cd.CompiledModel:
    """Two equal arms whose tip slides on a line through their base."""
    scene = cd.Scene("two_arms", gravity=(0, 0, 0))
    one, two, tip = (scene.body(name, **POINT) for name in ("one", "two", "tip"))
    scene.joint("theta", cd.Revolute("z"), scene.ground, one)
    scene.joint("elbow", cd.Revolute("z"), one.at(arm, 0, 0), two)
    scene.joint("s", cd.Prismatic("x"), scene.ground, tip)
    scene.joint("pin", cd.Revolute("z"), two.at(arm, 0, 0), tip)
    return cd.compile(scene)


def turns(angle: Any) -> Any:
    """An angle up to full turns, between -pi and pi."""
    return np.remainder(np.asarray(angle) + math.pi, TURN) - math.pi


def kinds(path: Any) -> list[str]:
    return [point.kind for point in path.points]


def travelled(branches: Iterable[Any], name: str) -> float:
    """How far a coordinate that does not turn back goes on branches."""
    return sum(abs(float(branch[name][-1] - branch[name][0])) for branch in branches)


# of parallelograms with a crank and a ground: directions (coupler, follower) of the other branch
# where all links lie on one line, by the angle of the crank
PARALLELOGRAMS = {
    (1.0, 2.0): {0.0: (-2.0, -3.0), math.pi: (0.6666666666666666, -0.3333333333333333)},
    (0.6, 1.1): {
        0.0: (-2.3999999999999995, -3.3999999999999995),
        math.pi: (0.7058823529411764, -0.29411764705882354),
    },
}
# angles of the follower on it by the angle of the crank
FOLLOWERS = {
    (1.0, 2.0): {
        0.2: -0.5847553111661907,
        0.5: -1.3073579033710965,
        1.0: -2.0458756723586644,
        2.0: -2.71989332079659,
    },
    (0.6, 1.1): {
        0.2: -0.6575162574189898,
        0.5: -1.4298886087008178,
        1.0: -2.1538382931787834,
        2.0: -2.7682876050421563,
    },
}


@pytest.mark.parametrize("sizes", PARALLELOGRAMS)
def test_both_branches_of_a_parallelogram(sizes: tuple[float, float]) -> None:
    """tan(phi / 2) = -(d + a) / (d - a) tan(theta / 2) of the crossed one, a crank, d ground."""
    crank, ground = sizes
    model = linkage(crank, ground, crank, ground)
    path = model.continuation(
        A=(0.4, 0.4 + TURN), of="positions", branches=True, q={"A": 0.4, "B": -0.4, "D": 0.4}
    )
    assert path.success
    np.testing.assert_allclose(turns(path["D"] - path["A"]), 0, atol=EXACT)
    assert kinds(path) == ["branch point", "branch point", "event"]
    for point in path.points[:2]:
        flat = abs(turns(point["A"]))
        (angle,) = (angle for angle in (0.0, math.pi) if abs(angle - flat) < 1e-3)
        np.testing.assert_allclose(turns(point["A"] - angle), 0, atol=EXACT)
        np.testing.assert_allclose(turns(point["D"] - angle), 0, atol=EXACT)
        coupler, follower = PARALLELOGRAMS[sizes][angle]
        for a, b, d, part in point.tangents:
            np.testing.assert_allclose([(a + b) / a, d / a], [coupler, follower], atol=1e-8)
            assert part * TURN == pytest.approx(a, abs=1e-9)
        straight_on = point.special.place.tangent[:3]
        np.testing.assert_allclose(straight_on / straight_on[0], [1, -1, 1], atol=1e-8)
    # the crossed one is followed once round, in one part or from both sides
    _, *crossed = path.branches.values()
    for branch in crossed:
        theta, phi = branch["A"], branch["D"]
        left = np.sin(phi / 2) * np.cos(theta / 2) * (ground - crank)
        right = np.cos(phi / 2) * np.sin(theta / 2) * (ground + crank)
        np.testing.assert_allclose(left, -right, atol=1e-12)
    assert travelled(crossed, "A") == pytest.approx(TURN, abs=0.2)
    met = [point for branch in crossed for point in branch.points if point.kind == "branch point"]
    assert "it is branch point 2 of 'main'" in str(met[0])


@pytest.mark.parametrize("sizes", FOLLOWERS)
def test_angles_of_the_crossed_parallelogram(sizes: tuple[float, float]) -> None:
    """Closed form and bracketing agree to 7e-16."""
    crank, ground = sizes
    first = FOLLOWERS[sizes]
    path = linkage(crank, ground, crank, ground).continuation(
        A=(2.5, 0.1), of="positions", events={"A": 1.0}, q={"A": 2.5, "B": -5.0, "D": -2.87}
    )
    (event, _) = path.points
    assert event["D"] == pytest.approx(first[1.0], abs=EXACT)
    for angle, follower in first.items():
        to = linkage(crank, ground, crank, ground).continuation(
            A=(2.5, angle), of="positions", q={"A": 2.5, "B": -5.0, "D": -2.87}
        )
        assert to["D"][-1] == pytest.approx(follower, abs=EXACT)


def test_parallelograms_in_a_row_have_four_assemblies() -> None:
    """Where all links lie on one line the constraints lose two of their rank."""
    crank, ground, count = 0.6, 1.1, 2
    begin = {f"A{k}": 0.5 for k in range(count + 1)} | {f"B{k}": -0.5 for k in range(count)}
    path = windows(count, crank, ground).continuation(
        A0=(0.5, 0.5 + TURN), of="positions", branches=True, q=begin
    )
    assert [point.kernel.shape[1] for point in path.points[:2]] == [3, 3]
    assert [len(point.branches) for point in path.points[:2]] == [6, 6]
    assemblies = dict[tuple[bool, ...], list[Any]]()
    for branch in path.branches.values():
        at = branch.q[len(branch) // 2]
        angles = dict(zip(path.model.coordinates, at, strict=True))
        pairs = [(angles[f"A{k}"], angles[f"A{k + 1}"]) for k in range(count)]
        parallel = tuple(bool(abs(turns(b - a)) < 1e-6) for a, b in pairs)
        assemblies.setdefault(parallel, []).append(branch)
    assert len(assemblies) == 4
    for branches in assemblies.values():
        assert travelled(branches, "A0") == pytest.approx(TURN, abs=0.2)


@pytest.mark.parametrize("arm", [1.0, 0.7])
def test_arms_stretched_and_folded(arm: float) -> None:
    """s = 2 a cos(theta): it turns back at 2 a; folded arms turn freely about the base."""
    path = two_arms(arm).continuation(
        s=(0.4, -2 * arm), of="positions", branches=True, q={"theta": 1.3, "elbow": -2.6}
    )
    assert path.main.status == "closed"
    assert kinds(path) == ["branch point", "fold", "branch point", "fold"]
    for name, s in (("fold 1", -2 * arm), ("fold 2", 2 * arm)):
        fold = path.point(name)
        assert fold.values["s"] == pytest.approx(s, abs=EXACT)
        assert turns(fold["theta"] - (math.pi if s < 0 else 0.0)) == pytest.approx(0, abs=EXACT)
        assert turns(fold["elbow"]) == pytest.approx(0, abs=EXACT)
        assert "a dead point: 's' turns back" in str(fold)
    point = path.point("branch point 1")
    assert point.values["s"] == pytest.approx(0, abs=EXACT)
    assert point["theta"] == pytest.approx(math.pi / 2, abs=EXACT)
    assert turns(point["elbow"]) == pytest.approx(-math.pi, abs=EXACT)
    # directions (theta, beta, s), beta that of the second arm
    theta, elbow, s = point.special.place.tangent[:3]
    size = path.main.solutions.family.drivers.m.size
    np.testing.assert_allclose(
        [(theta + elbow) / theta, s * size / theta], [-1, -2 * arm], atol=1e-8
    )
    for theta, elbow, s, part in point.tangents:
        np.testing.assert_allclose([elbow / theta, s / theta, part], 0, atol=1e-8)
    # the folded arms are followed once, and nothing turns back on the way
    assert [*path.branches] == ["main", "1a"]
    folded = path.branches["1a"]
    assert folded.status == "closed"
    np.testing.assert_allclose(folded["s"], 0, atol=1e-12)
    assert [point.kind for point in folded.points] == ["branch point"] * 2


# of rigid longerons of length b on a radius r, and elastic diagonals of stiffness k
LOAD, SLOPE = 3188.9763779527566, -8578.773646829632
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
        assert tangent[-1] * 20000 / tangent[column] == pytest.approx(SLOPE, rel=1e-6)
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


@pytest.mark.parametrize("unit", [1.0, 1000.0])
def test_a_length_at_which_branches_meet(unit: float) -> None:
    """F. Grashof (1883): a + d = b + c; there the path of the crank crosses itself."""
    model = linkage(1.0, 2.0, 2.0, 2.5, unit)
    by_length = model.continuation(
        L=(2 * unit, 0.5 * unit), of="positions", locked={"A": math.pi}, q={"D": 2.0}
    )
    (shortest, longest) = by_length.points
    # a triangle with the sides a + d, b and L is flat
    assert shortest.values["L"] == pytest.approx(1.5 * unit, rel=EXACT)
    assert longest.values["L"] == pytest.approx(5.5 * unit, rel=EXACT)
    assert shortest.solution.model.parameters["L"] == pytest.approx(1.5 * unit)

    def crank(length: float) -> Any:
        return model.continuation(
            A=(1.0, 1.0 + TURN),
            of="positions",
            parameters={"L": length * unit},
            branches=True,
            q={"A": 1.0, "D": 2.0},
        )

    meeting = crank(1.5)
    assert kinds(meeting) == ["branch point", "event"]
    point = meeting.point("branch point 1")
    np.testing.assert_allclose(turns([point["A"], point["D"], point["B"]]), -math.pi, atol=1e-8)
    assert len(point.tangents) == 2
    # both assemblies, each once round: that which began is cut in two
    assert [*meeting.branches] == ["main", "1a", "1b"]
    main, *others = meeting.branches.values()
    assert travelled([main], "A") == pytest.approx(TURN)
    assert travelled(others, "A") == pytest.approx(TURN, abs=0.2)
    for branch in meeting.branches.values():
        a, d = branch["A"], branch["D"]
        gap = (2.5 + 1.5 * np.cos(d) - np.cos(a)) ** 2 + (1.5 * np.sin(d) - np.sin(a)) ** 2
        np.testing.assert_allclose(gap, 4, atol=EXACT)
    # a longer rocker lets the crank turn, a shorter one does not
    assert kinds(crank(1.51)) == ["event"]
    assert kinds(crank(1.49)) == ["fold", "fold"]


def test_a_range_of_less_than_a_turn() -> None:
    """Branches go on beyond the range, and end where they come to what was followed."""
    model = linkage(1.0, 2.0, 1.0, 2.0)
    begin = {"A": 2.5, "B": -2.5, "D": 2.5}
    path = model.continuation(A=(2.5, 4.0), of="positions", branches=True, q=begin)
    assert kinds(path) == ["branch point", "event"]
    main, *others = path.branches.values()
    assert travelled([main], "A") == pytest.approx(1.5)
    # what is left of the first one leaves the second branch point
    assert travelled(others, "A") == pytest.approx(2 * TURN - 1.5, abs=0.3)


def test_an_input_drives() -> None:
    scene = cd.Scene("prescribed", gravity=(0, 0, 0))
    a, b, c = (scene.body(name, **POINT) for name in ("crank", "coupler", "rocker"))
    turn, ground = cd.Revolute("z"), scene.ground
    scene.joint("A", turn, ground, a, prescribed=scene.input("angle"))
    scene.joint("B", turn, a.at(FOUR_BAR["crank"], 0, 0), b)
    scene.joint("D", turn, ground.at(FOUR_BAR["ground"], 0, 0), c)
    scene.joint("C", turn, b.at(FOUR_BAR["coupler"], 0, 0), c.at(FOUR_BAR["rocker"], 0, 0))
    model = cd.compile(scene)
    begin = {"B": 0.0, "D": 1.6}
    path = model.continuation(angle=(0.5, 3.0), of="positions", q=begin)
    swept = model.sweep("angle", path["angle"], start=begin)
    np.testing.assert_allclose(path["D"], swept["D"], atol=EXACT)


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
            lambda m: m.continuation(A=(0, 1), of="positions", q={"B": 0, "D": 0}),
            ModelError,
            "the start is a singular position, where branches meet. Start beside it",
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
