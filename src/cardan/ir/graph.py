"""The expression graph: interned nodes in topological order, simplified as they are made.

Nodes are small tuples in one list; an expression is the index of its node. Operands always have
smaller indices, so the list order is a valid order of evaluation and every pass is one loop.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import lru_cache
from typing import Any, NamedTuple

from ..errors import DerivationError, StructuralZero
from .ops import COMMUTATIVE, OPERATORS
from .table import Table

Node = tuple[Any, ...]
Origin = tuple[str, str]

ZERO, ONE, MINUS_ONE = 0, 1, 2
# sines and cosines are called after their angles
NAMED_ALREADY = frozenset({"const", "var", "atom", "sin", "cos"})
NO_ORIGIN: Origin = ("", "")
# of a docstring: ``omega = Rᵀ omega_parent + S_w u``
FORMULA = re.compile(r"``(\w+) = ([^`]+)``")


class SystemNames(NamedTuple):
    """Names of a linear system: its matrix, its unknowns and its right sides."""

    name: str
    rows: tuple[str, ...]
    columns: tuple[str, ...]


@lru_cache(maxsize=1024)
def _formulas(step: object, parts: bool) -> list[tuple[str, str]]:
    """Left sides and formulas in the docstring of a step, and of the methods of a class."""
    read = (step, *vars(step).values()) if parts and isinstance(step, type) else (step,)
    pairs = [pair for part in read for pair in FORMULA.findall(part.__doc__ or "")]
    return [(left, " ".join(f"{left} = {right}".split())) for left, right in pairs]


class Graph:
    """Hash-consed scalar expressions.

    Attributes:
        nodes: ``nodes[i]`` is ``(operator, operand, ...)``; the first three are 0, 1 and -1.
        origins: ``origins[i]`` is the (owner, quantity) that made node i first.
        shared: further origins of a node, where several owners use it.
        labels: readable names given to nodes, (owner, quantity) with the component in quantity.
        hints: the same for nodes that need not be shown; those that are have these names.
        formulas: quantity -> formula of the step that derived it, see :meth:`describe`.
        systems: names of the rows and columns of ``solve`` nodes.
        tables: the interpolation tables that ``table`` nodes refer to.
    """

    __slots__ = (
        *("_index", "formulas", "hints", "labels", "nodes", "origin", "origins"),
        *("shared", "systems", "tables"),
    )

    def __init__(self) -> None:
        self.nodes: list[Node] = [("const", 0.0), ("const", 1.0), ("const", -1.0)]
        self._index: dict[Node, int] = {node: i for i, node in enumerate(self.nodes)}
        self.origin: Origin = NO_ORIGIN
        self.origins: list[Origin] = [NO_ORIGIN] * 3
        self.shared: dict[int, set[Origin]] = {}
        self.labels: dict[int, Origin] = {}
        self.hints: dict[int, Origin] = {}
        self.formulas: dict[str, str] = {}
        self.systems: dict[int, SystemNames] = {}
        self.tables: list[Table] = []

    def __len__(self) -> int:
        return len(self.nodes)

    def __repr__(self) -> str:
        return f"Graph({len(self.nodes)} nodes)"

    def fork(self) -> Graph:
        """An independent copy in which all present indices stay valid."""
        other = Graph()
        for name in set(Graph.__slots__) - {"origin"}:
            setattr(other, name, getattr(self, name).copy())
        other.shared = {k: set(v) for k, v in self.shared.items()}
        return other

    @contextmanager
    def made_by(self, owner: str, quantity: str = "") -> Iterator[None]:
        """Nodes made in this block belong to ``quantity`` of ``owner``."""
        before = self.origin
        self.origin = (owner, quantity)
        try:
            yield
        finally:
            self.origin = before

    def describe(self, step: object, kind: str = "") -> Graph:
        """Take the formulas of a step of the derivation from its docstring, for readers of code.

        Each stands in double backticks there, its left side being the quantity that nodes are made
        or labeled under. Those of a class stand in its docstring and in those of its methods;
        ``kind`` is the quantity where it is a class of elements. Returns the graph.
        """
        for left, text in _formulas(step, parts=not kind):
            self.formulas.setdefault(kind or left, text)
        return self

    def description_of(self, name: str) -> str:
        """The quantity with a formula that begins a name, ``G`` of ``G_px_rod``; "" for none."""
        while name and name not in self.formulas:
            name = name.rpartition("_")[0]
        return name

    def label(self, node: int, owner: str, quantity: str) -> int:
        """Give a node a readable name; the first name stays. Leaves need none."""
        op = self.nodes[node][0]
        if op == "neg":
            return self.hint(node, owner, quantity)
        if op not in NAMED_ALREADY:
            self.labels.setdefault(node, (owner, quantity))
        return node

    def hint(self, node: int, owner: str, quantity: str) -> int:
        """Give a node the name that it has where it is shown; the first name stays."""
        op = self.nodes[node][0]
        if op in NAMED_ALREADY:
            return node
        self.hints.setdefault(node, (owner, quantity))
        # a changed sign is written where it is read: what has the name is shown
        if op == "neg":
            plain = quantity.removeprefix("minus_")
            self.hint(
                self.nodes[node][1], owner, f"minus_{quantity}" if plain == quantity else plain
            )
        return node

    def note(self, node: int, word: str) -> int:
        """Give a node the name of a step to what is made here, see :meth:`made_by`."""
        owner, quantity = self.origin
        # what belongs to nobody needs no more than the word
        return self.hint(node, owner, f"{quantity}_{word}" if owner and quantity else word)

    def adopt(self, copy: int, other: Graph, i: int) -> None:
        """Give a node the names that node i of another graph has, whose value it has."""
        label, hint = other.labels.get(i), other.hints.get(i)
        if label:
            self.label(copy, *label)
        if hint:
            self.hint(copy, *hint)
        if i in other.systems:
            self.systems.setdefault(copy, other.systems[i])

    # leaves

    def intern(self, key: Node) -> int:
        """Index of the node, made if it is new. No simplification."""
        node = self._index.get(key)
        if node is None:
            node = len(self.nodes)
            self._index[key] = node
            self.nodes.append(key)
            self.origins.append(self.origin)
        elif self.origins[node] is not self.origin and self.origins[node] != self.origin:
            self.shared.setdefault(node, set()).add(self.origin)
        return node

    def const(self, value: float) -> int:
        """A finite number.

        Raises:
            DerivationError: the value is NaN or infinite.
        """
        value = float(value) + 0.0  # -0.0 becomes 0.0
        if not math.isfinite(value):
            raise DerivationError(f"a constant of an expression must be finite, not {value}")
        return self.intern(("const", value))

    def var(self, block: str, k: int) -> int:
        """Entry k of an input block."""
        return self.intern(("var", block, k))

    def atom(self, name: str) -> int:
        """A named placeholder."""
        return self.intern(("atom", name))

    def value(self, node: int) -> float | None:
        """The number a constant node holds, None for any other node."""
        entry = self.nodes[node]
        return entry[1] if entry[0] == "const" else None

    # arithmetic with local simplification

    def add(self, a: int, b: int) -> int:
        if a == 0:
            return b
        if b == 0:
            return a
        na, nb = self.nodes[a], self.nodes[b]
        if nb[0] == "neg":
            return self.sub(a, nb[1])
        if na[0] == "neg":
            return self.sub(b, na[1])
        if na[0] == "const" and nb[0] == "const":
            return self.const(na[1] + nb[1])
        return self.intern(("add", a, b) if a < b else ("add", b, a))

    def sub(self, a: int, b: int) -> int:
        if b == 0:
            return a
        if a == 0:
            return self.neg(b)
        if a == b:
            return 0
        na, nb = self.nodes[a], self.nodes[b]
        if nb[0] == "neg":
            return self.add(a, nb[1])
        if na[0] == "neg":
            return self.neg(self.add(na[1], b))
        if na[0] == "const" and nb[0] == "const":
            return self.const(na[1] - nb[1])
        if ("sub", b, a) in self._index:
            return self.neg(self.intern(("sub", b, a)))
        return self.intern(("sub", a, b))

    def neg(self, a: int) -> int:
        if a == 0:
            return 0
        na = self.nodes[a]
        if na[0] == "neg":
            return int(na[1])
        if na[0] == "const":
            return self.const(-na[1])
        return self.intern(("neg", a))

    def mul(self, a: int, b: int) -> int:
        if a == 0 or b == 0:
            return 0
        if a == 1:
            return b
        if b == 1:
            return a
        if a == 2:
            return self.neg(b)
        if b == 2:
            return self.neg(a)
        na, nb = self.nodes[a], self.nodes[b]
        if na[0] == "neg":
            return self.neg(self.mul(na[1], b))
        if nb[0] == "neg":
            return self.neg(self.mul(a, nb[1]))
        if na[0] == "const":
            if nb[0] == "const":
                return self.const(na[1] * nb[1])
            if na[1] < 0:
                return self.neg(self.mul(self.const(-na[1]), b))
        elif nb[0] == "const" and nb[1] < 0:
            return self.neg(self.mul(a, self.const(-nb[1])))
        return self.intern(("mul", a, b) if a < b else ("mul", b, a))

    def div(self, a: int, b: int) -> int:
        """a / b.

        Raises:
            StructuralZero: b is the number 0.
        """
        if b == 0:
            raise StructuralZero("an expression divides by a structural zero")
        if a == 0:
            return 0
        if b == 1:
            return a
        if b == 2:
            return self.neg(a)
        if a == b:
            return 1
        na, nb = self.nodes[a], self.nodes[b]
        if na[0] == "neg":
            return self.neg(self.div(na[1], b))
        if nb[0] == "neg":
            return self.neg(self.div(a, nb[1]))
        if na[0] == "const" and nb[0] == "const":
            return self.const(na[1] / nb[1])
        return self.intern(("div", a, b))

    def square(self, a: int) -> int:
        return self.mul(a, a)

    def power(self, a: int, exponent: float) -> int:
        """a to a constant power; small integers and halves become products and roots."""
        if exponent == 0:
            return ONE
        if exponent < 0:
            return self.div(ONE, self.power(a, -exponent))
        if exponent == int(exponent) and exponent <= 16:
            n = int(exponent)
            half = self.power(a, n // 2) if n > 1 else ONE
            result = self.mul(half, half)
            return self.mul(result, a) if n % 2 else result
        if exponent == int(exponent) + 0.5 and exponent <= 16:
            return self.mul(self.power(a, int(exponent)), self.apply("sqrt", a))
        return self.apply("pow", a, self.const(exponent))

    def apply(self, op: str, *operands: int) -> int:
        """Any operator of the table, folded where all operands are numbers.

        Raises:
            ValueError: a number outside the domain of the operator.
        """
        special = _CONSTRUCTORS.get(op)
        if special is not None:
            return special(self, *operands)
        if op == "select":
            condition = self.value(operands[0])
            if condition is not None:
                return operands[1] if condition else operands[2]
            if operands[1] == operands[2]:
                return operands[1]
        if op != "table" and all(self.nodes[a][0] == "const" for a in operands):
            try:
                return self.const(OPERATORS[op].value(*(self.nodes[a][1] for a in operands)))
            except (ValueError, OverflowError) as problem:
                values = ", ".join(str(self.nodes[a][1]) for a in operands)
                raise ValueError(f"{op}({values}) is not a finite number") from problem
        first = self.nodes[operands[0]]
        if op == "sqrt" and first[0] == "mul" and first[1] == first[2]:
            return self.apply("abs", first[1])
        if first[0] == "neg" and op in _EVEN:
            return self.apply(op, first[1])
        if first[0] == "neg" and op in _ODD:
            return self.neg(self.apply(op, first[1]))
        if op in COMMUTATIVE:
            operands = tuple(sorted(operands))
        return self.intern((op, *operands))

    def interpolate(self, table: Table, x: int, derivative: int = 0) -> int:
        """Value or derivative of an interpolation table at x."""
        if table not in self.tables:
            self.tables.append(table)
        number = self.const(float(self.tables.index(table)))
        return self.intern(("table", number, self.const(float(derivative)), x))


_EVEN = frozenset({"cos", "cosh", "abs"})
_ODD = frozenset({"sin", "tan", "asin", "atan", "sinh", "tanh", "asinh", "atanh", "sign"})
_CONSTRUCTORS: dict[str, Callable[..., int]] = {
    "add": Graph.add,
    "sub": Graph.sub,
    "mul": Graph.mul,
    "div": Graph.div,
    "neg": Graph.neg,
}
