"""Derivatives of expressions as expressions of the same graph.

Source: Griewank and Walther, Evaluating Derivatives (2008), chapter 3.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager

from .function import live, operands
from .graph import NO_ORIGIN, ONE, ZERO, Graph
from .matrix import Matrix, inner
from .ops import LEAVES
from .partials import PARTIALS, choice
from .solve import solve

CHOICES = frozenset({"select", "min", "max"})
UNSYMMETRIC = frozenset({"rank_revealing", "basic"})


def forward(
    graph: Graph, roots: Sequence[int], seeds: Mapping[int, int], word: str = ""
) -> list[int]:
    """Derivatives of the roots along a direction.

    Args:
        graph: Where the roots live; the derivatives are added to it.
        roots: Nodes to differentiate.
        seeds: Node -> node of its derivative. These are the independent variables; all other
            leaves have derivative 0.
        word: Added to the name of what is differentiated, names the derivative.

    Returns:
        One node per root.
    """
    dots = dict(seeds)
    solutions: dict[int, list[int]] = {}
    nodes = graph.nodes
    with _origins(graph) as belongs:
        for i in live(graph, roots):
            if i in dots or nodes[i][0] in LEAVES:
                continue
            belongs(i)
            dot = _dot(graph, i, dots, solutions)
            if dot != ZERO:
                dots[i] = dot
                name = graph.labels.get(i) or graph.hints.get(i) if word else None
                if name is not None:
                    graph.hint(dot, name[0], f"{name[1]}_{word}")
    return [dots.get(i, ZERO) for i in roots]


def _dot(graph: Graph, i: int, dots: Mapping[int, int], solutions: dict[int, list[int]]) -> int:
    """Derivative of one node from those of its operands."""
    node = graph.nodes[i]
    op, x = node[0], node[1:]
    if op == "item":
        return solutions[x[0]][x[1]] if x[0] in solutions else ZERO
    if op == "solve":
        _solve_forward(graph, i, dots, solutions)
        return ZERO
    d = [dots.get(k, ZERO) for k in x]
    if not any(d):
        return ZERO
    if op in ("add", "sub", "neg"):
        return graph.apply(op, *d)
    if op == "mul":
        return graph.add(graph.mul(d[0], x[1]), graph.mul(x[0], d[1]))
    if op == "div":
        return graph.div(graph.sub(d[0], graph.mul(i, d[1])), x[1])
    if op in CHOICES:
        condition, a, b = choice(graph, op, x)
        return graph.apply("select", condition, dots.get(a, ZERO), dots.get(b, ZERO))
    total = ZERO
    for k, dk in enumerate(d):
        if dk != ZERO:
            total = graph.add(total, graph.mul(PARTIALS[op][k](graph, i, x), dk))
    return total


def _solve_forward(
    graph: Graph, i: int, dots: Mapping[int, int], solutions: dict[int, list[int]]
) -> None:
    """A X = B: X' solves A X' = B' - A' X."""
    kind, a, b, x = _system(graph, i)
    da, db = a.map(lambda k: dots.get(k, ZERO)), b.map(lambda k: dots.get(k, ZERO))
    right = db - da @ x
    if not right.is_zero:
        solutions[i] = list(solve(kind, a, right).nodes)


def _system(graph: Graph, i: int) -> tuple[str, Matrix, Matrix, Matrix]:
    """Kind, A, B and X of a solve node."""
    _, kind, n, m, *entries = graph.nodes[i]
    a = Matrix(graph, n, n, entries[: n * n])
    b = Matrix(graph, n, m, entries[n * n :])
    x = Matrix(graph, n, m, [graph.intern(("item", i, k)) for k in range(n * m)])
    return kind, a, b, x


@contextmanager
def _origins(graph: Graph) -> Iterator[Callable[[int], None]]:
    """Derivatives belong to who asks for them, or else to the owner of what is differentiated.

    Yields:
        To be called with every node before its derivative is made.
    """
    before = graph.origin

    def inherit(i: int) -> None:
        graph.origin = graph.origins[i]

    def leave(i: int) -> None:
        graph.origin = before

    try:
        yield inherit if before == NO_ORIGIN else leave
    finally:
        graph.origin = before


def gradient(graph: Graph, root: int, wrt: Sequence[int]) -> list[int]:
    """Derivatives of one node with respect to many, in one sweep from the root inwards.

    Args:
        graph: Where the root lives; the derivatives are added to it.
        root: Node to differentiate.
        wrt: The independent variables.

    Returns:
        One node per entry of ``wrt``.
    """
    independent = set(wrt)
    order = live(graph, [root])
    active = _depends(graph, order, independent)
    bars: dict[int, int] = {root: ONE}
    items: dict[int, dict[int, int]] = {}
    with _origins(graph) as belongs:
        for i in reversed(order):
            if i not in active or i in independent:
                continue
            belongs(i)
            if graph.nodes[i][0] == "solve":
                pulled = _solve_reverse(graph, i, items.get(i, {}))
            elif i in bars:
                pulled = _pull_chosen(graph, i, bars[i], active, items)
            else:
                continue
            for k, bar in pulled:
                if k in active:
                    bars[k] = _sum(graph, bars.get(k, ZERO), bar)
    return [bars.get(i, ZERO) for i in wrt]


def _depends(graph: Graph, order: Sequence[int], independent: set[int]) -> set[int]:
    """Nodes of a topological order that depend on the independent variables."""
    active: set[int] = set()
    for i in order:
        if i in independent or not active.isdisjoint(operands(graph.nodes[i])):
            active.add(i)
    return active


def _pull_chosen(
    graph: Graph, i: int, bar: int, active: set[int], items: dict[int, dict[int, int]]
) -> list[tuple[int, int]]:
    """Same as :func:`_pull`, with choices kept outermost.

    A side that is not taken may be infinite, and 0 times infinity would spoil the side that is.
    """
    node = graph.nodes[bar]
    if node[0] != "select" or graph.nodes[i][0] == "item" or ZERO not in node[2:]:
        return _pull(graph, i, bar, active, items)
    _, condition, then, otherwise = node
    pulled = _pull(graph, i, then or otherwise, active, items)
    if then:
        return [(k, graph.apply("select", condition, x, ZERO)) for k, x in pulled]
    return [(k, graph.apply("select", condition, ZERO, x)) for k, x in pulled]


def _sum(graph: Graph, a: int, b: int) -> int:
    """a + b; two choices by one condition become one."""
    x, y = graph.nodes[a], graph.nodes[b]
    if x[0] == y[0] == "select" and x[1] == y[1]:
        return graph.apply("select", x[1], graph.add(x[2], y[2]), graph.add(x[3], y[3]))
    return graph.add(a, b)


def _pull(
    graph: Graph, i: int, bar: int, active: set[int], items: dict[int, dict[int, int]]
) -> list[tuple[int, int]]:
    """Derivative contributions of a node to its operands: (operand, share)."""
    node = graph.nodes[i]
    op, x = node[0], node[1:]
    if op == "item":
        items.setdefault(x[0], {})[x[1]] = bar
        return []
    if op == "add":
        return [(x[0], bar), (x[1], bar)]
    if op == "sub":
        return [(x[0], bar), (x[1], graph.neg(bar))]
    if op == "neg":
        return [(x[0], graph.neg(bar))]
    if op == "mul":
        return [(x[0], graph.mul(bar, x[1])), (x[1], graph.mul(bar, x[0]))]
    if op == "div":
        share = graph.div(bar, x[1])
        return [(x[0], share), (x[1], graph.neg(graph.mul(share, i)))]
    if op in CHOICES:
        condition, a, b = choice(graph, op, x)
        taken = graph.apply("select", condition, bar, ZERO)
        return [(a, taken), (b, graph.apply("select", condition, ZERO, bar))]
    return [
        (k, graph.mul(PARTIALS[op][at](graph, i, x), bar)) for at, k in enumerate(x) if k in active
    ]


def _solve_reverse(graph: Graph, i: int, bars: Mapping[int, int]) -> list[tuple[int, int]]:
    """A X = B: B_bar solves Aᵀ B_bar = X_bar, and A_bar = -B_bar Xᵀ."""
    kind, a, b, x = _system(graph, i)
    n, m = b.rows, b.columns
    adjoint = Matrix(graph, n, m, [bars.get(k, ZERO) for k in range(n * m)])
    if adjoint.is_zero:
        return []
    b_bar = solve(kind, a.T if kind in UNSYMMETRIC else a, adjoint)
    a_bar = -(b_bar @ x.T)
    return [*zip(b.nodes, b_bar.nodes, strict=True), *zip(a.nodes, a_bar.nodes, strict=True)]


def directional(
    graph: Graph,
    roots: Sequence[int],
    directions: Sequence[Mapping[int, int]],
    labels: Sequence[str] = (),
) -> list[list[int]]:
    """Derivatives of all roots along all directions: column by column, one per direction.

    Forward by columns, or backward by rows where there are fewer rows.

    Args:
        graph: Where the roots live; the derivatives are added to it.
        roots: Nodes to differentiate.
        directions: Node -> node of its derivative, as :func:`forward` takes them.
        labels: For the names of derivatives by columns, one per direction.
    """
    variable_roots = [root for root in dict.fromkeys(roots) if graph.value(root) is None]
    if len(variable_roots) >= len(directions):
        each = labels or [""] * len(directions)
        return [forward(graph, roots, *one) for one in zip(directions, each, strict=True)]
    leaves = list(dict.fromkeys(node for seeds in directions for node in seeds))
    place = {node: n for n, node in enumerate(leaves)}
    rows = {root: gradient(graph, root, leaves) for root in variable_roots}
    return [
        [
            inner(graph, [rows[root][place[n]] for n in seeds], list(seeds.values()))
            if root in rows
            else ZERO
            for root in roots
        ]
        for seeds in directions
    ]


def jacobian(graph: Graph, roots: Sequence[int], wrt: Sequence[int]) -> list[list[int]]:
    """Derivatives of all roots with respect to all of ``wrt``: row by row, one row per root."""
    columns = directional(graph, roots, [{node: ONE} for node in wrt])
    return [[column[i] for column in columns] for i in range(len(roots))]
