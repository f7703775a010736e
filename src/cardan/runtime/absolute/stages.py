"""Which blocks of a sparse matrix are eliminated together.

Multipliers have no diagonal of their own: each is eliminated when something is there that its rows
hold, so that pivots are found among the rows at hand. Nodes go one after the other, as fill asks.
Rows that hold all motion of a node go with that node, one set per node, as a joint goes with its
body in a tree: the two are regular whatever else the node has, and what is left of the node moves
with those that its joint hangs on. All other rows close circuits: they wait for the node at which
the ways from their nodes meet, where all motion in the circuit is known. Coordinates of joints go
with the last of the nodes they are for, and not before rows that hold them.
"""

from __future__ import annotations

from collections.abc import Mapping
from heapq import heapify, heappop, heappush

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import maximum_bipartite_matching

from .ordering import elimination, graph, ranks
from .pattern import Longs, Pattern

Bools = NDArray[np.bool_]


def together(pattern: Pattern) -> tuple[Longs, Longs]:
    """The order of elimination.

    Returns:
        order: The blocks in order of elimination (nb,).
        vertex: Of each of them, which set it belongs to, ascending from 0 (nb,).
    """
    stage = stages(pattern)
    kind = np.where(pattern.multiplier, 1, np.where(pattern.massless, 2, 0))
    order = np.lexsort((np.arange(len(stage)), kind, stage))
    return order, np.unique(stage[order], return_inverse=True)[1].astype(np.int64)


def stages(pattern: Pattern) -> Longs:
    """When each block is eliminated; those of one number together (nb,)."""
    nb = len(pattern.sizes)
    rows, columns = pattern.rows.astype(np.int64), pattern.column.astype(np.int64)
    light, lam = pattern.massless, pattern.multiplier
    stage = np.full(nb, -1)
    beside = _most(rows, columns, light[rows] & ~light[columns] & ~lam[columns], np.arange(nb))
    # coordinates that no node has are nodes themselves
    node = ~lam & (~light | (beside < 0))
    stage[node] = _of_nodes(rows, columns, np.where(node, np.arange(nb), beside), ~lam)
    waiting = light & ~node
    on_nodes = _most(rows, columns, waiting[rows] & node[columns], stage)
    beyond = _most(rows, columns, lam[rows] & waiting[columns], on_nodes)
    held = _held(pattern, rows, columns, node)
    for at, row in held.items():
        stage[row] = stage[at]
    for row in np.flatnonzero(lam & (stage < 0)).tolist():
        at = _closing(pattern, node, stage, held, row)
        stage[row] = at if at < 0 else max(at, int(beyond[row]))
    by_rows = lam[columns] & (stage[columns] >= 0)
    first = nb - _most(rows, columns, waiting[rows] & by_rows, nb - stage)
    stage[waiting] = np.maximum(on_nodes, np.where(first <= nb, first, -1))[waiting]
    # rows on coordinates of joints alone, and rows on nothing
    rest = lam & (stage < 0)
    stage[rest] = _most(rows, columns, rest[rows] & ~lam[columns], stage)[rest]
    lost = stage < 0
    stage[lost] = nb + np.flatnonzero(lost)
    return stage


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
    between = graph(len(names), place[rows[among]], place[columns[among]])
    return ranks(elimination(between))


def _held(pattern: Pattern, rows: Longs, columns: Longs, node: Bools) -> dict[int, int]:
    """Node -> rows that hold all its motion; as many nodes as can be."""
    same = pattern.sizes[rows] == pattern.sizes[columns]
    fit = pattern.multiplier[rows] & node[columns] & same
    shape = (len(node), len(node))
    offers = coo_array((np.ones(int(fit.sum())), (rows[fit], columns[fit])), shape).tocsr()
    found = maximum_bipartite_matching(offers, perm_type="column")
    taken = np.flatnonzero(found >= 0)
    return dict(zip(found[taken].tolist(), taken.tolist(), strict=True))


def _nodes(pattern: Pattern, row: int, node: Bools) -> list[int]:
    """The nodes that a row block meets."""
    met = pattern.column[pattern.row[row] : pattern.row[row + 1]]
    return [int(x) for x in met[node[met]]]


def _closing(pattern: Pattern, node: Bools, stage: Longs, held: Mapping[int, int], row: int) -> int:
    """The stage at which the ways from the nodes of a row block meet, -1 if it meets none.

    Each way goes from a node to those that its own rows hang it on. Ways that end on the ground, or
    at nodes too small to give way to all rows, leave the others to be gone to their ends.
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
        if here not in held:
            missing -= int(pattern.sizes[here])
            to_ends = missing > 0
            continue
        later = [x for x in _nodes(pattern, held[here], node) if stage[x] > at]
        to_ends = to_ends or not later
        for x in later:
            heappush(front, (int(stage[x]), x))
    return at
