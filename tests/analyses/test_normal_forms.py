"""Normal forms of bifurcations, stiff and soft: where they are, what leaves them, what starts."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from cardan.errors import ArgumentError, SolveWarning
from mechanisms.change_points import linkage, turns

Force = Callable[[Any, Any], Any]


def slider(force: Force) -> cd.CompiledModel:
    """A body on a rail x, pushed by a force of mu and x."""
    scene = cd.Scene("slider", gravity=(0, 0, 0))
    mu = scene.parameter("mu", -1.0)
    body = scene.body("body", mass=1.0, inertia=(1, 1, 1))
    scene.joint("x", cd.Prismatic("x"), scene.ground, body)
    scene.force("push", cd.JointForce("x", force(mu, scene.q("x"))))
    return cd.compile(scene)


def path_of(force: Force, mu: tuple[float, float] = (-1.0, 1.0), x: float = 0.0) -> Any:
    return slider(force).continuation(mu=mu, q={"x": x}, branches=True, bounds={"x": (-1, 1)})


@pytest.mark.parametrize("c", [1.0, 1e2, 1e4, 1e6, 1e8])
def test_a_pitchfork_of_any_curvature(c: float) -> None:
    """mu x = c x^3: mu = c x^2."""
    path = path_of(lambda mu, x: mu * x - c * x**3)
    point = path.point("branch point 1")
    assert abs(point.values["mu"]) < 1e-12
    assert point.branches == ("1a", "1b")
    for name in point.branches:
        branch = path.branches[name]
        exact = np.sqrt(np.maximum(branch["mu"], 0) / c)
        np.testing.assert_allclose(np.abs(branch["x"]), exact, rtol=1e-9, atol=1e-9)
        assert branch["mu"][-1] == pytest.approx(1.0, abs=1e-9)
    if c <= 1e4:
        assert point.symmetric == (("1a", "1b"),)
        np.testing.assert_allclose(np.abs(point.tangents[:, 0]), 1.0, atol=1e-8)


@pytest.mark.parametrize("c", [1.0, 1e2, 1e4, 1e6])
def test_a_crossing_at_any_angle(c: float) -> None:
    """mu x = c x^2: x = mu / c, which leaves at an angle of 1 / c."""
    path = path_of(lambda mu, x: mu * x - c * x**2)
    point = path.point("branch point 1")
    assert abs(point.values["mu"]) < 1e-12
    assert point.branches == ("1a", "1b")
    for name, (along, load) in zip(point.branches, point.tangents, strict=True):
        # a whole range is one unit of the load
        assert along / (2 * load) == pytest.approx(1 / c, rel=1e-6)
        branch = path.branches[name]
        np.testing.assert_allclose(c * branch["x"], branch["mu"], rtol=1e-8, atol=1e-9)


def test_a_branch_point_at_which_the_load_turns_back_is_one_point() -> None:
    path = path_of(lambda mu, x: mu * x - x**3, (0.81, -1.0), 0.9)
    assert [point.kind for point in path.points] == ["branch point", "event"]
    assert path["x"][-1] == pytest.approx(-1.0, abs=1e-9)


def test_curves_that_were_followed_go_by_their_names() -> None:
    """x (mu - x^2) (mu - 0.5 - x): the line is met by the main path and by a half of the other."""
    path = path_of(lambda mu, x: x * (mu - x**2) * (mu - 0.5 - x))
    named = {name for branch in path.branches.values() for point in branch.points
             for name in point.branches}  # fmt: skip
    assert named <= set(path.branches)
    # every point of all curves lies on one of the three, and each of these is followed once
    counts = [0, 0, 0]
    for branch in path.branches.values():
        x, mu = branch["x"][len(branch) // 2], branch["mu"][len(branch) // 2]
        left = np.abs([x, mu - x**2, mu - 0.5 - x])
        assert left.min() < 1e-9
        counts[int(left.argmin())] += 1
    assert counts[0] == 1
    assert all(counts)


def test_branches_end_a_range_before_the_start() -> None:
    path = path_of(lambda mu, x: mu * x - 1e-3 * x**2)
    ended = {name: branch["mu"][-1] for name, branch in path.branches.items()}
    assert all(abs(mu) <= 3 + 1e-9 for mu in ended.values()), ended


STARTS: dict[str, tuple[Force, int]] = {
    "pitchfork": (lambda mu, x: mu * x - x**3, 2),
    "pitchfork backward": (lambda mu, x: mu * x + x**3, 2),
    "crossing": (lambda mu, x: mu * x - x**2, 2),
    "fold": (lambda mu, x: mu - x**2, 0),
}


@pytest.mark.parametrize("name", STARTS)
def test_a_start_where_curves_cross_or_turn_back(name: str) -> None:
    force, count = STARTS[name]
    path = path_of(force, (0.0, 1.0))
    assert path.main.values["mu"][0] == 0.0
    assert path["mu"][-1] == pytest.approx(1.0, abs=1e-9)
    crossing = [point for point in path.points if point.kind == "branch point"]
    assert [len(point.branches) for point in crossing] == ([count] if count else [])
    assert set(path.branches) == {"main", *(crossing[0].branches if count else ())}
    for branch in path.branches.values():
        left = [float(force(mu, x)) for mu, x in zip(branch["mu"], branch["x"], strict=True)]
        np.testing.assert_allclose(left, 0, atol=1e-9)
    if name == "fold":
        np.testing.assert_allclose(path["x"] ** 2, path["mu"], atol=1e-9)


def test_a_start_where_positions_branch() -> None:
    """A parallelogram with all links on one line: it goes on, or crosses."""
    model = linkage(1.0, 2.0, 1.0, 2.0)
    path = model.continuation(A=(0, 3), of="positions", q={"B": 0, "D": 0}, branches=True)
    point = path.point("branch point 1")
    assert abs(turns(point["A"])) < 1e-9
    # the parallelogram is the main path, the other one leaves to both sides
    np.testing.assert_allclose(turns(path["D"] - path["A"]), 0, atol=1e-9)
    assert len(point.branches) == 2
    for a, b, d, _ in point.tangents:
        np.testing.assert_allclose([(a + b) / a, d / a], [-2, -3], atol=1e-8)
    crossed = path.branches[point.branches[0]]
    theta, phi = crossed["A"], crossed["D"]
    left = np.sin(phi / 2) * np.cos(theta / 2)
    right = np.cos(phi / 2) * np.sin(theta / 2) * 3
    np.testing.assert_allclose(left, -right, atol=1e-12)


def test_paths_say_when_nothing_moves_and_what_moves_where_they_end() -> None:
    still = slider(lambda mu, x: -x + 0.1).continuation(mu=(0, 1))
    assert "it stays where it is at any mu" in still.message
    with pytest.warns(SolveWarning, match=r"it moves along 'x' there"):
        domain = slider(lambda mu, x: -x + sp.sqrt(0.25 - mu)).continuation(mu=(0, 1))
    assert domain["mu"][-1] == pytest.approx(0.25, abs=1e-3)
    assert math.isfinite(domain["x"][-1])


def test_a_path_has_two_points_at_least() -> None:
    with pytest.raises(ArgumentError, match="2 at least"):
        slider(lambda mu, x: mu - x).continuation(mu=(0, 1), points=1)


@pytest.mark.parametrize("e", [1e-2, 1e-4, 1e-6])
def test_two_folds_within_a_step(e: float) -> None:
    """mu = x^3 - e x turns back at x^2 = e / 3: far less than a step."""
    path = slider(lambda mu, x: mu - x**3 + e * x).continuation(mu=(-1, 1), q={"x": -1.0})
    assert [point.kind for point in path.points] == ["fold", "fold", "event"]
    exact = 2 * np.sqrt(e / 3) ** 3
    loads = [point["mu"] for point in path.points[:2]]
    np.testing.assert_allclose(loads, [exact, -exact], rtol=1e-6, atol=1e-15)


@pytest.mark.parametrize("c", [-1.0, 1.0])
@pytest.mark.parametrize("ends", [{"mu": (-1, 0)}, {"mu": (-1, 1), "until": {"mu": 0.0}}])
def test_a_path_to_a_branch_point_ends_there(c: float, ends: Any) -> None:
    """mu x = c x^3 + x^5: the equations at mu = 0 are singular."""
    model = slider(lambda mu, x: mu * x - c * x**3 - x**5)
    path: Any = model.continuation(**ends, branches=1)
    assert path["mu"][-1] == pytest.approx(0.0, abs=1e-12)
    assert path.point("branch point 1").branches == ("1a", "1b")
    assert all(branch.status == "finished" for branch in path.branches.values())
    assert all(branch["mu"].max() <= 1 + 1e-9 for branch in path.branches.values())


def test_a_search_beside_a_circle_of_equilibria() -> None:
    """x = 0, and a circle that no path leads to: iterations come to where deflation is infinite."""
    model = slider(lambda mu, x: -x * (mu**2 + (x - 1) ** 2 - 0.04))
    path: Any = model.continuation(mu=(-0.5, 0.5), search=4)
    (circle,) = [branch for name, branch in path.branches.items() if name.startswith("other")]
    assert circle.status == "closed"
    np.testing.assert_allclose(circle["mu"] ** 2 + (circle["x"] - 1) ** 2, 0.04, atol=1e-9)


def test_a_load_that_moves_nothing_may_change_stiffness() -> None:
    """mu x = 0 at x = 0: the path ends in front of its branch point."""
    still = slider(lambda mu, x: mu * x - x**3).continuation(mu=(-1, -0.5))
    assert "nothing depends" not in still.message


@pytest.mark.parametrize("e", [0.1, 1e-2, 1e-3, 1e-4])
def test_an_oscillation_that_begins_next_to_a_fold(e: float) -> None:
    """x'' + (x - e) x' = 2 (P - x^2): damping is 0 at x = e, P = e^2, and the load turns at 0."""
    scene = cd.Scene("near", gravity=(0, 0, 0))
    load = scene.parameter("P", 1.0)
    body = scene.body("body", mass=1.0, inertia=(1, 1, 1))
    scene.joint("x", cd.Prismatic("x"), scene.ground, body)
    x, v = scene.q("x"), scene.u("x")
    scene.force("push", cd.JointForce("x", 2 * (load - x**2) - (x - e) * v))
    path = cd.compile(scene).continuation(P=(1, -1), q={"x": 1.0}, bounds={"x": (-2, 2)})
    hopf, fold, _ = path.points
    assert (hopf.kind, fold.kind) == ("Hopf point", "fold")
    assert hopf.values["P"] == pytest.approx(e**2, rel=1e-6)
    assert hopf["x"] == pytest.approx(e, rel=1e-6)
    assert hopf.frequency == pytest.approx(2 * np.sqrt(e), rel=1e-6)
    assert abs(fold.values["P"]) < 1e-12
