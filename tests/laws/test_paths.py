"""What holds for every path of equilibria, whatever the scene: balance, stability, symmetry."""

from __future__ import annotations

from functools import cache
from itertools import combinations, pairwise, product
from typing import Any

import numpy as np
import pytest

import cardan as cd
from laws.path_scenes import SCENES, PathScene, Variant, truss
from laws.test_equilibria import allowed, unbalanced
from spread import some

PLAIN = Variant()
# loads of special points, and positions: at folds those are as good as the root of the loads
LOADS, POSITIONS, AT_FOLDS = 1e-8, 1e-7, 1e-5
VARIANTS: dict[str, Variant] = {
    "millimeters": Variant(length=1e3),
    "kilonewtons": Variant(force=1e-3),
    "micrometers and meganewtons": Variant(length=1e6, force=1e-6),
    "the opposite order": Variant(turned=True),
    "beams the other way round": Variant(exchanged=True),
    "absolute": Variant(coordinates="absolute"),
}


@cache
def model_of(name: str, variant: Variant = PLAIN) -> cd.CompiledModel:
    return SCENES[name].model(variant)


@cache
def path_of(name: str, variant: Variant = PLAIN) -> Any:
    return SCENES[name].follow(variant, model_of(name, variant))


def special(path: Any, scene: PathScene, variant: Variant = PLAIN) -> list[tuple[Any, ...]]:
    """Kinds of special points, loads and positions there, in meters and newtons."""
    load, (of, start, end) = scene.load(variant), scene.swept
    along, size = scene.along[0], scene.measure(variant)
    return [
        (point.kind, point.values[of] / load / abs(end - start), point[along] / size)
        for point in path.points
    ]


def same(one: list[tuple[Any, ...]], other: list[tuple[Any, ...]]) -> None:
    """Special points are the same, in the same order."""
    assert [point[0] for point in one] == [point[0] for point in other]
    for (kind, *here), (_, *there) in zip(one, other, strict=True):
        print(f"{kind}: {abs(here[0] - there[0]):.1e}, {abs(here[1] - there[1]):.1e}")
        assert here[0] == pytest.approx(there[0], abs=LOADS)
        assert here[1] == pytest.approx(there[1], abs=AT_FOLDS if kind == "fold" else POSITIONS)


@pytest.mark.parametrize("name", SCENES)
def test_kinds_of_points_are_those_of_the_scene(name: str) -> None:
    """The laws below say something: the paths pass what they are there for."""
    path = path_of(name)
    assert path.success
    assert tuple(point.kind for point in path.points) == (*SCENES[name].passes, "event")


@pytest.mark.parametrize("name", some(SCENES, 3))
def test_every_row_balances(name: str) -> None:
    path = path_of(name)
    # stiffnesses cancel at folds, the forces that meet do not. Corrections of 1e-7 are the last
    # ones, so that their square is left of all loads
    load = float(np.abs(next(iter(path.main.values.values()))).max())
    most = np.maximum.reduce([allowed(row) for row in map(path.main.__getitem__, range(len(path)))])
    most = most + 1e-13 * load
    for k in range(len(path)):
        row = path[k]
        left = unbalanced(row)
        if row.modes:
            # a stop bears what is left
            left = left - np.abs(row.lam)
        held = [row.model.speeds.index(f"{of}.u") for of in row.holding_forces]
        for i, force in zip(held, row.holding_forces.values(), strict=True):
            assert unbalanced(row)[i] == pytest.approx(abs(force), abs=most[i])
            left[i] = 0.0
        assert (left <= most).all(), (k, row.model.speeds[int((left - most).argmax())], left.max())


@pytest.mark.parametrize("name", some(SCENES, 3, 1))
def test_stability_is_that_of_small_motions(name: str) -> None:
    path = path_of(name)
    told, held = path.main.stable, path.main.stable_held
    for k in range(len(path)):
        values = path[k].model.linearize(path[k]).eigenvalues
        # eigenvalues that meet at 0 are as good as the root of rounding
        size = 1e-6 * np.abs(values).max(initial=0.0)
        grows = float(values.real.max(initial=-np.inf))
        if abs(grows) < size and not np.abs(values).min() > 10 * size:
            continue
        assert held[k] is None or held[k] == (grows <= size), (k, grows)
        if not SCENES[name].locked:
            assert told[k] == held[k]


def test_a_dead_load_in_place_of_a_displacement_tells_stability() -> None:
    path = path_of("prescribed")
    model, seen = model_of("prescribed"), set[bool]()
    for k in range(len(path)):
        load = -path["up.holding_force"][k]
        values = model.with_parameters(P=load).linearize(q=path[k].q).eigenvalues
        assert path.main.stable[k] == bool(values.real.max() < 1e-6)
        seen.add(bool(path.main.stable[k]))
    assert seen == {True, False}


@pytest.mark.parametrize("name", some(SCENES, 3, 2))
def test_the_way_back_passes_the_same_points(name: str) -> None:
    scene, path = SCENES[name], path_of(name)
    of, start, end = scene.swept
    key, value = scene.along
    turns = any(point.kind == "fold" for point in path.points)
    # a path that turned passes its first load before it is back
    first = start - 10 * (end - start) if turns else start
    ways = {of: (end, first)}
    way, locked = (None, ways) if scene.locked else (ways, None)
    until = {key: path[key][0]} if turns else {}
    back = model_of(name).continuation(
        way, locked=locked, q=path[-1].q, events={key: value}, until=until
    )
    assert back.success
    there = [point for point in special(back, scene) if point[0] != "event"]
    same([point for point in special(path, scene) if point[0] != "event"][::-1], there)
    passed = {p.name: p.values[of] for p in path.points[:-1] if p.kind == "event"}
    again = {p.name: p.values[of] for p in back.points[:-1] if p.kind == "event"}
    rename = {"floor.release": "floor.lower"}
    again = {rename.get(name, name): load for name, load in again.items()}
    assert again == pytest.approx(passed, abs=LOADS * abs(end - start))
    assert back[key][-1] == pytest.approx(path[key][0], abs=POSITIONS)


def written(name: str, variant: str) -> bool:
    """Whether a scene can be written so."""
    if variant == "absolute":
        return "absolute" in SCENES[name].coordinates
    if variant == "beams the other way round":
        return name == "frame"
    return name != "boom"


CASES = [(name, variant) for variant, name in product(VARIANTS, SCENES) if written(name, variant)]


@pytest.mark.parametrize(("name", "variant"), some(CASES, 4))
def test_how_a_scene_is_written_does_not_matter(name: str, variant: str) -> None:
    scene, other = SCENES[name], VARIANTS[variant]
    same(special(path_of(name, other), scene, other), special(path_of(name), scene))


@pytest.mark.parametrize(
    ("name", "step"), some([(n, s) for s in (0.5, 0.125, 0.03) for n in SCENES], 5)
)
def test_lengths_of_steps_do_not_matter(name: str, step: float) -> None:
    scene = SCENES[name]
    path = scene.follow(PLAIN, model_of(name), step=step, points=3000)
    same(special(path, scene), special(path_of(name), scene))


FAST = [1e-3, 1.0, 1e3]  # stiffnesses of the strut, that of the bars being 1
VISCOUS = [1e-4, 1e-2, 1.0, 1e2, 1e4]


@cache
def lagging(coordinates: str) -> cd.CompiledModel:
    """The truss with a strut that gives way in time, of any stiffness and viscosity."""
    variant = Variant(coordinates=coordinates)
    return cd.compile(truss(variant, lag=True, tuned=True), coordinates=coordinates)


LAGS = list(product(("relative", "absolute"), FAST, VISCOUS, (0.25, 0.03)))


@pytest.mark.parametrize(("coordinates", "stiffness", "damping", "step"), some(LAGS, 11))
def test_what_gives_way_in_time_holds_no_load(
    coordinates: str, stiffness: float, damping: float, step: float
) -> None:
    """A Maxwell strut has come to rest without force: special points are those without it.

    One motion grows between the folds, next to those as slowly as rounding, the more so beside
    what moves fast.
    """
    model = lagging(coordinates).with_parameters(strut_k=stiffness, strut_c=damping)
    path = SCENES["lag"].follow(PLAIN, model, step=step, points=2000)
    same(special(path, SCENES["lag"]), special(path_of("truss"), SCENES["truss"]))


def rows(branch: Any, load: str, size: float) -> np.ndarray:
    """Positions and loads of a branch (n, nq + 1)."""
    return np.column_stack([branch.q, branch[load] / size])


def apart(point: np.ndarray, line: np.ndarray) -> float:
    """Distance to a line through points, by the length of the piece that is next to it."""
    least = np.inf
    for one, two in pairwise(line):
        along = two - one
        size = float(along @ along)
        part = np.clip((point - one) @ along / size, 0, 1) if size else 0.0
        least = min(least, float(np.linalg.norm(point - one - part * along)) / max(size**0.5, 1e-6))
    return least


BRANCHED = {"swaying": {"aside": 2.0}, "links": {"theta": 1.4}, "pendulum": {"low_hinge": 1.2},
            "boom": {"hinge": 0.25}}  # fmt: skip


@pytest.mark.parametrize("name", some(BRANCHED, 2))
def test_branches_are_followed_once_and_mirror_images_agree(name: str) -> None:
    scene, key = SCENES[name], next(iter(BRANCHED[name]))
    of, start, end = scene.swept
    most, passed = BRANCHED[name][key], "{} = {:.10g}".format(*scene.along)
    path = scene.follow(PLAIN, model_of(name), branches=1, bounds={key: (-most, most)})
    lines = {name: rows(branch, of, end - start) for name, branch in path.branches.items()}
    for one, two in combinations(lines, 2):
        middle = lines[two][len(lines[two]) // 2]
        # on one curve, steps that turn by 0.3 leave chords by 4 % of their length
        assert apart(middle, lines[one]) > 0.08, (one, two)
    pairs = [pair for point in path.points for pair in point.symmetric]
    assert pairs
    for left, right in pairs:
        if not {left, right} <= {*path.branches}:
            continue
        here, there = path.branches[left], path.branches[right]
        if left == right:
            # a closed branch is its own mirror image
            assert here.status == "closed"
            mirror = np.ones(lines[left].shape[1])
            mirror[path.model.coordinates.index(key)] = -1.0
            assert max(apart(mirror * row, lines[left]) for row in lines[left]) < 0.08
            continue
        assert here.status == there.status
        points = [[p for p in one.points if p.name != passed] for one in (here, there)]
        assert [p.kind for p in points[0]] == [p.kind for p in points[1]]
        loads = [[p.values[of] for p in one] for one in points]
        assert loads[0] == pytest.approx(loads[1], abs=LOADS * abs(end - start))
        assert here[key][-1] == pytest.approx(-there[key][-1], abs=POSITIONS)
        if len(here) == len(there):
            np.testing.assert_allclose(here[of], there[of], atol=1e-6 * abs(end - start))
            np.testing.assert_allclose(here[key], -there[key], atol=1e-6)
