"""MuJoCo's Runge-Kutta method of order 4, in its own loop in C.

Source: E. Todorov, T. Erez, Y. Tassa, MuJoCo: A physics engine for model-based control, IROS 2012.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from benchmarks.motion.problem import Array, Task
from benchmarks.motion.programs.program import Entry, Program
from cardan.peers import mujoco as peer

NAME = "MuJoCo"


def refusal(task: Task) -> str:
    """Trees alone."""
    if task.closed:
        return "it closes loops by soft constraints: another motion"
    return peer.refusal(task.scene, task.model.coordinates)


def _run(task: Task, model: Any, data: Any, places: list[int], steps: int) -> Callable[[], Array]:
    import mujoco
    from mujoco import rollout

    mujoco.mj_resetData(model, data)
    data.qpos[places], data.qvel[:] = task.x0[: task.model.nq], 0.0
    start = np.empty(mujoco.mj_stateSize(model, mujoco.mjtState.mjSTATE_FULLPHYSICS))
    mujoco.mj_getState(model, data, start, mujoco.mjtState.mjSTATE_FULLPHYSICS)
    clock = 1

    def run() -> Array:
        model.opt.timestep = task.problem.end / steps
        states, _ = rollout.rollout(model, data, start[None, :], nstep=steps)
        return states[0, -1, [clock + place for place in places]]

    return run


def entries(task: Task) -> list[Entry]:
    """Steps of one size."""
    import mujoco

    scene, loads = task.scene, task.problem.loads
    model, data = peer.model_and_data(mujoco, scene)
    model.opt.integrator = mujoco.mjtIntegrator.mjINT_RK4
    bodies = range(len(scene.parents))
    joints = [model.joint(f"j{body}") for body in bodies]
    for values, target in ((loads.damping, "damping"), (loads.stiffness, "stiffness")):
        for body, value in zip(bodies, task.along(values), strict=True):
            getattr(joints[body], target)[:] = value
    places = [int(joint.qposadr[0]) for joint in joints]
    return [
        Entry(NAME, "RK4", steps, _run(task, model, data, places, steps))
        for steps in task.problem.steps
    ]


PROGRAM = Program(NAME, peer.missing, refusal, entries)
