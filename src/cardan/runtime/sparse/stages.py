"""Groups of blocks of a sparse matrix that are eliminated at once.

The diagonal block of a multiplier is zero, so a multiplier is eliminated together with a node that
its rows constrain: pivots are then found inside the group. Nodes are eliminated one after the
other in an order with little fill.

Constraint rows that determine all motion of a node relative to its parent are eliminated with
that node, one set of rows per node, like a joint with its child body in a tree. Node and rows
together are regular even if the node has no mass. All other rows close loops. They wait for the
node at which the paths from their nodes toward the ground meet, because the motion of the whole
loop is then known. Coordinates of joints go with whichever of their nodes is eliminated last, and
not before the rows that constrain them.
"""

from __future__ import annotations

from collections.abc import Mapping
from heapq import heapify, heappop, heappush

import numpy as np

from ...arrays import Booleans
from .ordering import elimination, graph, ranks
from .pattern import Longs, Pattern

Bools = Booleans
CLOSING = 3  # turn of rows that close loops


def elimination_groups(pattern: Pattern) -> tuple[Longs, Longs, Bools]:
    """The order of elimination.

    Returns:
        order: The blocks in order of elimination (nb,).
        vertex: Of each of them, which set it belongs to, ascending from 0 (nb,).
        closing: Which blocks are rows that close loops, and may be redundant (nb,).
    """
    stage, turn = _both(pattern)
    order = np.lexsort((np.arange(len(stage)), turn, stage))
    vertex = np.unique(stage[order], return_inverse=True)[1].astype(np.int64)
    return order, vertex, turn == CLOSING


def stages(pattern: Pattern) -> Longs:
    """When each block is eliminated; those of one number together (nb,)."""
    return _both(pattern)[0]


def _both(pattern: Pattern) -> tuple[Longs, Longs]:
    """When each block is eliminated, and at which turn among those of its stage (nb,), (nb,).

    Within a stage a node comes first, then the rows of its joint with the joint's coordinates, and
    rows that close loops last: by then only the motion that they constrain is left, so a redundant
    row shows as a pivot that vanishes.
    """
    nb = len(pattern.sizes)
    rows, columns = pattern.rows.astype(np.int64), pattern.column.astype(np.int64)
    light, lam = pattern.massless, pattern.multiplier
    stage = np.full(nb, -1)
    host = _most(rows, columns, light[rows] & ~light[columns] & ~lam[columns], np.arange(nb))
    # coordinates that no node has are nodes themselves
    node = ~lam & (~light | (host < 0))
    stage[node] = _of_nodes(rows, columns, np.where(node, np.arange(nb), host), ~lam)
    waiting = light & ~node
    on_nodes = _most(rows, columns, waiting[rows] & node[columns], stage)
    beyond = _most(rows, columns, lam[rows] & waiting[columns], on_nodes)
    # every constraint row is assigned to a block that it can be eliminated with
    assigned = _assigned_rows(pattern, rows, columns, node)
    for at, row in assigned.items():
        stage[row] = stage[at]
    for row in np.flatnonzero(lam & (stage < 0)).tolist():
        at = _closing(pattern, node, stage, assigned, row)
        stage[row] = at if at < 0 else max(at, int(beyond[row]))
    by_rows = lam[columns] & (stage[columns] >= 0)
    first = nb - _most(rows, columns, waiting[rows] & by_rows, nb - stage)
    stage[waiting] = np.maximum(on_nodes, np.where(first <= nb, first, -1))[waiting]
    # rows on coordinates of joints alone, and rows on nothing
    unassigned = lam & (stage < 0)
    stage[unassigned] = _most(rows, columns, unassigned[rows] & ~lam[columns], stage)[unassigned]
    lost = stage < 0
    stage[lost] = nb + np.flatnonzero(lost)
    holds = np.zeros(nb, bool)
    holds[list(assigned.values())] = True
    with_node = _most(rows, columns, holds[columns], stage) == stage
    turn = np.select([node, holds, light & with_node, lam], [0, 1, 2, CLOSING], 4)
    return stage, turn.astype(np.int64)


def _most(rows: Longs, columns: Longs, chosen: Bools, number: Longs) -> Longs:
    """The largest number among the chosen columns of a row, -1 where there are none (nb,)."""
    most = np.full(len(number), -1)
    np.maximum.at(most, rows[chosen], number[columns[chosen]])
    return most


def _of_nodes(rows: Longs, columns: Longs, host: Longs, speed: Bools) -> Longs:
    """The order of the nodes; coordinates of joints stand with their host meanwhile."""
    among = speed[rows] & speed[columns]
    names, number = np.unique(host[speed], return_inverse=True)
    place = np.full(len(host), -1)
    place[speed] = number
    adjacency = graph(len(names), place[rows[among]], place[columns[among]])
    return ranks(elimination(adjacency))


def _assigned_rows(pattern: Pattern, rows: Longs, columns: Longs, node: Bools) -> dict[int, int]:
    """Node -> rows that hold all its motion; as many nodes as can be, children of joints first.

    A node without rows of its own has to be regular by itself. Therefore children of joints get
    rows first: they may have no mass. In a floating tree the root remains without rows.
    """
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import maximum_bipartite_matching

    same = pattern.sizes[rows] == pattern.sizes[columns]
    # what modes let go holds nothing for good
    permanent = pattern.multiplier & ~pattern.switched
    fit = permanent[rows] & node[columns] & same
    shape = (len(node), len(node))
    first = fit & (pattern.child[rows] == columns)
    offers = coo_array((np.ones(int(first.sum())), (rows[first], columns[first])), shape).tocsr()
    matching = maximum_bipartite_matching(offers, perm_type="column")
    taken = np.flatnonzero(matching >= 0)
    assigned = dict(zip(matching[taken].tolist(), taken.tolist(), strict=True))
    fitting: dict[int, list[int]] = {}
    for row, at in zip(rows[fit].tolist(), columns[fit].tolist(), strict=True):
        fitting.setdefault(at, []).append(row)
    for at in fitting:
        if at not in assigned:
            _assign_by_exchange(at, fitting, assigned)
    return assigned


def _assign_by_exchange(
    at: int, fitting: Mapping[int, list[int]], assigned: dict[int, int]
) -> None:
    """Hold one more node, if rows can be exchanged among the nodes that are held."""
    owner = {row: node for node, row in assigned.items()}
    before, front = {at: -1}, [at]
    while front:
        here = front.pop()
        for row in fitting[here]:
            if row not in owner:
                # every node on the way takes the row that led on, and leaves its own behind
                while here >= 0:
                    row, assigned[here] = assigned.get(here, -1), row
                    here = before[here]
                return
            if owner[row] not in before:
                before[owner[row]] = here
                front.append(owner[row])


def _nodes(pattern: Pattern, row: int, node: Bools) -> list[int]:
    """The nodes that a row block meets."""
    met = pattern.column[pattern.row[row] : pattern.row[row + 1]]
    return [int(x) for x in met[node[met]]]


def _closing(
    pattern: Pattern, node: Bools, stage: Longs, assigned: Mapping[int, int], row: int
) -> int:
    """The stage at which the ways from the nodes of a row block meet, -1 if it meets none.

    Each path goes from a node to its parents, the other nodes in its own rows. If a path ends at
    the ground, or at a node with fewer speeds than there are rows, the other paths are followed to
    their ends.
    """
    front = [(int(stage[x]), x) for x in _nodes(pattern, row, node)]
    heapify(front)
    missing, at = int(pattern.sizes[row]), -1
    to_ends = len(front) == 1
    while front:
        at, here = heappop(front)
        while front and front[0][1] == here:
            heappop(front)
        if not front and not to_ends:
            break
        if here not in assigned:
            missing -= int(pattern.sizes[here])
            to_ends = missing > 0
            continue
        later = [x for x in _nodes(pattern, assigned[here], node) if stage[x] > at]
        to_ends = to_ends or not later
        for x in later:
            heappush(front, (int(stage[x]), x))
    return at
