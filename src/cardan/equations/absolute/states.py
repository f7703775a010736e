"""States of the relative formulation as states of nodes and joints."""

from __future__ import annotations

from ...ir.function import Function, Output
from ...ir.matrix import Matrix
from ...spatial.exponential import quaternion_of
from ..blocks import blocks
from ..kinematics import Kinematics
from .scene import JOINT, Scene

READ = ("t", "q", "u", "r", "p")


def states(scene: Scene) -> Function:
    """[t, q, u, r, p] of the relative formulation -> [q, u] of all places.

    Nodes stand where the joints of the tree carry them; coordinates of joints stay what they are.
    """
    system, k = scene.system, Kinematics(scene.system)
    q, u = list[int](), list[int]()
    for kind, i in scene.places:
        if kind == JOINT or i in scene.nodal:
            q += k.coordinates[i].nodes
            u += k.speeds[i].nodes
            continue
        with k.graph.made_by(system.bodies[i].name, "state"):
            R = k.ground_rotation[i]
            q += Matrix.vstack(quaternion_of(R), k.ground_position[i]).nodes
            u += Matrix.vstack(k.omega[i], R @ k.v[i]).nodes
    listed = blocks(system)
    results = (Output("q", (len(q),), tuple(q)), Output("u", (len(u),), tuple(u)))
    return Function(
        "states",
        k.graph,
        tuple(listed[letter] for letter in READ),
        results,
        tuple(body.name for body in system.bodies),
        "states of the nodes and joints by joint coordinates",
    )
