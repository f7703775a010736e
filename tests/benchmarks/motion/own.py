"""What is measured of our own programs alone: ensembles, and steps of a stiff motion."""

from __future__ import annotations

from time import perf_counter

import numpy as np

import cardan as cd
from benchmarks.motion.problems import panda, spring_pendulum

RUNS, SEED = 2_000, 1
METHODS = ("DOP853", "RK45")
IMPLICIT = ("Radau", "Rosenbrock")


def gain(runs: int = RUNS, rounds: int = 3) -> float:
    """Time of Panda runs of 1 s one by one over that in lanes, both in one thread.

    Starts are drawn around the posture; rtol is 1e-6, each side has its fastest method.
    """
    model = cd.compile(panda.PROBLEM.build())
    rng = np.random.default_rng(SEED)
    starts = np.zeros((runs, model.nx))
    starts[:, : model.nq] = panda.POSTURE + rng.uniform(-0.3, 0.3, (runs, model.nq))
    least: dict[int | None, float] = {}
    for _ in range(rounds):
        for lanes in (1, None):
            for method in METHODS:
                began = perf_counter()
                model.ensemble(panda.PROBLEM.end, x0=starts, method=method, rtol=1e-6, threads=1,
                               lanes=lanes, progress=False)  # fmt: skip
                spent = perf_counter() - began
                least[lanes] = min(least.get(lanes, spent), spent)
    return least[1] / least[None]


def saved_steps() -> float:
    """Explicit steps of the stiff spring pendulum over implicit ones, both at rtol 1e-5."""
    problem = spring_pendulum.PROBLEM
    model = cd.compile(problem.build())

    def steps(method: str) -> int:
        motion = model.simulate(
            [0.0, problem.end], q=problem.start, method=method, rtol=1e-5, atol=1e-8
        )
        return int(motion.statistics["steps"])

    return steps("DOP853") / max(steps(method) for method in IMPLICIT)
