"""The symbolic factorization: every table that the C of ``kernels/sparse/sparse.h`` reads."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...arrays import Booleans
from ...errors import ArgumentError
from ...records import dataclass
from . import ordering, stages
from .pattern import LARGEST, Ints, Longs, Pattern, pattern, ranges

WIDEST = 48


@dataclass(frozen=True, eq=False)
class Plan:
    """Symbolic factorization of a sparse matrix.

    See ``cardan_sparse`` in ``kernels/sparse/sparse.h``.

    Attributes:
        pattern: The matrix.
        order: The unknown that is eliminated as the k-th (n,).
        multiplier: Whether that one is a multiplier (n,): 1, or 2 of a row that closes a loop.
        start: The first unknown of each of ns supernodes, in that order (ns + 1,).
        panel, later: Where the panel of a supernode begins in the factors, unknowns in U (ns,).
        open_start, open: The panels to be filled before a supernode is eliminated (ns + 1,), (ns,).
        load_start, load: Blocks of the matrix that go to a panel (ns + 1,), (nl, 8).
        run_start, run: Later unknowns that a supernode meets (ns + 1,), (nr, 4).
        target_start, target: Where products of two runs go (ns,), (nt,).
        factors: Numbers of the factors.
    """

    pattern: Pattern
    order: Ints
    multiplier: Ints
    start: Ints
    panel: Ints
    later: Ints
    open_start: Ints
    open: Ints
    load_start: Ints
    load: Ints
    run_start: Ints
    run: Ints
    target_start: Ints
    target: Ints
    factors: int

    @property
    def widest(self) -> int:
        """Unknowns of the largest supernode."""
        return int(np.diff(self.start).max(initial=0))

    @property
    def work(self) -> int:
        """Numbers of work memory, as ``cardan_sparse_work`` has it."""
        return self.pattern.n + self.widest**2 + 2 * len(self.later)

    @cached_property
    def operations(self) -> int:
        """Multiplications of one factorization."""
        n, later = np.diff(self.start).astype(np.int64), self.later.astype(np.int64)
        return int((n * (n * n - 1) // 3 + n * n * later + n * later * later).sum())

    def __repr__(self) -> str:
        return (
            f"Plan({self.pattern.n} unknowns in {len(self.pattern.sizes)} blocks, "
            f"{len(self.later)} supernodes up to {self.widest}, {self.pattern.values} numbers, "
            f"{self.factors} in the factors, {self.operations} multiplications)"
        )


def plan(
    sizes: ArrayLike,
    cliques: Sequence[ArrayLike],
    multiplier: ArrayLike | None = None,
    massless: ArrayLike | None = None,
    switched: ArrayLike | None = None,
) -> Plan:
    """Plan the factorization of a matrix of blocks.

    Args:
        sizes, cliques, multiplier, massless, switched: As
            :func:`~cardan.runtime.sparse.pattern.pattern` takes them.

    Raises:
        ArgumentError: blocks that do not fit, or more numbers than can be counted.
    """
    return planned(pattern(sizes, cliques, multiplier, massless, switched))


def planned(matrix: Pattern) -> Plan:
    """Plan the factorization of a matrix.

    Raises:
        ArgumentError: the factors have more numbers than can be counted.
    """
    panels = _Panels.of(matrix)
    load_start, load = _loads(matrix, panels)
    run_start, run, first = _runs(panels)
    target_start, target, touched = _targets(panels, run_start, run, first)
    # updates of a panel are listed under the supernode that receives them
    order = np.argsort(touched, kind="stable")
    supernodes = np.arange(panels.count + 1)
    tables = {
        "order": panels.order,
        "multiplier": np.repeat(1 * matrix.multiplier + panels.closing, matrix.sizes)[panels.order],
        "start": panels.start,
        "panel": panels.panel,
        "later": panels.later,
        "open_start": np.searchsorted(touched[order], supernodes),
        "open": order,
        "load_start": load_start,
        "load": load,
        "run_start": run_start,
        "run": run,
        "target_start": target_start,
        "target": target,
    }
    return Plan(
        pattern=matrix,
        factors=panels.size,
        **{name: np.ascontiguousarray(table, np.int32) for name, table in tables.items()},
    )


@dataclass(frozen=True, eq=False)
class _Panels:
    """Layout of the factors. A vertex is a set of blocks that are eliminated at once.

    Attributes:
        order: The unknown that is eliminated as the k-th (n,).
        block: At which place each block begins in that order (nb,).
        vertex: The vertex of each block (nb,).
        place: At which place each of nv vertices begins (nv + 1,).
        owner: The supernode of each vertex (nv,).
        start, panel, later: As in :class:`Plan`.
        keys: ns-th supernode times nv plus a later vertex that it meets, ascending (k,).
        at: Where that vertex begins in U (k,).
        closing: Which blocks are rows that close loops (nb,).
        size: Numbers of all panels.
    """

    order: Longs
    block: Longs
    vertex: Longs
    place: Longs
    owner: Longs
    start: Longs
    panel: Longs
    later: Longs
    keys: Longs
    at: Longs
    closing: Booleans
    size: int

    @property
    def count(self) -> int:
        """Supernodes."""
        return len(self.panel)

    @staticmethod
    def of(matrix: Pattern) -> _Panels:
        """Order, sets, fill and supernodes of a matrix."""
        order, vertices, closing = stages.elimination_groups(matrix)
        nv = int(vertices[-1]) + 1 if len(vertices) else 0
        vertex = np.empty_like(vertices)
        vertex[order] = vertices
        sizes = matrix.sizes.astype(np.int64)
        block = np.empty_like(order)
        block[order] = np.cumsum(sizes[order]) - sizes[order]
        weight = np.bincount(vertices, sizes[order], nv).astype(np.int64)
        place = np.concatenate([[0], np.cumsum(weight)])
        # symbolic factorization: graph of the vertices and fill of each column
        edges = ordering.graph(nv, vertex[matrix.rows], vertex[matrix.column])
        begin, below = ordering.filled(edges)
        # supernodes: vertices with the same later ones, up to some width
        heads = np.flatnonzero(_heads(begin, below, place))
        owner = np.repeat(np.arange(len(heads)), np.diff(np.append(heads, nv)))
        tails = np.append(heads[1:], nv)[: len(heads)] - 1
        counts = np.diff(begin)[tails]
        met = below[ranges(begin[tails], counts)]
        mine = np.repeat(np.arange(len(heads)), counts)
        ends = np.cumsum(weight[met])
        later = np.bincount(mine, weight[met], len(heads)).astype(np.int64)
        # place of each later vertex within the panel
        at = ends - weight[met] - np.repeat(np.cumsum(later) - later, counts)
        # their panels
        start = place[np.append(heads, nv)]
        count = np.diff(start)
        size = count * (count + 2 * later)
        if size.sum() > LARGEST:
            raise ArgumentError(f"factors of {size.sum():,} numbers are too large")
        return _Panels(
            ranges(matrix.first[:-1][order], sizes[order]), block, vertex, place, owner, start,
            np.cumsum(size) - size, later, mine * nv + met, at, closing,
            int(size.sum()),
        )  # fmt: skip

    def locate(self, i: Longs, row: Longs, j: Longs, column: Longs) -> tuple[Longs, Longs, Longs]:
        """Places of blocks whose rows are in vertices i and begin at places ``row``.

        Returns:
            The supernode, where the block begins in the factors, whether it is turned.
        """
        panel = np.minimum(self.owner[i], self.owner[j])
        transposed = self.owner[i] > panel
        down, across = self._in(panel, i, row), self._in(panel, j, column)
        size = np.diff(self.start)[panel]
        later = self.later[panel]
        # D, then U, then Lt, whose rows are columns of the matrix
        inside = down * size + across
        right = size * size + down * later + across - size
        below = size * (size + later) + across * later + down - size
        to = np.where(transposed, below, np.where(across < size, inside, right))
        return panel, self.panel[panel] + to, transposed.astype(np.int64)

    def _in(self, panel: Longs, vertex: Longs, place: Longs) -> Longs:
        """Places of vertices among the unknowns that a panel meets."""
        within = place - self.start[panel]
        beyond = self.owner[vertex] > panel
        p, v = panel[beyond], vertex[beyond]
        offset = self.at[np.searchsorted(self.keys, p * (len(self.place) - 1) + v)]
        size = np.diff(self.start)[p]
        within[beyond] = size + offset + place[beyond] - self.place[v]
        return within


def _heads(begin: Longs, below: Longs, place: Longs) -> Booleans:
    """Vertices that begin a supernode: those that do not meet what their forerunner meets."""
    counts = np.diff(begin)
    nv = len(counts)
    parent = np.full(nv, -1)
    parent[counts > 0] = below[begin[:-1][counts > 0]]
    same = (parent[:-1] == np.arange(1, nv)) & (counts[:-1] == counts[1:] + 1)
    head = np.concatenate([[True], ~same])[:nv]
    # cut where the width of a run passes multiples of the limit
    run = np.cumsum(head) - 1
    within = (place[:-1] - place[:-1][head][run]) // WIDEST if nv else place[:0]
    head[1:] |= np.diff(within) > 0
    return head


def _loads(matrix: Pattern, panels: _Panels) -> tuple[Longs, Ints]:
    """Blocks of the matrix by the panel they go to."""
    i, j = matrix.rows, matrix.column
    some = (matrix.sizes[i] > 0) & (matrix.sizes[j] > 0)
    i, j, value = i[some], j[some], matrix.value[some]
    panel, to, transposed = panels.locate(
        panels.vertex[i], panels.block[i], panels.vertex[j], panels.block[j]
    )
    sizes, first = matrix.sizes, matrix.first
    by = np.argsort(panel, kind="stable")
    load = np.empty((len(by), 8), np.int32)
    fields: list[NDArray[np.integer]] = [value, matrix.stride[i], to, sizes[i], sizes[j]]
    for k, numbers in enumerate([*fields, first[i], first[j], transposed]):
        load[:, k] = numbers[by]
    return np.searchsorted(panel[by], np.arange(panels.count + 1)), load


def _runs(panels: _Panels) -> tuple[Longs, Longs, Longs]:
    """Later unknowns of each supernode, cut where they stop following each other in one owner.

    Returns:
        Where the runs of each supernode begin (ns + 1,), the runs (nr, 4), their first vertices.
    """
    nv = max(len(panels.place) - 1, 1)
    mine, met = np.divmod(panels.keys, nv)
    owner = panels.owner[met]
    cut = np.ones(len(met), bool)
    cut[1:] = (np.diff(mine) > 0) | (np.diff(owner) > 0) | (np.diff(met) != 1)
    heads = np.flatnonzero(cut)
    lasts = np.append(heads[1:], len(met))[: len(heads)] - 1
    first = met[heads]
    size = panels.place[met[lasts] + 1] - panels.place[first]
    run = np.stack([panels.at[heads], size, panels.place[first], owner[heads]], 1)
    return np.searchsorted(mine[heads], np.arange(panels.count + 1)), run, first


def _targets(
    panels: _Panels, run_start: Longs, run: Longs, first: Longs
) -> tuple[Longs, Longs, Longs]:
    """Places for the products of all pairs of runs of a supernode.

    Returns:
        Where the list of each supernode begins (ns,), the list, and the first supernode that adds
        to each panel, itself if none does (ns,).
    """
    count = np.diff(run_start)
    squares = count * count
    start = np.cumsum(squares) - squares
    k = ranges(np.zeros_like(squares), squares)
    per, base = np.repeat(count, squares), np.repeat(run_start[:-1], squares)
    i, j = base + k // np.maximum(per, 1), base + k % np.maximum(per, 1)
    _, to, _ = panels.locate(first[i], run[i, 2], first[j], run[j, 2])
    touched = np.arange(panels.count)
    np.minimum.at(touched, run[:, 3], np.repeat(np.arange(panels.count), count))
    return start, to, touched
