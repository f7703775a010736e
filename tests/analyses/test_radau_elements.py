"""Radau over elements: order, constraints, beams, loops, internal states, events."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from analyses.test_beam_event_runs import everything
from laws.event_scenes import SCENES
from mechanisms.closed_spatial import bricard, bricard_angles
from mechanisms.flexible import pendulum, spin_up

REFERENCES = Path(__file__).parents[1] / "references"
START = {"q": {"B": 0.5}, "u": {"A": [1.0, 0.5, 3.0], "B": 2.0}}


def swinging() -> cd.Scene:
    """A rod on a ball joint with another on a hinge, in space."""
    scene = cd.Scene("swinging", gravity=(0, 0, -9.81))
    a = scene.body("a", mass=1.0, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.02))
    b = scene.body("b", mass=0.7, com=(0, 0, -0.4), inertia=(0.07, 0.05, 0.02))
    scene.joint("A", cd.Spherical(), scene.ground, a)
    scene.joint("B", cd.Revolute("y"), a.at(0, 0, -1), b)
    return scene


def test_order_of_motion_and_reactions() -> None:
    """Against the same scene in joint coordinates; positions are closed to rounding."""
    model, other = cd.compile(swinging(), coordinates="absolute"), cd.compile(swinging())
    exact = other.simulate(1.0, **START, method="DOP853", rtol=1e-13, atol=1e-14)
    errors = []
    for steps in (40, 80, 160):
        # without rtol the equations are solved to rounding, and max_step= makes all steps equal
        motion = model.simulate(
            1.0, **START, method="Radau", rtol=0, atol=1.0, step=1 / steps, max_step=1 / steps
        )
        assert len(motion.t) == steps + 1
        force = [m.reaction("B")[-1] for m in (motion, exact)]
        errors.append([abs(motion["B"][-1] - exact["B"][-1]), np.abs(force[0] - force[1]).max()])
        for level in ("position", "velocity"):
            found = motion.drift.worst(level)
            assert found is not None
            assert found[1].before < 1e-13
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    print("errors of angle and reaction", errors, "orders", orders)
    assert orders[:, 0] == pytest.approx(5, abs=0.3)
    assert orders[:, 1].min() > 3


def test_beam_at_a_tight_tolerance() -> None:
    """A rubber pendulum, and steps far fewer than those of a method of order 2."""
    model = cd.compile(pendulum(4))
    times = np.linspace(0, 0.3, 7)
    exact = model.simulate(times, method="DOP853", rtol=1e-10, atol=1e-12)
    motion = model.simulate(times, method="Radau", rtol=1e-9)
    np.testing.assert_allclose(motion.q, exact.q, atol=2e-9)
    np.testing.assert_allclose(motion.u, exact.u, atol=1e-6)
    assert model.simulate(0.01, rtol=1e-8).solver_info.method == "Radau"


def test_spinning_beam_takes_long_steps() -> None:
    """Stiff directions turn by many radians; the reference is of another program."""
    known = json.loads((REFERENCES / "spin_up.json").read_text(encoding="utf-8"))["reference"]
    motion = cd.compile(spin_up(8)).simulate([0.0, *known["t"]], method="Radau", rtol=1e-6)
    np.testing.assert_allclose(motion["across"][1:], known["u2_rich"], atol=1e-3)
    assert motion["along"][-1] == pytest.approx(known["u1_rich"][-1], abs=2e-6)
    # of one matrix for all stages, in axes of the ground, some twelve thousand
    assert motion.statistics["steps"] < 2000


def test_redundant_loop() -> None:
    model = cd.compile(bricard(), coordinates="absolute")
    start = {
        name: angle for name, angle in bricard_angles(0.1).items() if name in model.coordinates
    }
    runs = [
        model.simulate(0.5, q=start, method=method, rtol=rtol, atol=1e-12)
        for method, rtol in (("Radau", 1e-9), ("DOP853", 1e-11))
    ]
    np.testing.assert_allclose(runs[0].q[-1], runs[1].q[-1], atol=1e-8)


@pytest.mark.parametrize("name", ["controlled", "sampled", "latch", "rough_arm", "four_bar"])
def test_states_modes_and_events(name: str) -> None:
    """Internal states, samples, locks, friction and stops as in joint coordinates."""
    scene, start = SCENES[name]()
    mine = cd.compile(scene, coordinates="absolute").simulate(
        1.0, q=start, method="Radau", rtol=1e-8, atol=1e-11
    )
    other = cd.compile(SCENES[name]()[0])
    exact = other.simulate(1.0, q=start, method="DOP853", rtol=1e-11, atol=1e-12)
    assert [event.name for event in mine.events] == [event.name for event in exact.events]
    for coordinate in other.coordinates:
        assert mine[coordinate][-1] == pytest.approx(exact[coordinate][-1], abs=2e-7)


def test_beam_with_all_that_may_happen() -> None:
    model = cd.compile(everything())
    runs = [
        model.simulate(0.12, method=method, rtol=rtol)
        for method, rtol in (("Radau", 1e-10), ("DOP853", 1e-11))
    ]
    names, times = ([[getattr(e, x) for e in run.events] for run in runs] for x in ("name", "t"))
    assert names[0] == names[1]
    np.testing.assert_allclose(times[0], times[1], atol=5e-6)
    np.testing.assert_allclose(runs[0].q[-1], runs[1].q[-1], atol=1e-7)


def test_stiff_internal_state_on_a_beam() -> None:
    """A Maxwell element that relaxes fast beside the motion."""
    scene = pendulum(2)
    mass = scene.body("mass", mass=0.1)
    scene.joint("slide", cd.Prismatic("x"), scene.ground.at(0, 0.5, 0), mass)
    scene.force("soft", cd.Maxwell(scene.beams["bar"].end, mass, 50.0, 50.0 * 1e-4))
    model = cd.compile(scene)
    motion, exact = (
        model.simulate(0.2, u={"slide": 1.0}, method=method, rtol=rtol, atol=1e-12)
        for method, rtol in (("Radau", 1e-9), ("DOP853", 1e-11))
    )
    assert model.nz == 1
    np.testing.assert_allclose(motion.x[-1], exact.x[-1], atol=1e-7)


def test_rosenbrock_goes_by_differences() -> None:
    """Of the same order, with a Jacobian by differences and states projected after every step."""
    model, other = cd.compile(swinging(), coordinates="absolute"), cd.compile(swinging())
    exact = other.simulate(1.0, **START, method="DOP853", rtol=1e-13, atol=1e-14)
    errors = []
    for rtol in (1e-5, 1e-7, 1e-9):
        motion = model.simulate(1.0, **START, method="Rosenbrock", rtol=rtol)
        errors.append((motion.statistics["steps"], abs(motion["B"][-1] - exact["B"][-1])))
    steps, off = np.log(np.array(errors)).T
    slope = -(off[2] - off[0]) / (steps[2] - steps[0])
    print("Rosenbrock over elements: steps and errors", errors, "order", slope)
    assert errors[-1][1] < 1e-8
    assert slope > 4


@pytest.mark.parametrize("method", ["Radau", "GeneralizedAlpha", "DOP853"])
def test_the_energy_of_a_load_that_is_put_on(method: str) -> None:
    """It is the load times the way of its tip; check= asks for what the tolerance is worth."""
    load = 3.0
    scene = cd.Scene("loaded", gravity=(0, 0, 0))
    section, alloy = cd.section.rectangle(0.1, 0.01), cd.material(E=7e10, nu=0.3, rho=2700)
    beam = scene.beam("beam", scene.ground, (1, 0, 0), section, alloy, elements=2)
    scene.force("load", cd.Force(beam.end, (0, 0, load)))
    motion = cd.compile(scene).simulate(0.01, method=method, check=True)
    # its potential is counted as a force's is not
    work = load * (motion["beam.end.pz"] - motion["beam.end.pz"][0])
    total = motion.energy.total - motion.energy.total[0]
    scale = np.abs(motion.energy.kinetic).max() + np.ptp(work)
    missed = np.abs(total - work).max()
    print(method, "missed", missed, "of", scale)
    assert missed < (1e-3 if method == "GeneralizedAlpha" else 1e-6) * scale
