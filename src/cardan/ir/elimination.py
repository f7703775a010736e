"""Elimination on lists of numbers of any kind, for the interpreter."""

from __future__ import annotations

from typing import Any

from ..errors import SolveError

Rows = list[list[Any]]


def solve(kind: str, a: Rows, b: Rows, eps: Any) -> Rows:
    """X with A X = B.

    Args:
        kind: As in :func:`cardan.ir.solve.solve`.
        a: (n, n); overwritten.
        b: (n, m); overwritten.
        eps: Relative rounding of the numbers.

    Raises:
        SolveError: A is singular; a ``rank_revealing`` solve goes on with zeros for the unknowns
            that A does not determine, unless B contradicts A.
    """
    return _static(a, b) if kind == "spd" else _pivoting(kind, a, b, eps)


def _static(a: Rows, b: Rows) -> Rows:
    """A = Lᵀ D L from the last row up, without pivoting: the order of the unrolled code."""
    n = len(a)
    for k in range(n - 1, -1, -1):
        if a[k][k] == 0:
            raise SolveError(
                f"entry {k + 1} of {n} of a positive definite system has no pivot: the matrix is "
                "singular. Look for a coordinate that moves nothing with mass or inertia"
            )
        for i in range(k):
            factor = a[k][i] / a[k][k]
            for j in range(i + 1):
                a[i][j] -= factor * a[k][j]
            b[i] = [x - factor * y for x, y in zip(b[i], b[k], strict=True)]
    # Lᵀ is eliminated from the right side: D L X = B is left
    for k in range(n):
        for j in range(k):
            b[k] = [x - a[k][j] * y for x, y in zip(b[k], b[j], strict=True)]
        b[k] = [x / a[k][k] for x in b[k]]
    return b


def _pivoting(kind: str, a: Rows, b: Rows, eps: Any) -> Rows:
    """Gaussian elimination with complete pivoting."""
    n = len(a)
    columns = list(range(n))
    largest, rank = 0, n
    # the largest entry of every row of B tells rounding from contradiction
    scale = [max(map(abs, row)) for row in b]
    for k in range(n):
        size, row, column = max((abs(a[i][j]), -i, -j) for i in range(k, n) for j in range(k, n))
        row, column = -row, -column
        largest = largest or size
        if size <= n * eps * largest:
            rank = k
            break
        for rows in (a, b, scale):
            rows[k], rows[row] = rows[row], rows[k]
        columns[k], columns[column] = columns[column], columns[k]
        for line in a:
            line[k], line[column] = line[column], line[k]
        for i in range(k + 1, n):
            factor = a[i][k] / a[k][k]
            a[i] = [x - factor * y for x, y in zip(a[i], a[k], strict=True)]
            b[i] = [x - factor * y for x, y in zip(b[i], b[k], strict=True)]
            scale[i] = max(scale[i], abs(factor) * scale[k])
    if rank < n and kind != "rank_revealing":
        raise SolveError(f"a system of {n} equations has rank {rank}: its matrix is singular")
    if any(abs(x) > 64 * n * eps * scale[i] for i in range(rank, n) for x in b[i]):
        raise SolveError(f"a system of {n} equations has rank {rank} and contradicts itself")
    return _back(a, b, columns, rank)


def _back(a: Rows, b: Rows, columns: list[int], rank: int) -> Rows:
    """Solve the upper triangle of the pivoted rows; unknowns beyond the rank are zero."""
    zero = [x * 0 for x in b[0]]
    x: Rows = [list(zero) for _ in a]
    for k in range(rank - 1, -1, -1):
        right = b[k]
        for j in range(k + 1, rank):
            right = [r - a[k][j] * y for r, y in zip(right, x[columns[j]], strict=True)]
        x[columns[k]] = [r / a[k][k] for r in right]
    return x
