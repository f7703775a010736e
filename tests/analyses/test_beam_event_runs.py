"""Runs of beams with events: every integrator, ensembles, steppers, files, pages, energies."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from analyses.test_beam_events import LOWER, cantilever
from cardan.schema.integrators import INTEGRATORS
from view.unpacked import data_of

SPAN, STEP = 0.12, 1e-4
# what a method says that cannot, by name, with its cure
REFUSED = {
    "Newmark": "'Newmark'.*damping.*cd.GeneralizedAlpha",
    "EnergyMomentum": "'EnergyMomentum' keeps what is conserved, and .* has modes: take method=",
}
# explicit ones of given steps resolve the longitudinal vibration of light elements
SHORT = {"RK4": 2e-5, "RKMK4": 2e-5, "EnergyMidpoint": 5e-5}


def everything() -> cd.Scene:
    """A beam with a stop, friction, a lock that opens, and a sampled controller."""
    scene = cantilever(2, lower=LOWER, restitution=0.2)
    # a second joint of the scene rubs against its rail
    scene.force("rub", cd.Friction("run", coulomb=2e-4))
    wheel = scene.body("wheel", mass=0.05, inertia=(1e-4,) * 3)
    scene.joint("spin", cd.Revolute("y"), scene.bodies["head"], wheel)
    latch = cd.Lock("spin", locked=True, when=1, release=0.05 - cd.t, strength=5.0)
    scene.force("latch", latch)
    q, u = scene.q("spin"), scene.u("spin")
    pid = cd.Controller.pid("spin", q, u, target=0.4, kp=0.3, ki=0.5, kd=0.01, sample=0.01)
    scene.force("pid", pid)
    return scene


@pytest.fixture(scope="module")
def model() -> cd.CompiledModel:
    """A beam at a stop."""
    return cd.compile(cantilever(2, lower=LOWER, restitution=0.0))


@pytest.fixture(scope="module")
def scene_of_all() -> cd.CompiledModel:
    """A beam with what may happen to it."""
    return cd.compile(everything())


@pytest.fixture(scope="module")
def motion(scene_of_all: cd.CompiledModel) -> cd.Trajectory:
    """Its motion."""
    return scene_of_all.simulate(SPAN, method=cd.GeneralizedAlpha(0.8), step=2e-5)


@pytest.fixture(scope="module")
def fine(model: cd.CompiledModel) -> cd.Trajectory:
    """The motion of the beam at a stop, to tight tolerances."""
    return model.simulate(SPAN, method="DOP853", rtol=1e-10, atol=1e-12)


@pytest.mark.parametrize("method", [*INTEGRATORS])
def test_every_method_runs_or_says_why_not(
    model: cd.CompiledModel, fine: cd.Trajectory, method: str
) -> None:
    if method in REFUSED:
        with pytest.raises(cd.ModelError, match=REFUSED[method]):
            model.simulate(SPAN, method=method)
        return
    options = {"step": SHORT[method]} if method in SHORT else {"rtol": 1e-7, "atol": 1e-10}
    mine = model.simulate(SPAN, method=method, **options)
    assert mine.success
    assert [event.name for event in mine.events] == [event.name for event in fine.events]
    times = [event.t for event in fine.events]
    near = 2e-5 if method not in ("GeneralizedAlpha", "HHT") else 1e-4
    assert [event.t for event in mine.events] == pytest.approx(times, abs=near)
    assert mine["rail"][-1] == pytest.approx(fine["rail"][-1], abs=2e-6 if near < 1e-4 else 1e-5)


def test_newmark_takes_events_where_nothing_is_constrained() -> None:
    scene = cd.Scene("ball", gravity=(0, 0, -9.81))
    ball = scene.body("ball", mass=0.2, inertia=(1e-3,) * 3)
    scene.joint("J", cd.Free(), scene.ground, ball)
    floor = cd.Contact(ball, scene.ground, radius=0.1, stiffness=2e3, damping=0.1)
    scene.force("floor", floor)
    names, values = [], []
    for method in ("Newmark", "DOP853"):
        found = cd.compile(scene, coordinates="absolute").simulate(
            0.6, q={"J.pz": 0.3}, method=method, rtol=1e-8, atol=1e-10
        )
        names.append([event.name for event in found.events])
        values.append(found["J.pz"][-1])
    assert names[0] == names[1] != []
    assert values[0] == pytest.approx(values[1], abs=1e-4)


@pytest.mark.parametrize("method", ["DOP853", "GeneralizedAlpha"])
def test_ensembles_are_single_runs(model: cd.CompiledModel, method: str) -> None:
    starts = np.array([0.0, -0.02])
    together = model.ensemble(SPAN, u={"rail": starts}, method=method)
    for k, start in enumerate(starts):
        alone = model.simulate(SPAN, u={"rail": start}, method=method)
        np.testing.assert_array_equal(together.run(k).x[-1], alone.x[-1])
        np.testing.assert_array_equal(together.run(k).s[-1], alone.s[-1])


def test_a_stepper_goes_as_a_run(model: cd.CompiledModel) -> None:
    method = cd.GeneralizedAlpha(0.8)
    whole = model.simulate(SPAN, method=method, step=STEP)
    stepper = model.stepper(method=method, step=STEP)
    names = []
    for t in np.linspace(0, SPAN, 13)[1:]:
        stepper.step(SPAN / 12)
        assert stepper.t == pytest.approx(t)
        names += [event.name for event in stepper.events]
    assert names == [event.name for event in whole.events]
    assert stepper.state == pytest.approx(whole.x[-1], abs=1e-5)


@pytest.mark.parametrize("method", ["DOP853", "GeneralizedAlpha"])
def test_a_checkpoint_in_memory_goes_on_to_the_same_bits(
    model: cd.CompiledModel, method: str
) -> None:
    stepper = model.stepper(method=method)
    stepper.step(0.1)
    middle = stepper.save()
    ends = []
    for _ in range(2):
        stepper.restore(middle)
        stepper.step(0.02)
        ends.append((np.array(stepper.state), [event.t for event in stepper.events]))
    np.testing.assert_array_equal(ends[0][0], ends[1][0])
    assert ends[0][1] == ends[1][1] != []


def test_ensembles_go_on_from_a_file(model: cd.CompiledModel, tmp_path: Path) -> None:
    starts, file = {"rail": np.array([0.0, -0.02])}, tmp_path / "runs.npz"
    first = model.ensemble(SPAN, u=starts, method="DOP853", checkpoint=file)
    again = model.ensemble(SPAN, u=starts, method="DOP853", checkpoint=file)
    np.testing.assert_array_equal(first.final, again.final)


def test_dense_output_stays_on_the_constraints_that_modes_hold(model: cd.CompiledModel) -> None:
    motion = model.simulate(SPAN, method=cd.GeneralizedAlpha(0.8), step=STEP)
    hit, left = (event.t for event in motion.events[:2])
    times = np.linspace(hit, left, 57)[1:-1]
    states = motion.at(times)
    rail, speed = model.coordinates.index("rail"), model.nq + model.speeds.index("rail.u")
    assert states[:, rail] == pytest.approx(LOWER, abs=1e-9)
    assert states[:, speed] == pytest.approx(0.0, abs=1e-9)
    for x, t in zip(states[::9], times[::9], strict=True):
        rates = model.constraint_rates(
            x[: model.nq], x[model.nq :], s=motion.events[0].s_after, t=t
        )
        assert rates == pytest.approx(0.0, abs=1e-9)


def test_events_of_all_kinds_happen(motion: cd.Trajectory) -> None:
    assert motion.success
    names = [event.name for event in motion.events]
    assert {"stop.lower", "latch.release"} <= {*names}
    assert any(name.startswith("rub.") for name in names)
    # the wheel is free once the latch is open
    before = motion.t < 0.05
    assert np.abs(motion["spin"][before]).max() < 1e-9
    assert abs(motion["spin"][-1]) > 1e-2


def test_energies_balance_over_events(motion: cd.Trajectory) -> None:
    work = {name: float(np.asarray(x)[-1]) for name, x in motion.work.items()}
    largest = motion.energy.kinetic.max()
    assert np.abs(motion.energy_residual).max() < 1e-4 * largest
    assert work["stop.impact"] < 0
    assert abs(sum(work.values())) > 1e-3 * largest


def test_files_keep_events(motion: cd.Trajectory, tmp_path: Path) -> None:
    motion.save(tmp_path / "run.nc")
    again = cd.load_motion(tmp_path / "run.nc")
    assert [(e.name, e.t, e.kind) for e in again.events] == [
        (e.name, e.t, e.kind) for e in motion.events
    ]
    for mine, theirs in zip(again.events, motion.events, strict=True):
        np.testing.assert_array_equal(mine.x_after, theirs.x_after)
        np.testing.assert_array_equal(mine.s_after, theirs.s_after)
    np.testing.assert_array_equal(again.x, motion.x)
    np.testing.assert_array_equal(again.s, motion.s)
    motion.save(tmp_path / "run.csv")
    with (tmp_path / "run.csv").open() as file:
        head, *rows = list(csv.reader(file))
    assert len(rows) == len(motion.t)
    column = np.array([float(row[head.index("rail")]) for row in rows])
    assert column == pytest.approx(motion["rail"], abs=1e-15)


def test_pages_show_events(motion: cd.Trajectory, tmp_path: Path) -> None:
    motion.animate(tmp_path / "page.html")
    shown = data_of((tmp_path / "page.html").read_text("utf-8"))["events"]
    assert {"stop.lower", "latch.release"} <= {event["name"] for event in shown}
