"""All branches of linkages against closed forms: where and how they meet, each once."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from mechanisms.change_points import TURN, kinds, linkage, travelled, turns, two_arms, windows

EXACT = 1e-9


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


def test_three_modes_of_a_rhombus() -> None:
    """Four equal bars: the cranks are parallel, or one of them stands while the other turns."""
    path = linkage(1.0, 1.0, 1.0, 1.0).continuation(
        A=(0.5, 0.5 + TURN), of="positions", branches=True, q={"A": 0.5, "B": -0.5, "D": 0.5}
    )
    modes = dict[str, list[Any]]()
    for branch in path.branches.values():
        a, d = branch["A"], branch["D"]
        apart = {"parallel": d - a, "crank": d - math.pi, "follower": a}
        (mode,) = (name for name, off in apart.items() if np.abs(turns(off)).max() < EXACT)
        modes.setdefault(mode, []).append(branch)
    assert set(modes) == {"parallel", "crank", "follower"}
    assert travelled(modes["parallel"], "A") == pytest.approx(TURN)
    assert travelled(modes["crank"], "A") == pytest.approx(TURN, abs=0.2)
    assert travelled(modes["follower"], "D") == pytest.approx(TURN, abs=0.2)
    # any two of them meet at one position
    meeting = {
        tuple(np.rint(turns([point["A"], point["D"]]) / math.pi).astype(int) % 2)
        for branch in path.branches.values()
        for point in branch.points
        if point.kind == "branch point"
    }
    assert meeting == {(0, 0), (1, 1), (0, 1)}


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
    joined = [branch.message for branch in others if branch.status == "joined"]
    ends = ("the start of 'main'", "the end of 'main'")
    assert [any(end in message for message in joined) for end in ends] == [True, True]
    # what is left of the first one leaves the second branch point
    assert travelled(others, "A") == pytest.approx(2 * TURN - 1.5, abs=0.3)


@pytest.mark.parametrize("off", [1e-2, 1e-4, 1e-6, 1e-8])
def test_branches_that_nearly_meet_are_not_mixed_up(off: float) -> None:
    """A rocker a little longer than where they meet lets the crank turn; a shorter one does not."""
    model = linkage(1.0, 2.0, 2.0, 2.5)
    for length in (1.5 + off, 1.5 - off):
        path = model.continuation(
            A=(1.0, 1.0 + TURN), of="positions", parameters={"L": length}, q={"A": 1.0, "D": 2.0}
        )
        if length > 1.5:
            assert kinds(path) == ["event"]
            assert path["D"].max() < math.pi
            continue
        # coupler and rocker in line: |a exp(i A) - d| = b + L
        dead = math.acos((7.25 - (2 + length) ** 2) / 5)
        np.testing.assert_allclose([p["A"] for p in path.points], [dead, -dead], atol=1e-7)
        assert path.main.status == "closed"
