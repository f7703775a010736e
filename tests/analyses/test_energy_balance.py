"""The energy balance of compiled models holds at steps at which other methods lose it."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import cardan as cd
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
