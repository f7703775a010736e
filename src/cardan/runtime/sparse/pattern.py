"""Blocks of a sparse matrix, and the places where elements add to them."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...arrays import Booleans
from ...errors import ArgumentError
from ...records import dataclass

Ints = NDArray[np.int32]
Longs = NDArray[np.int64]
LARGEST = 2**31 - 1


@dataclass(frozen=True, eq=False)
class Pattern:
    """A square matrix whose rows and columns come in the same nb blocks, stored by rows (CSR).

    Attributes:
        first: The first unknown of each block, and how many there are (nb + 1,).
        multiplier, massless: Which blocks are multipliers; which speeds may have no diagonal of
            their own (nb,).
        switched: Which blocks of multipliers have a diagonal, of rows that are not in use (nb,).
        child: Of each block of multipliers the last node that its element couples, which a joint
            holds to the others; -1 of other blocks (nb,).
        row: Where the list of a row block begins in ``column`` (nb + 1,).
        column: The blocks that a row block meets, ascending (pairs,).
        value: Where the pair begins in the values of the matrix (pairs,).
        stride: Numbers from one row of a row block to the next (nb,).
        places: Of each group (n, k, k): where what element e adds for its blocks i and j begins in
            the values; -1 between two blocks of multipliers, but for switched ones on the
            diagonal. Rows are ``stride`` apart.
    """

    first: Ints
    multiplier: Booleans
    massless: Booleans
    switched: Booleans
    child: Longs
    row: Ints
    column: Ints
    value: Ints
    stride: Ints
    places: tuple[Ints, ...]

    @property
    def sizes(self) -> Ints:
        """Unknowns of each block (nb,)."""
        return np.diff(self.first)

    @property
    def n(self) -> int:
        """Unknowns."""
        return int(self.first[-1])

    @property
    def values(self) -> int:
        """Numbers of the matrix."""
        return int((self.stride.astype(np.int64) * self.sizes).sum())

    @cached_property
    def rows(self) -> Ints:
        """The row block of each pair (pairs,)."""
        return np.repeat(np.arange(len(self.stride), dtype=np.int32), np.diff(self.row))

    @cached_property
    def at(self) -> Ints:
        """The first value of each row block (nb,)."""
        count = self.sizes.astype(np.int64) * self.stride
        return np.asarray(np.cumsum(count) - count, np.int32)

    @cached_property
    def csr(self) -> tuple[Ints, Ints]:
        """Columns (values,) and row starts (n + 1,) as SciPy's CSR has them."""
        width = np.repeat(self.stride, self.sizes)
        starts = np.concatenate([[0], np.cumsum(width, dtype=np.int64)])
        # the columns of one row of each row block, then repeated for all its rows
        once = ranges(self.first[self.column], self.sizes[self.column])
        begin = np.concatenate([[0], np.cumsum(self.stride, dtype=np.int64)])[:-1]
        return once[ranges(np.repeat(begin, self.sizes), width)].astype(np.int32), np.asarray(
            starts, np.int32
        )

    @cached_property
    def transposed(self) -> tuple[Longs, Longs, Longs]:
        """The row of each value, the values column by column (values,), column starts (n + 1,)."""
        columns, starts = self.csr
        rows = np.repeat(np.arange(self.n), np.diff(starts))
        order = np.argsort(columns, kind="stable")
        return rows, order, np.searchsorted(columns[order], np.arange(self.n + 1))

    def block_of(self, unknown: int) -> int:
        """The block that an unknown belongs to."""
        return int(np.searchsorted(self.first, unknown, side="right")) - 1


def ranges(start: NDArray[Any], count: NDArray[Any]) -> Longs:
    """start[0], start[0] + 1, ... (count[0] numbers), start[1], ..."""
    ends = np.cumsum(count, dtype=np.int64)
    total = int(ends[-1]) if len(ends) else 0
    moved = np.asarray(start, np.int64) - (ends - count)
    return np.asarray(np.arange(total) + np.repeat(moved, count), np.int64)


def distinct(numbers: Longs) -> Longs:
    """Every number once, ascending. By sorting: hashes of numbers like these collide."""
    ascending = np.sort(numbers)
    first = np.append(True, ascending[1:] != ascending[:-1])[: len(ascending)]
    return np.asarray(ascending[first], np.int64)


def pattern(
    sizes: ArrayLike,
    cliques: Sequence[ArrayLike],
    multiplier: ArrayLike | None = None,
    massless: ArrayLike | None = None,
    switched: ArrayLike | None = None,
) -> Pattern:
    """The matrix of elements each of which couples its blocks pairwise.

    Args:
        sizes: Unknowns of each block (nb,).
        cliques: Of each group of elements the blocks (n, k) they couple, those of a joint from
            parent to child. Every block of speeds has a diagonal, whether or not it is in one.
        multiplier: Which blocks are multipliers (nb,); none by default.
        massless: Which blocks of speeds may have no diagonal of their own (nb,), such as the
            coordinates of joints; none by default.
        switched: Which blocks of multipliers have a diagonal (nb,); none by default.

    Raises:
        ArgumentError: sizes, blocks or masks that do not fit, or more numbers than can be counted.
    """
    size = np.asarray(sizes, np.int64).reshape(-1)
    nb = len(size)
    if size.size and size.min() < 0:
        raise ArgumentError(f"block {int(size.argmin())} has {size.min()} unknowns")
    lam, light = _mask("multiplier", multiplier, nb), _mask("massless", massless, nb)
    switches = _mask("switched", switched, nb) & lam
    groups = [_blocks(i, clique, nb) for i, clique in enumerate(cliques)]
    # pairs of blocks as numbers, and where the pairs of every element are among them
    keys = [blocks[:, :, None] * nb + blocks[:, None, :] for blocks in groups]
    absent = [_absent(blocks, lam, switches) for blocks in groups]
    present = [key[~without] for key, without in zip(keys, absent, strict=True)]
    pairs = distinct(np.concatenate([np.flatnonzero(~lam) * (nb + 1), *present]))
    row, column, value, stride = _laid(pairs, size)
    positions = [np.full(key.shape, -1, np.int32) for key in keys]
    for place, key, without in zip(positions, present, absent, strict=True):
        place[~without] = value[np.searchsorted(pairs, key)]
    first = np.concatenate([[0], np.cumsum(size)]).astype(np.int32)
    light &= ~lam
    child = _children(groups, ~lam & ~light, lam)
    return Pattern(first, lam, light, switches, child, row, column, value, stride, tuple(positions))


def _absent(blocks: Longs, lam: Booleans, switches: Booleans) -> Booleans:
    """Which pairs of the blocks of elements the matrix does not have (n, k, k)."""
    both = lam[blocks][:, :, None] & lam[blocks][:, None, :]
    diagonal = np.eye(blocks.shape[1], dtype=bool) & switches[blocks][:, :, None]
    return np.asarray(both & ~diagonal, bool)


def _children(groups: Sequence[Longs], node: Booleans, lam: Booleans) -> Longs:
    """The last node of the element of each block of multipliers, -1 without one (nb,)."""
    child = np.full(len(node), -1)
    for blocks in groups:
        for k in range(blocks.shape[1]):
            for position in range(blocks.shape[1]):
                holds = lam[blocks[:, position]] & node[blocks[:, k]]
                child[blocks[holds, position]] = blocks[holds, k]
    return child


def _laid(pairs: Longs, size: Longs) -> tuple[Ints, Ints, Ints, Ints]:
    """Row, column, value and stride of :class:`Pattern`: rows of a block one behind the other."""
    rows, columns = np.divmod(pairs, max(len(size), 1))
    row = np.searchsorted(rows, np.arange(len(size) + 1))
    before = np.concatenate([[0], np.cumsum(size[columns])])
    stride = np.diff(before[row])
    count = stride * size
    if count.sum() > LARGEST:
        raise ArgumentError(f"a matrix of {count.sum():,} numbers is too large")
    value = (np.cumsum(count) - count)[rows] + before[:-1] - before[row[rows]]
    return (
        row.astype(np.int32), columns.astype(np.int32), value.astype(np.int32),
        stride.astype(np.int32),
    )  # fmt: skip


def _mask(name: str, values: ArrayLike | None, nb: int) -> Booleans:
    mask = np.zeros(nb, bool) if values is None else np.asarray(values, bool).reshape(-1)
    if len(mask) != nb:
        raise ArgumentError(f"{name}: {len(mask)} entries for {nb} blocks")
    return mask


def _blocks(group: int, clique: ArrayLike, nb: int) -> Longs:
    blocks = np.asarray(clique, np.int64)
    if blocks.ndim != 2:
        raise ArgumentError(f"cliques of group {group}: shape {blocks.shape} instead of (n, k)")
    if blocks.size and not (blocks.min() >= 0 and blocks.max() < nb):
        raise ArgumentError(
            f"cliques of group {group}: blocks {blocks.min()} to {blocks.max()}, there are {nb}"
        )
    return blocks
