"""Linear systems inside the straight line: nodes with several results.

``("solve", kind, n, m, A..., B...)`` is X with A X = B; ``("item", solve, k)`` is its k-th entry,
row by row. Entries of A that are structural zeros are its sparsity pattern.
"""

from __future__ import annotations

from collections.abc import Sequence

from .graph import ZERO, Graph
from .matrix import Matrix, inner

KINDS = ("spd", "symmetric_indefinite", "rank_revealing", "semidefinite", "basic")
# of its diagonal entry: where the pivot of a row of a semidefinite matrix counts as zero
DEPENDENT = 1e-9
# of the largest diagonal entry: no row is measured by less, as nothing but rounding may be left
VANISHED = 1e-15
# of what is left of the row that depends least: rows with more are taken by their size
LEAST = 1e-3


def solve(kind: str, a: Matrix, b: Matrix) -> Matrix:
    """X with A X = B.

    Args:
        kind: ``"spd"``: symmetric positive definite, eliminated in static order from the last row
            to the first (LᵀL, no fill on the pattern of a tree); ``"symmetric_indefinite"`` and
            ``"rank_revealing"``: a C kernel that pivots; ``"semidefinite"``: one that takes the
            rows of a symmetric positive semidefinite A as far as they are independent, each
            measured by its diagonal entry, and gives the others the solution 0; ``"basic"``: one
            that leaves out rows that follow from others, each measured by its largest entry, and
            gives unknowns that are free the solution 0.
        a: (n, n).
        b: (n, m).
    """
    if kind not in KINDS:
        raise ValueError(f"kind of solve must be one of {', '.join(KINDS)}, not {kind!r}")
    graph, n, m = a.graph, a.rows, b.columns
    if a.columns != n or b.rows != n:
        raise ValueError(f"cannot solve {a.rows}x{a.columns} with {b.rows}x{b.columns}")
    if b.is_zero:
        return Matrix.zeros(graph, n, m)
    node = graph.intern(("solve", kind, n, m, *a.nodes, *b.nodes))
    return Matrix(graph, n, m, [graph.intern(("item", node, k)) for k in range(n * m)])


def ltl(a: Matrix) -> tuple[list[list[int]], list[int]]:
    """Factor A = Lᵀ D L from the last row up, symbolically, keeping structural zeros.

    Returns:
        Unit lower triangular L as rows of nodes, and the reciprocals of D.

    Source: Featherstone, Rigid Body Dynamics Algorithms, section 6.5.
    """
    g, n = a.graph, a.rows
    work = [list(a.row(i)) for i in range(n)]
    lower = [[ZERO] * n for _ in range(n)]
    inverse = [ZERO] * n
    for k in range(n - 1, -1, -1):
        inverse[k] = g.div(1, work[k][k])
        for i in range(k - 1, -1, -1):
            if work[k][i] == ZERO:
                continue
            lower[k][i] = g.mul(work[k][i], inverse[k])
            # row i loses its share of row k, only where row k has entries
            for j in range(i + 1):
                if work[k][j] != ZERO:
                    work[i][j] = g.sub(work[i][j], g.mul(lower[k][i], work[k][j]))
    return lower, inverse


def substitute(lower: list[list[int]], inverse: list[int], graph: Graph, b: list[int]) -> list[int]:
    """Solve Lᵀ D L x = b."""
    n, x = len(b), list(b)
    for k in range(n - 1, -1, -1):
        for j in range(k):
            if lower[k][j] != ZERO:
                x[j] = graph.sub(x[j], graph.mul(lower[k][j], x[k]))
    x = [graph.mul(inverse[k], x[k]) for k in range(n)]
    for k in range(n):
        for j in range(k):
            if lower[k][j] != ZERO:
                x[k] = graph.sub(x[k], graph.mul(lower[k][j], x[j]))
    return x


def inverted(lower: list[list[int]], graph: Graph) -> list[list[int]]:
    """S with L⁻¹ = 1 - S, strictly lower; what is 0 between branches stays 0."""
    n = len(lower)
    strict = [[ZERO] * n for _ in range(n)]
    for i in range(n):
        for j in range(i):
            column = [strict[k][j] for k in range(i)]
            strict[i][j] = graph.sub(lower[i][j], inner(graph, lower[i][:i], column))
    return strict


def multiply(strict: list[list[int]], d: list[int], graph: Graph, b: list[int]) -> list[int]:
    """x = L⁻¹ D⁻¹ L⁻ᵀ b, with S of :func:`inverted` and the reciprocals of D."""
    n = len(b)
    z = [graph.sub(b[j], inner(graph, [strict[k][j] for k in range(n)], b)) for j in range(n)]
    z = [graph.mul(d[j], z[j]) for j in range(n)]
    return [graph.sub(z[i], inner(graph, strict[i], z)) for i in range(n)]


Factor = tuple[list[list[int]], list[int]]


def unrolled(
    graph: Graph, n: int, m: int, entries: Sequence[int], factors: dict[tuple[int, ...], Factor]
) -> list[int]:
    """A positive definite system as straight-line expressions.

    Args:
        graph: Where the entries live.
        n, m: Rows of A, columns of B.
        entries: A and B, row by row.
        factors: Factors by the entries of their matrix; a known A is not factored again.

    Returns:
        X, row by row.
    """
    a, b = tuple(entries[: n * n]), entries[n * n :]
    if a not in factors:
        lower, inverse = factors[a] = ltl(Matrix(graph, n, n, a))
        owner = graph.origin[0]
        # names for the reader: rows of L and reciprocals of D
        for k in range(n):
            graph.label(inverse[k], owner, f"D_inverse_{k + 1}")
            for j in range(k):
                graph.label(lower[k][j], owner, f"L_{k + 1}_{j + 1}")
    lower, inverse = factors[a]
    if m > n and any(lower[k][j] == ZERO for k in range(n) for j in range(k)):
        # what is 0 in a column stays 0 in branches that it does not reach
        strict = inverted(lower, graph)
        columns = [multiply(strict, inverse, graph, list(b[j::m])) for j in range(m)]
    else:
        columns = [substitute(lower, inverse, graph, list(b[j::m])) for j in range(m)]
    return [columns[j][i] for i in range(n) for j in range(m)]
