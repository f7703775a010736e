"""Stage: separate what the parameters alone determine from what runs at every call."""

from __future__ import annotations

from .function import Function, Staged
from .ops import LEAVES


def stage(function: Function, block: str = "p") -> Staged:
    """Find the values of p that a call needs.

    Args:
        function: The function.
        block: The block that is prepared.
    """
    nodes, order = function.graph.nodes, function.live()
    # 0: a number, 1: of p only, 2: of anything else
    level = bytearray(len(nodes))
    results_used: set[int] = set()
    for i in order:
        node = nodes[i]
        op = node[0]
        if op in LEAVES:
            level[i] = 0 if op == "const" else 1 if node[1] == block and op == "var" else 2
            continue
        read = node[1:]
        if op == "solve":
            read = node[4:]
        elif op == "item":
            read = node[1:2]
        highest = 0
        for k in read:
            if level[k] > highest:
                highest = level[k]
        level[i] = highest
        # a call reads these: they are prepared
        if highest == 2:
            for k in read:
                if level[k] == 1:
                    results_used.add(k)
    results_used.update(i for i in function.roots if level[i] == 1)
    return Staged(function, tuple(sorted(results_used)), tuple(order))
