"""States of the relative formulation as states of nodes and joints."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ...ir.arithmetic import atan2
from ...ir.function import Function, Output
from ...ir.matrix import Matrix
from ...spatial.exponential import quaternion_of
from ...spatial.plane import Plane
from ..constraints.constraints import Constraints
from ..functions.blocks import blocks
from ..kinematics.kinematics import Kinematics
from .nodal_scene import JOINT, NODE, Scene

ASSEMBLY_SIGNS = "assembly_signs "  # before the name of the joint
READ = ("t", "q", "u", "r", "p")


def states(
    scene: Scene, planes: Mapping[int, Plane] | None = None, tree_ends: Sequence[int] = ()
) -> Function:
    """[t, q, u, r, p] of the relative formulation -> [q, u] of all places.

    Args:
        scene: The scene.
        planes: By body those nodes that are told by x, y and angle in a plane.
        tree_ends: Bodies of rigid trees that beams end at: ``ends_q`` and ``ends_u`` are their
            poses (n, 7) and speeds (n, 6) as of nodes.

    Nodes stand where the joints of the tree carry them; coordinates of joints stay what they are.
    ``assembly_signs <joint>`` of a joint that closes a loop are positive where none of its axes is
    reversed.
    """
    system, k = scene.system, Kinematics(scene.system)
    q, u = list[int](), list[int]()
    for kind, i in scene.places:
        plane = (planes or {}).get(i) if kind == NODE else None
        if plane is not None:
            with k.graph.made_by(system.bodies[i].name, "state"):
                q_nodes, u_nodes = _in_plane(plane, k, i)
            q += q_nodes
            u += u_nodes
            continue
        if kind == JOINT or i in scene.nodal:
            q += k.coordinates[i].nodes
            u += k.speeds[i].nodes
            continue
        with k.graph.made_by(system.bodies[i].name, "state"):
            pose, speeds = _in_space(k, i)
            q += pose
            u += speeds
    listed = blocks(system)
    results = [Output("q", (len(q),), tuple(q)), Output("u", (len(u),), tuple(u))]
    if tree_ends:
        pairs = [_in_space(k, i) for i in tree_ends]
        poses, speeds = (tuple(node for pair in pairs for node in pair[n]) for n in range(2))
        results.append(Output("ends_q", (len(tree_ends), 7), poses))
        results.append(Output("ends_u", (len(tree_ends), 6), speeds))
    if system.cuts:
        owners, signs = Constraints(k).assembly_signs
        for owner in dict.fromkeys(owners):
            sign_nodes = tuple(
                n for name, n in zip(owners, signs.nodes, strict=True) if name == owner
            )
            results.append(Output(f"{ASSEMBLY_SIGNS}{owner}", (len(sign_nodes),), sign_nodes))
    return Function(
        "states",
        k.graph,
        tuple(listed[letter] for letter in READ),
        tuple(results),
        tuple(body.name for body in system.bodies),
        "states of the nodes and joints by joint coordinates",
    )


def _in_space(k: Kinematics, i: int) -> tuple[tuple[int, ...], tuple[int, ...]]:
    """Unit quaternion and position of a body, angular velocity in its axes and velocity."""
    R = k.ground_rotation[i]
    pose = Matrix.vstack(quaternion_of(R), k.ground_position[i])
    return pose.nodes, Matrix.vstack(k.omega[i], R @ k.v[i]).nodes


def _in_plane(plane: Plane, k: Kinematics, i: int) -> tuple[tuple[int, ...], tuple[int, ...]]:
    """x, y, angle of a body and their rates."""
    R, p = k.ground_rotation[i], k.ground_position[i]
    to_space = Matrix.of(k.graph, plane.to_space.tolist())
    rotation = R @ Matrix.of(k.graph, plane.rotation.T.tolist())
    a, b = plane.along
    angle = atan2(rotation[b, a], rotation[a, a])
    rates = to_space.T @ Matrix.vstack(k.omega[i], R @ k.v[i])
    return (p[a].node, p[b].node, angle.node), rates.nodes
