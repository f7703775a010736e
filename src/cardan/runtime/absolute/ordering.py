"""In which order the blocks of a sparse matrix are eliminated, and which are eliminated together.

Multipliers have no diagonal of their own: each is eliminated together with speeds that its rows
hold, so that pivots are found among the rows at hand. Rows that hold all motion of a node go with
that node, one set per node, as a joint goes with its body in a tree: the two are regular whatever
else the node has. All others go with the last of their nodes, when what is left of the earlier ones
stands on their diagonal.

Source: J. A. George, J. W. Liu, Computer Solution of Large Sparse Positive Definite Systems, 1981
(minimum degree); X. S. Li, An overview of SuperLU, ACM TOMS 31 (2005).
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array, csc_array, csr_array, diags_array
from scipy.sparse.csgraph import (
    connected_components,
    depth_first_order,
    maximum_bipartite_matching,
)
from scipy.sparse.linalg import splu

from .pattern import Longs, Pattern

Bools = NDArray[np.bool_]
FAINT = 1e-9


def together(pattern: Pattern) -> tuple[Longs, Longs]:
    """Which blocks are eliminated together, and in which order.

    Returns:
        order: The blocks in order of elimination (nb,).
        vertex: Of each of them, which set it belongs to, ascending from 0 (nb,).
    """
    nb = len(pattern.sizes)
    rows, columns = pattern.rows.astype(np.int64), pattern.column.astype(np.int64)
    speed, light = ~pattern.multiplier, pattern.massless
    node = speed & ~light
    host = _last(nb, rows, columns, light[rows] & node[columns], np.arange(nb))
    node |= light & (host < 0)
    host[node] = np.flatnonzero(node)
    # the order of nodes, speeds of joints standing with one of theirs
    among = speed[rows] & speed[columns]
    names, vertices = np.unique(host[speed], return_inverse=True)
    number = np.full(nb, -1)
    number[speed] = vertices
    rank = np.full(nb, -1)
    rank[names] = _ranks(
        elimination(graph(len(names), number[rows[among]], number[columns[among]]))
    )
    # with the order known, everything finds its place
    home = np.where(node, np.arange(nb), -1)
    light = light & ~node
    home[light] = _last(nb, rows, columns, light[rows] & node[columns], rank)[light]
    _settle(pattern, rank, home)
    kind = np.where(node, 0, np.where(pattern.multiplier, 1, 2))
    stand = np.where(home >= 0, rank[home], len(names))
    order = np.lexsort((np.arange(nb), kind, np.where(home >= 0, 0, np.arange(nb)), stand))
    key = np.where(home >= 0, stand, len(names) + np.arange(nb))[order]
    return order, np.unique(key, return_inverse=True)[1].astype(np.int64)


def _ranks(order: Longs) -> Longs:
    """At which place each stands."""
    ranks = np.empty_like(order)
    ranks[order] = np.arange(len(order))
    return ranks


def _last(nb: int, rows: Longs, columns: Longs, chosen: Bools, rank: Longs) -> Longs:
    """Of the columns that a row meets the one of highest rank, -1 where it meets none (nb,)."""
    at = np.full(nb, -1)
    np.maximum.at(at, rows[chosen], rank[columns[chosen]])
    back = np.full(int(rank.max(initial=-1)) + 2, -1)
    back[rank] = np.arange(nb)
    back[-1] = -1
    return np.asarray(back[at], np.int64)


def _settle(pattern: Pattern, rank: Longs, home: Longs) -> None:
    """Give every block of multipliers a node to be eliminated with."""
    sizes, multiplier = pattern.sizes, pattern.multiplier
    rows, columns = pattern.rows.astype(np.int64), pattern.column.astype(np.int64)
    touched = multiplier[rows] & (home[columns] >= 0)
    at = np.full(len(sizes), -1)
    np.maximum.at(at, rows[touched], rank[home[columns[touched]]])
    by_rank = np.full(len(sizes) + 1, -1)
    by_rank[rank[rank >= 0]] = np.flatnonzero(rank >= 0)
    last = by_rank[at]
    home[multiplier] = last[multiplier]
    # rows that hold all motion of a node directly: one set per node, as many as can be
    direct = touched & (home[columns] == columns) & (sizes[rows] >= sizes[columns])
    offer = np.ones(int(direct.sum()))
    offers = coo_array((offer, (rows[direct], columns[direct])), (len(sizes),) * 2).tocsr()
    taken = maximum_bipartite_matching(offers, perm_type="column")
    home[taken >= 0] = taken[taken >= 0]


def graph(n: int, i: Longs, j: Longs) -> csr_array:
    """The graph of n vertices with these edges, each in both directions."""
    other = i != j
    ones = np.ones(int(other.sum()))
    edges = coo_array((ones, (i[other], j[other])), (n, n)).tocsr()
    edges = edges + edges.T
    edges.data[:] = 1
    return edges


def elimination(edges: csr_array) -> Longs:
    """An order of elimination with little fill: none in trees, as numbered in chains."""
    n = edges.shape[0]
    if n == 0:
        return np.zeros(0, np.int64)
    parts, part = connected_components(edges, directed=False)
    if edges.nnz // 2 != n - parts:
        lu = _factored(edges, "MMD_AT_PLUS_A")
        return _ranks(np.asarray(lu.perm_c, np.int64))
    # a forest: from the leaves to the last vertex of every tree, which hang on one more
    roots = np.zeros(parts, np.int64)
    np.maximum.at(roots, part, np.arange(n))
    i, j = edges.nonzero()
    whole = graph(n + 1, np.concatenate([i, roots]), np.concatenate([j, np.full(parts, n)]))
    found = depth_first_order(whole, n, directed=False, return_predecessors=False)
    return np.asarray(found[:0:-1], np.int64)


def filled(edges: csr_array) -> tuple[Longs, Longs]:
    """The columns of the factor L when vertices are eliminated as numbered, without diagonals.

    Returns:
        Where each column begins in the list (n + 1,), and the rows in it, ascending.
    """
    n = edges.shape[0]
    if n == 0:
        return np.zeros(1, np.int64), np.zeros(0, np.int64)
    lower = csc_array(_factored(edges, "NATURAL").L)
    lower.sort_indices()
    start = lower.indptr.astype(np.int64)
    inside = np.ones(len(lower.indices), bool)
    inside[start[:-1]] = False
    return start - np.arange(n + 1), lower.indices[inside].astype(np.int64)


def _factored(edges: csr_array, order: str) -> Any:
    """The factors of a matrix in which nothing cancels and nothing fades: almost a Laplacian."""
    degree = np.asarray(edges.sum(axis=1)).reshape(-1)
    matrix = (diags_array(degree * (1 + FAINT) + FAINT) - edges).tocsc()
    return splu(
        matrix,
        permc_spec=order,
        diag_pivot_thresh=0.0,
        options={"SymmetricMode": True},
    )
