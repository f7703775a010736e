"""Runs of mechanisms over singular positions: errors fall with the tolerance, ranks stay."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import numpy as np
import pytest

import cardan as cd
from mechanisms.closed import CLOSED
from mechanisms.closed_planar import four_bar, parallelogram, slider_crank

A = 0.2  # of crank and rod [m]
FALLING = (1e-6, 1e-8, 1e-10, 1e-12)


@pytest.fixture(scope="module")
def equal() -> cd.CompiledModel:
    """A slider-crank of equal links: its slider sits on the pivot at +- 90 degrees."""
    return cd.compile(slider_crank(A, A))


def began(model: cd.CompiledModel, theta: float = 0.3) -> dict[str, Any]:
    every = {"A": theta, "B": -2 * theta, "guide": 2 * A * math.cos(theta), "C": theta}
    return {"q": {name: every[name] for name in model.coordinates}, "u": {"A": 8.0}}


def test_rows_beside_singular_positions(equal: cd.CompiledModel) -> None:
    """guide = 2 a cos A on the branch, at whatever time a row is asked for."""
    times = np.linspace(0, 5, 5001)
    for rtol in FALLING:
        motion = equal.simulate(times, **began(equal), rtol=rtol, atol=1e-2 * rtol, check=True)
        on = 2 * A * np.cos(motion["A"])
        np.testing.assert_allclose(motion["guide"], on, rtol=0, atol=max(1e-11, 1e-2 * rtol))
        assert motion.statistics["passed"] == 6
        assert "over 6 singular positions" in repr(motion)


@pytest.mark.parametrize("step", [0.3, 0.01])
def test_stops_next_to_singular_positions(equal: cd.CompiledModel, step: float) -> None:
    exact = equal.simulate([0, 3.0], **began(equal), rtol=1e-12, atol=1e-14).x[-1]
    for rtol in (1e-8, 1e-10):
        walk = equal.stepper(**began(equal), rtol=rtol, atol=1e-2 * rtol)
        for _ in range(round(3 / step)):
            state = walk.step(step)
        # magnified tenfold in 3 s, at speeds of 30 rad/s
        np.testing.assert_allclose(state, exact, rtol=0, atol=1e2 * rtol)


def test_fixed_steps_keep_their_grid_and_order(equal: cd.CompiledModel) -> None:
    exact = equal.simulate([0, 3.0], **began(equal), rtol=1e-12, atol=1e-14).x[-1]
    errors = []
    for step in (4e-3, 2e-3, 1e-3):
        motion = equal.simulate(3.0, **began(equal), method="RK4", step=step, check=True)
        np.testing.assert_allclose(motion.t, step * np.arange(len(motion)), rtol=0, atol=1e-11)
        errors.append(float(np.abs(motion.x[-1] - exact).max()))
    assert (np.log2(np.divide(errors[:-1], errors[1:])) > 3.5).all(), errors


def test_backwards(equal: cd.CompiledModel) -> None:
    there = equal.simulate([0, 2.0], **began(equal), rtol=1e-12, atol=1e-14)
    back = equal.simulate((2.0, 0.0), x0=there.x[-1], rtol=1e-12, atol=1e-14)
    np.testing.assert_allclose(back.x[-1], there.x[0], rtol=0, atol=1e-8)


@pytest.mark.parametrize(
    "links", [(0.3, 0.2, 0.3, 0.2), (0.3, 0.3, 0.2, 0.2), (0.3, 0.2, 0.2, 0.3)]
)
def test_parallelogram_and_kites(links: tuple[float, ...]) -> None:
    """Energy is kept the better, the smaller the tolerance; every run passes the same places."""
    model = cd.compile(four_bar(*links))
    x0 = model.assemble({"A": 0.9}, u={"A": 7.0}).x
    drifts, beside, passed = [], [], []
    for rtol in FALLING:
        motion = model.simulate(3.0, x0=x0, rtol=rtol, atol=1e-2 * rtol)
        largest = float(motion.energy.kinetic.max())
        drifts.append(float(np.abs(motion.energy_residual[-1]) / largest))
        beside.append(float(np.abs(motion.energy_residual).max()) / largest)
        passed.append(motion.statistics["passed"])
    print(links, drifts, beside, passed)
    # of the two rows inside a passage, by its polynomial: the run goes on from its end, without
    assert beside[-1] < 1e-8
    assert passed[0] > 3
    assert set(passed) == {passed[0]}
    assert all(fine <= max(coarse, 1e-11) for coarse, fine in pairwise(drifts))
    assert drifts[-1] < 1e-10


@pytest.mark.parametrize(("name", "held"), [("parallelogram", 4), ("bricard", 4), ("four_bar", 2)])
def test_the_rank_does_not_flicker(name: str, held: int) -> None:
    model = cd.compile(parallelogram() if name == "parallelogram" else CLOSED[name].build())
    slots = {row["joint"] for row in model.manifest["coordinates"]}
    state = CLOSED[name].state(0.5, -3.0, slots)
    walk = model.stepper(q=state.q, u=state.u, rtol=1e-9)
    for _ in range(40):
        walk.step(0.05)
        run = walk._runner.record
        assert (run.constraint_rank, run.ranks) == (held, 0)
    assert (run.passed > 0) == (name == "parallelogram")


def test_without_a_compiler(equal: cd.CompiledModel, bare: Any) -> None:
    exact = equal.simulate([0, 0.5], **began(equal), rtol=1e-12, atol=1e-14).x[-1]
    plain, errors = bare(equal), []
    for rtol in (1e-6, 1e-8, 1e-10):
        motion = plain.simulate([0, 0.5], **began(equal), rtol=rtol, atol=1e-2 * rtol, check=True)
        assert motion.statistics["passed"] == 1
        errors.append(float(np.abs(motion.x[-1] - exact).max()))
    assert errors[0] > errors[1] > errors[2]
    assert errors[2] < 1e-8


def window_with_a_beam(closed: bool) -> cd.Scene:
    """A parallelogram whose coupler carries a beam; open, gears turn what the loop would."""
    scene = cd.Scene("window", gravity=(0, -9.81, 0))
    rod = cd.inertia.rod(1.0, 1.0, axis="x")
    bars = [scene.body(f"bar{k}", mass=1.0, com=(0.5, 0, 0), inertia=rod) for k in range(3)]
    scene.joint("A", cd.Revolute("z"), scene.ground, bars[0], q0=0.5, u0=-4.0)
    places = (("B", bars[0].at(1, 0, 0), -1.0), ("D", scene.ground.at(1, 0, 0), 1.0))
    for (name, place, ratio), bar in zip(places, bars[1:], strict=True):
        if closed:
            start = {"q0": 0.5 * ratio, "u0": -4.0 * ratio}
            scene.joint(name, cd.Revolute("z"), place, bar, **start)
        else:
            scene.joint(name, cd.Gear("A", ratio=ratio, axis="z"), place, bar)
    if closed:
        scene.joint("C", cd.Revolute("z"), bars[1].at(1, 0, 0), bars[2].at(1, 0, 0), cut=True)
    section = cd.section.general(EA=2e3, GA=1e3, GJ=1.5, EI=20.0, rhoA=1.0, rhoI=1e-3)
    place = bars[1].at(0.5, 0, 0)
    beam = scene.beam("beam", place, (1.0, 0.5, 0.0), section, elements=2, up="z")
    for axis, value in zip("xy", beam.end.position()[:2], strict=True):
        scene.output(f"tip_{axis}", value)
    return scene


@pytest.mark.parametrize("coordinates", ["auto", "absolute"])
def test_what_vibrates_passes_singular_positions(coordinates: str) -> None:
    """A step over the place is short beside the vibrations, or its sweeps do not settle."""
    ends = []
    for closed in (True, False):
        model = cd.compile(window_with_a_beam(closed), coordinates=coordinates)
        motion = model.simulate(0.2, method="DOP853", rtol=1e-10, atol=1e-12, check=True)
        assert motion.statistics["passed"] == closed
        ends.append([motion[name][-1] for name in ("A", "tip_x", "tip_y")])
    np.testing.assert_allclose(ends[0], ends[1], rtol=0, atol=1e-7)


def test_what_vibrates_passes_singular_positions_on_a_grid() -> None:
    ends = []
    for closed in (True, False):
        model = cd.compile(window_with_a_beam(closed))
        motion = model.simulate(0.2, method="RK4", step=5e-4, check=True)
        np.testing.assert_allclose(motion.t, 5e-4 * np.arange(len(motion)), rtol=0, atol=1e-11)
        assert motion.statistics["passed"] == closed
        ends.append([motion[name][-1] for name in ("A", "tip_x", "tip_y")])
    np.testing.assert_allclose(ends[0], ends[1], rtol=0, atol=1e-4)
