"""What holds for every path of positions, whatever the linkage: closure, singularity, symmetry."""

from __future__ import annotations

import warnings
from collections.abc import Iterable
from functools import cache
from itertools import combinations, pairwise
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.errors import SolveWarning
from laws.position_scenes import LINKAGES, Linkage, Variant
from mechanisms.change_points import turns
from spread import some

PLAIN = Variant()
# special points are roots to rounding; what moves most is known as well there
VALUES, MARKS, CLOSED = 1e-10, 1e-8, 1e-11
RANK = 1e-6  # of the largest singular value: rank lost where a point was located to 1e-10
VARIANTS: dict[str, Variant] = {
    "millimeters": Variant(length=1e3),
    "megameters": Variant(length=1e-6),
    "micrometers": Variant(length=1e6),
    "the opposite order": Variant(turned=True),
    "joints the other way round": Variant(exchanged=True),
    "cut elsewhere": Variant(cut=True),
    "askew in the ground": Variant(tilted=True),
    "all of it": Variant(1e-3, True, True, True, True),
}


def spread(cases: Iterable[Any], every: int, first: int = 0) -> list[Any]:
    """Cases of which most are slow, and all of a swept length, whose models are many."""
    return [
        pytest.param(*case.values, marks=[pytest.mark.slow]) if "length" in case.values else case
        for case in some(cases, every, first)
    ]


@cache
def model_of(name: str, variant: Variant = PLAIN) -> cd.CompiledModel:
    return cd.compile(LINKAGES[name].scene(variant))


@cache
def path_of(name: str, variant: Variant = PLAIN) -> Any:
    return LINKAGES[name].follow(variant, model_of(name, variant))


@cache
def branches_of(name: str) -> Any:
    return LINKAGES[name].follow(PLAIN, model_of(name), branches=True, search=6)


def marks(linkage: Linkage, row: Any, variant: Variant = PLAIN) -> np.ndarray:
    """Places of bodies in a position (n,)."""
    return linkage.marks(variant, row.model, row.q, row.t, row.r)


def marks_along(linkage: Linkage, branch: Any, variant: Variant = PLAIN) -> np.ndarray:
    """Those of a branch (rows, n)."""
    return np.array([marks(linkage, branch[k], variant) for k in range(len(branch))])


def special(path: Any, linkage: Linkage, variant: Variant = PLAIN) -> list[tuple[Any, ...]]:
    """Kinds of special points, what is swept, and places of bodies there."""
    name, unit = linkage.swept[0], linkage.unit(variant)
    return [
        (point.kind, point.values[name] / unit, marks(linkage, point.solution, variant))
        for point in path.points
    ]


def same(one: list[tuple[Any, ...]], other: list[tuple[Any, ...]]) -> None:
    """Special points are the same, in the same order."""
    assert [point[0] for point in one] == [point[0] for point in other]
    for (kind, value, places), (_, value_there, places_there) in zip(one, other, strict=True):
        off = np.abs(places - places_there).max()
        print(f"{kind}: {abs(value - value_there):.1e}, {off:.1e}")
        assert value == pytest.approx(value_there, abs=VALUES)
        assert off < MARKS


def apart(point: np.ndarray, line: np.ndarray) -> float:
    """Distance to a line through points, by the length of the piece that is next to it."""
    least = np.inf
    for one, two in pairwise(line):
        along = two - one
        size = float(along @ along)
        part = np.clip((point - one) @ along / size, 0, 1) if size else 0.0
        least = min(least, float(np.linalg.norm(point - one - part * along)) / max(size**0.5, 1e-6))
    return least


@pytest.mark.parametrize("name", spread(LINKAGES, 2))
def test_kinds_of_points_are_those_of_the_linkage(name: str) -> None:
    """The laws below say something: the paths pass what they are there for."""
    path, linkage = path_of(name), LINKAGES[name]
    assert path.main.status == ("closed" if linkage.closed else "finished")
    assert tuple(point.kind for point in path.points) == linkage.passes
    if linkage.closed:
        first, last = (marks(linkage, path[k]) for k in (0, -1))
        np.testing.assert_allclose(last, first, atol=MARKS)


@pytest.mark.parametrize("name", spread(LINKAGES, 2))
def test_loops_are_closed_and_what_is_locked_stays(name: str) -> None:
    path, linkage = path_of(name), LINKAGES[name]
    for k in range(len(path)):
        row = path[k]
        gaps = linkage.gaps(PLAIN, row.model, row.q, row.t, row.r)
        assert gaps.max() < CLOSED, (k, gaps.argmax())
        for of, value in linkage.locked.items():
            assert path[of][k] == pytest.approx(value, abs=CLOSED)
    driven = linkage.swept[0]
    if driven in path.model.coordinates:
        np.testing.assert_array_equal(
            path[driven], path.main.q[:, path.model.coordinates.index(driven)]
        )


@pytest.mark.parametrize("name", spread(LINKAGES, 4))
def test_no_row_jumps_to_another_curve(name: str) -> None:
    """A path of short steps passes all rows of one of long steps."""
    linkage = LINKAGES[name]
    long = marks_along(linkage, path_of(name).main)
    fine = linkage.follow(PLAIN, model_of(name), step=0.05, points=3000)
    line = marks_along(linkage, fine.main)
    steps = np.linalg.norm(np.diff(line, axis=0), axis=1)
    # a body turns by no more than a step or two, and two directions of up to 5 bodies go along
    assert steps.max() < 0.05 * 2 * np.sqrt(3 * len(linkage.bodies))
    same(special(fine, linkage), special(path_of(name), linkage))
    # steps along a circle leave chords by ds / 8 of their length
    assert max(apart(row, line) for row in long) < 0.05


def ranks(linkage: Linkage, row: Any) -> tuple[np.ndarray, np.ndarray]:
    """Singular values of loops, and of loops with all that drives and is locked as it is.

    Lengths are of order 1, so that rows and columns need no units.
    """
    model = row.model
    G = model.constraint_jacobian(row.q, t=row.t, r=row.r)
    still = [linkage.swept[0], *linkage.locked]
    free = [k for k, of in enumerate(model.speeds) if of.removesuffix(".u") not in still]
    return np.linalg.svd(G, compute_uv=False), np.linalg.svd(G[:, free], compute_uv=False)


@pytest.mark.parametrize("name", spread(LINKAGES, 2))
def test_points_are_where_rank_is_lost_and_no_other_rows_are(name: str) -> None:
    """Of the Jacobian of the loops at branch points, of that of the followers at dead points."""
    path, linkage = path_of(name), LINKAGES[name]
    values = [ranks(linkage, path[k]) for k in range(len(path))]
    whole, driven = (np.array(rows) for rows in zip(*values, strict=True))
    rank = int((whole[0] > RANK * whole[0, 0]).sum())
    # nothing moves but what drives and is locked
    driver = linkage.swept[0] in path.model.coordinates
    assert rank == path.model.nu - int(driver) - len(linkage.locked)
    least = driven[:, rank - 1] / driven[:, 0]
    assert (whole[:, rank - 1] > 1e-3 * whole[:, 0]).mean() > 0.8
    for point in path.points:
        loops, followers = ranks(linkage, point.solution)
        lost = [values[rank - 1] < RANK * values[0] for values in (loops, followers)]
        # what is prescribed belongs to the loops
        folded = [bool(linkage.prescribed), True]
        assert lost == {"fold": folded, "branch point": [True, True]}.get(
            point.kind, [False, False]
        )
    # the least singular value is small next to those points only
    near = {k for p in path.points for k in range(p.special.after - 2, p.special.after + 4)}
    ends = set() if not linkage.closed else {0, len(path) - 1}
    away = [k for k in range(len(path)) if k not in near | ends]
    assert least[away].min() > 0.01


CASES = [(name, variant) for variant in VARIANTS for name in LINKAGES]


@pytest.mark.parametrize(("name", "variant"), spread(CASES, 7))
def test_how_a_linkage_is_written_does_not_matter(name: str, variant: str) -> None:
    linkage, other = LINKAGES[name], VARIANTS[variant]
    path = path_of(name, other)
    same(special(path, linkage, other), special(path_of(name), linkage))
    if other.cut or other.turned:
        assert path.model.coordinates != path_of(name).model.coordinates
    for k in range(len(path)):
        row = path[k]
        assert linkage.gaps(other, row.model, row.q, row.t, row.r).max() < CLOSED


@pytest.mark.parametrize("name", spread(LINKAGES, 4, 2))
def test_the_way_back_passes_the_same_points(name: str) -> None:
    linkage, path = LINKAGES[name], path_of(name)
    of, start, end = linkage.swept
    # a closed path is left the other way, another one from its end
    way = (start, 2 * start - end) if linkage.closed else (end, start)
    begin = {} if linkage.closed else {"q": path[-1].q}
    back = linkage.follow(PLAIN, model_of(name), swept={of: way}, **begin)
    assert back.main.status == path.main.status
    ways = [[p for p in special(one, linkage) if p[0] != "event"] for one in (path, back)]
    same(ways[0][::-1], ways[1])
    if not linkage.closed:
        first, last = (marks(linkage, one) for one in (path[0], back[-1]))
        np.testing.assert_allclose(last, first, atol=MARKS)


FOLLOWED = [name for name, one in LINKAGES.items() if one.followed and not one.prescribed
            and name not in ("parallelogram", "length")]  # fmt: skip
ROUND = ("rocker", "slider", "arms", "skew")


@pytest.mark.parametrize("name", spread(FOLLOWED, 3))
def test_another_coordinate_follows_the_same_path(name: str) -> None:
    """Dead points of the driver are where its rate is 0 as another coordinate goes on."""
    linkage, path = LINKAGES[name], path_of(name)
    driver, key = linkage.swept[0], linkage.followed
    first, other = path[0][key], path[2][key]
    way = (first, first + np.sign(other - first) * 7.0)
    folds = [p for p in path.points if p.kind == "fold"]
    if name in ROUND:
        positions = path.model.singular_positions(key, way, driver=driver, start=path[0].q)
        dead = [p for p in positions.positions if p.kind == "dead point"]
        k = path.model.coordinates.index(driver)
        # the other one goes on, so that all of them lie in its range
        assert len(dead) >= len(folds)
        for fold in folds:
            assert min(abs(p.q[k] - fold.values[driver]) for p in dead) < 1e-9
    # the path of the other one turns back elsewhere, and is the same curve
    along = linkage.follow(PLAIN, path.model, swept={key: way}, q=path[0].q)
    line = marks_along(linkage, along.main)
    for k in range(0, len(path), 3):
        assert apart(marks(linkage, path[k]), line) < 0.08
    ends = [fold.values[driver] for fold in folds]
    assert along[driver].min() > min(ends) - 1e-9
    assert along[driver].max() < max(ends) + 1e-9


DRIVEN = [name for name, one in LINKAGES.items() if not one.prescribed]


def crossings(linkage: Linkage, branches: Any, value: float) -> list[np.ndarray]:
    """Positions of branches at a value of the driver, to first order, each once."""
    of, found = linkage.swept[0], list[np.ndarray]()
    whole = 1.0 if linkage.long else 2 * np.pi
    for branch in branches:
        places = marks_along(linkage, branch)
        off = branch[of] - value
        off = off if linkage.long else turns(off)
        for k in np.flatnonzero((off[:-1] * off[1:] <= 0) & (np.abs(np.diff(off)) < whole / 2)):
            share = off[k] / (off[k] - off[k + 1])
            here = (1 - share) * places[k] + share * places[k + 1]
            if all(np.abs(here - one).max() > 0.05 for one in found):
                found.append(here)
    return found


BETWEEN = {
    "rocker": (1.8, 2.3), "slider": (2.2, 3.1), "arms": (0.7, -1.1), "parallelogram": (0.9, 2.2),
    "five": (-1.1, 0.4, 2.5), "length": (0.8, 3.3), "bricard": (0.4, 1.9), "skew": (0.1, -0.6),
}  # fmt: skip


@pytest.mark.parametrize("name", spread(DRIVEN, 8, 2))
def test_paths_pass_all_assemblies(name: str) -> None:
    """Solutions of random searches at a value of the driver are those of all branches there."""
    linkage, path = LINKAGES[name], branches_of(name)
    branches = [*path.branches.values()]
    if name == "skew":
        # the coupler can be turned about its length: its universal joint allows it
        crank, rocker, first, second = path[0].q
        flipped = np.array([crank, rocker, first + np.pi, np.pi - second])
        branches.append(linkage.follow(PLAIN, path.model, q=flipped).main)
    for value in BETWEEN[name]:
        passed = crossings(linkage, branches, value)
        model, targets = path.model, {linkage.swept[0]: value, **linkage.locked}
        if linkage.parameter[1]:
            model = model.with_parameters({linkage.swept[0]: targets.pop(linkage.swept[0])})
        with warnings.catch_warnings():
            # of two that are equally near
            warnings.simplefilter("ignore", SolveWarning)
            counts = [model.assemble(targets, starts=40, seed=seed).solutions for seed in (1, 2)]
        assert counts == [len(passed)] * 2, value


@pytest.mark.parametrize("name", some(("bricard", "timed", "rocker"), 3))
def test_search_finds_closed_positions_only_and_each_curve_once(name: str) -> None:
    """Of overconstrained loops conditions were left out, and full turns are no other curve."""
    linkage, path = LINKAGES[name], branches_of(name)
    lines = {n: marks_along(linkage, branch) for n, branch in path.branches.items()}
    for branch in path.branches.values():
        for k in range(0, len(branch), 4):
            row = branch[k]
            assert linkage.gaps(PLAIN, row.model, row.q, row.t, row.r).max() < CLOSED
    for one, two in combinations(lines, 2):
        assert apart(lines[two][len(lines[two]) // 2], lines[one]) > 0.08, (one, two)
    assert (len(lines) > 1) == (name != "bricard")


@pytest.mark.parametrize("name", ["arms", "parallelogram"])
def test_branches_are_followed_once_and_mirror_images_agree(name: str) -> None:
    linkage, path = LINKAGES[name], branches_of(name)
    lines = {name: marks_along(linkage, branch) for name, branch in path.branches.items()}
    assert len(lines) > 1
    for one, two in combinations(lines, 2):
        assert apart(lines[two][len(lines[two]) // 2], lines[one]) > 0.08, (one, two)
    of, places = linkage.swept[0], [point for point in path.points if point.branches]
    assert places
    for point in places:
        # branches begin at the point, in the directions that it tells; or those of others pass it
        here = marks(linkage, point.solution)
        for name in set(point.branches) & set(path.branches):
            first = marks(linkage, path.branches[name][0])
            if np.abs(first - here).max() > 0.1:
                assert apart(here, lines[name]) < 0.08
                continue
            assert np.abs(first - here).max() > 0
            move = path.branches[name].q[0] - point.solution.q
            named = np.array([other == name for other in point.branches])
            ways = point.tangents[named][:, :-1]
            along = ways @ move / np.linalg.norm(move) / np.linalg.norm(ways, axis=1)
            # lengths and angles are of order 1 here, but the length of a unit
            assert along.max() > 0.8
    for point in path.points:
        for left, right in point.symmetric:
            names = [*point.branches]
            one, two = names.index(left), len(names) - 1 - names[::-1].index(right)
            np.testing.assert_allclose(
                point.tangents[one][:-1], -point.tangents[two][:-1], atol=1e-8
            )
    assert {of} == set(path.main.values)


@pytest.mark.parametrize(("end", "near"), [(4.0, 1e-5), (4.0, 1e-8), (-4.0, 1e-6)])
def test_points_next_to_the_start_of_a_closed_path_count_once(end: float, near: float) -> None:
    linkage, path = LINKAGES["rocker"], path_of("rocker")
    dead = path.point("fold 1" if end > 0 else "fold 2").values["D"]
    begin = dead - np.sign(end) * near
    for crank in (1.0, 5.0):
        close = linkage.follow(
            PLAIN, path.model, swept={"D": (begin, end)}, q={"D": begin, "A": crank}
        )
        assert close.main.status == "closed"
        values = sorted(point.values["D"] for point in close.points)
        expected = sorted(point.values["D"] for point in path.points)
        assert values == pytest.approx(expected, abs=VALUES)


def test_dead_points_of_the_time_have_no_speeds() -> None:
    path = path_of("timed")
    for point in path.points:
        position = point.solution
        assert np.isnan(position.u).all() or np.abs(position.u).max() > 1e6
        assert position.q == pytest.approx(path.main.q[point.special.after], abs=0.5)


def test_a_path_starts_at_a_dead_point_too() -> None:
    """Angles there that differ by full turns were two positions."""
    linkage, path = LINKAGES["rocker"], path_of("rocker")
    dead = path.point("fold 1")
    begin = {"D": dead.values["D"], "A": dead["A"]}
    there = linkage.follow(PLAIN, path.model, swept={"D": (begin["D"], 4.0)}, q=begin)
    assert there.main.status == "closed"
    assert there.points[-1].values["D"] == pytest.approx(path.points[1].values["D"], abs=VALUES)


@pytest.mark.parametrize("more", [{"u": {"A": 1.0}}, {"start": 3}])
def test_what_is_of_other_paths_is_refused(more: Any) -> None:
    with pytest.raises(cd.ModelError, match="u= and start= are of equilibria and cycles"):
        LINKAGES["rocker"].follow(PLAIN, model_of("rocker"), **more)
