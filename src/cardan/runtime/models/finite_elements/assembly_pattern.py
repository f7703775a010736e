"""Places of the matrices of elements in those of the model: looked up once for all states."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ....arrays import Array
from ....records import dataclass

if TYPE_CHECKING:
    from scipy.sparse import csr_matrix

Integers = NDArray[np.intp]


@dataclass(frozen=True, eq=False)
class AssemblyPattern:
    """The sparse matrix that matrices of elements are summed in.

    Attributes:
        shape: Of the matrix.
        starts, columns: Of its rows, as compressed rows have them.
        entry: Entry of the matrix for every number of the elements, one after the other.
    """

    shape: tuple[int, int]
    starts: Integers
    columns: Integers
    entry: Integers

    @classmethod
    def of(
        cls, blocks: Sequence[tuple[Integers, Integers]], shape: tuple[int, int]
    ) -> AssemblyPattern:
        """The pattern of groups of elements, each by rows (n, k) and columns (n, l) of its blocks.

        Args:
            blocks: Of every group.
            shape: Of the whole matrix.
        """
        width = max(1, shape[1])
        keys = [
            (rows[:, :, None].astype(np.int64) * width + columns[:, None, :]).reshape(-1)
            for rows, columns in blocks
        ]
        all_keys = np.concatenate(keys) if keys else np.zeros(0, dtype=np.int64)
        unique, entry = np.unique(all_keys, return_inverse=True)
        starts = np.searchsorted(unique, np.arange(shape[0] + 1, dtype=np.int64) * width)
        return cls(shape, starts.astype(np.int32), (unique % width).astype(np.int32), entry)

    def matrix(self, values: Sequence[Array]) -> csr_matrix:
        """The matrix with the numbers (n, k l) of every group."""
        numbers = np.concatenate([v.reshape(-1) for v in values]) if values else np.zeros(0)
        data = np.bincount(self.entry, numbers, len(self.columns))
        # models without elements never load SciPy
        from scipy.sparse import csr_matrix

        matrix = csr_matrix(self.shape)
        matrix.data, matrix.indices, matrix.indptr = data, self.columns, self.starts
        return matrix
