"""Unroll: positive definite solve nodes become straight-line factorizations.

Systems of many rows with many right-hand sides stay: a kernel takes eight columns at once.

A = Lᵀ D L from the last row up, in static order without pivoting; on the pattern of a tree it makes
no entry that A has not. The factor of one matrix is shared by all that solve with it.
"""

from __future__ import annotations

from collections.abc import Mapping

from ..ir.function import Function
from ..ir.graph import ZERO, Graph
from ..ir.rewrite import rebuild_function, with_roots
from ..ir.solve import Factor, unrolled

# rows² x columns that would take minutes to compile, where there are several columns
LARGE, SEVERAL = 250_000, 8


def straight(kind: str, n: int, m: int) -> bool:
    """True when a system with n rows and m columns is written out."""
    return kind == "spd" and (m < SEVERAL or n * n * m < LARGE)


def unroll(function: Function) -> Function:
    """The function without ``spd`` solve nodes that are small; other kinds stay."""
    nodes, live = function.graph.nodes, function.live()
    solves = [i for i in live if nodes[i][0] == "solve" and straight(*nodes[i][1:4])]
    if not solves:
        return function
    # solutions that nothing but results read are written behind what is there
    if all(nodes[i][0] == "item" for i in live if i > solves[0]):
        return _appended(function, solves[0])
    return _rebuilt(function, set(solves))


def _appended(function: Function, i: int) -> Function:
    """The function with its only solve node written out at the end of a copy of its graph."""
    graph, node = function.graph.fork(), function.graph.nodes[i]
    with graph.made_by(*graph.origins[i]):
        solution = unrolled(graph, node[2], node[3], node[4:], {}, graph.systems.get(i))
    roots = []
    for root in function.roots:
        entry = graph.nodes[root]
        if entry[:2] == ("item", i):
            root, item = solution[entry[2]], root
            graph.adopt(root, graph, item)
        roots.append(root)
    return with_roots(function, graph, roots)


def _rebuilt(function: Function, solves: set[int]) -> Function:
    """The function in a new graph, with the solve nodes written out where they stand."""
    nodes = function.graph.nodes
    solutions: dict[int, list[int]] = {}
    factors: dict[tuple[int, ...], Factor] = {}

    def rule(target: Graph, i: int, copies: Mapping[int, int]) -> int | None:
        node = nodes[i]
        if i in solves:
            entries = [copies[k] for k in node[4:]]
            names = function.graph.systems.get(i)
            solutions[i] = unrolled(target, node[2], node[3], entries, factors, names)
            return ZERO
        if node[0] == "item" and node[1] in solutions:
            solved = solutions[node[1]][node[2]]
            target.adopt(solved, function.graph, i)
            return solved
        return None

    return rebuild_function(function, rule)
