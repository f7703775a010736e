"""cardan: the call of ``model.simulate`` as a user writes it, dense output and ledger included."""

from __future__ import annotations

from collections.abc import Callable

from benchmarks.motion.problem import Array, Task
from benchmarks.motion.programs.program import Entry, Program, present, willing

NAME = "cardan"


def _run(task: Task, method: str, tolerance: float) -> Callable[[], Array]:
    model, x0, span = task.model, task.x0, (0.0, task.problem.end)

    def run() -> Array:
        motion = model.simulate(
            span, x0=x0, method=method, rtol=tolerance, atol=tolerance / 10, progress=False
        )
        return motion.q[-1]

    return run


def entries(task: Task) -> list[Entry]:
    """All methods of the problem over their tolerances."""
    return [
        Entry(NAME, method, tolerance, _run(task, method, tolerance))
        for method, tolerances in task.problem.methods.items()
        for tolerance in tolerances
    ]


PROGRAM = Program(NAME, present, willing, entries)
