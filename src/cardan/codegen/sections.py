"""The order of statements: whoever owns values has them computed together.

Statements are taken greedily: all that one owner can compute now, then the owner of the earliest
statement that waits. A sweep over a tree therefore reads body by body, as in the textbook.
"""

from __future__ import annotations

from heapq import heappop, heappush

from .plan import Owners, Plan


def arrange(plan: Plan, owners: Owners) -> list[tuple[str, list[int]]]:
    """Sections (title, statements) that respect what reads what."""
    readers: dict[int, list[int]] = {i: [] for i in plan.reads}
    waiting: dict[int, int] = {}
    for i, read in plan.reads.items():
        missing = 0
        for k in read:
            if k in readers:
                readers[k].append(i)
                missing += 1
        waiting[i] = missing

    # ready statements of each section by place, and of all sections
    node_at = _places(plan)
    place = {i: at for at, i in node_at.items()}
    home = {i: owners.of(i).section for i in plan.reads}
    ready: dict[str, list[int]] = {}
    anywhere: list[int] = []
    for i, missing in waiting.items():
        if not missing:
            heappush(ready.setdefault(home[i], []), place[i])
            heappush(anywhere, place[i])

    sections: list[tuple[str, list[int]]] = []
    done: set[int] = set()
    while anywhere:
        at = heappop(anywhere)
        if at in done:
            continue
        title, statements = home[node_at[at]], list[int]()
        queue = ready[title]
        while queue:
            at = heappop(queue)
            done.add(at)
            i = node_at[at]
            statements.append(i)
            for k in readers[i]:
                waiting[k] -= 1
                if not waiting[k]:
                    heappush(ready.setdefault(home[k], []), place[k])
                    heappush(anywhere, place[k])
        sections.append((title, statements))
    return sections


def _places(plan: Plan) -> dict[int, int]:
    """Place -> statement; sine and cosine of one angle stand side by side."""
    nodes = plan.graph.nodes
    node_at: dict[int, int] = {}
    angles: dict[int, int] = {}
    for number, i in enumerate(plan.reads):
        at = 2 * number
        if nodes[i][0] in ("sin", "cos"):
            first = angles.setdefault(nodes[i][1], at)
            at = first if first == at else first + 1
        node_at[at] = i
    return node_at
