"""Linear systems inside the straight line: nodes with several results.

``("solve", kind, n, m, A..., B...)`` is X with A X = B; ``("item", solve, k)`` is its k-th entry,
row by row. Entries of A that are structural zeros are its sparsity pattern.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from .graph import ZERO, Graph, SystemNames
from .matrix import Matrix, inner

KINDS = ("spd", "symmetric_indefinite", "rank_revealing", "semidefinite", "basic")
# of its diagonal entry: where the pivot of a row of a semidefinite matrix counts as zero
DEPENDENT = 1e-9
# of the largest diagonal entry: no row is measured by less, as nothing but rounding may be left
VANISHED = 1e-15
# of what is left of the row that depends least: rows with more are taken by their size
LEAST = 1e-3


def solve(kind: str, a: Matrix, b: Matrix, names: SystemNames | None = None) -> Matrix:
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
        names: Of matrix, rows and columns, for the reader.
    """
    if kind not in KINDS:
        raise ValueError(f"kind of solve must be one of {', '.join(KINDS)}, not {kind!r}")
    graph, n, m = a.graph, a.rows, b.columns
    if a.columns != n or b.rows != n:
        raise ValueError(f"cannot solve {a.rows}x{a.columns} with {b.rows}x{b.columns}")
    if b.is_zero:
        return Matrix.zeros(graph, n, m)
    node = graph.intern(("solve", kind, n, m, *a.nodes, *b.nodes))
    if names is not None:
        graph.systems.setdefault(node, names)
    return Matrix(graph, n, m, [graph.intern(("item", node, k)) for k in range(n * m)])


class _Namer:
    """Names the steps of an elimination after rows and columns of its system."""

    def __init__(self, graph: Graph, n: int, m: int, names: SystemNames | None) -> None:
        names = names or SystemNames(graph.origin[0], (), ())
        self.graph, self.name = graph, names.name
        self.rows, self.columns = (
            labels if len(labels) == size else tuple(str(k + 1) for k in range(size))
            for labels, size in ((names.rows, n), (names.columns, m))
        )

    def factor(self, node: int, letter: str, *rows: int) -> None:
        """An entry of a factor."""
        quantity = "_".join(["factor", letter, *(self.rows[k] for k in rows)])
        self.graph.hint(node, self.name, quantity)

    def column(self, j: int) -> Name:
        """Names the entries of a right side on its way to the solution."""
        owner = self.columns[j] or self.name

        def name(node: int, letter: str, row: int) -> None:
            self.graph.hint(node, owner, f"{letter}_{self.rows[row]}")

        return name


Rows = list[list[int]]
Name = Callable[..., None]


def _nameless(*_: object) -> None:
    """Steps need no names where nobody reads them."""


def ltl(a: Matrix, name: Name = _nameless) -> tuple[list[list[int]], list[int]]:
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
        name(work[k][k], "D", k)
        inverse[k] = g.div(1, work[k][k])
        for i in range(k - 1, -1, -1):
            if work[k][i] == ZERO:
                continue
            name(work[k][i], "DL", k, i)
            lower[k][i] = g.mul(work[k][i], inverse[k])
            # row i loses its share of row k, only where row k has entries
            for j in range(i + 1):
                if work[k][j] != ZERO:
                    work[i][j] = g.sub(work[i][j], g.mul(lower[k][i], work[k][j]))
    return lower, inverse


def substitute(
    lower: Rows, inverse: list[int], graph: Graph, b: list[int], name: Name = _nameless
) -> list[int]:
    """Solve Lᵀ D L x = b: Lᵀ y = b, D z = y, L x = z."""
    n, x = len(b), list(b)
    for k in range(n - 1, -1, -1):
        for j in range(k):
            if lower[k][j] != ZERO:
                x[j] = graph.sub(x[j], graph.mul(lower[k][j], x[k]))
    for k in range(n):
        name(x[k], "y", k)
        x[k] = graph.mul(inverse[k], x[k])
        if any(lower[k][:k]):
            name(x[k], "z", k)
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


def multiply(
    lower: Rows, inverse: list[int], graph: Graph, b: list[int], name: Name = _nameless
) -> list[int]:
    """x = L⁻¹ D⁻¹ L⁻ᵀ b, with S of :func:`inverted` for ``lower``."""
    n = len(b)
    z = [graph.sub(b[j], inner(graph, [lower[k][j] for k in range(n)], b)) for j in range(n)]
    for j in range(n):
        name(z[j], "y", j)
        z[j] = graph.mul(inverse[j], z[j])
        if any(lower[j][:j]):
            name(z[j], "z", j)
    return [graph.sub(z[i], inner(graph, lower[i], z)) for i in range(n)]


Factor = tuple[list[list[int]], list[int]]


def factored(a: Matrix, names: SystemNames | None = None) -> Factor:
    """Same as :func:`ltl`, with names for the entries of the factors."""
    namer = _Namer(a.graph, a.rows, 0, names)
    lower, inverse = ltl(a, namer.factor)
    for k in range(a.rows):
        namer.factor(inverse[k], "D_inverse", k)
        for j in range(k):
            namer.factor(lower[k][j], "L", k, j)
    return lower, inverse


def unrolled(
    graph: Graph,
    n: int,
    m: int,
    entries: Sequence[int],
    factors: dict[tuple[int, ...], Factor],
    names: SystemNames | None = None,
) -> list[int]:
    """A positive definite system as straight-line expressions.

    Args:
        graph: Where the entries live.
        n, m: Rows of A, columns of B.
        entries: A and B, row by row.
        factors: Factors by the entries of their matrix; a known A is not factored again.
        names: Of matrix, rows and columns.

    Returns:
        X, row by row.
    """
    a, b = tuple(entries[: n * n]), entries[n * n :]
    namer = _Namer(graph, n, m, names)
    if a not in factors:
        factors[a] = factored(Matrix(graph, n, n, a), names)
    lower, inverse = factors[a]
    if m > n and any(lower[k][j] == ZERO for k in range(n) for j in range(k)):
        # what is 0 in a column stays 0 in branches that it does not reach
        strict = inverted(lower, graph)
        for k in range(n):
            for j in range(k):
                namer.factor(strict[k][j], "S", k, j)
        solve_for, left = multiply, strict
    else:
        solve_for, left = substitute, lower
    columns = [solve_for(left, inverse, graph, list(b[j::m]), namer.column(j)) for j in range(m)]
    return [columns[j][i] for i in range(n) for j in range(m)]
