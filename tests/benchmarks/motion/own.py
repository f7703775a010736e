"""What is measured of our own programs alone: ensembles, and steps of a stiff motion."""

from __future__ import annotations

import cardan as cd
from benchmarks.cases import CASES
from benchmarks.ensembles import beside
from benchmarks.motion.problems import spring_pendulum

ROUNDS = 9
IMPLICIT = ("Radau", "Rosenbrock")


def gain() -> float:
    """Time of a Panda run of 1 s among many one by one, over that in lanes."""
    alone, lanes = beside(next(case for case in CASES if case.name == "panda"), ROUNDS)
    return alone / lanes


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
