"""SciPy's solvers calling the C that cardan wrote, through the same wrapper.

Source: P. Virtanen et al., SciPy 1.0: fundamental algorithms for scientific computing, 2020.
"""

from __future__ import annotations

from collections.abc import Callable

from scipy.integrate import solve_ivp

from benchmarks.motion.problem import Array, Task
from benchmarks.motion.programs.program import Entry, Program, present, willing

NAME = "SciPy on our C"
EXPLICIT, STIFF = ("DOP853", "LSODA"), ("LSODA", "Radau")


def _run(task: Task, method: str, tolerance: float) -> Callable[[], Array]:
    model, x0, end = task.model, task.x0, task.problem.end

    def run() -> Array:
        options = {"rtol": tolerance, "atol": tolerance / 10}
        done = solve_ivp(model.rhs, (0.0, end), x0, method=method, t_eval=[end], **options)
        return done.y[: model.nq, -1]

    return run


def entries(task: Task) -> list[Entry]:
    """Its methods over the tolerances."""
    return [
        Entry(NAME, method, tolerance, _run(task, method, tolerance))
        for method in (STIFF if task.problem.stiff else EXPLICIT)
        for tolerance in task.problem.tolerances
    ]


PROGRAM = Program(NAME, present, willing, entries)
