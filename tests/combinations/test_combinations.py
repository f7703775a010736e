"""Scenes in which every two features meet, each by two routes; what fails is reduced to its part.

Nearly all of it is slow; a dozen scenes are in every run.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from itertools import combinations
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.errors import CardanError
from cardan.schema.integrators import INTEGRATORS

from .arrays import SCENES
from .covering import covering, smallest
from .features import FEATURES, PRESENT, closed
from .refusals import MISSING, expected
from .routes import Names, apart, other_route, outputs_at, route
from .uses import USES

# in every run: those that build soonest, every group of features among them
QUICK = 12
# of methods of low order and of others: the tolerance they are given, and what is left of 1 m
LOW, HIGH = (1e-5, 5e-3), (1e-8, 1e-4)
# steps of methods that do not choose them, which resolve the vibrations of the beam
STEP = 2e-4
# what a feature must change to be there [m]
EFFECT = 1e-4


def test_what_is_missing_is_still_missing() -> None:
    """A refusal that is only not written yet leaves the list when it is."""
    seen = set()
    for names in (("PID",), ("beam",)):
        side = route(names)
        for row in MISSING:
            for method in row.asked:
                try:
                    side.run(t=1e-3, method=method)
                except cd.ModelError as problem:
                    seen |= {row} if re.search(row.message, str(problem)) else set()
    assert seen == {*MISSING}


def features_of(scene: Names) -> Names:
    """A scene without its uses."""
    return tuple(name for name in scene if name not in USES)


def reduced(names: Names, act: Callable[[Names], object]) -> str:
    """What fails with fewest features, and how."""
    said = {}

    def fails(some: Names) -> bool:
        try:
            act(some)
        except (AssertionError, CardanError, ArithmeticError, ValueError) as problem:
            said[some] = " ".join(str(problem).split())[:500]
            return True
        return False

    assert fails(names)
    part = smallest(names, fails)
    return f"{' + '.join(closed(part)) or 'the bars alone'}: {said[part]}"


def checked(names: Names, act: Callable[[Names], object], asked: str = "auto") -> None:
    """Act on a scene; a refusal must be on the list, a failure is reduced to its part."""
    try:
        act(names)
        return
    except (cd.ModelError, cd.DerivationError, cd.CodegenError) as problem:
        try:
            expected(names, asked, " ".join(str(problem).split()))
            return
        except AssertionError:
            pass
    except (AssertionError, CardanError, ArithmeticError, ValueError):
        pass
    pytest.fail(reduced(names, act))


def test_every_pair_is_in_a_scene() -> None:
    pairs = {frozenset(pair) for scene in SCENES for pair in combinations(scene, 2)}
    assert pairs >= {frozenset(pair) for pair in combinations((*PRESENT, *USES), 2)}
    assert all(len(scene) <= 8 for scene in SCENES)


def test_small_arrays() -> None:
    assert covering("abc", 3, tuple) == [("a", "b", "c")]
    sets = covering("abcdef", 3, tuple)
    assert {frozenset(p) for s in sets for p in combinations(s, 2)} == {
        frozenset(p) for p in combinations("abcdef", 2)
    }
    assert smallest(tuple("abcdef"), lambda part: {"b", "e"} <= {*part}) == ("b", "e")


@pytest.mark.parametrize("name", [pytest.param(n, marks=pytest.mark.slow) for n in PRESENT])
def test_every_feature_has_an_effect(name: str) -> None:
    feature = FEATURES[name]
    names = closed((name,))
    with_it, without = route(names).run(), route(names, "auto", name).run()
    if feature.effect == "events":
        assert len(with_it.events) > len(without.events)
        return
    assert np.abs(outputs_at(with_it) - outputs_at(without)).max() > EFFECT


def agree(names: Names) -> None:
    """Two routes have the same motion."""
    mine, theirs = route(names), other_route(names)
    start = {} if "beam" in names else mine.start
    said = apart(mine.run(), theirs.run(**start))
    assert not said, said


def rows() -> list[Any]:
    """The scenes, all but some of them slow."""
    # a line load brings a beam with it
    short = sorted(range(len(SCENES)), key=lambda k: ("beam" in SCENES[k], len(SCENES[k]), k))
    quick = short[:QUICK]
    return [
        pytest.param(scene, id=f"scene{k}", marks=[] if k in quick else [pytest.mark.slow])
        for k, scene in enumerate(SCENES)
    ]


@pytest.mark.parametrize("scene", rows())
def test_both_kinds_of_coordinates_agree(scene: Names) -> None:
    checked(features_of(scene), agree)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("use", "scene"),
    [
        pytest.param(use, scene, id=f"{use}-scene{k}")
        for k, scene in enumerate(SCENES)
        for use in USES
        if use in scene
    ],
)
def test_uses(use: str, scene: Names) -> None:
    checked(features_of(scene), USES[use], use)


def moves(method: str) -> Callable[[Names], object]:
    """A run by a method that ends where a fine one ends."""

    def act(names: Names) -> None:
        side, row = route(names), INTEGRATORS[method]
        rtol, near = HIGH if row.order > 3 else LOW
        options = {"rtol": rtol, "atol": 1e-2 * rtol} if row.adaptive else {"step": STEP}
        motion = side.run(method=method, **options)
        assert motion.success, f"{motion.status}: {motion.message}"
        gap = np.abs(outputs_at(motion) - outputs_at(side.run())).max()
        assert gap < near, f"off by {gap:.2e}"

    return act


@pytest.mark.slow
@pytest.mark.parametrize("method", INTEGRATORS)
@pytest.mark.parametrize("scene", [pytest.param(s, id=f"scene{k}") for k, s in enumerate(SCENES)])
def test_integrators(method: str, scene: Names) -> None:
    checked(features_of(scene), moves(method), method)
