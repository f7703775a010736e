"""The slider-crank by Exudyn: its rod in a floating frame with the same modes, or of its cables.

Source: A. Zwoelfer, J. Gerstmayr, The nodal-based floating frame of reference formulation with
modal reduction, Acta Mechanica 232 (2021); J. Gerstmayr, Exudyn - a C++-based Python package for
flexible multibody systems, Multibody System Dynamics 60 (2024).
"""

from __future__ import annotations

import time
from collections.abc import Callable
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import eigh

from benchmarks import superelement_problem as problem
from benchmarks.superelement_problem import CRANK, LENGTH, SIDE, SLIDER, SPEED

Array = NDArray[np.float64]
# of the rigid rod as it sets off: the slider stands still
TURNING = -SPEED * CRANK / LENGTH
RIGID = 6


def _system() -> Any:
    import exudyn as exu

    exu.config.printToConsole = False
    return exu.SystemContainer().AddSystem()


def _basis(modes: int) -> Array:
    """Shapes (rows, n) of the record without rigid motions: its free modes."""
    record = problem.rod(modes)[1]
    _, shapes = eigh(record.K, record.M)
    basis: Array = record.basis @ shapes[:, RIGID:]
    return basis


def floating_frame(modes: int) -> tuple[Any, list[Any]]:
    """A rod in a floating frame of reference, and sensors of its middle."""
    import exudyn as exu
    from exudyn import itemInterface as items
    from exudyn.FEM import FEMinterface, ObjectFFRFreducedOrderInterface

    mesh, _, nodes = problem.rod(modes)
    M, K = problem.matrices()
    fem = FEMinterface()
    # pins are in the middle of the ends
    fem.nodes = {"Position": mesh.points - [0, SIDE / 2, SIDE / 2]}
    fem.massMatrix, fem.stiffnessMatrix = M.tocsr(), K.tocsr()
    fem.modeBasis = {"matrix": _basis(modes), "type": "NormalModes"}
    system = _system()
    ground = system.AddObject(items.ObjectGround())
    made = ObjectFFRFreducedOrderInterface(fem).AddObjectFFRFreducedOrder(
        system, positionRef=[CRANK, 0, 0], initialVelocity=[0, CRANK * SPEED, 0],
        initialAngularVelocity=[0, 0, TURNING],
        stiffnessProportionalDamping=problem.DAMPING,
    )  # fmt: skip
    rod = made["oFFRFreducedOrder"]
    ends = [
        system.AddMarker(
            items.MarkerSuperElementRigid(
                bodyNumber=rod,
                meshNodeNumbers=nodes[name].tolist(),
                weightingFactors=[1 / len(nodes[name])] * len(nodes[name]),
            )
        )
        for name in ("pin", "slider")
    ]
    turning = system.AddNode(
        items.NodeRigidBodyEP(
            referenceCoordinates=[0, 0, 0, 1, 0, 0, 0],
            initialVelocities=[0, 0, 0, 0, 0, 0, SPEED / 2],
        )
    )
    inertia = [problem.INERTIA] * 3 + [0] * 3
    crank = system.AddObject(
        items.ObjectRigidBody(physicsMass=1.0, physicsInertia=inertia, nodeNumber=turning)
    )
    hinge = [1, 1, 1, 1, 1, 0]
    for pair in (
        [
            system.AddMarker(items.MarkerBodyRigid(bodyNumber=ground)),
            system.AddMarker(items.MarkerBodyRigid(bodyNumber=crank)),
        ],
        [
            system.AddMarker(items.MarkerBodyRigid(bodyNumber=crank, localPosition=[CRANK, 0, 0])),
            ends[0],
        ],
    ):
        system.AddObject(items.GenericJoint(markerNumbers=pair, constrainedAxes=hinge))
    place = system.AddNode(items.NodePoint(referenceCoordinates=[CRANK + LENGTH, 0, 0]))
    system.AddObject(items.MassPoint(physicsMass=SLIDER, nodeNumber=place))
    mass = system.AddMarker(items.MarkerNodePosition(nodeNumber=place))
    system.AddObject(items.SphericalJoint(markerNumbers=[mass, ends[1]]))
    _on_line(system, place)
    position = exu.OutputVariableType.Position
    sensors = [
        system.AddSensor(
            items.SensorSuperElement(
                bodyNumber=rod, meshNodeNumber=int(node), storeInternal=True,
                outputVariableType=position,
            )
        )
        for node in nodes["middle"]
    ]  # fmt: skip
    return system, sensors


def _on_line(system: Any, node: Any) -> None:
    """The slider keeps y = 0."""
    from exudyn import itemInterface as items

    ground = system.AddNode(items.NodePointGround())
    still = system.AddMarker(items.MarkerNodeCoordinate(nodeNumber=ground, coordinate=0))
    moving = system.AddMarker(items.MarkerNodeCoordinate(nodeNumber=node, coordinate=1))
    system.AddObject(items.CoordinateConstraint(markerNumbers=[still, moving]))


def cable(elements: int) -> tuple[Any, list[Any]]:
    """The same of planar cables (absolute nodal coordinates), an even number of them."""
    import exudyn as exu
    from exudyn import itemInterface as items

    system, area = _system(), SIDE**2
    nodes = [
        system.AddNode(
            items.NodePoint2DSlope1(
                referenceCoordinates=[CRANK + x, 0, 1, 0],
                initialVelocities=[0, CRANK * SPEED + TURNING * x, 0, TURNING],
            )
        )
        for x in np.linspace(0, LENGTH, elements + 1)
    ]
    young, density = problem.ALUMINIUM["E"], problem.ALUMINIUM["rho"]
    for pair in pairwise(nodes):
        system.AddObject(
            items.ObjectANCFCable2D(
                nodeNumbers=list(pair),
                length=LENGTH / elements,
                massPerLength=density * area,
                bendingStiffness=young * SIDE**4 / 12,
                axialStiffness=young * area,
                bendingDamping=problem.DAMPING * young * SIDE**4 / 12,
                axialDamping=problem.DAMPING * young * area,
            )
        )
    ground = system.AddObject(items.ObjectGround())
    turning = system.AddNode(
        items.NodeRigidBody2D(referenceCoordinates=[0, 0, 0], initialVelocities=[0, 0, SPEED])
    )
    crank = system.AddObject(
        items.ObjectRigidBody2D(physicsMass=1.0, physicsInertia=problem.INERTIA, nodeNumber=turning)
    )
    place = system.AddNode(items.NodePoint2D(referenceCoordinates=[CRANK + LENGTH, 0]))
    system.AddObject(items.ObjectMassPoint2D(physicsMass=SLIDER, nodeNumber=place))
    for pair in (
        [
            system.AddMarker(items.MarkerBodyPosition(bodyNumber=ground)),
            system.AddMarker(items.MarkerBodyPosition(bodyNumber=crank)),
        ],
        [
            system.AddMarker(
                items.MarkerBodyPosition(bodyNumber=crank, localPosition=[CRANK, 0, 0])
            ),
            system.AddMarker(items.MarkerNodePosition(nodeNumber=nodes[0])),
        ],
        [
            system.AddMarker(items.MarkerNodePosition(nodeNumber=nodes[-1])),
            system.AddMarker(items.MarkerNodePosition(nodeNumber=place)),
        ],
    ):
        system.AddObject(items.ObjectJointRevolute2D(markerNumbers=pair))
    _on_line(system, place)
    sensor = items.SensorNode(
        nodeNumber=nodes[elements // 2], storeInternal=True,
        outputVariableType=exu.OutputVariableType.Position,
    )  # fmt: skip
    return system, [system.AddSensor(sensor)]


def run(
    build: Callable[[int], tuple[Any, list[Any]]],
    size: int,
    steps: int,
    sparse: bool = False,
    whole: bool = True,
) -> tuple[float, Array]:
    """Time of a call [s], and where the middle is at the samples of the motion (SAMPLES, 2).

    Args:
        build, size: Of the rod: modes or elements.
        steps: Of a turn.
        sparse: Which of its solvers.
        whole: A turn, or one step of it.
    """
    import exudyn as exu

    system, sensors = build(size)
    system.Assemble()
    settings = exu.SimulationSettings()
    settings.solution.file.write = False
    settings.solution.sensors.writePeriod = problem.TURN / problem.SAMPLES
    settings.show.computationTime = False
    solvers = exu.LinearSolverType
    settings.linearSolver.solverType = solvers.EigenSparse if sparse else solvers.EXUdense
    clock = settings.timeIntegration
    clock.endTime, clock.numberOfSteps, clock.verboseMode = problem.TURN, steps, 0
    if not whole:
        clock.endTime, clock.numberOfSteps = problem.TURN / steps, 1
    clock.generalizedAlpha.spectralRadius = problem.RHO_INF
    clock.newton.useModifiedNewton = True
    start = time.thread_time()
    system.SolveDynamic(
        settings, solverType=exu.DynamicSolverType.GeneralizedAlpha, showHints=False
    )
    taken = time.thread_time() - start
    rows = [np.array(system.GetSensorStoredData(s))[-problem.SAMPLES :, 1:3] for s in sensors]
    return taken, np.asarray(np.mean(rows, axis=0))
