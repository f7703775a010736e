"""CasADi: dynamics written in it, compiled, integrated by its CVODES.

Loops are closed at the level of accelerations, as multipliers in one linear system.

Source: J. Andersson et al., CasADi: a software framework for nonlinear optimization, 2019.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from benchmarks.motion.problem import Array, Task
from benchmarks.motion.programs.program import Entry, Program, willing
from cardan.peers import casadi as peer

NAME = "CasADi"
MOST = 10_000_000
JIT = {
    "jit": True,
    "compiler": "shell",
    "jit_options": {"flags": ["-O2", "-march=native"], "verbose": False},
}


def _rates(ca: Any, task: Task) -> tuple[Any, Any]:
    """State and its derivative."""
    from benchmarks.motion.programs import casadi_circuits as circuits
    from cardan.peers import casadi_algorithms as algorithms

    model, loads = task.model, task.problem.loads
    x = ca.SX.sym("x", len(task.x0))
    q, u = x[: model.nq], x[model.nq :]
    tree = algorithms.tree(task.scene, q)
    tau = ca.DM(task.along(loads.constant)) - ca.DM(task.along(loads.stiffness)) * q
    tau = tau - ca.DM(task.along(loads.damping)) * u
    if task.closed:
        udot = circuits.accelerations(task, tree, q, u, tau)
    else:
        udot = algorithms.articulated(tree, u, tau)
    return x, ca.vertcat(u, udot)


def _run(task: Task, solver: Any) -> Callable[[], Array]:
    def run() -> Array:
        return np.array(solver(x0=task.x0)["xf"])[: task.model.nq, 0]

    return run


def entries(task: Task) -> list[Entry]:
    """Its methods over the tolerances; the dynamics is compiled once."""
    import casadi as ca

    x, rates = _rates(ca, task)
    rhs = ca.Function("rhs", [x], [ca.densify(rates)], {**JIT, "cse": True})
    state = ca.MX.sym("x", len(task.x0))
    system = {"x": state, "ode": rhs(state)}
    methods = {"BDF": {"linear_multistep_method": "bdf"}}
    if not task.problem.stiff:
        adams = {"linear_multistep_method": "adams", "nonlinear_solver_iteration": "functional"}
        methods["Adams"] = adams
    found = []
    for method, choice in methods.items():
        for tolerance in task.problem.tolerances:
            options = {**choice, "reltol": tolerance, "abstol": tolerance / 10}
            options |= {"max_num_steps": MOST}
            solver = ca.integrator("run", "cvodes", system, 0.0, task.problem.end, options)
            found.append(Entry(NAME, f"CVODES {method}", tolerance, _run(task, solver)))
    return found


PROGRAM = Program(NAME, peer.missing, willing, entries)
