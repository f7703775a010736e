"""Paths that cannot go on, and calls that mean nothing: each says so, none is wrong in silence."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from cardan.errors import ModelError, SolveWarning

POINT = {"mass": 1.0, "inertia": (1.0, 1.0, 1.0)}


def slide(law: Callable[[Any, Any], Any]) -> cd.CompiledModel:
    """A body on a slide x with a force that depends on x and a parameter P."""
    scene = cd.Scene("slide", gravity=(0, 0, 0))
    load, body = scene.parameter("P", 0.0), scene.body("body", **POINT)
    scene.parameter("Q", 0.0)
    scene.joint("x", cd.Prismatic("x"), scene.ground, body)
    scene.force("force", cd.JointForce("x", law(scene.q("x"), load)))
    return cd.compile(scene)


# force, load by the position, and where the path ends
ENDING: dict[str, tuple[Callable[[Any, Any], Any], Callable[[Any], Any], float]] = {
    "root": (lambda x, P: sp.sqrt(1 - P) - x, lambda x: 1 - x**2, 1.0),
    "logarithm": (lambda x, P: sp.log(1 - P) - x, lambda x: 1 - np.exp(x), 1.0),
    "pole": (lambda x, P: 1 / (1 - P) - x, lambda x: 1 - 1 / x, 1.0),
}


@pytest.mark.parametrize("name", ENDING)
def test_paths_end_where_there_is_nothing_more(name: str) -> None:
    law, load, last = ENDING[name]
    with pytest.warns(SolveWarning, match="steps become too short|points= allows"):
        path = slide(law).continuation(P=(0, 2))
    assert not path.success
    # points are as good as the last corrections, which are below 1e-9
    assert 0.8 * last < path["P"].max() <= last + 1e-9
    np.testing.assert_allclose(path["P"], load(path["x"]), atol=2e-9)


def test_what_nothing_depends_on_changes_nothing() -> None:
    path = slide(lambda x, P: 1 - x + 0 * P).continuation(Q=(0, 1))
    assert path.success
    assert path["x"] == pytest.approx(np.ones(len(path)))
    assert [point.kind for point in path.points] == ["event"]


def test_where_every_position_balances_another_path_crosses() -> None:
    path = slide(lambda x, P: P * x - x).continuation(P=(0, 2), branches=1, bounds={"x": (-1, 1)})
    (point, _) = path.points
    assert point["P"] == pytest.approx(1.0, abs=1e-10)
    for name in ("1a", "1b"):
        np.testing.assert_allclose(path.branches[name]["P"], 1.0, atol=1e-10)
        assert abs(path.branches[name]["x"][-1]) == pytest.approx(1.0)


def test_ranges_are_of_any_size() -> None:
    for size in (1e-14, 1e-6, 1e6):
        path = slide(lambda x, P, size=size: P / size - x).continuation(P=(0, size))
        assert path.success
        assert path["x"][-1] == pytest.approx(1.0, rel=1e-12)


def test_a_range_that_is_none_is_refused() -> None:
    with pytest.raises(ModelError, match="P ends where it starts"):
        slide(lambda x, P: P - x).continuation(P=(1, 1))


@pytest.mark.parametrize("prescribed", [False, True])
def test_what_cannot_move_is_refused(prescribed: bool) -> None:
    scene = cd.Scene("rigid")
    turn, body = scene.parameter("P", 0.0), scene.body("body", **POINT)
    joint = cd.Revolute("z") if prescribed else cd.Fixed()
    scene.joint("x", joint, scene.ground, body, **({"prescribed": turn} if prescribed else {}))
    model = cd.compile(scene)
    for call in (lambda: model.continuation(P=(0, 1)), lambda: model.statics(P=(0, 1))):
        with pytest.raises(ModelError, match="nothing in this model can move"):
            call()
    with pytest.raises(ModelError, match="nothing in this model can move"):
        model.equilibrium()


def test_many_points_are_followed() -> None:
    path = slide(lambda x, P: P - x - 3 * sp.sin(x)).continuation(
        P=(0, 20), step=5e-3, points=20000
    )
    assert path.success
    assert len(path) > 2000
    position = path["x"]
    np.testing.assert_allclose(path["P"], position + 3 * np.sin(position), atol=1e-9)


@pytest.mark.parametrize(
    ("bounds", "last"), [((-1, 0), 0.0), ((0, 2), 1.0), ((1e-9, 2), 1.0), ((-1, -1e-9), 0.0)]
)
def test_a_start_on_a_bound_lies_within_it(bounds: tuple[float, float], last: float) -> None:
    path = slide(lambda x, P: P - x).continuation(P=(0, 1), bounds={"x": bounds})
    assert path["x"][-1] == pytest.approx(last, abs=1e-5)


@pytest.mark.parametrize(
    ("more", "error", "match"),
    [
        ({"search": -1}, cd.ArgumentError, r"search=-1: give the number"),
        ({"start": 3}, ModelError, r"start= is of cycles"),
        ({"bounds": {"x": (2, -1)}}, cd.ArgumentError, r"the first is the lower one"),
        ({"bounds": {"x": (1, 2)}}, ModelError, r"starts at x = 0, and bounds= end it"),
    ],
)
def test_what_means_nothing_is_refused(more: Any, error: type[Exception], match: str) -> None:
    with pytest.raises(error, match=match):
        slide(lambda x, P: P - x).continuation(P=(0, 1), **more)
