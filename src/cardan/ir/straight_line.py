"""A Function as a Python function of floats, without a look at its graph at every call.

The function is built as a syntax tree of known nodes: no text is ever evaluated.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from itertools import islice
from types import CodeType, FunctionType
from typing import TypedDict

from .function import Function
from .graph import Node
from .interpreter import evaluate
from .numbers import FLOATS
from .ops import OPERATORS

Floats = Sequence[float]


class Location(TypedDict):
    """Where Python takes a node to stand in a source."""

    lineno: int
    col_offset: int


# of every node: ast.fix_missing_locations takes longer than all that builds them
PLACE: Location = {"lineno": 1, "col_offset": 0}
# calls that take as long as building and compiling the syntax tree
OFTEN = 20
ARITHMETIC = {"add": ast.Add, "sub": ast.Sub, "mul": ast.Mult, "div": ast.Div}
COMPARISONS: dict[str, type[ast.cmpop]] = {"lt": ast.Lt, "le": ast.LtE, "eq": ast.Eq}
# where Python raises and C goes on with infinity or NaN
OUTSIDE = (ValueError, OverflowError, ZeroDivisionError)


def repeated(function: Function, *results: str) -> RepeatedFunction:
    """A Function, or some of its results, for many calls with floats: the same one every time."""
    cache: dict[tuple[str, ...], RepeatedFunction] = function.__dict__.setdefault("_repeated", {})
    if results not in cache:
        outputs = tuple(o for o in function.outputs if not results or o.name in results)
        cache[results] = RepeatedFunction(replace(function, outputs=outputs))
    return cache[results]


class RepeatedFunction:
    """A Function for many calls: interpreted at first, a straight line once that pays.

    Args:
        function: The Function.
    """

    def __init__(self, function: Function) -> None:
        self.function, self.calls = function, 0
        self._line: Callable[..., list[float]] | None = None
        self._blocks = read(function)

    def __call__(self, values: Mapping[str, Floats]) -> dict[str, list[float]]:
        """Output name -> its entries, row by row, for block name -> its entries.

        Raises:
            ValueError: a block is missing or has another length. SolveError: as of the Function.
        """
        self.calls += 1
        if self._line is None and self.calls <= OFTEN:
            return evaluate(self.function, values)
        if self._line is None:
            self._line = straight_line(self.function)
        numbers = iter(self._line(*(values[name] for name in self._blocks)))
        return {o.name: list(islice(numbers, len(o.nodes))) for o in self.function.outputs}


def straight_line(function: Function) -> Callable[..., list[float]]:
    """The results of a function, one behind the other, as a function of its input blocks.

    It takes the blocks of :func:`read` in their order, sequences of floats, and gives the numbers
    that :func:`.interpreter.evaluate` gives, to the bit.

    Raises (the result):
        SolveError: a linear system has no solution.
    """
    quick, blocks = _compiled(function), read(function)

    def results(*values: Floats) -> list[float]:
        try:
            return quick(*values)
        except OUTSIDE:
            named = evaluate(function, dict(zip(blocks, values, strict=True)))
        return [x for output in function.outputs for x in named[output.name]]

    return results


def read(function: Function) -> tuple[str, ...]:
    """Names of the blocks that results depend on, in the order of the inputs."""
    nodes = function.graph.nodes
    names = {nodes[i][1] for i in function.live() if nodes[i][0] == "var"}
    return tuple(block.name for block in function.inputs if block.name in names)


def _compiled(function: Function) -> Callable[..., list[float]]:
    """The Python function; it raises where an operator leaves its domain."""
    graph, lines = function.graph, list[ast.stmt]()
    place: dict[str, object] = {name: op.value for name, op in OPERATORS.items()}
    for i in function.live():
        node = graph.nodes[i]
        if node[0] == "table":
            table, derivative = (int(graph.nodes[k][1]) for k in node[1:3])
            place[f"table_{i}"] = partial(FLOATS.table, graph.tables[table], derivative)
        elif node[0] == "solve":
            place[f"solve_{i}"] = partial(FLOATS.solve, *node[1:4])
        if node[0] != "const":
            name = ast.Name(f"v{i}", ast.Store(), **PLACE)
            lines.append(ast.Assign([name], _term(function, i, node), **PLACE))
    results = [_value(function, k) for k in function.roots]
    lines.append(ast.Return(ast.List(results, ast.Load(), **PLACE), **PLACE))
    names = [ast.arg(name, **PLACE) for name in read(function)]
    arguments = ast.arguments([], names, None, [], [], None, [])
    definition = ast.FunctionDef("results", arguments, lines, [], **PLACE)
    module = ast.Module([definition], [])
    code = compile(module, f"<{function.name}>", "exec")
    inner = next(part for part in code.co_consts if isinstance(part, CodeType))
    return FunctionType(inner, place)


def _value(function: Function, k: int) -> ast.expr:
    """The value of a node, where it was computed before."""
    node = function.graph.nodes[k]
    return _number(node[1]) if node[0] == "const" else _name(f"v{k}")


def _number(value: float) -> ast.expr:
    return ast.Constant(float(value), **PLACE)


def _name(name: str) -> ast.expr:
    return ast.Name(name, ast.Load(), **PLACE)


def _entry(of: ast.expr, k: int) -> ast.expr:
    return ast.Subscript(of, ast.Constant(k, **PLACE), ast.Load(), **PLACE)


def _call(name: str, operands: Sequence[ast.expr]) -> ast.expr:
    return ast.Call(_name(name), list(operands), [], **PLACE)


def _term(function: Function, i: int, node: Node) -> ast.expr:
    """Statement that computes a node from those before it."""
    op = node[0]
    value = partial(_value, function)
    if op == "var":
        return _entry(_name(node[1]), node[2])
    if op == "item":
        return _entry(value(node[1]), node[2])
    if op == "solve":
        entries: ast.expr = ast.List([value(k) for k in node[4:]], ast.Load(), **PLACE)
        return _call(f"solve_{i}", [entries])
    if op == "table":
        return _call(f"table_{i}", [value(node[3])])
    if op not in OPERATORS:
        raise ValueError(f"node {node} cannot be evaluated: placeholders must be replaced first")
    operands = [value(k) for k in node[1:]]
    if op in ARITHMETIC:
        return ast.BinOp(operands[0], ARITHMETIC[op](), operands[1], **PLACE)
    if op == "neg":
        return ast.UnaryOp(ast.USub(), operands[0], **PLACE)
    if op in COMPARISONS:
        holds = ast.Compare(operands[0], [COMPARISONS[op]()], [operands[1]], **PLACE)
        return ast.IfExp(holds, _number(1.0), _number(0.0), **PLACE)
    if op == "select":
        chosen = ast.Compare(operands[0], [ast.NotEq()], [_number(0.0)], **PLACE)
        return ast.IfExp(chosen, operands[1], operands[2], **PLACE)
    return _call(op, operands)
