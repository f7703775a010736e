"""Linear systems of expressions whose pivots are chosen by their values at one place.

What is chosen stays: the code is straight-line, without tests, and short where entries are zero.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from ...arrays import Array
from ...ir.graph import ZERO
from ...ir.matrix import Matrix

# a pivot is at least this part of the largest entry of its column
THRESHOLD = 0.1
DEPENDENT = 1e-9


def solved(a: Matrix, b: Matrix, values: Array) -> Matrix:
    """X (n, m) with A X = B.

    Args:
        a: (n, n), regular. b: (n, m).
        values: Of A at a place like those where the result is used (n, n).
    """
    n, g = a.rows, a.graph
    rows = [[*a.row(i), *b.row(i)] for i in range(n)]
    numbers = np.array(values, dtype=np.float64).reshape(n, n)
    left, columns, order = list(range(n)), list(range(n)), list[tuple[int, int]]()
    while columns:
        row, column = _pivot(rows, numbers, left, columns)
        left.remove(row)
        columns.remove(column)
        order.append((row, column))
        for i in left:
            if rows[i][column] == ZERO:
                continue
            factor = g.div(rows[i][column], rows[row][column])
            targets = [*columns, *range(n, n + b.columns)]
            for j in targets:
                rows[i][j] = g.sub(rows[i][j], g.mul(factor, rows[row][j]))
            numbers[i] -= numbers[i, column] / numbers[row, column] * numbers[row]
            rows[i][column] = ZERO
    solution = [[ZERO] * b.columns for _ in range(n)]
    done: list[int] = []
    for row, column in reversed(order):
        for m in range(b.columns):
            total = rows[row][n + m]
            for j in done:
                total = g.sub(total, g.mul(rows[row][j], solution[j][m]))
            solution[column][m] = g.div(total, rows[row][column])
        done.append(column)
    return Matrix(g, n, b.columns, [x for line in solution for x in line])


def _pivot(
    rows: list[list[int]], numbers: Array, left: list[int], columns: list[int]
) -> tuple[int, int]:
    """The entry that is large enough in its column and fills least, numbers before expressions."""
    graph_cost: Any = {i: sum(rows[i][j] != ZERO for j in columns) for i in left}
    best: tuple[Any, ...] | None = None
    for j in columns:
        sizes = {i: abs(numbers[i, j]) for i in left if rows[i][j] != ZERO}
        largest = max(sizes.values(), default=0.0)
        for i, size in sizes.items():
            if size >= THRESHOLD * largest > 0:
                fill = (graph_cost[i] - 1) * (len(sizes) - 1)
                key = (fill, -size, i, j)
                best = key if best is None or key < best else best
    if best is None:
        raise ZeroDivisionError("the matrix is singular")
    return best[2], best[3]


def null_space(G: Array) -> Array:
    """An orthonormal basis (n, k) of what rows G (m, n) allow."""
    n = G.shape[1]
    if not len(G) or not n:
        return np.eye(n)
    _, s, right = np.linalg.svd(G)
    rank = int(np.sum(s > DEPENDENT * max(float(s.max(initial=0.0)), 1e-300)))
    return np.asarray(right[rank:].T)


def independent(G: Array, weights: Array) -> list[int]:
    """Columns of G (m, n) that may be chosen freely, those of large weight (n,) first."""
    from scipy.linalg import qr

    basis = null_space(G)
    k = basis.shape[1]
    if k == len(basis):
        return list(range(k))
    chosen = qr(basis.T * weights, mode="r", pivoting=True)[1][:k] if k else []
    return sorted(int(i) for i in chosen)


def independent_rows(G: Array) -> list[int]:
    """Rows of G (m, n) that the others follow from."""
    from scipy.linalg import qr

    if not G.size:
        return []
    triangle, order = qr(G.T, mode="r", pivoting=True)
    sizes = np.abs(np.diag(np.atleast_2d(triangle)))
    rank = int(np.sum(sizes > DEPENDENT * max(float(sizes.max(initial=0.0)), 1e-300)))
    return sorted(int(i) for i in order[:rank])
