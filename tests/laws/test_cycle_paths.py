"""What holds for every path of cycles, whatever the scene: laps, multipliers, volumes, symmetry."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import cardan as cd
from cycle_scenes import step, walker
from laws.cycle_path_scenes import SCENES, CycleScene, Variant
from spread import some

PLAIN = Variant()
# what is swept at special points, states there, laps by another program, multipliers
VALUES, STATES, LAPS, MULTIPLIERS = 1e-8, 1e-6, 1e-8, 1e-6
VARIANTS: dict[str, Variant] = {
    "kilometers": Variant(length=1e-3),
    "micrometers": Variant(length=1e6),
    "milliseconds": Variant(time=1e3),
    "hours": Variant(time=1 / 3600),
    "the opposite order": Variant(turned=True),
    "absolute": Variant(coordinates="absolute"),
}
OPEN = [name for name in SCENES if name != "linkage"]
KEPT = [name for name, scene in SCENES.items() if scene.mode is not None]


@cache
def model_of(name: str, variant: Variant = PLAIN) -> cd.CompiledModel:
    return SCENES[name].build(variant)


@cache
def path_of(name: str, variant: Variant = PLAIN) -> Any:
    return SCENES[name].follow(variant, model_of(name, variant))


def special(path: Any, scene: CycleScene, variant: Variant = PLAIN) -> list[tuple[Any, ...]]:
    """Kinds of special points, what is swept, and sizes of the state there."""
    name, load, size = scene.swept[0], scene.load(variant), scene.size(variant)
    return [(p.kind, p.values[name] / load, abs(p[scene.key]) / size) for p in path.points]


def same(one: list[tuple[Any, ...]], other: list[tuple[Any, ...]]) -> None:
    """Special points are the same, in the same order."""
    assert [point[0] for point in one] == [point[0] for point in other]
    for (kind, *here), (_, *there) in zip(one, other, strict=True):
        print(f"{kind}: {abs(here[0] - there[0]):.1e}, {abs(here[1] - there[1]):.1e}")
        assert here[0] == pytest.approx(there[0], abs=VALUES)
        assert here[1] == pytest.approx(there[1], abs=STATES)


def rows(path: Any) -> list[Any]:
    """Three cycles of a path."""
    return [path[k] for k in sorted({1, len(path) // 2, len(path) - 1})]


def rates(cycle: Any) -> Callable[[float, np.ndarray], np.ndarray]:
    """The equations of motion of a cycle's model."""
    model = cycle.model
    return lambda t, x: model.rhs(t, x)


def slopes(cycle: Any, t: float, x: np.ndarray) -> np.ndarray:
    """Their derivatives by the state, by differences of order 4."""
    f, h = rates(cycle), 1e-3
    columns = []
    for e in h * np.eye(len(x)):
        odd = [f(t, x + k * e) - f(t, x - k * e) for k in (1, 2)]
        columns.append((8 * odd[0] - odd[1]) / (12 * h))
    return np.stack(columns, axis=1)


def lap(cycle: Any, f: Any, x: np.ndarray) -> np.ndarray:
    """Where a lap ends, by another program."""
    method = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-13}
    end: np.ndarray = solve_ivp(f, (0, cycle.period), x, **method).y[:, -1]
    return end


@cache
def variation(name: str, k: int) -> tuple[np.ndarray, float]:
    """Derivative of a lap by the linear equations along it, and the integral of their trace."""
    cycle, f = rows(path_of(name))[k], rates(rows(path_of(name))[k])
    n = len(cycle.x)

    def equations(t: float, y: np.ndarray) -> np.ndarray:
        A = slopes(cycle, t, y[:n])
        return np.concatenate([f(t, y[:n]), (A @ y[n:-1].reshape(n, n)).ravel(), [np.trace(A)]])

    end = lap(cycle, equations, np.concatenate([cycle.x, np.eye(n).ravel(), [0.0]]))
    return end[n:-1].reshape(n, n), float(end[-1])


def paired(values: Any, others: Any) -> float:
    """Largest distance between numbers of two lists that belong together."""
    left, off = [*others], 0.0
    for value in sorted(values, key=lambda one: -abs(one)):
        k = int(np.abs(np.array(left) - value).argmin())
        off = max(off, abs(left.pop(k) - value))
    return off


@pytest.mark.parametrize("name", some(SCENES, 2))
def test_kinds_of_points_are_those_of_the_scene(name: str) -> None:
    """The laws below say something: the paths pass what they are there for."""
    path = path_of(name)
    assert path.success
    assert tuple(point.kind for point in path.points) == (*SCENES[name].passes, "event")


@pytest.mark.parametrize("name", some(SCENES, 3, 1))
def test_laps_by_another_program_come_back(name: str) -> None:
    for cycle in rows(path_of(name)):
        end = lap(cycle, rates(cycle), cycle.x)
        off = np.abs(end - cycle.x).max() / np.abs(cycle.x).max()
        assert off < LAPS, off
        # and not before: the period is no multiple of one
        for parts in (2, 3):
            x = solve_ivp(rates(cycle), (0, cycle.period / parts), cycle.x, rtol=1e-9).y[:, -1]
            # a crank that swings by little about its place
            least = 0.1 if name in OPEN else 0.01
            assert np.abs(x - cycle.x).max() > least * np.abs(cycle.x).max()


@pytest.mark.parametrize("name", some(OPEN, 4))
def test_multipliers_are_those_of_the_linear_equations(name: str) -> None:
    """Of a free period less a 1, of an energy that is kept less another one."""
    scene = SCENES[name]
    for k, cycle in enumerate(rows(path_of(name))):
        expected = [*np.linalg.eigvals(variation(name, k)[0])]
        neutral = 0 if scene.period is not None else 1 + (scene.mode is not None)
        for _ in range(neutral):
            # two of one Jordan block are as good as the root of the rounding
            nearest = int(np.abs(np.array(expected) - 1).argmin())
            assert abs(expected.pop(nearest) - 1) < (1e-4 if neutral == 2 else 1e-8)
        assert len(expected) == len(cycle.multipliers)
        assert paired(cycle.multipliers, expected) < MULTIPLIERS


@pytest.mark.parametrize("name", some(OPEN, 4))
def test_volumes_shrink_as_the_divergence_says(name: str) -> None:
    """J. Liouville (1838): the product of all multipliers is exp of the integral of the trace."""
    for k, cycle in enumerate(rows(path_of(name))):
        product = complex(np.prod(cycle.multipliers))
        assert product == pytest.approx(np.exp(variation(name, k)[1]), rel=1e-6, abs=1e-9)


@pytest.mark.parametrize("name", some(KEPT, 2, 1))
def test_multipliers_of_what_keeps_its_energy_come_in_pairs(name: str) -> None:
    """H. Poincare (1892): a factor, its inverse, and both complex conjugate."""
    path = path_of(name)
    for k in range(len(path)):
        values = path[k].multipliers
        assert paired(1 / values, values) < 1e-9 * np.abs(values).max() ** 2
        assert paired(values.conj(), values) < 1e-10
        assert abs(np.prod(values) - 1) < 1e-9


@pytest.mark.parametrize("name", some(KEPT, 2, 1))
def test_energies_are_those_of_the_motion(name: str) -> None:
    """Kinetic energy and the work of forces at rest, along the lap as at its start."""
    path, model = path_of(name), model_of(name)

    def energy(x: np.ndarray) -> float:
        q, u = x[: model.nq], x[model.nq :]
        M = model.mass_matrix(q)
        places, weights = np.polynomial.legendre.leggauss(12)
        still, work = 0 * u, 0.0
        for place, weight in zip((places + 1) / 2, weights / 2, strict=True):
            force = model.mass_matrix(place * q) @ model.rhs(0, [*(place * q), *still])[model.nq :]
            work += weight * float(force @ q)
        return 0.5 * float(u @ M @ u) - work

    for k in (1, len(path) // 2, -1):
        for x in path[k].motion.at(np.linspace(0, path[k].period, 5)):
            assert energy(x) == pytest.approx(path["energy"][k], rel=1e-9)


CASES = [(name, variant) for variant in VARIANTS for name in SCENES
         if variant != "absolute" or ("absolute" in SCENES[name].coordinates
         and SCENES[name].mode is None)]  # fmt: skip


@pytest.mark.parametrize(("name", "variant"), some(CASES, 9, 2))
def test_how_a_scene_is_written_does_not_matter(name: str, variant: str) -> None:
    scene, other = SCENES[name], VARIANTS[variant]
    path, plain = path_of(name, other), path_of(name)
    same(special(path, scene, other), special(plain, scene))
    assert path["period"][-1] / other.time == pytest.approx(plain["period"][-1], rel=1e-9)
    assert paired(path[-1].multipliers, plain[-1].multipliers) < MULTIPLIERS


@pytest.mark.parametrize("name", some(("limit cycle", "resonance"), 2))
def test_the_way_back_passes_the_same_points(name: str) -> None:
    scene, path, model = SCENES[name], path_of(name), path_of(name).model
    of, first, last = scene.swept
    bottom = path[of][0] if scene.mode is not None else first
    # a path that turned passes its first value before it is back
    turned = any(point.kind == "fold" for point in path.points)
    size = f"{scene.key}.max"
    options = {"until": {size: path[size][0]}} if turned else {}
    bottom = bottom - (last - first) if turned else bottom
    back = model.continuation({of: (last, bottom)}, of="cycles", start=path[-1], **options)
    assert back.success
    ways = [[p[:2] for p in special(one, scene) if p[0] != "event"] for one in (path, back)]
    assert [kind for kind, _ in ways[0][::-1]] == [kind for kind, _ in ways[1]]
    for (_, here), (_, there) in zip(ways[0][::-1], ways[1], strict=True):
        assert here == pytest.approx(there, abs=VALUES)
    assert back["period"][-1] == pytest.approx(path["period"][0], rel=1e-8)
    assert paired(back[-1].multipliers, path[0].multipliers) < 1e-5


@pytest.mark.parametrize("name", some(OPEN, 4))
def test_lengths_of_steps_do_not_matter(name: str) -> None:
    scene = SCENES[name]
    for length in (0.1, 0.5):
        path = scene.follow(PLAIN, model_of(name), step=length, points=3000)
        same(special(path, scene), special(path_of(name), scene))
        assert path["period"][-1] == pytest.approx(path_of(name)["period"][-1], rel=1e-9)


FIRST = [name for name, scene in SCENES.items() if scene.mode is None and name in OPEN]


@pytest.mark.parametrize("name", some(FIRST, 2))
def test_a_cycle_may_begin_anywhere_on_itself(name: str) -> None:
    scene, cycle = SCENES[name], path_of(name)[-1]
    for share in (0.3, 0.8):
        t = share * cycle.period
        x = cycle.motion.at(np.array([t]))[0]
        forced = {} if scene.period is None else {"period": cycle.period, "t": t}
        other = cycle.model.cycle(x, check=True, **forced)
        assert other.period == pytest.approx(cycle.period, rel=1e-10)
        assert paired(other.multipliers, cycle.multipliers) < MULTIPLIERS
        # what was known to a run's accuracy stays where it was, but along a free period
        if scene.period is not None:
            np.testing.assert_allclose(other.x, x, atol=1e-8)


@pytest.mark.parametrize("name", some(FIRST, 2))
def test_two_laps_square_the_multipliers(name: str) -> None:
    scene, cycle = SCENES[name], path_of(name)[-1]
    period = {} if scene.period is None else {"period": cycle.period}
    twice = cycle.model.cycle(cycle.x, laps=2, check=True, **period)
    assert twice.period == pytest.approx(2 * cycle.period, rel=1e-10)
    assert paired(twice.multipliers, cycle.multipliers**2) < MULTIPLIERS


@pytest.mark.slow
def test_half_of_a_symmetric_cycle_has_roots_of_multipliers() -> None:
    """Along a whole path: what moves back after half a period, mirrored."""
    scene, model = SCENES["resonance"], model_of("resonance")
    assert scene.period is not None
    half = scene.cycle(PLAIN, model, period=scene.period / 2, symmetry={"x": ("x", -1)})
    path = scene.follow(PLAIN, model, start=half)
    same(special(path, scene)[:2], special(path_of("resonance"), scene)[:2])
    whole = path_of("resonance")[-1]
    assert paired(path[-1].multipliers ** 2, whole.multipliers) < MULTIPLIERS


@pytest.mark.slow
def test_symmetric_systems_have_mirror_cycles() -> None:
    """Where the masses of a pair part, each of them moves more on one branch."""
    scene = SCENES["pair"]
    path = scene.follow(PLAIN, model_of("pair"), branches=1)
    (point,) = (point for point in path.points if point.kind == "branch point")
    left, right = (path.branches[name] for name in point.branches)
    assert left.status == right.status == "finished"
    assert left["period"][-1] == pytest.approx(right["period"][-1], rel=1e-9)
    for one, other in ("xy", "yx"):
        assert left[f"{one}.max"][-1] == pytest.approx(right[f"{other}.max"][-1], rel=1e-6)
    assert left["x.max"][-1] != pytest.approx(left["y.max"][-1], rel=0.2)
    assert paired(left[-1].multipliers, right[-1].multipliers) < 1e-5
    for branch in (left, right):
        cycle = branch[len(branch) - 1]
        assert np.abs(lap(cycle, rates(cycle), cycle.x) - cycle.x).max() < LAPS


@pytest.mark.slow
def test_cycles_of_two_laps_begin_with_twice_the_period() -> None:
    model = walker()
    gait = step(model, 0.2003, -0.1998)
    path = model.continuation(slope=(0.0145, 0.0155), of="cycles", start=gait, branches=1)
    (point,) = (point for point in path.points if point.kind == "period doubling")
    branch = path.branches[point.name]
    first, single = branch[0], point.solution
    assert abs(branch["slope"][0] - point.values["slope"]) < 1e-4
    assert first.period == pytest.approx(2 * single.period, rel=1e-3)
    assert paired(first.multipliers, single.multipliers**2) < 0.1
    # where one is stable the other is not
    assert branch[-1].stable != path[-1].stable
