"""An order of elimination with little fill, and the fill it leaves.

Source: J. A. George, J. W. Liu, Computer Solution of Large Sparse Positive Definite Systems, 1981
(minimum degree); X. S. Li, An overview of SuperLU, ACM TOMS 31 (2005).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .pattern import Longs

if TYPE_CHECKING:
    from scipy.sparse import csr_array

FAINT = 1e-9


def ranks(order: Longs) -> Longs:
    """At which place each stands."""
    ranks = np.empty_like(order)
    ranks[order] = np.arange(len(order))
    return ranks


def graph(n: int, i: Longs, j: Longs) -> csr_array:
    """The graph of n vertices with these edges, each in both directions."""
    from scipy.sparse import coo_array

    other = i != j
    ones = np.ones(int(other.sum()))
    edges = coo_array((ones, (i[other], j[other])), (n, n)).tocsr()
    edges = edges + edges.T
    edges.data[:] = 1
    return edges


def elimination(edges: csr_array) -> Longs:
    """An order of elimination with little fill: minimum degree, for trees from the leaves.

    Trees have no fill. Chains are eliminated in the order in which they are numbered.
    """
    from scipy.sparse.csgraph import connected_components, depth_first_order

    n = edges.shape[0]
    if n == 0:
        return np.zeros(0, np.int64)
    parts, part = connected_components(edges, directed=False)
    if edges.nnz // 2 != n - parts:
        lu = _factored(edges, "MMD_AT_PLUS_A")
        return ranks(np.asarray(lu.perm_c, np.int64))
    # a forest: the last vertex of every tree becomes a child of one more vertex, the common root
    roots = np.zeros(parts, np.int64)
    np.maximum.at(roots, part, np.arange(n))
    i, j = edges.nonzero()
    extended = graph(n + 1, np.concatenate([i, roots]), np.concatenate([j, np.full(parts, n)]))
    order = depth_first_order(extended, n, directed=False, return_predecessors=False)
    return np.asarray(order[:0:-1], np.int64)


def filled(edges: csr_array) -> tuple[Longs, Longs]:
    """The columns of the factor L when vertices are eliminated as numbered, without diagonals.

    Returns:
        Where each column begins in the list (n + 1,), and the rows in it, ascending.
    """
    from scipy.sparse import csc_array

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
    """The factors of a matrix with the given pattern; only its ordering and pattern are used.

    A slightly shifted Laplacian is regular, and no entry of its factors cancels to zero.
    """
    from scipy.sparse import diags_array
    from scipy.sparse.linalg import splu

    degree = np.asarray(edges.sum(axis=1)).reshape(-1)
    matrix = (diags_array(degree * (1 + FAINT) + FAINT) - edges).tocsc()
    return splu(matrix, permc_spec=order, diag_pivot_thresh=0.0, options={"SymmetricMode": True})
