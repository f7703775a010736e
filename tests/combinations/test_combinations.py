"""Scenes in which every two features meet, each by two routes; what fails is reduced to its part.

Nearly all of it is slow; a dozen scenes are in every run.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import combinations
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.errors import CardanError

from .arrays import SCENES
from .covering import covering, smallest
from .features import FEATURES, PRESENT, closed
from .refusals import expected
from .routes import FLEXIBLE, Names, apart, other_route, outputs_at, route
from .uses import USES

# in every run: those that build soonest, every group of features among them
QUICK = 12
# what a feature must change to be there [m]
EFFECT = 1e-4
# energy that powers of all sources, which no error control sees, leave unaccounted for [J]
LOST = 1e-4


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
    """Two routes have the same motion, and account for all energy."""
    mine, theirs = route(names), other_route(names)
    start = {} if FLEXIBLE & {*names} else mine.start
    motions = mine.run(), theirs.run(**start)
    said = apart(*motions)
    assert not said, said
    lost = [float(np.abs(motion.energy_residual).max()) for motion in motions]
    assert max(lost) < LOST, f"{lost[0]:.2e} J and {lost[1]:.2e} J are not accounted for"


def rows() -> list[Any]:
    """The scenes, all but some of them slow."""
    # a line load brings a beam with it
    flexible = [bool(FLEXIBLE & {*scene}) for scene in SCENES]
    short = sorted(range(len(SCENES)), key=lambda k: (flexible[k], len(SCENES[k]), k))
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
