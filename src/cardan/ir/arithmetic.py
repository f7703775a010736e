"""Scalars with operators: a graph and a node, for formulas that people read."""

from __future__ import annotations

from typing import Union

from .graph import Graph

Number = Union[int, float, "Scalar"]


class Scalar:
    """One expression of a graph. Numbers mix in freely; graphs do not."""

    __slots__ = ("graph", "node")

    def __init__(self, graph: Graph, node: int) -> None:
        self.graph = graph
        self.node = node

    def __repr__(self) -> str:
        return f"Scalar({self.graph.nodes[self.node]})"

    def _other(self, other: Number) -> int:
        if isinstance(other, Scalar):
            if other.graph is not self.graph:
                raise ValueError("two expressions of different graphs cannot be combined")
            return other.node
        return self.graph.const(other)

    def _new(self, node: int) -> Scalar:
        return Scalar(self.graph, node)

    def __add__(self, other: Number) -> Scalar:
        return self._new(self.graph.add(self.node, self._other(other)))

    __radd__ = __add__

    def __sub__(self, other: Number) -> Scalar:
        return self._new(self.graph.sub(self.node, self._other(other)))

    def __rsub__(self, other: Number) -> Scalar:
        return self._new(self.graph.sub(self._other(other), self.node))

    def __mul__(self, other: Number) -> Scalar:
        return self._new(self.graph.mul(self.node, self._other(other)))

    __rmul__ = __mul__

    def __truediv__(self, other: Number) -> Scalar:
        return self._new(self.graph.div(self.node, self._other(other)))

    def __rtruediv__(self, other: Number) -> Scalar:
        return self._new(self.graph.div(self._other(other), self.node))

    def __neg__(self) -> Scalar:
        return self._new(self.graph.neg(self.node))

    def __pow__(self, exponent: float) -> Scalar:
        return self._new(self.graph.power(self.node, exponent))

    def note(self, word: str) -> Scalar:
        """Name it as a step to what is made here, see :meth:`.Graph.note`."""
        return self._new(self.graph.note(self.node, word))

    @property
    def value(self) -> float | None:
        """The number this is, or None."""
        return self.graph.value(self.node)

    def apply(self, op: str, *others: Number) -> Scalar:
        """An operator of the table with this as its first operand."""
        return self._new(self.graph.apply(op, self.node, *(self._other(o) for o in others)))


def sqrt(x: Scalar) -> Scalar:
    """Square root; its derivative at 0 is taken as 0."""
    return x.apply("sqrt")


def sin(x: Scalar) -> Scalar:
    return x.apply("sin")


def cos(x: Scalar) -> Scalar:
    return x.apply("cos")


def tan(x: Scalar) -> Scalar:
    return x.apply("tan")


def atan2(y: Scalar, x: Number) -> Scalar:
    """Angle of the point (x, y); its derivative at the origin is taken as 0."""
    return y.apply("atan2", x)


def select(condition: Scalar, then: Number, otherwise: Number) -> Scalar:
    """``then`` where the condition is not 0, else ``otherwise``; both sides are evaluated."""
    return condition.apply("select", then, otherwise)


def stumpff(k: int, x: Scalar) -> Scalar:
    """Stumpff function c_k(x), see :func:`cardan.ir.ops.stumpff`."""
    return Scalar(x.graph, x.graph.apply("stumpff", x.graph.const(float(k)), x.node))


def norm(*entries: Scalar) -> Scalar:
    """Length of a vector; its derivative is v/|v|, and 0 at v = 0."""
    squares = [x * x for x in entries]
    return sqrt(sum(squares[1:], squares[0]))
