"""Expressions in the notation that C shares with most languages.

Parentheses stand only where precedence needs them, but a + (b + c) keeps its own: floating-point
sums are computed in the order in which the expression graph has them. Commutative operators may
change sides and signs may move, which changes no bit.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from ...ir.graph import Node
from ...ir.ops import OPERATORS
from ..program.program import Scope

# how tightly a text holds together; a text that begins with "-" is not an ATOM
SUM, PRODUCT, ATOM = 0, 1, 2
ELSEWHERE = frozenset({"var", "solve", "item"})
Fragment = tuple[str, int]


def definitions(scope: Scope) -> tuple[dict[int, str], dict[int, Fragment]]:
    """Texts of the nodes of a scope.

    Returns:
        What every operator node is, and how every node is read: by name where it has one.
    """
    nodes, names, outside = scope.graph.nodes, scope.names, scope.outside
    texts: dict[int, str] = {}
    fragments: dict[int, Fragment] = {}
    for i in scope.order:
        node = nodes[i]
        op = node[0]
        name = names.get(i)
        if i in outside or op in ELSEWHERE:
            if name is not None:
                fragments[i] = name, ATOM
            continue
        if op in INFIX:
            fragment = INFIX[op](fragments[node[1]], fragments[node[2]])
        elif op == "const":
            fragment = repr(node[1]), ATOM if node[1] >= 0 else PRODUCT
        elif op == "neg":
            fragment = negated(fragments[node[1]])
        else:
            fragment = CALLS[op](scope, node, [fragments[k][0] for k in node[1:]]), ATOM
        texts[i] = fragment[0]
        fragments[i] = fragment if name is None else (name, ATOM)
    return texts, fragments


def sum_of(a: Fragment, b: Fragment) -> Fragment:
    """a + b."""
    (left, l), (right, r) = a, b
    if r == SUM:
        if l == SUM:
            return f"{left} + ({right})", SUM
        left, right = right, left
    if right[0] == "-":
        return f"{left} - {right[1:]}", SUM
    if left[0] == "-" and l == PRODUCT and r != SUM:
        return f"{right} - {left[1:]}", SUM
    return f"{left} + {right}", SUM


def difference_of(a: Fragment, b: Fragment) -> Fragment:
    """a - b."""
    left, (right, r) = a[0], b
    if r == SUM:
        return f"{left} - ({right})", SUM
    if right[0] == "-":
        return f"{left} + {right[1:]}", SUM
    return f"{left} - {right}", SUM


def product_of(a: Fragment, b: Fragment) -> Fragment:
    """a b."""
    (left, l), (right, r) = a, b
    if l == SUM:
        left, l = f"({left})", ATOM
    if r == SUM:
        right = f"({right})"
    elif r == PRODUCT or (l == ATOM and right[0].isdigit()):
        if l == ATOM:
            left, right = right, left
        else:
            right = f"({right})"
    return f"{left} * {right}", PRODUCT


def quotient_of(a: Fragment, b: Fragment) -> Fragment:
    """a / b."""
    (left, l), (right, r) = a, b
    if l == SUM:
        left = f"({left})"
    if r != ATOM:
        right = f"({right})"
    return f"{left} / {right}", PRODUCT


def negated(a: Fragment) -> Fragment:
    """-a."""
    text, level = a
    if level == SUM:
        return f"-({text})", PRODUCT
    return (text[1:] if text[0] == "-" else f"-{text}"), PRODUCT


INFIX: dict[str, Callable[[Fragment, Fragment], Fragment]] = {
    "add": sum_of,
    "sub": difference_of,
    "mul": product_of,
    "div": quotient_of,
}

Call = Callable[[Scope, Node, Sequence[str]], str]


def _function(name: str) -> Call:
    start = OPERATORS[name].c.split("(")[0]
    return lambda scope, node, read: f"{start}({', '.join(read)})"


def _stumpff(scope: Scope, node: Node, read: Sequence[str]) -> str:
    return f"cardan_stumpff({int(scope.graph.nodes[node[1]][1])}, {read[1]})"


def _table(scope: Scope, node: Node, read: Sequence[str]) -> str:
    graph = scope.graph
    number, derivative = int(graph.nodes[node[1]][1]), int(graph.nodes[node[2]][1])
    table = graph.tables[number]
    size = f"{len(table.coefficients)}, {len(table.coefficients[0])}"
    arrays = f"{scope.table(number)}_breaks, {scope.table(number)}_coefficients"
    return f"cardan_piecewise({size}, {arrays}, {derivative}, {read[2]})"


CALLS: dict[str, Call] = {
    name: _function(name) for name, operator in OPERATORS.items() if "(" in operator.c
} | {"stumpff": _stumpff, "table": _table}
