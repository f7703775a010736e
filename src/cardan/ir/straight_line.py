"""A Function as a Python function of floats, without a look at its graph at every call.

The function is built as a syntax tree of known nodes: no text is ever evaluated.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Sequence
from functools import partial
from types import CodeType, FunctionType

from .function import Function
from .graph import Node
from .interpreter import evaluate
from .numbers import FLOATS
from .ops import OPERATORS

Floats = Sequence[float]
ARITHMETIC = {"add": ast.Add, "sub": ast.Sub, "mul": ast.Mult, "div": ast.Div}
COMPARISONS: dict[str, type[ast.cmpop]] = {"lt": ast.Lt, "le": ast.LtE, "eq": ast.Eq}
# where Python raises and C goes on with infinity or NaN
OUTSIDE = (ValueError, OverflowError, ZeroDivisionError)


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
            lines.append(ast.Assign([ast.Name(f"v{i}", ast.Store())], _term(function, i, node)))
    results = [_value(function, k) for k in function.roots]
    lines.append(ast.Return(ast.List(results, ast.Load())))
    arguments = ast.arguments(
        [], [ast.arg(name) for name in read(function)], None, [], [], None, []
    )
    definition = ast.FunctionDef("results", arguments, lines, [])
    module = ast.fix_missing_locations(ast.Module([definition], []))
    code = compile(module, f"<{function.name}>", "exec")
    inner = next(part for part in code.co_consts if isinstance(part, CodeType))
    return FunctionType(inner, place)


def _value(function: Function, k: int) -> ast.expr:
    """The value of a node, where it was computed before."""
    node = function.graph.nodes[k]
    return _number(node[1]) if node[0] == "const" else ast.Name(f"v{k}", ast.Load())


def _number(value: float) -> ast.expr:
    return ast.Constant(float(value))


def _call(name: str, operands: Sequence[ast.expr]) -> ast.expr:
    return ast.Call(ast.Name(name, ast.Load()), list(operands), [])


def _term(function: Function, i: int, node: Node) -> ast.expr:
    """Statement that computes a node from those before it."""
    op = node[0]
    value = partial(_value, function)
    if op == "var":
        return ast.Subscript(ast.Name(node[1], ast.Load()), ast.Constant(node[2]), ast.Load())
    if op == "item":
        return ast.Subscript(value(node[1]), ast.Constant(node[2]), ast.Load())
    if op == "solve":
        entries: ast.expr = ast.List([value(k) for k in node[4:]], ast.Load())
        return _call(f"solve_{i}", [entries])
    if op == "table":
        return _call(f"table_{i}", [value(node[3])])
    if op not in OPERATORS:
        raise ValueError(f"node {node} cannot be evaluated: placeholders must be replaced first")
    operands = [value(k) for k in node[1:]]
    if op in ARITHMETIC:
        return ast.BinOp(operands[0], ARITHMETIC[op](), operands[1])
    if op == "neg":
        return ast.UnaryOp(ast.USub(), operands[0])
    if op in COMPARISONS:
        holds = ast.Compare(operands[0], [COMPARISONS[op]()], [operands[1]])
        return ast.IfExp(holds, _number(1.0), _number(0.0))
    if op == "select":
        chosen = ast.Compare(operands[0], [ast.NotEq()], [_number(0.0)])
        return ast.IfExp(chosen, operands[1], operands[2])
    return _call(op, operands)
