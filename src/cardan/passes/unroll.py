"""Unroll: positive definite solve nodes become straight-line factorizations.

A = Lᵀ D L from the last row up, in static order without pivoting; on the pattern of a tree it makes
no entry that A has not. The factor of one matrix is shared by all that solve with it.
"""

from __future__ import annotations

from collections.abc import Mapping

from ..ir.function import Function
from ..ir.graph import ZERO, Graph
from ..ir.rewrite import rebuild_function
from ..ir.solve import Factor, unrolled


def unroll(function: Function) -> Function:
    """The function without ``spd`` solve nodes; other kinds stay."""
    nodes = function.graph.nodes
    solutions: dict[int, list[int]] = {}
    factors: dict[tuple[int, ...], Factor] = {}

    def rule(target: Graph, i: int, copies: Mapping[int, int]) -> int | None:
        node = nodes[i]
        if node[0] == "solve" and node[1] == "spd":
            entries = [copies[k] for k in node[4:]]
            solutions[i] = unrolled(target, node[2], node[3], entries, factors)
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
