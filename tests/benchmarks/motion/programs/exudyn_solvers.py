"""Exudyn: trees in minimal coordinates by RK67 and DOPRI5, loops by generalized-alpha.

Source: J. Gerstmayr, Exudyn - a C++-based Python package for flexible multibody systems, Multibody
System Dynamics 60, 2024.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from benchmarks.motion.problem import Array, Task
from benchmarks.motion.programs.program import Entry, Program
from cardan.peers.peer import installed

NAME = "Exudyn"


def missing() -> str:
    """What keeps it from being called, "" where nothing does."""
    return installed("exudyn", "exudyn")


def refusal(task: Task) -> str:
    """Hinges and slides along axes of their frames."""
    from benchmarks.motion.programs import exudyn_tree as tree

    return "" if task.closed else tree.refusal(task)


def _settings(exu: Any, task: Task, method: str, setting: float) -> Any:
    """Quiet settings of a run; tolerances are those of adaptive methods."""
    settings = exu.SimulationSettings()
    settings.solutionSettings.writeSolutionToFile = False
    settings.solutionSettings.sensorsWritePeriod = task.problem.end
    time = settings.timeIntegration
    time.endTime, time.verboseMode = task.problem.end, 0
    settings.displayComputationTime = settings.displayStatistics = False
    time.generalizedAlpha.spectralRadius = 0.8
    time.newton.useModifiedNewton = True
    # else small errors of its iterations hide those of its steps
    time.newton.relativeTolerance, time.newton.absoluteTolerance = 1e-10, 1e-12
    if method == "DOPRI5":
        time.relativeTolerance, time.absoluteTolerance = setting, setting / 10
        time.numberOfSteps, time.minimumStepSize = 100, 1e-14
    else:
        time.numberOfSteps, time.automaticStepSize = int(setting), False
    return settings


def _run(task: Task, system: Any, read: Any, method: str, setting: float) -> Callable[[], Array]:
    import exudyn as exu

    settings = _settings(exu, task, method, setting)
    solver = getattr(exu.DynamicSolverType, method)

    def run() -> Array:
        system.SolveDynamic(settings, solverType=solver, showHints=False)
        return read()

    return run


def entries(task: Task) -> list[Entry]:
    """Explicit methods of trees; its implicit one of stiff and closed systems."""
    import exudyn as exu

    from benchmarks.motion.programs import exudyn_planar, exudyn_tree

    exu.SetWriteToConsole(False)
    system, read = (exudyn_planar if task.closed else exudyn_tree).built(task)
    wanted = [("GeneralizedAlpha", float(n)) for n in task.problem.steps]
    if not task.closed:
        wanted = [] if not task.problem.stiff else wanted
        wanted += [("RK67", float(n)) for n in task.problem.steps]
        if not task.problem.stiff:
            wanted += [("DOPRI5", each) for each in task.problem.tolerances]
    return [Entry(NAME, how, each, _run(task, system, read, how, each)) for how, each in wanted]


PROGRAM = Program(NAME, missing, refusal, entries)
