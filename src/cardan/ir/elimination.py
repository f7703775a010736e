"""Elimination on lists of numbers of any kind, for the interpreter."""

from __future__ import annotations

import math
from typing import Any

from ..errors import SolveError
from .solve import DEPENDENT, LEAST, VANISHED

Rows = list[list[Any]]


def solve(kind: str, a: Rows, b: Rows, eps: object) -> Rows:
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
    if kind == "semidefinite":
        return _semidefinite(a, b)
    if kind == "basic":
        return _basic(a, b)
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


def _basic(a: Rows, b: Rows) -> Rows:
    """Complete pivoting on the rows that are independent, measured by their largest entries."""
    n = len(a)
    vanished = max((abs(x) for row in a for x in row), default=0) * math.sqrt(VANISHED)
    for i, row in enumerate(a):
        largest = max(vanished, *map(abs, row))
        if largest:
            a[i], b[i] = [x / largest for x in row], [x / largest for x in b[i]]
    columns, rank = list(range(n)), n
    for k in range(n):
        size, pivot, column = _largest(a, k)
        if not size * size > DEPENDENT:
            rank = k
            break
        _exchange(k, pivot, column, columns, a, b)
        _clear_below(a, b, k)
    return _back(a, b, columns, rank)


def _largest(a: Rows, k: int) -> tuple[Any, int, int]:
    """The largest entry from row and column k on, the first of equal ones."""
    n = len(a)
    size, row, column = max((abs(a[i][j]), -i, -j) for i in range(k, n) for j in range(k, n))
    return size, -row, -column


def _exchange(k: int, row: int, column: int, columns: list[int], a: Rows, *others: Any) -> None:
    """Bring an entry of A to the place of pivot k."""
    for rows in (a, *others):
        rows[k], rows[row] = rows[row], rows[k]
    columns[k], columns[column] = columns[column], columns[k]
    for line in a:
        line[k], line[column] = line[column], line[k]


def _clear_below(a: Rows, b: Rows, k: int) -> list[Any]:
    """Subtract row k from those below; the factors."""
    factors = [a[i][k] / a[k][k] for i in range(k + 1, len(a))]
    for i, factor in enumerate(factors, k + 1):
        a[i] = [x - factor * y for x, y in zip(a[i], a[k], strict=True)]
        b[i] = [x - factor * y for x, y in zip(b[i], b[k], strict=True)]
    return factors


def _pivoting(kind: str, a: Rows, b: Rows, eps: Any) -> Rows:
    """Gaussian elimination with complete pivoting."""
    n = len(a)
    columns = list(range(n))
    largest, rank = 0, n
    # the largest entry of every row of B tells rounding from contradiction
    scale = [max(map(abs, row)) for row in b]
    for k in range(n):
        size, row, column = _largest(a, k)
        largest = largest or size
        if size <= n * eps * largest:
            rank = k
            break
        _exchange(k, row, column, columns, a, b, scale)
        for i, factor in enumerate(_clear_below(a, b, k), k + 1):
            scale[i] = max(scale[i], abs(factor) * scale[k])
    if rank < n and kind != "rank_revealing":
        raise SolveError(f"a system of {n} equations has rank {rank}: its matrix is singular")
    if any(abs(x) > 64 * n * eps * scale[i] for i in range(rank, n) for x in b[i]):
        raise SolveError(f"a system of {n} equations has rank {rank} and contradicts itself")
    return _back(a, b, columns, rank)


def _semidefinite(a: Rows, b: Rows) -> Rows:
    """Elimination along the diagonal, of the rows that are independent."""
    n = len(a)
    size, left, taken = [a[i][i].real for i in range(n)], list(range(n)), list[int]()
    size = [max(diagonal, VANISHED * max(size)) for diagonal in size]
    while left:
        # the largest of the rows that depend least on those before it
        shares = {i: _share(a[i][i], size[i]) for i in left}
        least = max(DEPENDENT, LEAST * max(shares.values()))
        free = [i for i in left if shares[i] > least]
        if not free:
            break
        best = max(free, key=lambda i: (a[i][i].real, -i))
        left.remove(best)
        taken.append(best)
        for i in left:
            factor = a[i][best] / a[best][best]
            for j in left:
                a[i][j] -= factor * a[best][j]
            b[i] = [x - factor * y for x, y in zip(b[i], b[best], strict=True)]
    x: Rows = [[entry * 0 for entry in b[0]] for _ in a]
    for place in range(len(taken) - 1, -1, -1):
        k = taken[place]
        right = b[k]
        for j in taken[place + 1 :]:
            right = [r - a[k][j] * y for r, y in zip(right, x[j], strict=True)]
        x[k] = [r / a[k][k] for r in right]
    return x


def _share(pivot: Any, size: Any) -> Any:
    """Remaining part of a diagonal entry; of complex numbers the real parts count."""
    return pivot.real / size if size > 0 else 0


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
