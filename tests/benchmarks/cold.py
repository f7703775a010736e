"""First use of scenes with long loops: in a process of its own whose cache is empty.

``cold_process`` starts it; ``cold`` is what it does. Times are those of all processors, the
compiler of C among them; packages stand as bytecode, and kernels, which serve every model, are
compiled.
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
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))
from mechanisms.closed_planar import arc_angles, hanging_chain, parallelogram

SPAN, SHORT, STEPS = 0.8, 1.0, 1000


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
    # in turns: a call with its start takes as long as many steps
    rounds = [[spent(partial(run, count))[1] for count in (1, STEPS + 1)] for _ in range(5)]
    few, many = map(min, zip(*rounds, strict=True))
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
