"""Paths of cycles that shrink to rest end there: at a Hopf point, or at a state of no energy."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.special import ellipk

import cardan as cd
from cardan.errors import ModelError
from cycle_scenes import POINT

END = "reached a Hopf point: the cycle shrinks to rest"


def between_two_hopf_points(symmetric: bool) -> cd.CompiledModel:
    """x'' = (mu (1 - mu) - y^2) x' - y + ..., y = x or x - mu: cycles between mu = 0 and 1."""
    scene = cd.Scene("two", gravity=(0, 0, 0))
    mu = scene.parameter("mu", -0.2)
    scene.parameter("other", 0.0)
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("body", **POINT))
    x, v = scene.q("x"), scene.u("x")
    y, bent = (x, 0) if symmetric else (x - mu, 0.4 * (x - mu) ** 2 + 0.3 * mu * (x - mu))
    scene.force("force", cd.JointForce("x", (mu * (1 - mu) - y**2) * v - y - bent))
    return cd.compile(scene)


@pytest.fixture(scope="module", params=[True, False], ids=["symmetric", "moving"])
def model(request: pytest.FixtureRequest) -> cd.CompiledModel:
    return between_two_hopf_points(request.param)


@pytest.mark.parametrize(("first", "span"), [(1, (-0.1, 1.2)), (2, (1.1, -0.2)), (1, (0.5, 1.2))])
def test_from_one_hopf_point_to_the_other(
    model: cd.CompiledModel, first: int, span: tuple[float, float]
) -> None:
    rest = model.continuation(mu=(-0.2, 1.2))
    path = model.continuation(mu=span, of="cycles", start=rest.point(f"Hopf point {first}"))
    there = rest.point(f"Hopf point {3 - first}")
    assert path.main.status == "finished"
    assert END in path.main.message
    assert [point.kind for point in path.points] == ["Hopf point"]
    point = path.point("Hopf point 1")
    assert point["mu"] == pytest.approx(there["mu"], abs=1e-8)
    assert point["period"] == pytest.approx(2 * np.pi / there.frequency, abs=1e-7)
    assert "where the cycle shrinks to rest" in repr(point)
    assert point["x"] == pytest.approx(there["x"], abs=1e-3)
    # the first harmonic alone: A^2 = 4 mu (1 - mu)
    if first == 1 and span[0] < 0 and there["x"] == 0:
        half = int(np.abs(path["mu"] - 0.5).argmin())
        amplitude = 2 * np.sqrt(path["mu"][half] * (1 - path["mu"][half]))
        assert path["x.max"][half] == pytest.approx(amplitude, rel=1e-2)


@pytest.mark.parametrize("end", [1.2, -0.2])
def test_from_a_cycle_in_between(model: cd.CompiledModel, end: float) -> None:
    cycle = model.cycle({"x": 0.6, "x.u": 0.3}, parameters={"mu": 0.5}, settle=10, check=True)
    path = model.continuation(mu=(0.5, end), of="cycles", start=cycle)
    assert END in path.main.message
    assert path.point("Hopf point 1")["mu"] == pytest.approx(float(end > 0), abs=1e-8)


def test_another_sweep_than_that_of_the_start_is_refused() -> None:
    model = between_two_hopf_points(True)
    start = model.continuation(mu=(-0.2, 0.5)).point("Hopf point 1")
    with pytest.raises(ModelError, match=r"start= is at mu = .*: sweep that, through it"):
        model.continuation(other=(0, 1), of="cycles", start=start)


def test_a_mode_without_energy() -> None:
    scene = cd.Scene("pendulum", gravity=(0, 0, -9.81))
    bob = scene.body("bob", mass=1.0, inertia=(0, 0, 0), com=(0, 0, -1))
    scene.joint("angle", cd.Revolute("y"), scene.ground, bob)
    pendulum = cd.compile(scene)
    swing: Any = pendulum.continuation(energy=(0.0, 5.0), of="cycles", start=pendulum.modes()[0])
    path = pendulum.continuation(energy=(5.0, -1.0), of="cycles", start=swing[-1])
    assert "reached a state of rest" in path.main.message
    assert path["energy"][-1] == pytest.approx(0.0, abs=1e-6)
    periods = 4 * np.sqrt(1 / 9.81) * ellipk(np.sin(path["angle"][:-1] / 2) ** 2)
    np.testing.assert_allclose(path["period"][:-1], periods, rtol=1e-9)
    columns = path.table()
    for name in ("energy", "angle", "period", "multiplier"):
        np.testing.assert_array_equal(columns[name], path[name])


@pytest.mark.parametrize("low", [1e-3, 1e-6])
def test_an_energy_next_to_rest_is_not_stepped_over(low: float) -> None:
    """A step may lead through rest to the mirrored cycles, whose energies are above the end."""
    scene = cd.Scene("hard", gravity=(0, 0, 0))
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("body", **POINT))
    x = scene.q("x")
    scene.force("spring", cd.JointForce("x", -x - x**3))
    hard = cd.compile(scene)
    out: Any = hard.continuation(energy=(0, 0.8), of="cycles", start=hard.modes()[0])
    events = {"energy": 2 * low}
    path: Any = hard.continuation(
        energy=(0.8, low), of="cycles", start=out[-1], points=40, events=events
    )
    assert path.main.message.endswith(f"reached energy = {low:.10g}")
    assert path["energy"][-1] == pytest.approx(low, rel=1e-6)
    assert path["x.max"][-1] == pytest.approx(np.sqrt(2 * low), rel=1e-3)
    assert path.point(f"energy = {2 * low:.10g}")["energy"] == pytest.approx(2 * low, rel=1e-6)


@pytest.mark.parametrize("low", [1e-5, 0.0])
def test_small_cycles_of_a_wide_motion_end_at_rest(low: float) -> None:
    """In units of a wide motion no cycles are solved for next to rest: the path ends there."""
    scene = cd.Scene("swing", gravity=(0, 0, -9.81))
    bar: Any = {"mass": 1.0, "inertia": (0, 0, 0), "com": (0, 0, -1)}
    upper, lower = scene.body("upper", **bar), scene.body("lower", **bar)
    scene.joint("upper", cd.Revolute("y"), scene.ground, upper)
    scene.joint("lower", cd.Revolute("y"), upper.at(0, 0, -1), lower)
    swing = cd.compile(scene)
    out: Any = swing.continuation(energy=(0, 10.0), of="cycles", start=swing.modes()[1])
    path: Any = swing.continuation(energy=(0.8, low), of="cycles", start=out[-1], points=40)
    assert path.main.status == "finished"
    assert path["energy"][-1] == pytest.approx(low, abs=1e-6)
    assert path["energy"].max() <= 0.8 + 1e-9
