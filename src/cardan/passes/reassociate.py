"""Reassociate: sums in the order in which their terms become known.

A chain of additions waits for its last term in every step. Terms are combined two by two, those
known first coming first (Huffman's tree of the depths), and parameters with parameters. Only sums
whose partial sums nobody else reads are touched, so the number of operations never rises.

Not run by default. Measured on serial arms with gcc -O2 (clang): articulated bodies gain 18 % (4 %)
at 7 joints and 13 % (5 %) at 14, but lose 12 % (10 %) at 30, where partial sums no longer fit into
registers; composite bodies and Newton-Euler stay within 4 %. The pass takes three times as long as
all others together.

Source: Huffman, A Method for the Construction of Minimum-Redundancy Codes, Proc. IRE 40 (1952).
"""

from __future__ import annotations

from collections.abc import Mapping
from heapq import heapify, heappop, heapreplace

from ..ir.function import Function, operands
from ..ir.graph import Graph
from ..ir.ops import LEAVES
from ..ir.rewrite import rebuild_function

# cycles until a result can be read; operators not listed take long
LATENCY = {"add": 4.0, "sub": 4.0, "mul": 4.0, "neg": 0.0, "div": 13.0, "sqrt": 18.0, "item": 0.0}
LONG = 40.0
SUMS = frozenset({"add", "sub", "neg"})


def reassociate(function: Function, block: str = "p") -> Function:
    """The function with its single-use sums reordered; entries of ``block`` are known first."""
    nodes = function.graph.nodes
    inner = _inner(function)
    known: dict[int, float] = {}

    def rule(target: Graph, i: int, copies: Mapping[int, int]) -> int | None:
        if i in inner:
            return 0
        if nodes[i][0] not in SUMS or inner.isdisjoint(nodes[i][1:]):
            return None
        terms = _terms(function.graph, i, inner)
        ready = [
            (_known(target, copies[k], known, block), n, copies[k], s)
            for n, (k, s) in enumerate(terms)
        ]
        return _combine(target, ready, known, block)

    return rebuild_function(function, rule) if inner else function


def _inner(function: Function) -> set[int]:
    """Sums that one other sum reads and nothing else."""
    nodes = function.graph.nodes
    reader: dict[int, int] = dict.fromkeys(function.roots, -1)
    for i in function.live():
        for k in operands(nodes[i]):
            reader[k] = -1 if k in reader else i
    return {k for k, i in reader.items() if i >= 0 and nodes[k][0] in SUMS and nodes[i][0] in SUMS}


def _terms(graph: Graph, i: int, inner: set[int]) -> list[tuple[int, int]]:
    """(term, sign) of the sum that ends in node i, from left to right."""
    terms: list[tuple[int, int]] = []
    stack = [(i, 1)]
    while stack:
        k, sign = stack.pop()
        if k != i and k not in inner:
            terms.append((k, sign))
            continue
        op, *read = graph.nodes[k]
        if op == "neg":
            stack.append((read[0], -sign))
        else:
            stack.append((read[1], -sign if op == "sub" else sign))
            stack.append((read[0], sign))
    return terms


def _known(graph: Graph, i: int, known: dict[int, float], block: str) -> float:
    """Cycles after which a node is known; parameters were known before the call."""
    stack = [i]
    while stack:
        k = stack[-1]
        if k in known:
            stack.pop()
            continue
        node = graph.nodes[k]
        if node[0] in LEAVES:
            known[k] = -1.0 if node[0] == "const" or node[1] == block else 0.0
            continue
        read = operands(node)
        waiting = [x for x in read if x not in known]
        if waiting:
            stack.extend(waiting)
            continue
        last = max(known[x] for x in read)
        known[k] = last if last < 0 else last + LATENCY.get(node[0], LONG)
    return known[i]


def _combine(
    graph: Graph, ready: list[tuple[float, int, int, int]], known: dict[int, float], block: str
) -> int:
    """The sum of (known after, number, node, sign), the two known first added first."""
    heapify(ready)
    number = len(ready)
    while len(ready) > 1:
        _, _, a, sign = heappop(ready)
        _, _, b, other = ready[0]
        if sign != other:
            # a difference is positive: the term with the minus goes right
            total = graph.sub(a, b) if sign > 0 else graph.sub(b, a)
            sign = 1
        else:
            total = graph.add(a, b)
        heapreplace(ready, (_known(graph, total, known, block), number, total, sign))
        number += 1
    _, _, node, sign = ready[0]
    return node if sign > 0 else graph.neg(node)
