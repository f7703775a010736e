"""Generalized speeds that the user chose, and what of a velocity belongs to each speed."""

from __future__ import annotations

from collections.abc import Sequence

from ...errors import DerivationError
from ...ir.derivative import forward, jacobian
from ...ir.function import live
from ...ir.graph import ONE, ZERO, Graph
from ...ir.matrix import Matrix
from ...ir.rewrite import rebuild
from ...ir.solve import solve


def speeds_of_joints(
    graph: Graph, nodes: Sequence[int], names: Sequence[str]
) -> tuple[Matrix, Matrix]:
    """Y (nu, nu) and the joint speeds (nu, 1) of Y(q) u_joint + Z(q) = u_chosen.

    Args:
        graph: Of the chosen speeds.
        nodes: Expressions in the joint speeds ``("var", "u", k)``, which are the chosen ones in
            what is returned.
        names: Theirs.

    Raises:
        DerivationError: one is not linear.
    """
    nu = len(nodes)
    slots = [graph.var("u", k) for k in range(nu)]
    y = [n for row in jacobian(graph, nodes, slots) for n in row]
    _, z = rebuild(graph, nodes, dict.fromkeys(slots, ZERO), into=graph)
    if set(live(graph, y)) & set(slots):
        raise DerivationError(
            "speeds: every chosen speed must be linear in the joint speeds; "
            f"one of {', '.join(names)} is not"
        )
    left = Matrix(graph, nu, nu, y)
    right = Matrix(graph, nu, 1, slots) - Matrix(graph, nu, 1, z)
    return left, solve("rank_revealing", left, right)


def by_speeds(x: Matrix, nu: int) -> dict[int, Matrix]:
    """Slot -> derivative of a velocity by the speed in it, where there is any."""
    columns = {}
    for slot in range(nu):
        dots = forward(x.graph, x.nodes, {x.graph.var("u", slot): ONE})
        column = Matrix(x.graph, x.rows, x.columns, dots)
        if not column.is_zero:
            columns[slot] = column
    return columns
