"""The rules every Function obeys; checked between passes and after reading a file."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from .function import Function, operands
from .graph import Graph, Node
from .ops import LEAVES, OPERATORS
from .solve import KINDS

ARITIES = {name: op.arity for name, op in OPERATORS.items()}

# operators whose first operands are not values but whole numbers
NUMBERED = {"stumpff": 1, "table": 2}
# length of the node of every other operator
SINGLE = {name: arity + 1 for name, arity in ARITIES.items() if name not in NUMBERED}


def check(function: Function) -> Function:
    """The function itself, when it obeys the rules.

    Raises:
        ValueError: a rule is broken; the message names the function, the node and the rule.
    """
    _check_results(function)
    sizes = {block.name: len(block) for block in function.inputs}
    nodes = function.graph.nodes
    for i in _live(function):
        node = nodes[i]
        op = node[0]
        # the common case in few steps: an operator of the table on single values
        if SINGLE.get(op) == len(node):
            read = node[1:]
        else:
            read = _special_operands(function, i, node, sizes)
        for k in read:
            if not 0 <= k < i:
                raise _broken(function, i, f"operand {k} does not stand before it")
            if nodes[k][0] == "solve" and op != "item":
                raise _broken(
                    function, i, f"it reads the solve node {k}, which is not a single value"
                )
    return function


def _live(function: Function) -> list[int]:
    """Live nodes; an operand that is not a node at all is found here."""
    try:
        return function.live()
    except (IndexError, TypeError):
        size = len(function.graph.nodes)
        for i, node in enumerate(function.graph.nodes):
            for k in operands(node):
                if type(k) is not int or not 0 <= k < size:
                    raise _broken(function, i, f"operand {k} does not stand before it") from None
        raise


def _broken(function: Function, i: int, rule: str) -> ValueError:
    node = function.graph.nodes[i]
    return ValueError(f"function '{function.name}', node {i} {node}: {rule}")


def _check_results(function: Function) -> None:
    size, names = len(function.graph.nodes), [o.name for o in function.outputs]
    if len(set(names)) != len(names):
        raise ValueError(f"function '{function.name}': two results have one name: {names}")
    for output in function.outputs:
        where = f"function '{function.name}', result '{output.name}'"
        if math.prod(output.shape) != len(output.nodes):
            raise ValueError(f"{where}: {len(output.nodes)} nodes do not fill {output.shape}")
        for texts in (output.entries, output.units):
            if texts and len(texts) != len(output.nodes):
                raise ValueError(
                    f"{where}: {len(texts)} names or units for {len(output.nodes)} nodes"
                )
        for k in output.nodes:
            if not 0 <= k < size:
                raise ValueError(f"{where}: node {k} does not exist")
            if function.graph.nodes[k][0] == "solve":
                raise ValueError(f"{where}: the solve node {k} is not a single value")
    for block in function.inputs:
        if len(block.units) != len(block.entries):
            raise ValueError(
                f"function '{function.name}', block '{block.name}': {len(block.units)} units for "
                f"{len(block.entries)} entries"
            )


def _special_operands(
    function: Function, i: int, node: Node, sizes: Mapping[str, int]
) -> tuple[Any, ...]:
    """Operands of leaves, solutions and operators with whole numbers, their rules checked."""
    op = node[0]
    if op in LEAVES:
        problem = _leaf_problem(node, sizes)
    elif op == "solve":
        problem = _solve_problem(node)
    elif op == "item":
        problem = _item_problem(function.graph, node)
    elif op in ARITIES:
        problem = _number_problem(function.graph, node)
    else:
        problem = f"operator {op!r} does not exist"
    if problem:
        raise _broken(function, i, problem)
    return operands(node)


def _leaf_problem(node: Node, sizes: Mapping[str, int]) -> str:
    op = node[0]
    if op == "atom":
        return "a placeholder is left: kinematics must resolve it"
    if op == "const":
        finite = len(node) == 2 and isinstance(node[1], float) and math.isfinite(node[1])
        return "" if finite else "a constant must be a finite float"
    if len(node) != 3 or node[1] not in sizes:
        return f"its block is none of {', '.join(sizes) or 'the inputs: there are none'}"
    inside = isinstance(node[2], int) and 0 <= node[2] < sizes[node[1]]
    return "" if inside else f"block '{node[1]}' has {sizes[node[1]]} entries"


def _solve_problem(node: Node) -> str:
    if len(node) < 4 or node[1] not in KINDS:
        return f"its kind must be one of {', '.join(KINDS)}"
    n, m = node[2], node[3]
    if not (isinstance(n, int) and isinstance(m, int) and n > 0 and m > 0):
        return "its numbers of rows and columns must be positive"
    return "" if len(node) == 4 + n * n + n * m else f"it needs {n * n + n * m} entries"


def _item_problem(graph: Graph, node: Node) -> str:
    if len(node) != 3 or type(node[2]) is not int:
        return "an item names a solve node and the number of an entry"
    solution = graph.nodes[node[1]]
    if solution[0] != "solve":
        return f"node {node[1]} is not a solve node"
    return "" if 0 <= node[2] < solution[2] * solution[3] else "the solution has no such entry"


def _number_problem(graph: Graph, node: Node) -> str:
    op = node[0]
    if len(node) != ARITIES[op] + 1:
        return f"{op} takes {ARITIES[op]} operands"
    for k in node[1 : 1 + NUMBERED[op]]:
        value = graph.value(k)
        if value is None or value < 0 or value != int(value):
            return f"operand {k} must be a whole number"
    if op == "table" and int(graph.nodes[node[1]][1]) >= len(graph.tables):
        return f"the graph has {len(graph.tables)} tables"
    return ""
