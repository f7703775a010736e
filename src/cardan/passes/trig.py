"""Trig: squares of sine and cosine that meet become one, tangents share sine and cosine.

``a s s + a c c`` becomes ``a``, ``1 - s s`` becomes ``c c``, and ``tan`` becomes ``s / c`` where
sine and cosine of its angle are there anyway. Nothing is replaced by more operations than it had.
"""

from __future__ import annotations

from collections.abc import Mapping

from ..ir.function import Function, operands
from ..ir.graph import ONE, Graph
from ..ir.rewrite import rebuild_function

# products with more sines and cosines than this are left alone
MOST = 8


def trig(function: Function) -> Function:
    """The function with sin² + cos² = 1 applied where both squares meet."""
    partner = _partners(function)
    products = _find(function, partner) if partner else {}
    if not products:
        return function
    nodes = function.graph.nodes

    def rule(target: Graph, i: int, copies: Mapping[int, int]) -> int | None:
        if i not in products:
            return None
        factors = [copies[k] for k in products[i]]
        if nodes[i][0] == "tan":
            return target.div(factors[0], factors[1])
        return _product(target, factors)

    return rebuild_function(function, rule)


def _partners(function: Function) -> dict[int, int]:
    """Sine -> cosine of the same angle and back."""
    sines: dict[int, int] = {}
    cosines: dict[int, int] = {}
    nodes = function.graph.nodes
    for i in function.live():
        if nodes[i][0] == "sin":
            sines[nodes[i][1]] = i
        elif nodes[i][0] == "cos":
            cosines[nodes[i][1]] = i
    both = {sines[x]: cosines[x] for x in sines if x in cosines}
    return both | {c: s for s, c in both.items()}


def _find(function: Function, partner: Mapping[int, int]) -> dict[int, list[int]]:
    """Nodes to replace -> the factors of the product that replaces them (of a tangent: s, c)."""
    nodes = function.graph.nodes
    angles = {nodes[x][1]: x for x in partner if nodes[x][0] == "sin"}
    products: dict[int, list[int]] = {}
    # node -> the sines and cosines among its factors
    marks: dict[int, tuple[int, ...]] = {x: (x,) for x in partner}
    uses: dict[int, int] = {}
    for i in function.live():
        node = nodes[i]
        op = node[0]
        # a product of few sines and cosines may take part in an addition formula
        if op == "mul":
            angle_marks = marks.get(node[1], ()) + marks.get(node[2], ())
            if angle_marks and len(angle_marks) <= MOST:
                marks[i] = angle_marks
        elif op == "add" and node[1] in marks and node[2] in marks:
            uses = uses or _uses(function)
            factors = _met(function.graph, node, marks, partner, products, uses)
            if factors is not None:
                products[i] = factors
                marks[i] = tuple(x for k in factors for x in marks.get(k, ()))
        # 1 - sin^2 is cos^2, and the reverse
        elif op == "sub" and node[1] == ONE and len(set(marks.get(node[2], ()))) == 1:
            x = marks[node[2]][0]
            if _factors(function.graph, node[2], products) == [x, x]:
                products[i] = [partner[x]] * 2
                marks[i] = (partner[x],) * 2
        elif op == "tan" and node[1] in angles:
            sine = angles[node[1]]
            products[i] = [sine, partner[sine]]
    return products


def _uses(function: Function) -> dict[int, int]:
    """Number of reads of each node."""
    uses = dict.fromkeys(function.roots, 1)
    for i in function.live():
        for k in operands(function.graph.nodes[i]):
            uses[k] = uses.get(k, 0) + 1
    return uses


def _met(
    graph: Graph,
    node: tuple[str, int, int],
    marks: Mapping[int, tuple[int, ...]],
    partner: Mapping[int, int],
    products: Mapping[int, list[int]],
    uses: Mapping[int, int],
) -> list[int] | None:
    """Common factors of the two terms of a sum, where the others are s s and c c."""
    _, a, b = node
    for x in set(marks[a]):
        if marks[a].count(x) < 2 or marks[b].count(partner[x]) < 2:
            continue
        left, right = _factors(graph, a, products), _factors(graph, b, products)
        for _ in range(2):
            left.remove(x)
            right.remove(partner[x])
        # the sum falls away, and the terms that nobody else reads
        spare = 1 + (uses[a] == 1) + (uses[b] == 1)
        if sorted(left) == sorted(right) and len(left) - 1 <= spare:
            return left
    return None


def _factors(graph: Graph, i: int, products: Mapping[int, list[int]]) -> list[int]:
    """Factors of a product, replaced nodes taken as what replaces them."""
    if i in products:
        return list(products[i])
    node = graph.nodes[i]
    if node[0] != "mul":
        return [i]
    return _factors(graph, node[1], products) + _factors(graph, node[2], products)


def _product(graph: Graph, factors: list[int]) -> int:
    """Product that squares what occurs twice, so that few multiplications are new."""
    root, odd = ONE, ONE
    for x in sorted(set(factors)):
        n = factors.count(x)
        odd = graph.mul(odd, x) if n % 2 else odd
        for _ in range(n // 2):
            root = graph.mul(root, x)
    return graph.mul(odd, graph.square(root)) if root != ONE else odd
