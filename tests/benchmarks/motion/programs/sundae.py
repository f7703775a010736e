"""scikit-sundae: CVODE, and IDA where loops are closed, calling the C that cardan wrote.

Source: A. C. Hindmarsh et al., SUNDIALS: suite of nonlinear and differential/algebraic equation
solvers, ACM Transactions on Mathematical Software 31, 2005.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from benchmarks.motion.problem import Array, Task
from benchmarks.motion.programs.program import Entry, Program, willing
from cardan.peers.peer import installed

NAME = "scikit-sundae on our C"
MOST = 10_000_000
# multipliers are held by the equations, not by the error control
LOOSE = 1e6


def missing() -> str:
    """What keeps it from being called, "" where nothing does."""
    return installed("sksundae", "scikit-sundae")


def _ends(solver: Any, end: float, *start: Array) -> Array:
    """The state that a solver finds at the end."""
    found = solver.solve(np.array([0.0, end]), *start)
    return np.asarray(found.y[-1])


def _cvode(task: Task, method: str, tolerance: float) -> Callable[[], Array]:
    from sksundae.cvode import CVODE

    model = task.model

    def rhs(t: float, x: Array, out: Array) -> None:
        out[:] = model.rhs(t, x)

    def run() -> Array:
        options = {"rtol": tolerance, "atol": tolerance / 10, "max_num_steps": MOST}
        solver = CVODE(rhs, method=method, **options)
        return _ends(solver, task.problem.end, task.x0)[: model.nq]

    return run


def _ida(task: Task, tolerance: float) -> Callable[[], Array]:
    """Index 1: accelerations keep the constraints; a multiplier for each beside the state."""
    from sksundae.ida import IDA

    model, n, nq = task.model, len(task.x0), task.model.nq
    q, u = model.split(task.x0)
    lam = model.multipliers(q, u)
    y0 = np.concatenate([task.x0, lam])
    rates = np.concatenate([model.rhs(0.0, task.x0), np.zeros_like(lam)])
    atol = np.concatenate([np.full(n, tolerance / 10), np.full(len(lam), LOOSE)])

    def residual(t: float, y: Array, yp: Array, out: Array) -> None:
        q, u, lam = y[:nq], y[nq:n], y[n:]
        out[:] = model.residual(t, q, u, yp[nq:n], lam, qdot=yp[:nq], index=1)

    def run() -> Array:
        options = {"rtol": tolerance, "atol": atol, "max_num_steps": MOST}
        solver = IDA(residual, algebraic_idx=list(range(n, len(y0))), **options)
        return _ends(solver, task.problem.end, y0, rates)[:nq]

    return run


def entries(task: Task) -> list[Entry]:
    """Its methods over the tolerances."""
    methods = ("BDF",) if task.problem.stiff else ("Adams", "BDF")
    found = [
        Entry(NAME, f"CVODE {method}", tolerance, _cvode(task, method, tolerance))
        for method in methods
        for tolerance in task.problem.tolerances
    ]
    if task.closed:
        tolerances = task.problem.tolerances
        found += [Entry(NAME, "IDA", each, _ida(task, each)) for each in tolerances]
    return found


PROGRAM = Program(NAME, missing, willing, entries)
