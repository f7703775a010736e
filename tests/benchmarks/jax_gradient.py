"""Overhead of a cost of a motion in an export for JAX: ``python tests/benchmarks/jax_gradient.py``.

A run of a single step is nearly nothing: what a jitted call with its gradient takes is what jax.ffi
and the C around the run add.
"""

from __future__ import annotations

import importlib.util
import shutil
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

import cardan as cd

LIMIT = 100.0  # us


def least(call: Callable[[], Any], calls: int = 2000, rounds: int = 7) -> float:
    """The shortest mean time of a call [us]."""
    times = []
    for _ in range(rounds):
        before = time.perf_counter()
        for _ in range(calls):
            call()
        times.append((time.perf_counter() - before) / calls)
    return 1e6 * min(times)


def main() -> None:
    """Print the times."""
    missing = [] if importlib.util.find_spec("jax") else ["jax (pip install jax)"]
    missing += [] if any(map(shutil.which, ("cc", "gcc", "clang"))) else ["a C compiler"]
    if missing:
        print(f"skipped: {' and '.join(missing)} is missing")
        return
    import jax

    jax.config.update("jax_enable_x64", True)
    equations = cd.derive(cd.load(cd.examples.path("double_pendulum")))
    with tempfile.TemporaryDirectory() as folder:
        options: dict[str, Any] = {"integrators": ["rk4"], "gradient": cd.cost(final="elbow^2")}
        where = equations.export(Path(folder) / "swing", ["energy"], language="jax", **options)
        sys.path.insert(0, str(where))
        module = importlib.import_module("double_pendulum_jax")
        x = jax.numpy.array(np.array([0.3, 0.1, 0.0, 0.0]))
        empty = jax.jit(lambda x: (x[0], x))
        times = {}
        for steps in (1, 1000):
            run = jax.jit(
                jax.value_and_grad(lambda x, n=steps: module.cost(x, end=n * 1e-3, step=1e-3))
            )
            run(x)[1].block_until_ready()
            times[steps] = least(lambda run=run: run(x)[1].block_until_ready(), 200)
        empty(x)
        nothing = least(lambda: empty(x)[1].block_until_ready())
    print(f"empty call {nothing:.1f} us, 1000 steps and back {times[1000]:.0f} us")
    print(f"one step {times[1]:.1f} us, at most {LIMIT:g}: {'yes' if times[1] <= LIMIT else 'NO'}")


if __name__ == "__main__":
    main()
