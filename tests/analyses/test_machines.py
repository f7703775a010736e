"""Machines with beams by two methods that share no step: what defaults give against tight Radau."""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd
from mechanisms.machines import MACHINES

# in every run; the others where there is time
SHOWN = ("beam_on_a_rigid_stop", "stick_slip", "sampled_arm")
# of the amplitude; the damped vibration of beams is what GeneralizedAlpha misses most
DEFAULT = 5e-3


@pytest.mark.parametrize(
    "name", [n if n in SHOWN else pytest.param(n, marks=pytest.mark.slow) for n in MACHINES]
)
def test_defaults_are_near_to_tight_runs(name: str) -> None:
    machine = MACHINES[name]
    model = cd.compile(machine.build())
    start = {"q": machine.q, "u": machine.u}
    times = np.linspace(0, machine.end, 41)
    motion = model.simulate(times, **start)
    tight = model.simulate(times, method="Radau", rtol=1e-9, atol=1e-11, **start)
    assert motion.success
    assert tight.success
    assert [e.name for e in motion.events] == [e.name for e in tight.events]
    for watched in machine.watched:
        error = np.abs(motion[watched] - tight[watched]).max() / np.ptp(tight[watched])
        print(f"{name}: {watched} {error:.1e} of the amplitude")
        assert error < DEFAULT
