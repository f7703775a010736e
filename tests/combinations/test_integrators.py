"""Every integrator with every two features that it has equations for; what it refuses, and why."""

from __future__ import annotations

import functools
from collections.abc import Callable
from itertools import combinations
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.schema.integrators import INTEGRATORS

from .features import PRESENT, closed
from .method_arrays import ARRAYS, COORDINATES, EXCLUDED, REFUSED
from .refusals import expected
from .routes import FLEXIBLE, Names, outputs_at, route
from .test_combinations import checked

# of methods of low order and of others: the tolerance they are given, and what is left of 1 m
LOW, HIGH = (1e-5, 5e-3), (1e-8, 1e-4)
# steps of methods that do not choose them, which resolve the vibrations of the beam
STEP = 2e-4
# scenes in every run: the ones that build soonest
QUICK = 1


@functools.lru_cache(maxsize=2)
def fine(names: Names, coordinates: str) -> np.ndarray:
    """Outputs of a tight run by DOP853, the route that all methods are compared with."""
    motion = route(names, coordinates).run()
    assert motion.success, f"{motion.status}: {motion.message}"
    return np.asarray(outputs_at(motion))


def moves(method: str) -> Callable[[Names], object]:
    """A run by a method that ends where a fine one ends."""

    def act(names: Names) -> None:
        kind, row = COORDINATES.get(method, "auto"), INTEGRATORS[method]
        rtol, near = HIGH if row.order > 3 else LOW
        options = {"rtol": rtol, "atol": 1e-2 * rtol} if row.adaptive else {"step": STEP}
        motion = route(names, kind).run(method=method, **options)
        assert motion.success, f"{motion.status}: {motion.message}"
        gap = np.abs(outputs_at(motion) - fine(names, kind)).max()
        assert gap < near, f"off by {gap:.2e}"

    return act


def test_every_two_features_meet_every_integrator() -> None:
    for method, scenes in ARRAYS.items():
        taken = [name for name in PRESENT if name not in REFUSED.get(method, ())]
        pairs = {frozenset(pair) for scene in scenes for pair in combinations(scene, 2)}
        every = {frozenset(pair) for pair in combinations(taken, 2)}
        feature, partners = EXCLUDED.get(method, ("", ()))
        assert pairs == every - {frozenset((feature, other)) for other in partners}, method


def rows() -> list[Any]:
    """Scene by scene, so that each is derived once; all but some of them slow."""
    every = {s for array in ARRAYS.values() for s in array}
    scenes = sorted(every, key=lambda s: (bool(FLEXIBLE & {*s}), s))
    number = {scene: k for k, scene in enumerate(scenes)}
    return [
        pytest.param(
            *(method, scene),
            id=f"scene{number[scene]}-{method}",
            marks=[pytest.mark.slow] if number[scene] >= QUICK else [],
        )
        for scene in scenes
        for method, array in ARRAYS.items()
        if scene in array
    ]


@pytest.mark.parametrize(("method", "scene"), rows())
def test_integrators(method: str, scene: Names) -> None:
    checked(scene, moves(method), method)


@pytest.mark.parametrize(
    ("method", "name"),
    [
        pytest.param(method, name, marks=[] if name in ("wheel", "stop") else [pytest.mark.slow])
        for method, names in REFUSED.items()
        for name in names
    ],
)
def test_what_is_refused_is_on_the_list(method: str, name: str) -> None:
    side = route(closed((name,)), COORDINATES.get(method, "auto"))
    with pytest.raises(cd.ModelError) as problem:
        side.run(t=2 * STEP, method=method, step=STEP)
    expected((name,), method, " ".join(str(problem.value).split()))
