"""Schedule: the order in which statements stand."""

from __future__ import annotations

from dataclasses import replace

from ..ir.function import Staged, operands


def schedule(staged: Staged) -> Staged:
    """Order the nodes depth-first from the results: values are made shortly before their use."""
    nodes = staged.function.graph.nodes
    order: list[int] = []
    done = bytearray(len(nodes))
    for root in staged.function.roots:
        stack = [root]
        while stack:
            i = stack[-1]
            if done[i]:
                stack.pop()
                continue
            waiting = [k for k in operands(nodes[i]) if not done[k]]
            if waiting:
                waiting.reverse()
                stack.extend(waiting)
            else:
                done[i] = 1
                order.append(i)
                stack.pop()
    return replace(staged, order=tuple(order))
