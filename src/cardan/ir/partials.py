"""Partial derivatives of the operators, exact, and defined where the operator has a corner.

At a corner the derivative is the value that keeps compositions finite: 0 for the square root at 0
(so the derivative of a norm is v/|v|, and 0 at v = 0), for the angle of the origin and for |x|
at 0. Floor, comparisons and logic have derivative 0.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

from .graph import ONE, ZERO, Graph

# graph, the node, its operands -> derivative of the node with respect to one operand
Partial: TypeAlias = Callable[[Graph, int, tuple[int, ...]], int]


def guarded(graph: Graph, at: int, value: int) -> int:
    """The value, or 0 where ``at`` is 0."""
    return graph.apply("select", at, value, ZERO)


def _sqrt(g: Graph, i: int, x: tuple[int, ...]) -> int:
    return guarded(g, i, g.div(g.const(0.5), i))


def _root_of_circle(g: Graph, x: int) -> int:
    """1/sqrt(1 - x^2), and 0 at the ends."""
    root = g.apply("sqrt", g.mul(g.sub(ONE, x), g.add(ONE, x)))
    return guarded(g, root, g.div(ONE, root))


def _root_of_hyperbola(g: Graph, x: int) -> int:
    """1/sqrt(x^2 - 1), and 0 at 1."""
    root = g.apply("sqrt", g.mul(g.sub(x, ONE), g.add(ONE, x)))
    return guarded(g, root, g.div(ONE, root))


def _inverse_square(g: Graph, x: int) -> int:
    inverse = g.div(ONE, x)
    return g.mul(inverse, inverse)


def _atan2(g: Graph, x: tuple[int, ...], k: int) -> int:
    """x/(x² + y²) and -y/(x² + y²), 0 at the origin."""
    squares = g.add(g.square(x[0]), g.square(x[1]))
    return guarded(g, squares, g.div(x[1] if k == 0 else g.neg(x[0]), squares))


def _power_base(g: Graph, i: int, x: tuple[int, ...]) -> int:
    """b a^(b - 1), 0 where a negative power of 0 would stand."""
    exponent = g.value(x[1])
    if exponent is None:
        return guarded(g, x[0], g.mul(x[1], g.apply("pow", x[0], g.sub(x[1], ONE))))
    value = g.mul(x[1], g.power(x[0], exponent - 1.0))
    return value if exponent >= 1.0 else guarded(g, x[0], value)


def _power_exponent(g: Graph, i: int, x: tuple[int, ...]) -> int:
    return guarded(g, x[0], g.mul(i, g.apply("log", x[0])))


def _stumpff(g: Graph, i: int, x: tuple[int, ...]) -> int:
    """c_k' = (k c_{k+2} - c_{k+1}) / 2."""
    k = g.value(x[0]) or 0.0
    first = g.apply("stumpff", g.const(k + 1.0), x[1])
    second = g.apply("stumpff", g.const(k + 2.0), x[1])
    return g.mul(g.const(0.5), g.sub(g.mul(x[0], second), first))


def _table(g: Graph, i: int, x: tuple[int, ...]) -> int:
    """The next derivative of the polynomial pieces."""
    table = g.tables[int(g.value(x[0]) or 0.0)]
    derivative = int(g.value(x[1]) or 0.0) + 1
    return ZERO if derivative >= table.order else g.interpolate(table, x[2], derivative)


def _nothing(g: Graph, i: int, x: tuple[int, ...]) -> int:
    return ZERO


PARTIALS: dict[str, tuple[Partial, ...]] = {
    "sqrt": (_sqrt,),
    "sin": (lambda g, i, x: g.apply("cos", x[0]),),
    "cos": (lambda g, i, x: g.neg(g.apply("sin", x[0])),),
    "tan": (lambda g, i, x: g.add(ONE, g.square(i)),),
    "asin": (lambda g, i, x: _root_of_circle(g, x[0]),),
    "acos": (lambda g, i, x: g.neg(_root_of_circle(g, x[0])),),
    "atan": (lambda g, i, x: g.div(ONE, g.add(ONE, g.square(x[0]))),),
    "atan2": (lambda g, i, x: _atan2(g, x, 0), lambda g, i, x: _atan2(g, x, 1)),
    "exp": (lambda g, i, x: i,),
    "log": (lambda g, i, x: g.div(ONE, x[0]),),
    "sinh": (lambda g, i, x: g.apply("cosh", x[0]),),
    "cosh": (lambda g, i, x: g.apply("sinh", x[0]),),
    # 1 - tanh^2 would lose its digits where tanh is near 1
    "tanh": (lambda g, i, x: _inverse_square(g, g.apply("cosh", x[0])),),
    "asinh": (lambda g, i, x: g.div(ONE, g.apply("sqrt", g.add(ONE, g.square(x[0])))),),
    "acosh": (lambda g, i, x: _root_of_hyperbola(g, x[0]),),
    "atanh": (lambda g, i, x: g.div(ONE, g.mul(g.sub(ONE, x[0]), g.add(ONE, x[0]))),),
    "pow": (_power_base, _power_exponent),
    "abs": (lambda g, i, x: g.apply("sign", x[0]),),
    "stumpff": (_nothing, _stumpff),
    "table": (_nothing, _nothing, _table),
} | dict.fromkeys(("sign", "floor", "not"), (_nothing,))

# operators whose derivative is 0 wherever it exists
PARTIALS |= dict.fromkeys(("lt", "le", "eq", "and", "or"), (_nothing, _nothing))


def choice(g: Graph, op: str, x: tuple[int, ...]) -> tuple[int, int, int]:
    """Condition, and the operands it chooses between, of ``select``, ``min`` and ``max``."""
    if op == "select":
        return x[0], x[1], x[2]
    low, high = (x[0], x[1]) if op == "min" else (x[1], x[0])
    return g.apply("le", low, high), x[0], x[1]
