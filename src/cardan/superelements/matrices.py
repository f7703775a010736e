"""Matrices of a component as given: sparse, symmetric, finite, or refused by the name of a row."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Array
from ..errors import ModelError, SolveError
from .node_dofs import NodeDofs
from .values import LARGEST, unmasked

if TYPE_CHECKING:
    from scipy.sparse import csc_matrix as Sparse

SYMMETRY = 1e-8  # beside the diagonal: what rounded texts lose, and nothing that matters


def symmetric_part(matrix: Array) -> Array:
    """(A + A^T)/2, without what rounding left of asymmetry."""
    return (matrix + matrix.T) / 2


def square_size(name: str, matrix: Sparse) -> int:
    """Rows of a square matrix, dense or sparse.

    Raises:
        ModelError: it is not square.
    """
    try:
        shape = tuple(matrix.shape) if hasattr(matrix, "shape") else np.shape(matrix)
    except ValueError:
        raise ModelError(f"{name}: rows of different lengths, expected (n, n)") from None
    if len(shape) != 2 or shape[0] != shape[1] or not shape[0]:
        raise ModelError(f"{name}: shape {shape}, expected a square matrix (n, n)")
    return int(shape[0])


def as_sparse(name: str, matrix: Sparse, size: int) -> Sparse:
    """A real matrix by columns.

    Raises:
        ModelError: of another size, or not of real numbers.
    """
    from scipy.sparse import csc_matrix, issparse

    rows = square_size(name, matrix)
    if rows != size:
        raise ModelError(f"{name} is {rows} x {rows}, expected {size} x {size}, as K is")
    values = matrix if issparse(matrix) else unmasked(name, matrix)
    return csc_matrix(well_formed(name, values), dtype=np.float64, copy=True)


def well_formed(name: str, values: Sparse) -> Sparse:
    """A matrix of real numbers, whose places are within it.

    Raises:
        ModelError: something else.
    """
    if values.dtype.kind not in "fiu":
        raise ModelError(f"{name}: entries of {values.dtype}, expected real numbers")
    if hasattr(values, "check_format"):
        try:
            # places outside of the matrix would be read from foreign memory
            values.check_format(full_check=True)
        except (ValueError, TypeError) as error:
            raise ModelError(
                f"{name}: its sparse matrix is damaged: {error}; build it again from rows, columns "
                "and values, scipy.sparse.coo_matrix"
            ) from None
    return values


def symmetric(name: str, matrix: Sparse, dofs: NodeDofs) -> Sparse:
    """A symmetric matrix by columns; what rounding left of asymmetry is gone.

    Raises:
        SolveError: an entry that is not finite.
        ModelError: of another size, or unsymmetric.
    """
    sparse = as_sparse(name, matrix, len(dofs))
    sparse.sum_duplicates()
    entries = sparse.tocoo()
    bad = np.flatnonzero(~(abs(entries.data) < LARGEST))
    if len(bad):
        row, column = entries.row[bad[0]], entries.col[bad[0]]
        raise SolveError(
            f"{name}: the entry of {dofs.label(row)} and {dofs.label(column)} is "
            f"{entries.data[bad[0]]}; write the matrix again"
        )
    if not abs(entries.data).max(initial=0.0):
        raise ModelError(f"{name} is zero; give the matrix of the component")
    # judged beside the diagonal of its own rows: displacements and rotations differ in units
    difference, diagonal = (sparse - sparse.T).tocoo(), np.sqrt(abs(sparse.diagonal()))
    scale = diagonal[difference.row] * diagonal[difference.col] + abs(difference.data)
    unequal = abs(difference.data) / np.where(scale > 0, scale, 1.0)
    worst = int(np.argmax(unequal)) if len(unequal) else 0
    if len(unequal) and unequal[worst] > SYMMETRY:
        row, column = difference.row[worst], difference.col[worst]
        there, mirrored = sparse[row, column], sparse[column, row]
        triangle = not (np.any(entries.row > entries.col) and np.any(entries.row < entries.col))
        cure = (
            "only one triangle is there: give A + A.T - diag(A)"
            if triangle
            else f"give the symmetric part, {name} + {name}.T over 2, if the rest is not meant"
        )
        raise ModelError(
            f"{name} is not symmetric: {dofs.label(row)} and {dofs.label(column)} have "
            f"{there:.6g} on one side and {mirrored:.6g} on the other; {cure}"
        )
    return ((sparse + sparse.T) / 2).tocsc()


def check_diagonals(M: Sparse, K: Sparse, dofs: NodeDofs) -> None:
    """Refuse matrices that no component has.

    Raises:
        ModelError: a negative mass or stiffness, or a row that nothing is connected to.
    """
    mass, stiffness = M.diagonal(), K.diagonal()
    for name, values in (("M", mass), ("K", stiffness)):
        row = int(np.argmin(values))
        if values[row] < 0:
            raise ModelError(
                f"{name} has {values[row]:.6g} on the diagonal at {dofs.label(row)}; mass and "
                "stiffness are not negative: check the sign and which file is which"
            )
    empty = np.flatnonzero((stiffness == 0) & (mass == 0))
    if len(empty):
        raise ModelError(
            f"{dofs.label(empty[0])} has neither mass nor stiffness: take its row and column out "
            "of M and K, and name the rows that stay by dofs=[(node, 'x'), ...]"
        )
