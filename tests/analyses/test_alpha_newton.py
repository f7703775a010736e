"""Newton steps of the generalized-alpha method on elements in tables, and what they are held to."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

import cardan as cd
from analyses.test_alpha import SPEED, spinning, top
from benchmarks.superelement_problem import START as SPIN
from benchmarks.superelement_problem import TURN as RUN
from benchmarks.superelement_problem import slider_crank
from cardan.errors import ModelError
from cardan.runtime.models.finite_elements.frames import rotation

Array = np.ndarray
INDICES = pytest.mark.parametrize("index", [2, 3])
TILT = np.array([np.sin(0.3), 0.0, np.cos(0.3)])


def rod(tilt: Array) -> cd.Scene:
    """A rod of rubber on a ball joint, which has coordinates of its own."""
    scene = cd.Scene("spun_rod", gravity=(0, 0, -9.81))
    rubber = cd.material(E=5e6, nu=0.3, rho=1100)
    tube = cd.section.tube(0.1, 0.02)
    beam = scene.beam("rod", (0, 0, 0), tuple(tilt), tube, rubber, elements=4)
    scene.joint("pin", cd.Spherical(), scene.ground, beam.start)
    return scene


def spun(model: cd.CompiledModel, axis: Array, speed: float) -> Array:
    """The state in which everything turns about an axis through the origin."""
    x = model.simulate([0, 1e-6], method="DOP853").x[0].copy()
    tables = model._source.results(model).mesh.tables
    for kind, q, u in zip(tables.kind, tables.q, model.nq + tables.u, strict=False):
        x[u : u + 3] = speed * rotation(x[q : q + 4]).T @ axis
        if tables.kinds[kind].name == "node":
            x[u + 3 : u + 6] = speed * np.cross(axis, x[q + 4 : q + 7])
    return x


@cache
def problem(name: str) -> tuple[cd.CompiledModel, Array, float]:
    """A model that spins, its start and how fast."""
    if name == "rod":
        model = cd.compile(rod(TILT))
        return model, spun(model, TILT, SPEED), SPEED
    model = top("heavy_top_meshed", coordinates="absolute")
    return model, spinning(model), SPEED


# rotations of radians in one step


@INDICES
@pytest.mark.parametrize("turn", [0.45, 0.9, 1.2])
@pytest.mark.parametrize("name", ["top", "rod"])
def test_long_rotations(name: str, turn: float, index: int) -> None:
    """The matrix knows how far bodies turn in a step, joints with rotations of their own too; of
    index 2 speeds are bound by one of their own where that is far."""
    model, start, speed = problem(name)
    method, end = cd.GeneralizedAlpha(0.8, index=index), 60 * turn / speed
    motion = model.simulate(end, x0=start, method=method, step=turn / speed)
    told = motion.statistics
    print(f"{name}, {turn} rad, index {index}: {told['evaluations'] / told['steps']:.1f} balances")
    assert motion.success
    assert told["evaluations"] <= 7 * told["steps"]
    assert told["factorizations"] <= 3 * told["steps"]


@INDICES
@pytest.mark.parametrize("name", ["top", "rod"])
def test_full_newton_steps_converge_quadratically(name: str, index: int) -> None:
    """Three or four corrections from a prediction to rounding, at half a radian in a step."""
    model, start, speed = problem(name)
    method = cd.GeneralizedAlpha(0.8, index=index, newton="full")
    motion = model.simulate(30 / speed, x0=start, method=method, step=0.5 / speed)
    told = motion.statistics
    assert motion.success
    assert told["evaluations"] <= 4.5 * told["steps"]


# when tangents are renewed


@INDICES
def test_full_and_modified_newton_steps_agree(index: int) -> None:
    model, start, _ = problem("top")
    ends, made = [], []
    for newton in ("modified", "full"):
        method = cd.GeneralizedAlpha(0.8, index=index, newton=newton)
        motion = model.simulate([0, 0.1], x0=start, method=method, step=2e-4)
        ends.append(motion.x[-1])
        made.append(motion.statistics["factorizations"])
    assert ends[1] == pytest.approx(ends[0], abs=1e-9 * SPEED)
    # the start has one of its own
    assert made[1] >= 2 * 500
    assert made[0] <= 1.1 * 500


@pytest.mark.parametrize("frame", ["pin", "chord", "mean"])
def test_tangents_of_a_stiff_mechanism_serve_several_steps(frame: str) -> None:
    """Where the stabilization began at zero, three steps took five tangents."""
    model = cd.compile(slider_crank(frame))
    method, step = cd.GeneralizedAlpha(0.8), RUN / 1000
    told = model.simulate(0.2 * RUN, u=SPIN, method=method, step=step).statistics
    assert told["evaluations"] <= 3.5 * told["steps"]
    assert told["jacobians"] <= 0.5 * told["steps"]


def test_newton_steps_are_full_or_modified() -> None:
    model, start, _ = problem("top")
    how = {"x0": start, "step": 1e-3}
    motion = model.simulate(0.01, method=cd.GeneralizedAlpha(newton="full"), **how)
    assert "index 2, full Newton steps" in str(motion)
    assert f"{motion.statistics['jacobians']:.0f} Jacobians" in str(motion)
    assert "full" not in str(model.simulate(0.01, method=cd.GeneralizedAlpha(), **how))
    with pytest.raises(ModelError, match=r"newton='often' is 'modified'.*or 'full'"):
        cd.GeneralizedAlpha(newton="often")
    with pytest.raises(ModelError, match=r"cd\.GeneralizedAlpha\(coefficients="):
        model.simulate(0.01, method=cd.stability.Alpha.hht(), **how)


# what counts as little


@pytest.fixture(scope="module")
def rods() -> cd.CompiledModel:
    """Two rods of 1 m in a plane, anywhere and in any unit of length."""
    scene = cd.Scene("rods_anywhere")
    metre, away = scene.parameter("metre", 1.0), scene.parameter("away", 0.0)
    scene.gravity = (0, 0, -9.81 * metre)
    inertia = (metre**2 / 12, metre**2 / 12, 1e-3 * metre**2)
    a = scene.body("a", mass=1, com=(0, 0, -metre / 2), inertia=inertia)
    b = scene.body("b", mass=1, com=(0, 0, -metre / 2), inertia=inertia)
    scene.joint("upper", cd.Revolute("y"), scene.ground.at(away * metre, 0, 0), a)
    scene.joint("lower", cd.Revolute("y"), a.at(0, 0, -metre), b)
    return cd.compile(scene, coordinates="absolute")


def counted(model: cd.CompiledModel, metre: float, away: float, **how: Any) -> tuple[int, ...]:
    """Steps, rejected ones, balances and factorizations of two seconds."""
    moved = model.with_parameters(metre=metre, away=away)
    motion = moved.simulate([0, 2.0], q={"upper": 1.0, "lower": 0.5}, **how)
    assert motion.success
    names = ("steps", "rejections", "evaluations", "factorizations")
    return tuple(int(motion.statistics[name]) for name in names)


@pytest.mark.parametrize("tolerance", [1e-4, 1e-6])
@pytest.mark.parametrize(("metre", "away"), [(1.0, 1e3), (1e3, 0.0), (1e-3, 0.0)])
def test_steps_know_no_origin_and_no_unit(
    rods: cd.CompiledModel, metre: float, away: float, tolerance: float
) -> None:
    """1 km from the origin, in millimetres, in kilometres: the same steps."""
    how = {"method": cd.GeneralizedAlpha(0.8), "rtol": tolerance, "atol": 1e-3 * tolerance}
    here, there = counted(rods, 1.0, 0.0, **how), counted(rods, metre, away, **how)
    print(f"{here} here, {there} there")
    assert there == pytest.approx(here, abs=2)
    # times are rounded: what counts steps of one size must not take that for another size
    how["method"] = cd.GeneralizedAlpha(0.8, index=3)
    here, there = counted(rods, 1.0, 0.0, **how), counted(rods, metre, away, **how)
    print(f"{here} here, {there} there, of index 3")
    assert there == pytest.approx(here, abs=2)


@INDICES
def test_given_steps_know_no_origin_and_no_unit(rods: cd.CompiledModel, index: int) -> None:
    how = {"method": cd.GeneralizedAlpha(0.8, index=index), "step": 0.01}
    here = counted(rods, 1.0, 0.0, **how)
    for metre, away in ((1.0, 1e3), (1e3, 0.0), (1e-3, 0.0)):
        # whether one more correction is wanted is decided at the edge of rounding
        assert counted(rods, metre, away, **how) == pytest.approx(here, rel=0.08)
