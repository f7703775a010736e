"""States of FMUs: an instance goes on from one to the bit, in the middle of a motion too."""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from codegen.fmu.importing import Instance, equations_of, model_of, unit
from codegen.fmu.scenes import CASES
from codegen.running import compilers

pytestmark = pytest.mark.skipif(not compilers(), reason="needs a C compiler")

QUICK = {("door", "3.0"), ("four_bar", "2.0"), ("tumbling", "3.0")}
PAIRS = [
    pytest.param(name, version, marks=[] if (name, version) in QUICK else [pytest.mark.slow])
    for version in ("3.0", "2.0")
    for name in CASES
]
STEPS = 12


def begun(name: str, version: str) -> Instance:
    one = Instance(unit(name, version))
    one.set(dict(CASES[name].inputs))
    return one.begin(stop=CASES[name].end)


def played(one: Instance, name: str, first: int, last: int) -> np.ndarray:
    """All values behind each of some communication steps."""
    h, rows = CASES[name].end / STEPS, []
    names = [n for n in one.references if n != "time"]
    for k in range(first, last):
        one.step(k * h, h)
        rows.append(one.get(*names))
    return np.array(rows)


@pytest.mark.parametrize(("name", "version"), PAIRS)
def test_a_state_in_the_middle_is_gone_on_from_to_the_bit(name: str, version: str) -> None:
    half = STEPS // 2
    with begun(name, version) as one, Instance(unit(name, version)) as other:
        played(one, name, 0, half)
        state = one.save()
        content = one.bytes_of(state)
        expected = played(one, name, half, STEPS)
        # back in the same instance
        one.restore(state)
        assert one.bytes_of(one.save()) == content
        assert np.array_equal(played(one, name, half, STEPS), expected)
        # by way of bytes, in another one that has not even begun
        moved = other.state_of(content)
        other.restore(moved)
        assert other.bytes_of(other.save()) == content
        assert np.array_equal(played(other, name, half, STEPS), expected)
        one.free(state)
        other.free(moved)


def test_bytes_go_on_in_another_process() -> None:
    name = "door"
    with begun(name, "3.0") as one:
        played(one, name, 0, 5)
        content = one.bytes_of(one.save())
        expected = played(one, name, 5, STEPS)
    program = (
        "import sys; sys.path.insert(0, 'tests')\n"
        "from pathlib import Path\n"
        "from codegen.fmu import importing, test_states\n"
        f"path = Path({str(unit(name))!r})\n"
        "one = importing.Instance(path)\n"
        "one.restore(one.state_of(sys.stdin.buffer.read()))\n"
        f"sys.stdout.buffer.write(test_states.played(one, {name!r}, 5, {STEPS}).tobytes())\n"
    )
    answer = subprocess.run([sys.executable, "-c", program], input=content, capture_output=True)
    assert answer.returncode == 0, answer.stderr.decode()[-2000:]
    assert answer.stdout == expected.tobytes()


def test_model_exchange_goes_back_over_an_event() -> None:
    """Modes, samples and armed events are part of a state."""
    with Instance(unit("bouncing"), "me") as one:
        one.begin()
        one.update()
        one.fmu.enterContinuousTimeMode()
        # falling fast, just above the floor, then below it
        one.fmu.setTime(0.1)
        one.set_states([0.01, -3.0])
        one.fmu.completedIntegratorStep()
        state = one.save()

        def fall() -> tuple[list[float], tuple[object, ...]]:
            one.fmu.setTime(0.11)
            one.set_states([-1e-9, -3.1])
            one.fmu.enterEventMode()
            happened = one.update()
            values = one.get(*[n for n in one.references if n != "time"])
            one.fmu.enterContinuousTimeMode()
            return values, happened

        first = fall()
        assert first[1][3], "the speed jumps"
        one.restore(state)
        assert fall() == first


def test_instances_do_not_know_each_other() -> None:
    name = "door"
    with begun(name, "3.0") as one, begun(name, "3.0") as other:
        expected = played(one, name, 0, STEPS)
        other.fmu.reset()
        other.set({"goal": 0.2})
        other.begin(stop=2.0)
        rows = []
        with begun(name, "3.0") as third:
            for k in range(STEPS):
                other.step(k / STEPS, 1 / STEPS)
                rows.append(played(third, name, k, k + 1)[0])
        assert np.array_equal(np.array(rows), expected)


def test_reset_is_a_new_start() -> None:
    name = "door"
    with begun(name, "3.0") as one:
        first = played(one, name, 0, STEPS)
        one.set({"goal": 0.1})
        one.fmu.reset()
        one.set(dict(CASES[name].inputs))
        one.begin(stop=CASES[name].end)
        assert np.array_equal(played(one, name, 0, STEPS), first)


@pytest.mark.parametrize(
    "damage",
    [
        lambda content: content[:100],
        lambda content: content[:-1] + bytes([content[-1] ^ 1]),
        lambda content: bytes(8) + content[8:],
        lambda content: b"",
    ],
)
def test_damaged_bytes_are_refused(damage: Callable[[bytes], bytes]) -> None:
    with begun("bouncing", "3.0") as one:
        content = one.bytes_of(one.save())
        with pytest.raises(Exception, match="failed with status 3"):
            one.state_of(damage(content))
        assert "damaged or of another FMU" in one.messages[-1]
        one.step(0.0, 0.1)


def test_states_of_another_unit_are_refused() -> None:
    with begun("bouncing", "3.0") as one, begun("sticking", "3.0") as other:
        with pytest.raises(Exception, match="failed with status 3"):
            other.state_of(one.bytes_of(one.save()))
        assert "another FMU" in other.messages[-1]


# what the model and the settings say of a run, and what no FMU uses: rows, a log that is kept
CONSTANT = frozenset(
    {
        *("nq", "nu", "nz", "nx", "n", "nr", "ns", "ne", "watched", "tick_count", "nlam"),
        *("quaternion_count", "bounded_count", "sampled", "charted", "positions", "rates"),
        *("stages", "dense_rows", "rtol", "atol", "max_step", "on_grid", "budget", "stop"),
        *("time_count", "next_time", "capacity", "count", "log_capacity", "log_count"),
        # nobody differentiates an FMU: steps over singular positions are not noted there
        *("pass_capacity", "pass_count"),
    }
)


def test_every_number_that_a_run_changes_is_in_its_state() -> None:
    from cardan.codegen.fmu.export import SOURCES
    from cardan.schema.records import POINTER, fields

    text = (SOURCES / "fmu_state.c").read_text("utf-8")
    numbers = {name for name, kind in fields("cardan_run") if kind is not POINTER}
    assert numbers > CONSTANT
    stated = set(re.findall(r"F\((\w+)[,)]", text))
    assert stated == numbers - CONSTANT


EXPORTED = {"GeneralizedAlpha": "alpha"}
COUNTED = ("steps", "rejections", "evaluations", "jacobians", "factorizations")


@pytest.mark.parametrize("method", ["GeneralizedAlpha", "Radau", "RK45", "Rosenbrock"])
def test_a_first_step_takes_the_work_of_simulate(method: str, tmp_path: Path) -> None:
    """What a method began with the run it goes on with: nothing is begun twice."""
    from cardan.codegen.fmu.export import SOURCES

    path = equations_of("pendulum").export(
        tmp_path / "x.fmu", integrators=(EXPORTED.get(method, method.lower()),), kinds=("cs",)
    )
    with Instance(path) as one:
        one.begin(1e-6, 0.25)
        one.step(0.0, 0.25)
        content = one.bytes_of(one.save())
    text = (SOURCES / "fmu_state.c").read_text("utf-8")
    integers = re.findall(r"F\((\w+),", text.split("#define INTEGERS")[1].split("#define REALS")[0])
    # behind the places of signals and stops, which are known here, the reals begin with t
    numbers = np.frombuffer(content[: len(content) // 8 * 8])
    ends = [k for k, t in enumerate(numbers) if t == 0.25 and k >= len(integers)]
    rows = [np.frombuffer(content[8 * (k - len(integers)) : 8 * k], np.int64) for k in ends]
    (work,) = [
        numbered
        for row in rows
        for numbered in [dict(zip(integers, row.tolist(), strict=True))]
        if numbered["culprit"] == numbered["open_row"] == -1 and numbered["steps"] > 0
    ]
    motion = model_of("pendulum").simulate(0.25, rtol=1e-6, method=method)
    assert {name: work[name] for name in COUNTED} == {
        name: motion.statistics[name] for name in COUNTED
    }


def hashed(content: bytearray) -> bytes:
    """Bytes with the hash that belongs to them, which anybody can compute: FNV-1a."""
    total = 14695981039346656037
    for byte in content[24:]:
        total = (total ^ byte) * 1099511628211 % 2**64
    content[16:24] = total.to_bytes(8, "little")
    return bytes(content)


def test_states_with_impossible_numbers_are_refused() -> None:
    """Every whole number of a state is made huge and negative, one after the other."""
    with begun("sticking", "3.0") as one:
        played(one, "sticking", 0, 3)
        content = one.bytes_of(one.save())
        expected = played(one, "sticking", 3, 4)
        assert hashed(bytearray(content)) == content
        # the head: flags, times, counts, numbers of the run
        refused = 0
        for place in range(24, 24 + 8 * 60, 8):
            for number in (-(2**62), 2**62):
                forged = bytearray(content)
                forged[place : place + 8] = number.to_bytes(8, "little", signed=True)
                try:
                    state = one.state_of(hashed(forged))
                    one.restore(state)
                    one.free(state)
                except Exception as error:
                    refused += "failed with status 3" in str(error)
        assert refused > 50
        one.restore(one.state_of(content))
        assert np.array_equal(played(one, "sticking", 3, 4), expected)
