"""Speed and error of the spine, beside other programs in the same run.

For every robot: derivation (scene to C text of forward dynamics), cold compile, load from the
cache in a new process, time per call within a batch, error against 40 digits. A peer that is
not installed is named. Nothing here decides whether a change is good: times are reported, not
asserted.
"""

from __future__ import annotations

import importlib.util
import os
import resource
import subprocess
import sys
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np
from rich.console import Console
from rich.table import Table

# peers and scenes stand beside this file and in the zoo
sys.path.insert(0, str(Path(__file__).parents[1]))

import cardan as cd
from benchmarks import pinocchio_cpp
from cardan.codegen import generate
from cardan.ir.interpreter import evaluate

SEED = 9
BATCH = 2000
EXACT_STATES = 5
PEERS = {"pinocchio": "pin", "casadi": "casadi"}

# a new process: what a user waits for when the model was compiled before
LOAD = """
import sys, time
import cardan as cd
from cardan.runtime.compiled import CompiledModel
start = time.perf_counter()
model = CompiledModel(sys.argv[1])
model.prepare("forward_dynamics")
print(time.perf_counter() - start)
"""


@dataclass(frozen=True)
class Case:
    """A scene to measure; ``urdf`` where Pinocchio can read it too.

    ``build(snap)`` makes the scene, with angles as printed where ``snap`` is False.
    """

    name: str
    build: Callable[[bool], Any]
    urdf: Path | None = None
    locked: tuple[str, ...] = ()


@dataclass(frozen=True)
class Row:
    """Figures of one program on one scene; None where there is none."""

    program: str
    derived: float | None = None
    compiled: float | None = None
    loaded: float | None = None
    call: float | None = None
    error: float | None = None
    operations: int | None = None


def cases() -> list[Case]:
    """Panda and UR5 where example-robot-data is installed, and chains."""
    from mechanisms.chain import chain

    found = []
    if importlib.util.find_spec("pinocchio"):
        from external.robots import ROBOTS

        panda, ur5 = (
            ROBOTS / name
            for name in ("panda_description/urdf/panda.urdf", "ur_description/urdf/ur5_robot.urdf")
        )
        fingers = ("panda_finger_joint1", "panda_finger_joint2")
        found = [
            Case(
                "Panda, fingers fixed",
                lambda snap: cd.load(_without(panda, fingers), snap=snap),
                panda,
                fingers,
            ),
            Case("UR5", lambda snap: cd.load(ur5, snap=snap), ur5),
        ]
    return [
        *found,
        Case("chain of 7", lambda snap: chain(7)),
        Case("chain of 100", lambda snap: chain(100)),
        Case("chain of 1000", lambda snap: chain(1000)),
    ]


def _without(path: Path, joints: tuple[str, ...]) -> Path:
    """A copy of a URDF with some joints made fixed."""
    import re

    text = path.read_text(encoding="utf-8")
    for joint in joints:
        text = re.sub(rf'(<joint name="{joint}" type=)"\w+"', r'\1"fixed"', text)
    text = re.sub(r"<mimic [^>]*/>", "", text)
    copy = Path(tempfile.mkdtemp(prefix="cardan-bench-")) / path.name
    copy.write_text(text, encoding="utf-8")
    return copy


def best(repeats: int, work: Callable[[], Any]) -> float:
    """Least of several durations [s]."""
    times = []
    for _ in range(repeats):
        start = perf_counter()
        work()
        times.append(perf_counter() - start)
    return min(times)


def ours(case: Case) -> tuple[Row, np.ndarray, np.ndarray]:
    """Our figures, and the states they were taken at."""
    equations = cd.derive(case.build(True))

    def derivation() -> None:
        generate(cd.derive(case.build(True)).form("forward_dynamics"), model=case.name)

    derived = best(3, derivation)
    model = cd.compile(equations, functions=("forward_dynamics",))
    start = perf_counter()
    model.prepare("forward_dynamics")
    compiled = perf_counter() - start
    command = [sys.executable, "-c", LOAD, str(model.directory)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    rng = np.random.default_rng(SEED)
    q, u = rng.uniform(-1.5, 1.5, (2, BATCH, model.nu))
    call = best(5, lambda: model.forward_dynamics(q, u)) / BATCH
    exact = digits(equations, q[:EXACT_STATES], u[:EXACT_STATES])
    computed = model.forward_dynamics(q[:EXACT_STATES], u[:EXACT_STATES])
    counts = sum(model.operations["forward_dynamics"].values())
    row = Row(
        f"cardan ({equations.method})",
        derived,
        compiled,
        float(done.stdout),
        call,
        relative(computed, exact),
        counts,
    )
    return row, q, u


def digits(equations: Any, q: np.ndarray, u: np.ndarray, damped: bool = True) -> np.ndarray:
    """Accelerations from 40 digits."""
    function = equations.function("forward_dynamics")
    p = [
        parameter.value * (damped or not parameter.name.endswith(".damping"))
        for parameter in equations.system.parameters
    ]
    blocks = {"p": p, "tau": [0.0] * equations.system.nu, "t": [0.0]}
    rows = [
        evaluate(function, blocks | {"q": a, "u": b}, arithmetic="mp")["udot"]
        for a, b in zip(q, u, strict=True)
    ]
    return np.array([[float(x) for x in row] for row in rows])


def relative(computed: np.ndarray, exact: np.ndarray) -> float:
    return float((np.abs(computed - exact).max(axis=1) / np.abs(exact).max(axis=1)).max())


def peers(case: Case, q: np.ndarray, u: np.ndarray, program: Path | None) -> list[Row]:
    """Pinocchio from Python and as C++, and CasADi's C; tests/external holds them against us."""
    import pinocchio as pin

    model = pin.buildModelFromUrdf(str(case.urdf))
    model = pin.buildReducedModel(
        model, [model.getJointId(name) for name in case.locked], pin.neutral(model)
    )
    data, rest = model.createData(), np.zeros(model.nv)
    some = list(zip(q[:200], u[:200], strict=True))
    few = q[:EXACT_STATES], u[:EXACT_STATES]
    # Pinocchio takes angles as printed, the hand-written CasADi exact zeros; neither damps
    printed, snapped = (digits(cd.derive(case.build(x)), *few, damped=False) for x in (False, True))
    call = best(5, lambda: [pin.aba(model, data, a, b, rest) for a, b in some]) / len(some)
    found = np.array([pin.aba(model, data, a, b, rest) for a, b in some[:EXACT_STATES]])
    error = relative(found, printed)
    rows = [Row("Pinocchio ABA from Python", call=call, error=error)]
    with tempfile.TemporaryDirectory() as folder:
        if program is not None:
            call = pinocchio_cpp.time(program, model, Path(folder))
            rows.append(Row("Pinocchio ABA in C++", call=call, error=error))
        if importlib.util.find_spec("casadi"):
            from benchmarks.casadi_aba import Peer

            start = perf_counter()
            peer = Peer(model, Path(folder))
            built = perf_counter() - start
            call, found = peer.time(q, u, 5)
            error = relative(found[:EXACT_STATES], snapped)
            counts = peer.operations
            name = "CasADi's C of an ABA"
            rows.append(Row(name, compiled=built, call=call, error=error, operations=counts))
    return rows


def shown(value: float | None, scale: float, digits: int) -> str:
    return "" if value is None else f"{value * scale:.{digits}f}"


def main() -> None:
    """Measure and print."""
    table = Table(title="forward dynamics: from scene to C to numbers")
    for heading in (
        "scene", "program", "operations", "derive [ms]", "compile [s]", "load [ms]",
        "per call [us]", "error (40 digits)",
    ):  # fmt: skip
        table.add_column(heading, justify="right" if "[" in heading else "left")
    used: dict[str, float] = {}
    # nothing cached: compile times are those of a first use
    with tempfile.TemporaryDirectory(prefix="cardan-bench-") as private:
        os.environ["CARDAN_CACHE"] = f"{private}/cache"
        lacking = pinocchio_cpp.missing()
        program = None if lacking else pinocchio_cpp.build(Path(private))
        for case in cases():
            row, q, u = ours(case)
            used[case.name] = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
            rows = [row, *(peers(case, q, u, program) if case.urdf else ())]
            for found in rows:
                table.add_row(
                    case.name,
                    found.program,
                    "" if found.operations is None else str(found.operations),
                    shown(found.derived, 1e3, 1),
                    shown(found.compiled, 1, 2),
                    shown(found.loaded, 1e3, 1),
                    shown(found.call, 1e6, 3),
                    "" if found.error is None else f"{found.error:.1e}",
                )
    out = Console(width=130)
    out.print(table)
    for module, package in PEERS.items():
        if importlib.util.find_spec(module) is None:
            out.print(f"{module} is not installed: pip install {package}")
    if lacking:
        out.print(f"Pinocchio as C++ was not measured: {lacking}")
    for name, memory in used.items():
        out.print(f"largest memory of this process up to {name}: {memory:.0f} MiB")


if __name__ == "__main__":
    main()
