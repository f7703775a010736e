"""What processes take from start to first call: with an empty compile cache, and with a warm one.

Times are those of all processors, the compiler of C among them, from the start of a process to its
end. Writes docs/performance/starts.md, or nothing with ``--quick``.

usage: starts.py [--quick]
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import statistics
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path
from typing import NamedTuple

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from benchmarks.all_figures import save
from benchmarks.cold import spent
from benchmarks.page import markdown
from benchmarks.provenance import signed
from cardan.peers.processor import name as processor
from cardan.runtime.build import cache

PAGE = Path(__file__).resolve().parents[2] / "docs" / "performance" / "starts.md"
WARM, COLD = 9, 2  # processes of each kind
PROCESS, COMMAND = 0.25, 0.4  # to reach with a warm cache [s]
LISTED = 5  # packages of a profile
PACKAGES = ("numpy", "sympy", "casadi", "pinocchio")
TEXT = """# Starts

What a process takes from its start to its end, in which a scene is read, compiled and called once,
or simulated for 0.1 s by the command. Written by `tests/benchmarks/starts.py`: {processor},
{compiler}, Python {python}, {versions}.

Times are those of all processors, the compiler of C among them, which others on the machine do not
lengthen by their turns. *Empty cache*: nothing was compiled before, the least of {cold}; Python's
bytecode and the kernels, which serve every model, are there. *Warm*: the same again, the least and
the median of {warm} processes, in which all rows take turns. Below stand imports of
packages, by which the processor may be compared with others.

Formulas in a scene are expressions of SymPy, which is imported to read them even where the scene
was compiled before; a system of elements orders its sparse equations anew in every process, with
SciPy. Scenes of numbers without elements need neither.
"""

NUMBERS = """
cardan: 2
name: arm
bodies:
  upper: {mass: 1, com: [0, 0, -0.25], inertia: {rod: {mass: 1, length: 0.5, axis: z}}}
  lower: {mass: 1, com: [0, 0, -0.25], inertia: {rod: {mass: 1, length: 0.5, axis: z}}}
joints:
  shoulder: {type: revolute, axis: y, parent: ground, child: upper}
  elbow: {type: revolute, axis: y, parent: {body: upper, at: [0, 0, -0.5]}, child: lower}
simulate: {time: 0.1}
"""
FORMULAS = """
import cardan as cd
scene = cd.Scene("arm", gravity=(0, 0, -9.81))
l = scene.parameter("l", 0.5, "m")
m = scene.parameter("m", 1.0, "kg")
inertia = cd.inertia.rod(m, l, axis="z")
upper = scene.body("upper", mass=m, com=(0, 0, -l / 2), inertia=inertia)
lower = scene.body("lower", mass=m, com=(0, 0, -l / 2), inertia=inertia)
scene.joint("shoulder", cd.Revolute("y"), scene.ground, upper)
scene.joint("elbow", cd.Revolute("y"), upper.at(0, 0, -l), lower)
"""
MARK = "account of imports:"
# every module that is loaded passes through one function of Python's; that of another inside it
# does not count twice
ACCOUNT = f"""
import atexit, importlib._bootstrap, json, sys, time
load, inside, seconds = importlib._bootstrap._find_and_load, [0.0], {{}}
def timed(name, *more):
    begin = time.process_time()
    inside.append(0.0)
    try:
        return load(name, *more)
    finally:
        total = time.process_time() - begin
        seconds[name] = seconds.get(name, 0.0) + total - inside.pop()
        inside[-1] += total
importlib._bootstrap._find_and_load = timed
def tell():
    print({MARK!r}, json.dumps(seconds | {{"all": time.process_time()}}), file=sys.stderr)
atexit.register(tell)
"""
CALL = """
import numpy as np
model = cd.compile(scene)
model.forward_dynamics(np.zeros(model.nq), np.zeros(model.nu))
"""
PANDA = """
import sys
from pathlib import Path
import cardan as cd
robots = Path(*[one for one in sys.path if "site-packages" in one][:1]) / "cmeel.prefix/share"
robots /= "example-robot-data/robots"
scene = cd.load(robots / "panda_description/urdf/panda.urdf", packages=robots)
"""


@dataclass(frozen=True)
class Start:
    """A process that is measured.

    Attributes:
        name: In the page.
        arguments: Of the interpreter.
        aim: Time to reach with a warm cache [s], None where none was set.
        compiles: It uses the compile cache.
    """

    name: str
    arguments: tuple[str, ...]
    aim: float | None = None
    compiles: bool = True


class Times(NamedTuple):
    """Seconds of processor time of the processes of a row."""

    cold: float
    least: float
    median: float


def starts(scene: Path, robots: bool) -> Iterator[Start]:
    """Processes to measure; ``scene`` is a scene file of numbers."""
    of_file = f"import cardan as cd\nscene = cd.load({str(scene)!r})\n"
    example = "import cardan as cd\nscene = cd.examples[{!r}]\n"
    programs = {
        "two links in Python, with formulas of SymPy": FORMULAS,
        "two links in YAML, with numbers": of_file,
        "double pendulum in YAML, with formulas": example.format("double_pendulum"),
        "flexible arm in YAML": example.format("flexible_arm"),
    }
    if robots and find_spec("pinocchio"):
        programs["Panda, URDF"] = PANDA
    for name, text in programs.items():
        yield Start(name, ("-c", text + CALL), PROCESS)
    yield Start("cardan simulate FILE.yaml", ("-m", "cardan", "simulate", str(scene)), COMMAND)
    for package in PACKAGES:
        if find_spec(package):
            yield Start(f"import {package}", ("-c", f"import {package}"), compiles=False)


def ran(start: Start, folder: Path, name: str, *flags: str) -> subprocess.CompletedProcess[str]:
    """A process with the cache of a name and with the bytecode of all."""
    environment = {
        **os.environ,
        "CARDAN_CACHE": str(folder / name),
        "PYTHONPYCACHEPREFIX": str(folder / "bytecode"),
        "PYTHONDONTWRITEBYTECODE": "",
    }
    command = [sys.executable, "-W", "ignore", *flags, *start.arguments]
    return subprocess.run(command, capture_output=True, text=True, check=True, env=environment)


def measured(rows: Sequence[Start], folder: Path, warm: int, cold: int) -> list[Times]:
    """Times of every row, whose processes take turns."""
    empty: list[list[float]] = [[] for _ in rows]
    again: list[list[float]] = [[] for _ in rows]
    for k, row in enumerate(rows):
        ran(row, folder, f"bytecode{k}")
    for turn in range(cold):
        for k, row in enumerate(rows):
            if row.compiles:
                empty[k].append(spent(partial(ran, row, folder, f"cache{k}-{turn}"))[1])
    for _ in range(warm):
        for k, row in enumerate(rows):
            again[k].append(spent(partial(ran, row, folder, f"cache{k}-0"))[1])
    return [
        Times(min(first, default=float("nan")), min(later), statistics.median(later))
        for first, later in zip(empty, again, strict=True)
    ]


def accounted(start: Start) -> Start:
    """The same process, which tells at its end how long its imports took."""
    kind, *more = start.arguments
    text = more[0]
    if kind == "-m":
        text = (
            f"import runpy, sys\nsys.argv = {more!r}\n"
            "runpy.run_module(sys.argv[0], run_name='__main__', alter_sys=True)"
        )
    return replace(start, arguments=("-c", f"{ACCOUNT}\n{text}"))


def cause(start: Start, folder: Path, name: str) -> str:
    """What takes the time of a row: seconds of its imports by package, and those of all else."""
    said = ran(accounted(start), folder, name).stderr
    account: dict[str, float] = json.loads(said.rpartition(MARK)[2])
    total = account.pop("all")
    seconds: Counter[str] = Counter()
    for module, part in account.items():
        package = module.partition(".")[0]
        is_standard = package in sys.stdlib_module_names
        seconds["the standard library" if is_standard else package] += part
    parts = [f"importing {package} {part:.2f} s" for package, part in seconds.most_common(LISTED)]
    parts.append(f"what is no import {max(0.0, total - seconds.total()):.2f} s")
    return ", ".join(parts)


def reached(start: Start, times: Times) -> bool:
    """The row has no aim, or reaches it."""
    return start.aim is None or times.least <= start.aim


def seconds_of(value: float) -> str:
    """A cell; empty for NaN."""
    return f"{value:.2f}" if value == value else ""


def table(rows: Sequence[Start], times: Sequence[Times]) -> str:
    """Rows as people read them."""
    headings = ("process", "empty cache [s]", "to reach warm [s]", "warm, least [s]", "median [s]")
    cells = [
        (
            row.name,
            seconds_of(one.cold),
            "" if row.aim is None else f"{row.aim:g}",
            seconds_of(one.least),
            seconds_of(one.median),
        )
        for row, one in zip(rows, times, strict=True)
    ]
    return "\n".join(markdown(headings, cells, 1))


def notes(rows: Sequence[Start], times: Sequence[Times], causes: Mapping[str, str]) -> list[str]:
    """What was missed and why, for the top of the page."""
    return [
        f"- Missed: {row.name}, {one.least:.2f} s where {row.aim:g} s were to reach. Its time: "
        f"{causes[row.name]}."
        for row, one in zip(rows, times, strict=True)
        if not reached(row, one)
    ] or ["Every figure to reach is reached."]


def figures(rows: Sequence[Start], times: Sequence[Times]) -> Iterator[tuple[str, str, str, str]]:
    """Figures to reach, for the table of all."""
    for row, one in zip(rows, times, strict=True):
        if row.aim is not None:
            verdict = "yes" if reached(row, one) else "no"
            yield f"warm start: {row.name}", f"≤ {row.aim:g} s", f"{one.least:.2f} s", verdict


def main() -> None:
    """Measure, print, write the page."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="few processes, no robot, no page")
    quick = parser.parse_args().quick
    with tempfile.TemporaryDirectory(prefix="cardan-start-") as private:
        folder = Path(private)
        scene = folder / "arm.yaml"
        scene.write_text(NUMBERS)
        rows = list(starts(scene, robots=not quick))
        times = measured(rows, folder, *((2, 1) if quick else (WARM, COLD)))
        causes = {
            row.name: cause(row, folder, f"cache{k}-0")
            for k, (row, one) in enumerate(zip(rows, times, strict=True))
            if not reached(row, one)
        }
    said = notes(rows, times, causes)
    lines = table(rows, times)
    print(*said, lines, sep="\n")
    save("starts.md", figures(rows, times))
    if quick:
        return
    head = TEXT.format(
        processor=processor(), compiler=cache.compiler().identity.splitlines()[0],
        python=platform.python_version(), warm=WARM, cold=COLD,
        versions=", ".join(f"{name} {version(name)}" for name in ("numpy", "sympy", "scipy")),
    )  # fmt: skip
    title, _, rest = head.partition("\n\n")
    text = f"{title}\n\n" + "\n".join(said) + f"\n\n{rest}\n{lines}\n"
    PAGE.write_text(signed(text), "utf-8")


if __name__ == "__main__":
    main()
