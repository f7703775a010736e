"""Beams of Exudyn hung at one end: spatial and planar geometrically exact ones, and its cable.

Source: J. Gerstmayr, Exudyn - a C++-based Python package for flexible multibody systems, Multibody
System Dynamics 60, 2024.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.flexible_problem import END, GRAVITY, LENGTH, RHO_INF, SAMPLES, SECTION

Array = NDArray[np.float64]
Built = tuple[Any, Any]


def _system() -> Any:
    import exudyn as exu

    exu.config.printToConsole = False
    return exu.SystemContainer().AddSystem()


def _filled(system: Any, nodes: list[Any], element: Callable[[list[Any]], Any], down: Any) -> None:
    """Elements between neighbors, each with its weight."""
    from exudyn import itemInterface as items

    for pair in pairwise(nodes):
        beam = system.AddObject(element(list(pair)))
        marker = system.AddMarker(items.MarkerBodyMass(bodyNumber=beam))
        load = [GRAVITY * part for part in down]
        system.AddLoad(items.LoadMassProportional(markerNumber=marker, loadVector=load))


def spatial(n: int) -> Built:
    """Its three-dimensional geometrically exact beam on nodes of a Lie group."""
    import exudyn as exu
    from exudyn import itemInterface as items

    system, section = _system(), exu.BeamSection()
    s = SECTION
    section.massPerLength = s["rhoA"]
    section.inertia = np.diag([2 * s["rhoI"], s["rhoI"], s["rhoI"]]).tolist()
    section.stiffnessMatrix = np.diag(
        [s["EA"], s["GA"], s["GA"], s["GJ"], s["EI"], s["EI"]]
    ).tolist()
    nodes = [
        system.AddNode(items.NodeRigidBodyRotVecLG(referenceCoordinates=[x, 0, 0, 0, 0, 0]))
        for x in np.linspace(0, LENGTH, n + 1)
    ]

    def element(pair: list[Any]) -> Any:
        return items.ObjectBeamGeometricallyExact(
            nodeNumbers=pair, length=LENGTH / n, sectionData=section
        )

    _filled(system, nodes, element, (0, 0, -1))
    ground = system.AddObject(items.ObjectGround())
    ends = [
        system.AddMarker(items.MarkerBodyPosition(bodyNumber=ground)),
        system.AddMarker(items.MarkerNodePosition(nodeNumber=nodes[0])),
    ]
    system.AddObject(items.ObjectJointSpherical(markerNumbers=ends))
    return system, nodes[-1]


def _pinned(system: Any, node: Any, coordinates: int = 2) -> None:
    from exudyn import itemInterface as items

    ground = system.AddNode(items.NodePointGround())
    still = system.AddMarker(items.MarkerNodeCoordinate(nodeNumber=ground, coordinate=0))
    for k in range(coordinates):
        moving = system.AddMarker(items.MarkerNodeCoordinate(nodeNumber=node, coordinate=k))
        system.AddObject(items.CoordinateConstraint(markerNumbers=[still, moving]))


def planar(n: int) -> Built:
    """Its planar geometrically exact beam."""
    from exudyn import itemInterface as items

    system, s = _system(), SECTION
    nodes = [
        system.AddNode(items.NodeRigidBody2D(referenceCoordinates=[x, 0, 0]))
        for x in np.linspace(0, LENGTH, n + 1)
    ]

    def element(pair: list[Any]) -> Any:
        return items.ObjectBeamGeometricallyExact2D(
            nodeNumbers=pair,
            length=LENGTH / n,
            massPerLength=s["rhoA"],
            crossSectionInertia=s["rhoI"],
            bendingStiffness=s["EI"],
            axialStiffness=s["EA"],
            shearStiffness=s["GA"],
        )

    _filled(system, nodes, element, (0, -1, 0))
    _pinned(system, nodes[0])
    return system, nodes[-1]


def cable(n: int) -> Built:
    """Its planar cable (absolute nodal coordinates): neither shear nor rotary inertia."""
    from exudyn import itemInterface as items

    system, s = _system(), SECTION
    nodes = [
        system.AddNode(items.NodePoint2DSlope1(referenceCoordinates=[x, 0, 1, 0]))
        for x in np.linspace(0, LENGTH, n + 1)
    ]

    def element(pair: list[Any]) -> Any:
        return items.ObjectANCFCable2D(
            nodeNumbers=pair,
            length=LENGTH / n,
            massPerLength=s["rhoA"],
            bendingStiffness=s["EI"],
            axialStiffness=s["EA"],
        )

    _filled(system, nodes, element, (0, -1, 0))
    _pinned(system, nodes[0])
    return system, nodes[-1]


def spatial_cable(n: int) -> Built:
    """Its three-dimensional cable (absolute nodal coordinates): nor does it resist twist."""
    from exudyn import itemInterface as items

    system, s = _system(), SECTION
    nodes = [
        system.AddNode(items.NodePointSlope1(referenceCoordinates=[x, 0, 0, 1, 0, 0]))
        for x in np.linspace(0, LENGTH, n + 1)
    ]

    def element(pair: list[Any]) -> Any:
        return items.ObjectANCFCable(
            nodeNumbers=pair,
            length=LENGTH / n,
            massPerLength=s["rhoA"],
            bendingStiffness=s["EI"],
            axialStiffness=s["EA"],
        )

    _filled(system, nodes, element, (0, 0, -1))
    _pinned(system, nodes[0], 3)
    return system, nodes[-1]


def run(build: Callable[[int], Built], n: int, steps: int, end: float = END) -> tuple[float, Array]:
    """Time of a step [s] and where the tip is at the samples of the motion (SAMPLES, 2) [m]."""
    import exudyn as exu
    from exudyn import itemInterface as items

    system, tip = build(n)
    place = exu.OutputVariableType.Position
    sensor = system.AddSensor(
        items.SensorNode(nodeNumber=tip, storeInternal=True, outputVariableType=place)
    )
    system.Assemble()
    settings = exu.SimulationSettings()
    settings.solution.file.write = False
    settings.solution.sensors.writePeriod = end / SAMPLES
    settings.show.computationTime = False
    settings.linearSolver.solverType = exu.LinearSolverType.EigenSparse
    clock = settings.timeIntegration
    clock.endTime, clock.numberOfSteps, clock.verboseMode = end, steps, 0
    clock.generalizedAlpha.spectralRadius = RHO_INF
    clock.newton.useModifiedNewton = True
    start = time.thread_time()
    system.SolveDynamic(
        settings, solverType=exu.DynamicSolverType.GeneralizedAlpha, showHints=False
    )
    taken = time.thread_time() - start
    history = np.array(system.GetSensorStoredData(sensor))[:, 1:]
    found = history[-SAMPLES:]
    height = 2 if build in (spatial, spatial_cable) else 1
    return taken / steps, found[:, [0, height]]


BEAMS = {
    "geometrically exact": spatial,
    "planar": planar,
    "cable": cable,
    "spatial cable": spatial_cable,
}
