"""Conversion of the user's values to expressions:

numbers to parameters, SymPy expressions to nodes.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any

from ..elements.quantity import Quantity, Ready, Value, written_unit
from ..elements.validation import TOO_DEEP
from ..errors import ModelError, brief, near
from ..ir.function import Function, Output, live, operands
from ..ir.graph import MINUS_ONE, ONE, ZERO, Graph
from ..ir.interpreter import evaluate
from ..ir.matrix import Matrix
from ..ir.ops import LEAVES
from ..ir.rewrite import rebuild
from ..scene import dimensions
from ..scene.checks import is_number
from ..scene.frame import rows_of
from ..scene.scene import SceneRecord
from ..spatial.numbers import check_axes, check_orthonormal, quarter_turns, roll_pitch_yaw
from .structural_parameters import BuiltIn
from .system import Nodes, Parameter

IDENTITY: Nodes = (ONE, ZERO, ZERO, ZERO, ONE, ZERO, ZERO, ZERO, ONE)
ORIGIN: Nodes = (ZERO, ZERO, ZERO)


class Converter:
    """Converts quantities of one model into nodes of one graph.

    A number becomes a parameter ``("var", "p", k)`` under its dotted name, except 0 anywhere and
    +-1 in ratios, which are structural: part of the form of the equations.

    Attributes:
        graph: Where the nodes live.
        parameters: Entries of p: declared ones first, then numbers in order of conversion.
        structural: Names and values of the numbers that are part of the form.
        used: Names of the symbols that some expression has.
        symbols: Names of the symbols an expression may have -> node.
        moving: Whether expressions may speak of more than parameters: of t, inputs and motion.
            Where bodies are and what they weigh may not.
        values: Numbers by dotted name that replace those written, as far as not yet used.
        same: Dotted name -> the name under which the same number is kept.
        built_in: Which parameters are written into the equations as numbers.
        fixing: Numbers, not expressions, are part of the form where this is set.
    """

    def __init__(self, model: SceneRecord, graph: Graph, built_in: BuiltIn | None = None) -> None:
        self.graph = graph
        self.built_in = built_in
        self.parameters: list[Parameter] = []
        self._defaults: list[float] = []
        self.structural: dict[str, float] = {}
        self.used: set[str] = set()
        self.moving = False
        self.fixing = False
        self.symbols: dict[str, int] = {}
        self.units: dict[str, str | None] = {}
        self.values = dict(model.values) | (built_in.values if built_in is not None else {})
        self._nodes: dict[str, int] = {}
        self.same: dict[str, str] = {}
        for entry in model.parameters.values():
            value = self.values.pop(entry.name, entry.value)
            node = self._parameter(entry.name, value, entry.unit, True)
            self._nodes[entry.name] = node
            self.define(entry.name, node, entry.unit if entry.stated else None)
        self._fixed = set(self.symbols)
        self.define("t", graph.var("t", 0))

    def define(self, name: str, node: int, unit: str | None = None) -> None:
        """Give a symbol its meaning; ``unit`` None fits anywhere."""
        self.symbols[name] = node
        self.units[name] = unit

    def _parameter(self, name: str, value: float, unit: str, declared: bool = False) -> int:
        if self.fixing or (self.built_in is not None and self.built_in.takes(name)):
            self.structural[name] = value
            return self.graph.const(value)
        self.parameters.append(Parameter(name, value, unit, declared))
        self._defaults.append(value)
        return self.graph.var("p", len(self.parameters) - 1)

    def scalar(self, value: Any, name: str, unit: str = "", ratio: bool = False) -> int:
        """One entry as written -> node.

        Raises:
            ModelError: not a finite number, or an expression with unknown symbols or wrong units.
        """
        if not is_number(value):
            return self.expression(value, name, unit)
        name = self.same.get(name, name)
        number = float(self.values.pop(name, value)) if self.values else float(value)
        if not math.isfinite(number):
            raise ModelError(f"'{name}' must be a finite number, not {number}")
        if number == 0.0 or (ratio and abs(number) == 1.0):
            self._build_in(name, number)
            return ZERO if number == 0.0 else ONE if number > 0 else MINUS_ONE
        if name in self._nodes:
            if name in self.same.values():
                return self._nodes[name]
            raise ModelError(f"the name '{name}' stands for two numbers; rename one of its owners")
        self.structural.pop(name, None)
        self._nodes[name] = self._parameter(name, number, unit)
        return self._nodes[name]

    def _build_in(self, name: str, number: float) -> None:
        """Note a structural number; a parameter of its name keeps it, for that one can be set."""
        if name not in self._nodes:
            self.structural[name] = number

    def converted(self, name: str, value: Value | None, unit: str) -> int:
        """The node of a number that was converted under this name, or of an expression."""
        name = self.same.get(name, name)
        if name in self._nodes:
            return self._nodes[name]
        if value is None or is_number(value):
            return self.graph.const(self.structural.get(name, float(value or 0.0)))
        return self.expression(value, name, unit)

    def defaults(self, nodes: Sequence[int], graph: Graph | None = None) -> list[float]:
        """Values of expressions of the parameters at their defaults.

        Args:
            nodes: The expressions.
            graph: Where they live, where that is a fork of this one's.
        """
        values = {"p": self._defaults}
        output = Output("values", (len(nodes),), tuple(nodes))
        values_at_defaults = evaluate(
            Function("values", graph or self.graph, (), (output,)), values
        )["values"]
        return [float(x) for x in values_at_defaults]

    def expression(self, value: Any, name: str, unit: str = "") -> int:
        """A SymPy expression -> node.

        Raises:
            ModelError: no expression, unknown symbols, unsupported functions or wrong units.
        """
        try:
            symbols = getattr(value, "free_symbols", None)
        except RecursionError:
            raise ModelError(f"'{name}' {TOO_DEEP}") from None
        if symbols is None:
            raise ModelError(f"'{name}': a number or an expression is wanted, not {brief(value)}")
        if hasattr(value, "shape"):
            raise ModelError(
                f"'{name}': one expression is wanted, not a matrix of shape {value.shape}; take "
                "its entries one by one, such as m[0]"
            )
        nodes_of_symbols = {
            symbol: self.symbols[symbol.name] for symbol in symbols if symbol.name in self.symbols
        }
        self.used.update(symbol.name for symbol in symbols)
        if not self.moving:
            self._check_fixed(nodes_of_symbols, name)
        if value.is_Symbol and value in nodes_of_symbols:
            node = nodes_of_symbols[value]
        else:
            from sympy import Symbol

            from ..ir.forms.sympy_bridge import from_sympy

            if len(nodes_of_symbols) < len(symbols):
                # the whole list, so that the message can suggest a near name
                nodes_of_symbols = {
                    Symbol(key): n for key, n in self.symbols.items()
                } | nodes_of_symbols
            try:
                node = from_sympy(self.graph, value, nodes_of_symbols)
            except ModelError as problem:
                raise ModelError(f"'{name}': {problem}") from problem
            except RecursionError:
                raise ModelError(f"'{name}' {TOO_DEEP}") from None
        try:
            dimensions.check(value, unit, self.units, name)
        except RecursionError:
            raise ModelError(f"'{name}' {TOO_DEEP}") from None
        return node

    def _check_fixed(self, nodes_of_symbols: Mapping[Any, int], name: str) -> None:
        for symbol in nodes_of_symbols:
            if symbol.name not in self._fixed:
                raise ModelError(
                    f"'{name}' may depend on parameters only; it has '{symbol.name}'. What moves a "
                    "body is a joint, with prescribed= where it is prescribed"
                )

    def vector(
        self,
        values: Sequence[object],
        name: str,
        unit: str = "",
        ratio: bool = False,
        labels: Sequence[str] = "xyz",
    ) -> Nodes:
        """Entries as written -> nodes; their names are ``name.x`` and so on."""
        return tuple(
            [
                self.scalar(value, f"{name}.{label}", unit, ratio)
                for value, label in zip(values, labels, strict=True)
            ]
        )

    def quantity(
        self, quantity: Quantity, name: str, sliding: bool = False
    ) -> tuple[int, int, Nodes]:
        """A quantity of an element -> rows, columns and nodes.

        Args:
            quantity: As written.
            name: Its dotted name.
            sliding: It belongs to a joint that slides: of a unit with two forms, such as
                "N*m*s/rad|N*s/m", the second holds.
        """
        unit = written_unit(quantity.unit, sliding)
        with self._local(quantity.local):
            return self._rows(quantity, name, unit)

    def _rows(self, quantity: Quantity, name: str, unit: str) -> tuple[int, int, Nodes]:
        value, ratio = quantity.value, quantity.ratio
        if isinstance(value, Ready):
            return value.rows, value.columns, self._ready(value, name)
        value = value.tolist() if hasattr(value, "tolist") else value
        if not isinstance(value, (list, tuple)):
            return 1, 1, (self.scalar(value, name, unit, ratio),)
        rows = [row if isinstance(row, (list, tuple)) else (row,) for row in value]
        columns = len(rows[0]) if rows else 0
        flat = [entry for row in rows for entry in row]
        labels: Sequence[str] = quantity.labels
        if not labels:
            vector = len(rows) <= 3 and columns == 1
            labels = "xyz"[: len(rows)] if vector else [str(k) for k in range(len(flat))]
        if quantity.units:
            each = zip(flat, labels, quantity.units, strict=True)
            nodes = [self.scalar(x, f"{name}.{label}", of, ratio) for x, label, of in each]
            return len(rows), columns, tuple(nodes)
        return len(rows), columns, self.vector(flat, name, unit, ratio, labels)

    def _ready(self, value: Ready, name: str) -> Nodes:
        """Expressions that are made already, with the symbols they speak of put in."""
        leaves = {}
        for node in live(value.graph, value.nodes):
            if value.graph.nodes[node][0] == "atom":
                symbol = value.graph.nodes[node][1]
                if symbol not in self.symbols:
                    raise ModelError(f"'{name}': symbol '{symbol}' is not known")
                leaves[node] = self.symbols[symbol]
                self.used.add(symbol)
        return tuple(rebuild(value.graph, value.nodes, leaves, into=self.graph)[1])

    @contextmanager
    def _local(self, names: Sequence[str]) -> Iterator[None]:
        """Symbols that stand for the coordinates of the element itself: placeholders."""
        if not names:
            yield
            return
        before = self.symbols, self.units, self._fixed
        local_symbols = {name: self.graph.atom(name) for name in names}
        self.symbols, self._fixed = self.symbols | local_symbols, self._fixed | set(local_symbols)
        self.units = {name: u for name, u in self.units.items() if name not in local_symbols}
        try:
            yield
        finally:
            self.symbols, self.units, self._fixed = before

    def finish(self) -> None:
        """All given values have been used.

        Raises:
            ModelError: one has a name that no number has.
        """
        if self.built_in is not None:
            self.built_in.finish(self.parameters, self.structural)
        for name in self.values:
            names = [*(parameter.name for parameter in self.parameters), *self.structural]
            listed = near(name, names).replace(" Known:", " Parameters:")
            raise ModelError(f"parameters: no number of the scene is called '{name}'.{listed}")

    # rotations

    def rotation(self, value: object, name: str) -> Nodes:
        """An orientation as written -> R (9), coordinates in its axes to coordinates outside.

        Raises:
            ModelError: not a rotation.
        """
        if value is None:
            return IDENTITY
        if hasattr(value, "as_matrix"):
            value = value.as_matrix()
        entries = rows_of(value)
        if len(entries) == 4 and isinstance(entries[0], str):
            return self.sequence(entries[0], entries[1:], name)
        rows = [rows_of(row) for row in entries]
        if len(rows) != 3 or any(len(row) != 3 for row in rows):
            raise ModelError(
                f"'{name}': a rotation is 3x3, a SciPy Rotation or like ('XYZ', a, b, c), "
                f"not {brief(value)}"
            )
        flat = [entry for row in rows for entry in row]
        labels = [i + j for i in "xyz" for j in "xyz"]
        if not all(is_number(entry) for entry in flat):
            return self.vector(flat, name, ratio=True, labels=labels)
        check_orthonormal(rows, name)
        if all(entry in (0, 1, -1) for entry in flat):
            return self.vector(flat, name, ratio=True, labels=labels)
        return self.sequence("xyz", roll_pitch_yaw(rows), name)

    def sequence(self, axes: str, angles: Sequence[object], name: str) -> Nodes:
        """Three turns in SciPy's case rule: "XYZ" about body-fixed, "xyz" about fixed axes."""
        check_axes(axes, name)
        labels = ("roll", "pitch", "yaw") if axes == "xyz" else ("angle1", "angle2", "angle3")
        turns = [
            self._turn(axis, self._angle(angle, f"{name}.{label}"))
            for axis, angle, label in zip(axes.lower(), angles, labels, strict=True)
        ]
        if axes.islower():
            turns.reverse()
        product = IDENTITY
        for turn in turns:
            product = compose(self.graph, product, turn)
        return product

    def _angle(self, value: Any, name: str) -> int | tuple[int, int]:
        """A node, or (cosine, sine) of an exact multiple of a quarter turn."""
        if not is_number(value) or not math.isfinite(value):
            return self.scalar(value, name, "rad")
        value = self.values.pop(name, value)
        turns = quarter_turns(float(value))
        if turns is None:
            return self.scalar(value, name, "rad")
        self._build_in(name, float(value))
        return ((ONE, ZERO), (ZERO, ONE), (MINUS_ONE, ZERO), (ZERO, MINUS_ONE))[turns % 4]

    def _turn(self, axis: str, angle: int | tuple[int, int]) -> Nodes:
        g = self.graph
        c, s = angle if isinstance(angle, tuple) else (g.apply("cos", angle), g.apply("sin", angle))
        n = g.neg(s)
        if axis == "x":
            return ONE, ZERO, ZERO, ZERO, c, n, ZERO, s, c
        if axis == "y":
            return c, ZERO, s, ZERO, ONE, ZERO, n, ZERO, c
        return c, n, ZERO, s, c, ZERO, ZERO, ZERO, ONE


def compose(graph: Graph, a: Nodes, b: Nodes) -> Nodes:
    """Product of two rotations (9)."""
    if a == IDENTITY:
        return b
    if b == IDENTITY:
        return a
    return (Matrix(graph, 3, 3, a) @ Matrix(graph, 3, 3, b)).nodes


def symmetric(entries: Nodes) -> Nodes:
    """Entries xx xy xz yy yz zz as a symmetric 3x3 (9)."""
    xx, xy, xz, yy, yz, zz = entries
    return xx, xy, xz, xy, yy, yz, xz, yz, zz


def parameters_only(graph: Graph, order: Sequence[int]) -> set[int]:
    """Nodes of a topological order that depend on parameters alone."""
    nodes, constant = graph.nodes, set[int]()
    for i in order:
        node = nodes[i]
        if (
            node[0] == "const"
            or node[:2] == ("var", "p")
            or (node[0] not in LEAVES and all(k in constant for k in operands(node)))
        ):
            constant.add(i)
    return constant
