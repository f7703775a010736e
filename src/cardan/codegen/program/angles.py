"""Sines and cosines are computed several at once: vectors do many in the time of one.

Those of the inputs come first, all together; those of values that need other sines follow where
they stand, with what else stands beside them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from ...ir.graph import Graph
from .plan import Plan

OPERATORS = frozenset({"sin", "cos"})


def first(plan: Plan) -> list[int]:
    """The statements to begin with: sines and cosines of inputs, after what their angles need."""
    nodes, reads = plan.graph.nodes, plan.reads
    # what follows from no sine, no cosine and no linear system
    early: set[int] = set()
    angles = []
    for i, read in reads.items():
        if all(k in early or k not in reads for k in read):
            if nodes[i][0] in OPERATORS:
                angles.append(i)
            elif nodes[i][0] != "solve":
                early.add(i)
    needed: set[int] = set()
    waiting = [k for i in angles for k in reads[i]]
    while waiting:
        k = waiting.pop()
        if k in reads and k not in needed:
            needed.add(k)
            waiting.extend(reads[k])
    return [*(i for i in reads if i in needed), *angles]


def groups(
    graph: Graph, reads: Mapping[int, tuple[int, ...]], statements: Sequence[int]
) -> Iterator[list[int]]:
    """The statements in their order, sines and cosines that stand side by side together."""
    nodes = graph.nodes
    group: list[int] = []
    for i in statements:
        if nodes[i][0] in OPERATORS and not any(k in group for k in reads[i]):
            group.append(i)
            continue
        if group:
            yield group
            group = []
        if nodes[i][0] in OPERATORS:
            group = [i]
        else:
            yield [i]
    if group:
        yield group
