"""The energy balance of compiled models holds at steps at which other methods lose it."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import cardan as cd
from laws.test_accounts import shaken
from mechanisms import ZOO
from mechanisms.closed import CLOSED


def missing(motion: cd.Trajectory) -> float:
    """What the balance misses at worst, relative to the kinetic energy."""
    energy = motion.energy
    work = sum(motion.work.values(), np.zeros(len(energy.total)))
    return float(np.abs(energy.total - energy.total[0] - work).max() / energy.kinetic.max())


@pytest.fixture(scope="module")
def double() -> cd.CompiledModel:
    return cd.compile(ZOO["double_pendulum"].build())


@pytest.mark.parametrize("step", [0.05, 0.1])
def test_double_pendulum(double: cd.CompiledModel, step: float) -> None:
    options: dict[str, Any] = {"q": {"shoulder": 1.5, "elbow": 0.5}, "step": step}
    times = np.linspace(0, 2e4 * step, 501)
    kept = double.simulate(times, method="EnergyMidpoint", **options)
    lost = double.simulate(times, method="RK4", **options)
    assert kept.status == "finished"
    # the solver accepts a thousand roundings of the energies at worst, in steps of either sign:
    # a random walk, three times its spread after all steps
    assert missing(kept) <= 3 * 1000 * np.finfo(float).eps * np.sqrt(2e4)
    assert missing(lost) >= 1e-3


@pytest.mark.parametrize("name", ["four_bar", "slider_crank"])
@pytest.mark.parametrize("step", [5e-3, 2e-2])
def test_closed_circuits(name: str, step: float) -> None:
    model = cd.compile(CLOSED[name].build())
    start: dict[str, Any] = {"u": {model.speeds[0]: 2.0}, "step": step}
    motion = model.simulate(2000 * step, method="EnergyMidpoint", **start)
    assert motion.status == "finished"
    assert missing(motion) <= 1e-11
    assert max(row.after for row in motion.drift.position.values()) <= 1e-14


@pytest.mark.parametrize(
    ("name", "step"),
    [
        *(
            (name, step)
            for name in ("four_bar", "slider_crank", "andrews")
            for step in (1e-6, 1e-5)
        ),
        ("slider_crank", 2e-4),
    ],
)
def test_circuits_from_rest_in_short_steps(name: str, step: float) -> None:
    model = cd.compile(CLOSED[name].build())
    start: dict[str, Any] = {"q": {"A": -0.870175036}} if name == "slider_crank" else {}
    motion = model.simulate(300 * step, method="EnergyMidpoint", step=step, **start)
    assert motion.status == "finished"
    known = model.simulate(300 * step, rtol=1e-11, atol=1e-13, **start)
    # energies round by some 1e-15 J, and speeds by what that is of them
    assert np.abs(motion.x[-1] - known.x[-1]).max() <= 1e-3 * np.abs(known.u[-1]).max()


def test_the_function_it_needs_is_named() -> None:
    model = cd.compile(ZOO["double_pendulum"].build(), functions=["rhs"])
    with pytest.raises(cd.ModelError, match=r"'EnergyMidpoint' needs the function 'energy'"):
        model.simulate(1.0, method="EnergyMidpoint", step=0.1)


@pytest.mark.parametrize("coordinates", ["relative", "absolute"])
@pytest.mark.parametrize("restitution", [0.0, 0.5])
def test_rest_on_a_stop(restitution: float, coordinates: str) -> None:
    """What falls, bounces and comes to rest stays there, though forces cancel but for rounding."""
    scene = cd.Scene("drop", gravity=(0, 0, -9.81))
    block = scene.body("block", mass=2.0, inertia=(0.1, 0.1, 0.1))
    scene.joint("z", cd.Prismatic("z"), scene.ground, block, q0=0.1)
    scene.force("floor", cd.Stop("z", lower=0.0, restitution=restitution))
    model = cd.compile(scene, coordinates=coordinates)
    motion = model.simulate(1.0, method="EnergyMidpoint", step=1e-3)
    assert motion.success, motion.message
    fall = np.sqrt(2 * 0.1 / 9.81)
    assert motion.events[0].t == pytest.approx(fall, abs=1e-6)
    assert np.abs(motion["z"][motion.t > 0.5]).max() < 1e-12


def test_rest_from_the_start() -> None:
    scene = cd.Scene("hanging", gravity=(0, 0, -9.81))
    links = [scene.body(f"b{k}", mass=1.0, com=(0.5, 0, 0), inertia=(0.1,) * 3) for k in range(3)]
    for k, (parent, child) in enumerate(zip([scene.ground, *links], links, strict=False)):
        place = parent.at(1, 0, 0) if k else parent
        scene.joint(f"j{k}", cd.Revolute("y"), place, child, q0=0.0 if k else np.pi / 2)
    model = cd.compile(scene, coordinates="absolute")
    motion = model.simulate(0.5, method="EnergyMidpoint", step=1e-2)
    assert motion.success, motion.message
    assert np.abs(motion.u).max() < 1e-12


def test_work_of_a_driven_joint_that_carries_a_beam() -> None:
    """The same in joints with nodes and in nodes alone, and all that the energy gains."""
    work = []
    for coordinates in ("auto", "absolute"):
        model = cd.compile(shaken(), coordinates=coordinates)
        fine = model.simulate(0.2, method="Radau", rtol=1e-9, atol=1e-11)
        assert np.abs(fine.energy_residual).max() < 1e-8
        work.append(fine.work["heave.motion"][-1])
        motion = model.simulate(0.2, method="EnergyMidpoint", step=2e-4)
        assert np.abs(motion["hinge"][-1] - fine["hinge"][-1]) < 1e-4
    assert work[0] == pytest.approx(work[1], rel=1e-7)
