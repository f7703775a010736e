"""Choose between the two solutions of a loop where the user does not."""

from __future__ import annotations

import dataclasses
import math

from ...ir.function import Function, Output
from ...ir.interpreter import evaluate
from ...topology.system import System
from ..functions import blocks
from ..kinematics.kinematics import Kinematics


def with_branches(system: System) -> System:
    """The system with a branch for every loop: the one nearest to the initial values.

    Loops are taken in the order of their solution, at the default parameters.
    """
    for n, closure in enumerate(system.closures):
        signs = (closure.branch,) if closure.branch else (1, -1)
        # a leg may also be drawn out backwards, its motor turned to the other side
        sides = (closure.side,) if closure.side else (1, -1)
        tried = [_with(system, n, sign, side) for side in sides for sign in signs]
        system = min(tried, key=lambda s: _distance(s, n)) if len(tried) > 1 else tried[0]
    return system


def _with(system: System, n: int, sign: int, side: int) -> System:
    closures = list(system.closures)
    closures[n] = dataclasses.replace(closures[n], branch=sign, side=side)
    return dataclasses.replace(system, closures=tuple(closures))


def _distance(system: System, n: int) -> float:
    """Distance of the joints of loop n from their initial values; infinite if it is open."""
    k = Kinematics(system)
    solved = k.closures.position(n).q
    unknown = system.closures[n].unknown
    nodes = [node for i in unknown for node in solved[i].nodes]
    values = evaluate(
        Function("q", k.graph, (), (Output("q", (len(nodes),), tuple(nodes)),)),
        {
            "t": [0.0],
            "p": [p.value for p in system.parameters],
            "r": [i.default for i in system.inputs],
            "q": _initial(system),
            "u": [0.0] * system.nu,
        },
    )["q"]
    goals = [value for i in unknown for value in _reference_values(system, i)]
    angles = [c.unit == "rad" for i in unknown for c in system.joints[i].element.coordinates]
    total = 0.0
    for value, goal, angle in zip(values, goals, angles, strict=True):
        if not math.isfinite(value):
            return math.inf
        total += 2 - 2 * math.cos(value - goal) if angle else (value - goal) ** 2
    return total


def _reference_values(system: System, i: int) -> tuple[float, ...]:
    joint = system.joints[i]
    return joint.q0 or tuple(c.default for c in joint.element.coordinates)


def _initial(system: System) -> list[float]:
    """q at the initial values of the joints with slots."""
    values = [default for _, _, default in blocks.coordinates(system)]
    for joint in system.joints:
        if joint.q >= 0 and joint.q0 is not None:
            values[joint.q : joint.q + len(joint.q0)] = joint.q0
    return values
