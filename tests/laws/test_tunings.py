"""Equal bits from lanes and scalars whatever instruction set and tuning the compiler is given."""

from __future__ import annotations

import os
import subprocess
import sys
from dataclasses import replace
from functools import cache as once
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pytest

import cardan as cd
from analyses.conftest import double_scene
from cardan.build import cache, prebuilt, toolchain
from cardan.build.toolchain import ALL_CHAINS
from cardan.codegen import generate
from codegen.lanes import WIDTHS, call_lanes
from codegen.running import CONTRACT, SPEED, STRICT, call, compilers
from laws.cases import derived, states, values
from spread import some

pytestmark = pytest.mark.optimized

LEVELS = ("x86-64-v2", "x86-64-v3", "x86-64-v4")
TUNINGS = ("znver3", "skylake-avx512", "generic")
# what each level needs beyond the one before, as gcc names it
NEEDS = {
    "x86-64-v2": ("sse4.2", "popcnt"),
    "x86-64-v3": ("avx2", "fma", "bmi2"),
    "x86-64-v4": ("avx512f", "avx512bw", "avx512dq", "avx512vl"),
}
PAIRS = [(level, tuning) for level in LEVELS for tuning in TUNINGS]
MEMBERS = ("spatial_chain", "free_quaternion", "crane")
LANES = 8


@once
def runs(level: str) -> bool:
    """This machine has gcc and a processor of the level."""
    if "gcc" not in compilers():
        return False
    checks = " && ".join(
        f'__builtin_cpu_supports("{need}")'
        for known in LEVELS[: LEVELS.index(level) + 1]
        for need in NEEDS[known]
    )
    with TemporaryDirectory() as folder:
        source, program = Path(folder) / "level.c", Path(folder) / "level"
        source.write_text(f"int main(void) {{ return !({checks}); }}\n", "utf-8")
        command = [*compilers()["gcc"], "-o", str(program), str(source)]
        if subprocess.run(command, capture_output=True, check=False).returncode:
            return False
        return subprocess.run([str(program)], check=False).returncode == 0


def required(level: str) -> None:
    if not runs(level):
        pytest.skip(f"this machine does not run {level}, or has no gcc")


def differences(name: str, flags: tuple[str, ...], tuning: tuple[str, ...]) -> int:
    """The states of a mechanism whose lanes differ from scalars, which alone are tuned."""
    equations = derived(name)
    file = generate(equations.form("forward_dynamics"), model=name)
    q, u = states(name)
    tau = np.random.default_rng(5).uniform(-1, 1, u.shape)
    given = values(equations)
    rows = [
        given | {"q": q[k % len(q)], "u": u[k % len(q)], "tau": tau[k % len(q)]}
        for k in range(LANES)
    ]
    alone = [call(file, row, "gcc", (*flags, *tuning)).out for row in rows]
    differing = 0
    for lanes in WIDTHS:
        for start in range(0, LANES, lanes):
            _, many = call_lanes(file, rows[start : start + lanes], flags, "gcc")
            for one, other in zip(many, alone[start : start + lanes], strict=True):
                differing += one.tobytes() != other.tobytes()
    return differing


@pytest.mark.parametrize(
    ("name", "level", "tuning"), some([(name, *pair) for name in MEMBERS for pair in PAIRS], 14)
)
def test_functions_have_the_same_bits_in_lanes(name: str, level: str, tuning: str) -> None:
    required(level)
    flags = (*STRICT, *SPEED, f"-march={level}", *CONTRACT["gcc"])
    assert differences(name, flags, (f"-mtune={tuning}",)) == 0


def states_of_runs(lanes: int, level: str, *options: str, chains: str = ALL_CHAINS) -> bytes:
    """States and statistics of an ensemble, from a process whose compiler has other options."""
    command = [sys.executable, __file__, str(lanes), chains, level, *options]
    paths = os.pathsep.join([str(Path(__file__).parents[1]), os.environ.get("PYTHONPATH", "")])
    environment = {**os.environ, "PYTHONPATH": paths}
    done = subprocess.run(command, env=environment, capture_output=True, check=False)
    assert done.returncode == 0, done.stderr.decode()[-3000:]
    return done.stdout


def write_states(lanes: int, chains: str, level: str, *options: str) -> None:
    """Simulate double pendulums with what the compiler makes under these options."""
    os.environ["CARDAN_LEVEL"] = level
    plain = cache.compiler()
    chosen = replace(plain, options=(*plain.options, *options))
    cache.compiler = lambda: chosen
    # these tunings in place of that of this processor
    toolchain.Compiler.tuning = ()
    # kernels with these options as well: none of the installation
    prebuilt.library = lambda level, variant: None
    toolchain.ALL_CHAINS = chains
    model = cd.compile(double_scene())
    model.prepare("rhs", batch=True)
    starts = {"elbow": np.linspace(-1, 1, 64)}
    # between steps and at their ends
    made = model.ensemble(np.linspace(0, 2, 23), q=starts, lanes=lanes or None, threads=1)
    assert (made.job.width > 1) == (lanes == 0)
    sys.stdout.buffer.write(made["states"].tobytes() + made.numbers.tobytes())


@pytest.mark.parametrize(("level", "tuning"), some(PAIRS, 9, 6))
def test_runs_have_the_same_bits_in_lanes(level: str, tuning: str) -> None:
    required(level)
    options = (level, f"-mtune={tuning}")
    assert states_of_runs(0, *options) == states_of_runs(1, *options)


@pytest.mark.slow
def test_f1_chains_left_unfused_in_narrow_vectors_are_seen() -> None:
    """A tuning that fuses chains in 512-bit vectors alone makes the comparison above fail."""
    required("x86-64-v4")
    given = "x86-64-v4"
    avoided = "--param=avoid-fma-max-bits=256"
    assert states_of_runs(0, given, chains=avoided) != states_of_runs(1, given, chains=avoided)


if __name__ == "__main__":
    write_states(int(sys.argv[1]), *sys.argv[2:])
