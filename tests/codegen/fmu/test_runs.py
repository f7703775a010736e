"""FMUs move as ``simulate`` does, in co-simulation and in model exchange."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from codegen.fmu.importing import VERSIONS, Instance, model_of, played, problems, simulated, unit
from codegen.fmu.scenes import CASES
from codegen.running import compilers

pytestmark = pytest.mark.skipif(not compilers(), reason="needs a C compiler")

QUICK = {("four_bar", "2.0"), ("tumbling", "3.0"), ("door", "3.0")}
PAIRS = [
    pytest.param(name, version, marks=[] if (name, version) in QUICK else [pytest.mark.slow])
    for version in VERSIONS
    for name in CASES
]


@pytest.mark.parametrize(("name", "version"), PAIRS)
def test_fmpy_has_no_objection(name: str, version: str) -> None:
    assert problems(unit(name, version)) == []


@pytest.mark.parametrize(("name", "version"), PAIRS)
def test_co_simulation_is_simulate(name: str, version: str) -> None:
    case = CASES[name]
    # communication steps are much shorter than those of the method
    times, rtol = np.linspace(0, case.end, 21), 1e-6 if case.elements else 1e-9
    moved, messages = played(unit(name, version), "cs", name, times, rtol)
    expected = simulated(name, times, rtol)
    assert moved == pytest.approx(expected, rel=10 * rtol, abs=10 * rtol)
    assert not [text for text in messages if "happens" not in text]


@pytest.mark.parametrize(
    ("name", "version"), [pair for pair in PAIRS if not CASES[str(pair.values[0])].elements]
)
def test_model_exchange_is_simulate(name: str, version: str) -> None:
    times = np.linspace(0, CASES[name].end, 21)
    moved, messages = played(unit(name, version), "me", name, times, 1e-11)
    assert moved == pytest.approx(simulated(name, times, 1e-11), rel=1e-6, abs=1e-6)
    assert not [text for text in messages if "happens" not in text]


def test_times_of_events_are_those_of_simulate() -> None:
    case = CASES["door"]
    motion = model_of("door").simulate(case.end, inputs=dict(case.inputs), rtol=1e-9)
    with Instance(unit("door")) as one:
        one.set(dict(case.inputs))
        one.begin(1e-9, case.end)
        for k in range(40):
            one.step(k * case.end / 40, case.end / 40)
        happened = [text for text in one.messages if "happens at" in text and "motor" not in text]
    expected = [(event.name, event.t) for event in motion.events]
    assert len(happened) == len(expected)
    for text, (name, t) in zip(happened, expected, strict=True):
        assert name in text
        assert float(text.split(" = ")[1].split()[0]) == pytest.approx(t, abs=1e-9)


@pytest.mark.parametrize("version", ["2.0", pytest.param("3.0", marks=pytest.mark.slow)])
def test_inputs_that_change_between_steps(version: str) -> None:
    """Held inputs of co-simulation are the same motion as a table with jumps."""
    steps, h = 20, 0.05
    values = [3.0 * np.sin(0.7 * k) for k in range(steps)]
    times = np.repeat(np.arange(steps + 1) * h, 2)[1:-1]
    table = (times, np.repeat(values, 2))
    motion = model_of("cart").simulate(steps * h, inputs={"push": table}, rtol=1e-10)
    with Instance(unit("cart", version)) as one:
        one.begin(1e-10, steps * h)
        for k, value in enumerate(values):
            one.set({"push": value})
            one.step(k * h, h)
        names = ["track", "pin", "track.u", "pin.u"]
        assert one.get(*names) == pytest.approx([motion[n][-1] for n in names], abs=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("version", VERSIONS)
def test_inputs_are_functions_of_time_in_model_exchange(version: str) -> None:
    """An importer that sets inputs at every stage; fmpy's CVode holds them over a step."""
    motion = model_of("cart").simulate(
        1.0, inputs={"push": lambda t, x: np.sin(3 * t)}, rtol=1e-10, max_step=0.02
    )
    with Instance(unit("cart", version), "me") as one:
        one.begin()
        one.update()
        one.fmu.enterContinuousTimeMode()

        def rates(t: float, x: np.ndarray) -> np.ndarray:
            one.fmu.setTime(t)
            one.set({"push": np.sin(3 * t)})
            one.set_states(x)
            return one.rates()

        run = solve_ivp(rates, (0.0, 1.0), one.states(), method="DOP853", rtol=1e-10, atol=1e-12)
    assert run.y[:, -1] == pytest.approx(motion.x[-1, :4], abs=1e-8)
