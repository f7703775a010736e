"""Mass properties of the bodies of a system."""

from __future__ import annotations

from ...ir.arithmetic import Scalar
from ...ir.matrix import Matrix
from ...spatial.moments import Inertia, second_moment, turn_symmetric
from ..recursion.recursion_boundary import CELLS
from .kinematics import Kinematics


def of_body(k: Kinematics, i: int) -> Inertia:
    """Inertia of a body about its origin; depends on p alone where it has axes of its own.

    ``turned = R(turn) inertia R(turn)ᵀ`` where its axes do not turn with it.
    """
    k.graph.describe(of_body)
    body, name = k.system.bodies[i], k.owner(i)
    mass = Scalar(k.graph, k.resolve([body.mass])[0])
    k.graph.label(mass.node, name, "whole_mass")
    moment = k.vector(body.first_moment).label(name, "first_moment")
    tensor = k.matrix(3, 3, body.inertia).label(name, "origin_inertia", CELLS)
    turn = k.turns[i]
    if turn is None:
        return Inertia(mass, moment, tensor)
    with k.graph.made_by(name, "turned"):
        return Inertia(mass, turn @ moment, turn_symmetric(turn, tensor))


def second_moment_of_body(k: Kinematics, i: int) -> Matrix:
    """Second moment of a body about its origin; depends on p alone where it has axes of its own."""
    nodes = k.system.bodies[i].second_moment
    if nodes is None:
        second = second_moment(k.matrix(3, 3, k.system.bodies[i].inertia))
    else:
        second = k.matrix(3, 3, nodes)
    second.label(k.owner(i), "second_moment", CELLS)
    turn = k.turns[i]
    return second if turn is None else turn_symmetric(turn, second)
