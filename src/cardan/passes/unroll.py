"""Unroll: positive definite solve nodes become straight-line factorizations.

Systems of many rows with many right-hand sides stay: a kernel takes eight columns at once.

A = Lᵀ D L from the last row up, in static order without pivoting; on the pattern of a tree it makes
no entry that A has not. The factor of one matrix is shared by all that solve with it.
"""

from __future__ import annotations

from collections.abc import Mapping

from ..ir.function import Function
from ..ir.graph import ZERO, Graph
from ..ir.rewrite import rebuild_function
from ..ir.solve import Factor, unrolled

# rows² x columns that would take minutes to compile, where there are several columns
LARGE, SEVERAL = 250_000, 8


def straight(kind: str, n: int, m: int) -> bool:
    """Whether a system with n rows and m columns is written out."""
    return kind == "spd" and (m < SEVERAL or n * n * m < LARGE)


def unroll(function: Function) -> Function:
    """The function without ``spd`` solve nodes that are small; other kinds stay."""
    nodes = function.graph.nodes
    solutions: dict[int, list[int]] = {}
    factors: dict[tuple[int, ...], Factor] = {}

    def rule(target: Graph, i: int, copies: Mapping[int, int]) -> int | None:
        node = nodes[i]
        if node[0] == "solve" and straight(*node[1:4]):
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
