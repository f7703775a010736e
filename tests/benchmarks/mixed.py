"""Rigid and flexible bodies in one scene: a robot with a flexible rod, rigid bodies on nodes.

Times are those of whole calls by the generalized-alpha method, the least of several in turns.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

import cardan as cd
from mechanisms.robots import STANDARD

Array = NDArray[np.float64]
HAND, ROD = "tool0", 0.3
START = (0.2, -0.8, 0.9, 0.1, 0.2, 0.3)
STEP, STEPS, ROUNDS = 1e-3, 2000, 5
RHO_INF = 0.8
# unit rods, hinged about y and z in turn, let go from the horizontal
BODIES, FEW = 40, 100
INERTIA = (0.01, 1 / 12, 1 / 12)


def rod(scene: cd.Scene, place: Any, tip: tuple[float, ...], elements: int) -> cd.Scene:
    """A rod of aluminum between a place and a free end."""
    material = cd.material(E=7e10, nu=0.3, rho=2700)
    scene.beam("rod", place, tip, cd.section.circle(0.01), material, elements=elements)
    return scene


def places() -> tuple[Array, tuple[float, ...]]:
    """Pose (4, 4) of the hand of the robot at rest and the tip of a rod along its x axis."""
    robot = cd.compile(STANDARD["ur5"].build())
    pose = np.asarray(robot.pose(HAND, np.zeros(robot.nq)))
    return pose, tuple((pose[:3, 3] + ROD * pose[:3, 0]).tolist())


def clamped(elements: int) -> cd.Scene:
    """The rod alone, clamped."""
    pose, tip = places()
    scene = cd.Scene("rod", gravity=(0, 0, -9.81))
    place = scene.ground.at(*pose[:3, 3], rotation=pose[:3, :3].tolist())
    return rod(scene, place, tip, elements)


def robot(elements: int) -> cd.Scene:
    """The robot with the rod in its hand."""
    return rod(STANDARD["ur5"].build(), HAND, places()[1], elements)


def least(runs: Mapping[str, Callable[[], object]], rounds: int = ROUNDS) -> dict[str, float]:
    """Seconds of the thread of runs that take turns, after one that is not timed."""
    best = dict.fromkeys(runs, float("inf"))
    for k in range(rounds + 1):
        for name, run in runs.items():
            begin = time.thread_time()
            run()
            spent = time.thread_time() - begin
            best[name] = min(best[name], spent) if k else best[name]
    return best


def robots(elements: int) -> dict[str, float]:
    """Times of a step [s] of the rod, the robot, and both in the coordinates that are chosen."""
    alone, both = cd.compile(clamped(elements)), cd.compile(robot(elements))
    nodes = cd.compile(robot(elements), coordinates="absolute")
    arm = cd.compile(STANDARD["ur5"].build())
    start = dict(zip(arm.coordinates, START, strict=True))

    def run(model: cd.CompiledModel, q: Mapping[str, float]) -> Callable[[], object]:
        method = cd.GeneralizedAlpha(RHO_INF)
        return lambda: model.simulate(STEPS * STEP, q=q, method=method, step=STEP)

    runs = {"rod": run(alone, {}), "robot": run(arm, start), "both": run(both, start)}
    runs["nodes"] = run(nodes, start)
    return {name: seconds / STEPS for name, seconds in least(runs, 3).items()}


def chain(bodies: int = BODIES) -> cd.Scene:
    """Unit rods between hinges about y and z in turn, along x."""
    scene = cd.Scene(f"chain{bodies}", gravity=(0, 0, -9.81))
    place = scene.ground
    for k in range(bodies):
        body = scene.body(f"rod{k}", mass=1.0, com=(0.5, 0, 0), inertia=INERTIA)
        scene.joint(f"hinge{k}", cd.Revolute("yz"[k % 2]), place, body)
        place = body.at(1, 0, 0)
    return scene


def exudyn_chain(bodies: int = BODIES) -> Callable[[int], Array]:
    """The same by Exudyn: a run of so many steps that gives the place of the last body (3,) [m]."""
    import exudyn as exu
    from exudyn import itemInterface as items

    exu.config.printToConsole = False
    system = exu.SystemContainer().AddSystem()
    before = system.AddMarker(
        items.MarkerBodyRigid(bodyNumber=system.AddObject(items.ObjectGround()))
    )
    node = None
    for k in range(bodies):
        node = system.AddNode(
            items.NodeRigidBodyEP(referenceCoordinates=[k + 0.5, 0, 0, 1, 0, 0, 0])
        )
        body = system.AddObject(
            items.ObjectRigidBody(
                physicsMass=1.0, physicsInertia=[*INERTIA, 0, 0, 0], nodeNumber=node
            )
        )
        ends = [
            system.AddMarker(items.MarkerBodyRigid(bodyNumber=body, localPosition=[x, 0, 0]))
            for x in (-0.5, 0.5)
        ]
        free = 4 + k % 2
        axes = [int(n != free) for n in range(6)]
        system.AddObject(
            items.ObjectJointGeneric(markerNumbers=[before, ends[0]], constrainedAxes=axes)
        )
        system.AddLoad(
            items.Force(
                markerNumber=system.AddMarker(items.MarkerBodyPosition(bodyNumber=body)),
                loadVector=[0, 0, -9.81],
            )
        )
        before = ends[1]
    system.Assemble()
    place = exu.OutputVariableType.Position

    def run(steps: int) -> Array:
        settings = exu.SimulationSettings()
        settings.solutionSettings.writeSolutionToFile = False
        settings.displayComputationTime = settings.displayStatistics = False
        settings.linearSolverType = exu.LinearSolverType.EigenSparse
        clock = settings.timeIntegration
        clock.endTime, clock.numberOfSteps, clock.verboseMode = steps * STEP, steps, 0
        clock.generalizedAlpha.spectralRadius = RHO_INF
        clock.newton.useModifiedNewton = True
        system.SolveDynamic(
            settings, solverType=exu.DynamicSolverType.GeneralizedAlpha, showHints=False
        )
        return np.asarray(system.GetNodeOutput(node, place))

    return run


def bodies_on_nodes(steps: int = FEW) -> tuple[dict[str, float], float]:
    """Times [s] of ours, of Exudyn and of our start; distance of the last bodies [m]."""
    model = cd.compile(chain(), coordinates="absolute")
    theirs = exudyn_chain()

    def ours(count: int) -> cd.Trajectory:
        end, method = count * STEP, cd.GeneralizedAlpha(RHO_INF)
        return model.simulate((0, end), t_eval=(0, end), method=method, step=STEP)

    spent = least({"cardan": lambda: ours(steps), "Exudyn": lambda: theirs(steps)})
    spent["start"] = least({"start": lambda: ours(1)})["start"]
    motion = ours(steps)
    pose = np.asarray(model.pose(f"rod{BODIES - 1}", motion.q[-1]))
    return spent, float(np.abs(pose[:3, 3] + 0.5 * pose[:3, 0] - theirs(steps)).max())
