"""The order of statements: whoever owns values has them computed together.

Statements are taken greedily: all that one owner can compute now, within a window, then the owner
of the earliest statement that waits. A sweep over a tree reads body by body, as in the textbook.
"""

from __future__ import annotations

from heapq import heapify, heappop, heappush

from ...ir.owners import SHARED
from . import angles
from .plan import Plan

Sections = list[tuple[str, list[int]]]

# how many statements one may overtake: values made long before they are read cost memory traffic.
# Measured on the mass matrix of 100 bodies: without a bound twice the run and compile time
WINDOW = 1000


def arrange(plan: Plan) -> Sections:
    """Sections (title, statements) that respect what reads what."""
    statements = _side_by_side(plan)
    number = {i: n for n, i in enumerate(statements)}
    home = [plan.owners[i].section for i in statements]
    readers: list[list[int]] = [[] for _ in statements]
    waiting = [0] * len(statements)
    for n, i in enumerate(statements):
        for k in plan.reads[i]:
            if k in number:
                readers[number[k]].append(n)
                waiting[n] += 1

    sections: Sections = []
    done = bytearray(len(statements) + 1)
    begin = angles.first(plan)
    if begin:
        begun = {home[number[i]] for i in begin}
        sections.append((begun.pop() if len(begun) == 1 else SHARED, begin))
        for i in begin:
            done[number[i]] = 1
        for i in begin:
            for k in readers[number[i]]:
                waiting[k] -= 1

    # ready statements of every section, and of all of them
    anywhere = [n for n, missing in enumerate(waiting) if not missing and not done[n]]
    ready: dict[str, list[int]] = {title: [] for title in home}
    for n in anywhere:
        ready[home[n]].append(n)
    for queue in ready.values():
        heapify(queue)

    first = 0
    while anywhere:
        n = heappop(anywhere)
        if done[n]:
            continue
        title, taken = home[n], list[int]()
        queue = ready[title]
        while queue and queue[0] <= first + WINDOW:
            n = heappop(queue)
            done[n] = 1
            taken.append(statements[n])
            while done[first]:
                first += 1
            for k in readers[n]:
                waiting[k] -= 1
                if not waiting[k]:
                    heappush(ready[home[k]], k)
                    heappush(anywhere, k)
        sections.append((title, taken))
    return sections


def _side_by_side(plan: Plan) -> list[int]:
    """The statements; sine and cosine of one angle stand side by side."""
    nodes = plan.graph.nodes
    partner: dict[int, int] = {}
    first: dict[int, int] = {}
    for i in plan.reads:
        if nodes[i][0] in ("sin", "cos"):
            angle = nodes[i][1]
            if angle in first:
                partner[first[angle]] = i
            else:
                first[angle] = i
    moved = set(partner.values())
    order = []
    for i in plan.reads:
        if i not in moved:
            order.append(i)
        if i in partner:
            order.append(partner[i])
    return order
