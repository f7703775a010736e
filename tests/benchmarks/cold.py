"""First use of scenes with long loops: in a process of its own whose cache is empty.

``cold_process`` starts it; ``cold`` is what it does. Times are those of all processors, the
compiler of C among them; packages stand as bytecode, and kernels, which serve every model, are
compiled.

``python tests/benchmarks/cold.py`` prints what whole processes take from start to first call, with
an empty cache and with one that has the scene, and what importing other packages takes.
"""

from __future__ import annotations

import json
import os
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from functools import partial
from importlib.util import find_spec
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))
from mechanisms.closed_planar import arc_angles, hanging_chain, parallelogram

SPAN, SHORT, STEPS = 0.8, 1.0, 200
WARM = 7  # processes, of which the quickest counts

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
PYTHON = """
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


def starts(scene: Path) -> dict[str, list[str]]:
    """Commands by what they do; ``scene`` is a scene file of numbers."""
    python = [sys.executable, "-W", "ignore"]
    of_file = f"import cardan as cd\nscene = cd.load({str(scene)!r})\n"
    formulas = "import cardan as cd\nscene = cd.examples['double_pendulum']\n"
    beam = "import cardan as cd\nscene = cd.examples['flexible_arm']\n"
    programs = {
        "two links in Python with formulas of SymPy": PYTHON + CALL,
        "the same in YAML with numbers": of_file + CALL,
        "the same in YAML with formulas": formulas + CALL,
        "Panda, URDF": PANDA + CALL,
        "flexible arm, YAML": beam + CALL,
    }
    found = {name: [*python, "-c", text] for name, text in programs.items()}
    return found | {"cardan simulate, YAML": [*python, "-m", "cardan", "simulate", str(scene)]}


def start_times() -> None:
    """Print seconds of processor time from the start of a process to its end."""
    with tempfile.TemporaryDirectory(prefix="cardan-start-") as private:
        given = {
            **os.environ,
            "PYTHONPYCACHEPREFIX": f"{private}/bytecode",
            "PYTHONDONTWRITEBYTECODE": "",
        }

        def seconds(command: list[str], cache: str) -> float:
            environment = given | {"CARDAN_CACHE": f"{private}/{cache}"}
            work = partial(
                subprocess.run, command, capture_output=True, check=True, env=environment
            )
            return spent(work)[1]

        scene = Path(private, "arm.yaml")
        scene.write_text(NUMBERS)
        print(f"{'':48}empty cache  warm, s of processor time")
        for k, (name, command) in enumerate(starts(scene).items()):
            seconds(command, f"bytecode{k}")
            cold_start = seconds(command, f"cache{k}")
            warm = min(seconds(command, f"cache{k}") for _ in range(WARM))
            print(f"{name:48}{cold_start:11.2f}{warm:6.2f}")
        for package in ("numpy", "sympy", "casadi", "pinocchio"):
            if find_spec(package):
                command = [sys.executable, "-c", f"import {package}"]
                seconds(command, "none")
                warm = min(seconds(command, "none") for _ in range(WARM))
                print(f"{'import ' + package:48}{'':11}{warm:6.2f}")


def spent(work: Callable[[], object]) -> tuple[object, float]:
    """A result with the seconds of this process and of those that it waits for."""

    def now() -> float:
        children = resource.getrusage(resource.RUSAGE_CHILDREN)
        return time.process_time() + children.ru_utime + children.ru_stime

    begin = now()
    result = work()
    return result, now() - begin


def cold(case: str) -> dict[str, float]:
    """Seconds by what was done: ``chain`` and links, or ``A02`` and windows."""
    name, size = case.split()
    return chain(int(size)) if name == "chain" else four_bars(int(size))


def chain(links: int) -> dict[str, float]:
    """A chain until accelerations can be called, at rest, at rest from a line."""
    import cardan as cd

    angles = arc_angles(links, SPAN)
    start = {f"pin{k}": a - b for k, (a, b) in enumerate(zip(angles, [0, *angles], strict=False))}
    scenes = [hanging_chain(links, stretched=line) for line in (False, True)]

    def built(scene: cd.Scene) -> cd.CompiledModel:
        model = cd.compile(scene)
        model.prepare("forward_dynamics")
        return model

    model, build = spent(lambda: built(scenes[0]))
    _, rest = spent(lambda: model.equilibrium(q=start, check=True))
    line = built(scenes[1])
    _, without = spent(lambda: line.equilibrium(check=True))
    return {"built": build, "equilibrium": rest, "equilibrium without angles": without}


def four_bars(windows: int) -> dict[str, float]:
    """Four-bars from the scene to a simulated second, then a step more."""
    import cardan as cd

    scene, start = parallelogram(windows), {"A0": 1.5707963267948966}

    def run(count: int) -> cd.Trajectory:
        method = cd.GeneralizedAlpha()
        end = count * 1e-3
        return model.simulate((0, end), q=start, u={"A0": -1.0}, method=method, step=1e-3)

    def first() -> cd.CompiledModel:
        compiled = cd.compile(scene)
        q = {f"A{k}": start["A0"] for k in range(windows + 1)}
        compiled.simulate(SHORT, q=q, u={"A0": -1.0}, check=True)
        return compiled

    model, simulated = spent(first)
    start = {f"A{k}": start["A0"] for k in range(windows + 1)}
    few = min(spent(lambda: run(1))[1] for _ in range(3))
    many = min(spent(lambda: run(STEPS + 1))[1] for _ in range(3))
    return {"simulated": simulated, "step": (many - few) / STEPS}


def cold_process(case: str) -> dict[str, float]:
    """What a new process says of a case; the first one only writes bytecode."""
    script = Path(__file__).with_name("large_loops.py")
    found: dict[str, float] = {}
    with tempfile.TemporaryDirectory(prefix="cardan-cold-") as private:
        for cache in ("first", "second"):
            given = {
                **os.environ,
                "CARDAN_CACHE": f"{private}/{cache}",
                "PYTHONPYCACHEPREFIX": f"{private}/bytecode",
                "PYTHONDONTWRITEBYTECODE": "",
            }
            command = [sys.executable, "-W", "ignore", str(script), "--cold", case]
            done = subprocess.run(command, capture_output=True, text=True, check=True, env=given)
            found = json.loads(done.stdout)
    return found


if __name__ == "__main__":
    start_times()
