"""Functions for tests: small makers, and random expressions for hypothesis."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from hypothesis import strategies as st

from cardan.ir.function import Block, Function, Output
from cardan.ir.graph import Graph
from cardan.ir.interpreter import evaluate
from cardan.ir.matrix import Matrix
from cardan.ir.solve import solve

SIZES = {"q": 4, "u": 3, "p": 4}
STATE = {"q": [0.3, -0.7, 1.1, 0.45], "u": [0.9, -1.3, 0.2], "p": [1.5, 0.8, 2.25, 0.375]}


def function(graph: Graph, roots: Sequence[int], name: str = "f") -> Function:
    """A function with one result ``y`` of the blocks q, u and p."""
    blocks = tuple(
        Block(b, tuple(f"{b}{k}" for k in range(n)), ("",) * n) for b, n in SIZES.items()
    )
    return Function(name, graph, blocks, (Output("y", (len(roots),), tuple(roots)),))


def y(f: Function, values: dict[str, list[Any]] | None = None, *how: Any) -> list[Any]:
    """The result of such a function, at STATE by default."""
    result: list[Any] = evaluate(f, values or STATE, *how)["y"]
    return result


def leaves(graph: Graph) -> list[int]:
    return [graph.var(block, k) for block, n in SIZES.items() for k in range(n)]


SMOOTH = ("sin", "cos", "tanh", "atan", "asinh")
KINDS = (*("add", "sub", "mul", "add", "sub", "mul"), "neg", *SMOOTH, "sqrt", "div", "choice")


@st.composite
def functions(draw: st.DrawFn, most: int = 40) -> Function:
    """Random functions: shared subexpressions, squares of sine and cosine, choices, systems.

    Constants are short binary fractions, so that folding them is exact.
    """
    graph = Graph()
    nodes = [*leaves(graph), *(graph.const(c) for c in (0.0, 1.0, -1.0, 2.0, 0.5, -4.0))]

    def pick() -> int:
        # late nodes more often: deep expressions
        back = draw(st.integers(1, min(len(nodes), draw(st.sampled_from((6, len(nodes)))))))
        return nodes[-back]

    for _ in range(draw(st.integers(1, most))):
        nodes.append(_one(draw, graph, draw(st.sampled_from(KINDS)), pick))
    if draw(st.booleans()):
        nodes.extend(_system(draw, graph, pick))
    return function(graph, [pick() for _ in range(draw(st.integers(1, 4)))])


def _one(draw: st.DrawFn, graph: Graph, kind: str, pick: Any) -> int:
    if kind in ("add", "sub", "mul"):
        return graph.apply(kind, pick(), pick())
    if kind == "sqrt":
        return graph.apply("sqrt", graph.add(1, graph.square(_bounded(graph, pick()))))
    if kind == "div":
        return graph.div(pick(), graph.add(1, graph.square(_bounded(graph, pick()))))
    if kind == "choice":
        return graph.apply("select", graph.apply("lt", pick(), pick()), pick(), pick())
    x = pick()
    # a number inside a transcendental function would be folded to a rounded number
    return x if graph.value(x) is not None else graph.apply(kind, x)


def _bounded(graph: Graph, x: int) -> int:
    """Between -1 and 1, and no number: quotients of numbers would be folded to rounded ones."""
    return graph.apply("sin", graph.var("q", 0) if graph.value(x) is not None else x)


def _system(draw: st.DrawFn, graph: Graph, pick: Any) -> list[int]:
    """A positive definite system: L Lᵀ + 1 of bounded entries."""
    n, m = draw(st.integers(1, 3)), draw(st.integers(1, 2))
    lower = Matrix(graph, n, n, [_bounded(graph, pick()) for _ in range(n * n)])
    a = lower.congruence(Matrix.identity(graph, n)) + Matrix.identity(graph, n)
    b = Matrix(graph, n, m, [pick() for _ in range(n * m)])
    return list(solve("spd", a, b).nodes)
