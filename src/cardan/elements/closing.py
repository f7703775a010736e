"""The closing conditions of a joint and their gradient with respect to its pose."""

from __future__ import annotations

from ..ir.derivative import forward
from ..ir.graph import ONE, ZERO
from ..ir.matrix import Matrix
from ..ir.rewrite import rebuild
from .joints.joint import Joint

# leaves that stand for the pose while it is differentiated
LEAVES = tuple(f"pose of a joint that closes a loop [{k}]" for k in range(12))


def closed(
    joint: Joint, rotation: Matrix, position: Matrix, data: dict[str, Matrix]
) -> tuple[Matrix, Matrix]:
    """Residuals of a joint at a pose of its frames, and their gradient along twists.

    Args:
        joint: The element.
        rotation, position: R_PC (3, 3), p_PC (3, 1) in P axes.
        data: Its quantities.

    Returns:
        g (m, 1) and J (m, 6): gdot = J V with V the velocity of C against P at the origin of C, in
        C axes, angular part first.
    """
    graph = rotation.graph
    leaves = [graph.atom(name) for name in LEAVES]
    r, p = Matrix(graph, 3, 3, leaves[:9]), Matrix(graph, 3, 1, leaves[9:])
    g = joint.closure(r, p, **data)
    columns = []
    for k in range(6):
        axis = Matrix(graph, 3, 1, [ONE if i == k % 3 else ZERO for i in range(3)])
        rotation_slope = r @ axis.skew if k < 3 else Matrix.zeros(graph, 3, 3)
        moved = r @ axis if k >= 3 else Matrix.zeros(graph, 3)
        seeds = dict(zip(leaves, (*rotation_slope.nodes, *moved.nodes), strict=True))
        columns.append(forward(graph, g.nodes, seeds))
    nodes = [*g.nodes, *(columns[k][i] for i in range(g.rows) for k in range(6))]
    at = dict(zip(leaves, (*rotation.nodes, *position.nodes), strict=True))
    rebuilt = rebuild(graph, nodes, at, into=graph)[1]
    return Matrix(graph, g.rows, 1, rebuilt[: g.rows]), Matrix(graph, g.rows, 6, rebuilt[g.rows :])
