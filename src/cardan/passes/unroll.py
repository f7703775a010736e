"""Unroll: positive definite solve nodes become straight-line factorizations.

A = Lᵀ D L from the last row up, in static order without pivoting; on the pattern of a tree it makes
no entry that A has not. The factor of one matrix is shared by all that solve with it.
"""

from __future__ import annotations

from collections.abc import Mapping

from ..ir.function import Function
from ..ir.graph import ZERO, Graph
from ..ir.matrix import Matrix
from ..ir.rewrite import rebuild_function
from ..ir.solve import ltl, substitute


def unroll(function: Function) -> Function:
    """The function without ``spd`` solve nodes; other kinds stay."""
    nodes = function.graph.nodes
    solutions: dict[int, list[int]] = {}
    factors: dict[tuple[int, ...], tuple[list[list[int]], list[int]]] = {}

    def rule(target: Graph, i: int, copies: Mapping[int, int]) -> int | None:
        node = nodes[i]
        if node[0] == "solve" and node[1] == "spd":
            solutions[i] = _expand(target, node[2], node[3], [copies[k] for k in node[4:]], factors)
            return ZERO
        if node[0] == "item" and node[1] in solutions:
            found = solutions[node[1]][node[2]]
            if i in function.graph.labels:
                target.label(found, *function.graph.labels[i])
            return found
        return None

    if not any(nodes[i][0] == "solve" for i in function.live()):
        return function
    return rebuild_function(function, rule)


def _expand(
    graph: Graph,
    n: int,
    m: int,
    entries: list[int],
    factors: dict[tuple[int, ...], tuple[list[list[int]], list[int]]],
) -> list[int]:
    """Solution of A X = B entry by entry; the factor of a known A is taken again."""
    a, b = tuple(entries[: n * n]), entries[n * n :]
    owner = graph.origin[0]
    if a not in factors:
        factors[a] = ltl(Matrix(graph, n, n, a))
        lower, inverse = factors[a]
        # names for the reader: rows of L and reciprocals of D
        for k in range(n):
            graph.label(inverse[k], owner, f"D_inverse_{k + 1}")
            for j in range(k):
                graph.label(lower[k][j], owner, f"L_{k + 1}_{j + 1}")
    columns = [substitute(*factors[a], graph, b[j::m]) for j in range(m)]
    return [columns[j][i] for i in range(n) for j in range(m)]
