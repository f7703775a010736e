"""FMUs move as ``simulate`` does, in co-simulation and in model exchange."""

from __future__ import annotations

import numpy as np
import pytest

from codegen.fmu.importing import VERSIONS, played, problems, simulated, unit
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
    from codegen.fmu.importing import Instance, model_of

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
