"""Machines with beams: the defaults and tight runs against one that shares nothing with them.

The other run has all bodies on nodes and beams joined to them by rows, where ends of beams follow
the joints else; and a method of another family.
"""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd
from mechanisms.machines import MACHINES, shaft

# in every run; the others where there is time
SHOWN = ("beam_on_a_rigid_stop", "stick_slip")
# of the amplitude: what the default tolerance 1e-6 promises, and what tight ones reach
DEFAULT, TIGHT = 1e-4, 1e-6


@pytest.mark.parametrize(
    "name", [n if n in SHOWN else pytest.param(n, marks=pytest.mark.slow) for n in MACHINES]
)
def test_defaults_and_tight_runs(name: str) -> None:
    machine = MACHINES[name]
    try:
        model = cd.compile(machine.build())
        other = cd.compile(machine.build(), coordinates="absolute")
    except FileNotFoundError as missing:
        pytest.skip(str(missing))
    start = {"q": machine.q, "u": machine.u}
    times = np.linspace(0, machine.end, 41)
    motion = model.simulate(times, **start)
    tight = model.simulate(times, method="Radau", rtol=1e-9, **start)
    independent = other.simulate(times, method="Rosenbrock", rtol=1e-7, **start)
    events = [event.name for event in independent.events]
    for run, bound in ((motion, DEFAULT), (tight, TIGHT)):
        assert run.success, run.message
        assert [event.name for event in run.events] == events
        for watched in machine.watched:
            error = np.abs(run[watched] - independent[watched]).max()
            error /= np.ptp(independent[watched])
            print(f"{name}: {watched} {error:.1e} of the amplitude, {run.solver_info.method}")
            assert error < bound, watched


@pytest.mark.slow
@pytest.mark.parametrize("ratio", [0.8, 1.2])
def test_a_shaft_with_internal_damping_whirls_above_its_critical_speed(ratio: float) -> None:
    """Jeffcott's rotor: forward whirl grows by damping / 2 omega² (speed / omega - 1)."""
    loss, at_rest = 2e-4, cd.compile(shaft(1e-9)).modes()
    omega = at_rest.angular[0]
    times = np.linspace(0, 0.6, 601)
    motion = cd.compile(shaft(ratio * omega)).simulate(times, u={"disk.u.py": 1.0})
    whirl = np.abs(motion["whirl"])
    # the backward whirl and the sag have died away in half of the time
    early, late = whirl[350:450].max(), whirl[500:600].max()
    rate = np.log(late / early) / 0.15
    print(f"speed {ratio:g} of the critical one: rate {rate:.3f} 1/s")
    assert rate == pytest.approx(loss * omega**2 / 2 * (ratio - 1), rel=0.1)
