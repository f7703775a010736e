"""Derivation, cold compilation, loading, size and memory of one mechanism, in a new process.

usage: building.py NAME | building.py --long BODIES | building.py --load FOLDER |
building.py --prepare KIND BODIES; prints JSON.
"""

from __future__ import annotations

import json
import os
import resource
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np

FUNCTION = "forward_dynamics"
MIB = 2**20
# a process that takes more is stopped
MEMORY = 12 * 1024 * MIB


def seconds(work: Callable[[], Any]) -> float:
    start = perf_counter()
    work()
    return perf_counter() - start


def memory() -> float:
    """Largest resident memory of this process so far [MiB]; getrusage remembers its parent's."""
    for line in Path("/proc/self/status").read_text("utf-8").splitlines():
        if line.startswith("VmHWM:"):
            return float(line.split()[1]) / 1024
    return float("nan")


def build(scene: Any, method: str, loops: bool | None, repeats: int) -> tuple[Any, dict[str, Any]]:
    """The model, and what it took to get it; nothing is in the cache."""
    import cardan as cd
    from cardan.codegen import generate

    def derivation() -> None:
        equations = cd.derive(scene, method=method)
        generate(equations.form(FUNCTION, loops=loops), model=equations.system.name)

    derived = min(seconds(derivation) for _ in range(repeats))
    equations = cd.derive(scene, method=method)
    model = cd.compile(equations, functions=(FUNCTION,), loops=loops)
    symbol = model._objects.symbol(FUNCTION)
    compiled = seconds(lambda: model._objects.load([symbol]))
    checked = seconds(lambda: model.prepare(FUNCTION))
    code = model._function(FUNCTION).code
    text = model.source[FUNCTION]
    return model, {
        "method": equations.method,
        "derived": derived,
        "compiled": compiled,
        "checked": checked,
        "lines": len(text.splitlines()),
        "bytes": code.built.path.stat().st_size,
        "memory": memory(),
        "compiler_memory": resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024,
    }


def standard(name: str) -> dict[str, Any]:
    """One of the cases."""
    from benchmarks.cases import CASES, DERIVATIVES

    case = next(case for case in CASES if case.name == name)
    model, found = build(case.build(), "auto", case.loops, 5)
    if DERIVATIVES in case.functions:
        found["slopes"] = slopes(case.build())
    command = [sys.executable, __file__, "--load", str(model.directory)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    return found | {"loaded": json.loads(done.stdout)["loaded"]}


def slopes(scene: Any) -> float:
    """Seconds until the C of the derivatives of forward dynamics is written and compiled."""
    import cardan as cd

    model = cd.compile(scene, functions=("derivative",))
    request = model.derivative("forward_dynamics", wrt=("q", "u")).request
    symbols = [("derivative", request)]
    return seconds(lambda: model._objects.load(model._objects.symbols(symbols)))


def load(folder: str) -> dict[str, Any]:
    """What a user waits for when the model was compiled before."""
    from cardan.api.compiled_model import CompiledModel

    return {"loaded": seconds(lambda: CompiledModel(Path(folder)).prepare(FUNCTION))}


def long(bodies: int) -> dict[str, Any]:
    """A chain as loops: nanoseconds per body and state too."""
    from cardan.peers.contest import contest
    from cardan.peers.ours import Ours
    from cardan.peers.peer import States
    from mechanisms.chain import chain

    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    model, found = build(chain(bodies), "articulated", True, 1)
    rng = np.random.default_rng(1)
    # folded states of a long chain are nobody's: small angles, as it hangs
    states, batch = (States(*rng.uniform(-0.1, 0.1, (3, n, bodies))) for n in (2, 16))
    ours = Ours(model)
    runs = {"call": ours.start(FUNCTION, states), "state": ours.batch(FUNCTION, batch)}
    times = contest(runs)
    return found | {name: 1e9 * time.least / bodies for name, time in times.items()}


def prepare(kind: str, bodies: int) -> dict[str, Any]:
    """Seconds of all processors from a scene to its first accelerations, the compiler of C among
    them: a "chain", a random "tree", or a chain in "absolute" coordinates.
    """
    import cardan as cd
    from mechanisms.chain import chain
    from mechanisms.random_trees import large_tree

    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    # the first model of a process loads the compiler half, and finds the compiler
    warm = cd.compile(chain(2), functions=(FUNCTION,))
    warm.forward_dynamics(*warm.split(warm.initial()))
    begin = sum(os.times()[:4])
    scene = large_tree(bodies) if kind == "tree" else chain(bodies)
    options = {"coordinates": "absolute"} if kind == "absolute" else {}
    model = cd.compile(cd.derive(scene, **options), functions=(FUNCTION,))
    q, u = model.split(model.initial())
    assert np.isfinite(model.forward_dynamics(q, u)).all()
    return {"prepared": sum(os.times()[:4]) - begin}


def main() -> None:
    # the zoo stands beside this folder
    sys.path.insert(0, str(Path(__file__).parents[1]))
    first, *rest = sys.argv[1:]
    if first == "--load":
        found = load(rest[0])
    elif first == "--long":
        found = long(int(rest[0]))
    elif first == "--prepare":
        found = prepare(rest[0], int(rest[1]))
    else:
        found = standard(first)
    print(json.dumps(found))


if __name__ == "__main__":
    main()
