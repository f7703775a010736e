"""Tasks: problems compiled, started, and known at their end."""

from __future__ import annotations

import numpy as np

import cardan as cd
from benchmarks.motion.problem import Array, Problem, Task

TIGHT = {"rtol": 3e-14, "atol": 1e-15}
# the other way: where stiff not many more steps than it takes, else of lower order
SECOND = {"rtol": 1e-12, "atol": 1e-14}


def task(problem: Problem) -> Task:
    """A problem ready for all programs.

    The end comes from the problem where it has a way of its own, else from the tightest tolerance
    of the first method of ours; the doubt is the distance to another method.
    """
    model = cd.compile(problem.build())
    start = {name: value for name, value in problem.start.items() if name in model.coordinates}
    x0 = model.initial(q=start)

    def places(method: str, tolerances: dict[str, float]) -> Array:
        motion = model.simulate([0.0, problem.end], x0=x0, method=method, **tolerances)
        return problem.places(model, motion.q[-1])

    first, second = ("Radau", "DOP853") if problem.stiff else ("DOP853", "Radau")
    found = places(first, TIGHT)
    exact = problem.exact(model, x0) if problem.exact else found
    other = found if problem.exact else places(second, SECOND)
    return Task(problem, model, x0, exact, float(np.abs(exact - other).max()))
