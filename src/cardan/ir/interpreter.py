"""Evaluation of Functions in Python: floats, complex numbers, NumPy arrays, any number of digits.

The slow and simple way to numbers. It judges the compiled way in tests and verification and stands
in for it where there is no compiler. What C computes as infinity or NaN is infinity or NaN here.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, cast

from .function import Function, Output
from .graph import Graph, Node
from .numbers import COMPLEXES, FLOATS, Numbers, digits_of

ARITHMETICS = ("float", "complex", "numpy", "mp")


def evaluate(
    function: Function, values: Mapping[str, object], arithmetic: str = "float", digits: int = 40
) -> dict[str, Any]:
    """Results of a function.

    Args:
        function: What to evaluate.
        values: Block name -> its entries (n); for ``numpy`` arrays (..., n), whose leading axes
            are broadcast, and complex entries make all results complex. Blocks that no result
            depends on may be missing.
        arithmetic: ``float``, ``complex`` (comparisons look at real parts), ``numpy`` or ``mp``.
        digits: Decimal digits of ``mp``.

    Returns:
        Output name -> list of its entries, row by row; for ``numpy`` an array (..., *shape).

    Raises:
        ValueError: a block is missing or has another length than the function's.
        SolveError: a linear system has no solution.
    """
    numbers = _numbers(arithmetic, digits, values)
    graph, order = function.graph, function.live()
    inputs = _inputs(function, values, numbers, order)
    if arithmetic != "numpy":
        values_by_node = nodes_of(graph, order, inputs, numbers)
        return {o.name: [values_by_node[i] for i in o.nodes] for o in function.outputs}
    import numpy as np

    with np.errstate(all="ignore"):
        values_by_node = nodes_of(graph, order, inputs, numbers)
    batch = np.broadcast_shapes(*(x[..., 0].shape for x in inputs.values() if x.shape[-1]))
    return {o.name: _stacked(o, values_by_node, batch, numbers.number) for o in function.outputs}


def nodes_of(
    graph: Graph, order: Sequence[int], inputs: Mapping[str, Any], numbers: Numbers
) -> dict[int, Any]:
    """Value of every node of a topological order."""
    nodes, number = graph.nodes, numbers.number
    plain = {op: f for op, f in numbers.operators.items() if op not in _SPECIAL}
    values: dict[int, Any] = {}
    for i in order:
        node = nodes[i]
        op = node[0]
        operator = plain.get(op)
        # nodes of two operands are the most by far
        if operator is not None:
            if len(node) == 3:
                values[i] = operator(values[node[1]], values[node[2]])
            elif len(node) == 2:
                values[i] = operator(values[node[1]])
            else:
                values[i] = operator(*[values[k] for k in node[1:]])
        elif op == "const":
            values[i] = number(node[1])
        elif op == "var":
            block = inputs[node[1]]
            values[i] = block[..., node[2]] if numbers.name == "numpy" else block[node[2]]
        else:
            values[i] = _special(graph, node, values, numbers)
    return values


# nodes with operands that are not values
_SPECIAL = frozenset({"solve", "item", "stumpff", "table", "atom"})


def _special(graph: Graph, node: Node, values_by_node: Mapping[int, Any], numbers: Numbers) -> Any:
    """Nodes whose operands are not all numbers."""
    op = node[0]
    if op == "solve":
        return numbers.solve(node[1], node[2], node[3], [values_by_node[k] for k in node[4:]])
    if op == "item":
        return values_by_node[node[1]][node[2]]
    if op == "stumpff":
        return numbers.operators[op](int(graph.nodes[node[1]][1]), values_by_node[node[2]])
    if op == "table":
        table = graph.tables[int(graph.nodes[node[1]][1])]
        return numbers.table(table, int(graph.nodes[node[2]][1]), values_by_node[node[3]])
    raise ValueError(f"node {node} cannot be evaluated: placeholders must be replaced first")


def _numbers(arithmetic: str, digits: int, values: Mapping[str, Any]) -> Numbers:
    if arithmetic == "float":
        return FLOATS
    if arithmetic == "complex":
        return COMPLEXES
    if arithmetic == "mp":
        return digits_of(digits)
    if arithmetic == "numpy":
        import numpy as np

        from .arrays import arrays, complex_arrays

        return complex_arrays() if any(map(np.iscomplexobj, values.values())) else arrays()
    raise ValueError(f"arithmetic must be one of {', '.join(ARITHMETICS)}, not {arithmetic!r}")


def _inputs(
    function: Function, values: Mapping[str, object], numbers: Numbers, order: Sequence[int]
) -> dict[str, Any]:
    """The blocks that are read, as numbers, checked."""
    nodes = function.graph.nodes
    read = {node[1] for node in map(nodes.__getitem__, order) if node[0] == "var"}
    sizes = {block.name: len(block) for block in function.inputs}
    result: dict[str, Any] = {}
    for name in sorted(read):
        if name not in values:
            names = ", ".join(sorted(values)) or "none"
            raise ValueError(f"function '{function.name}' reads block '{name}'; given: {names}")
        result[name] = _block(values[name], numbers)
        length = result[name].shape[-1] if numbers.name == "numpy" else len(result[name])
        expected = sizes.get(name, length)
        if length != expected:
            raise ValueError(
                f"block '{name}' of function '{function.name}' has {expected} entries, not {length}"
            )
    return result


def _block(entries: Any, numbers: Numbers) -> Any:
    if numbers.name != "numpy":
        return [numbers.number(x) for x in entries]
    import numpy as np

    return np.asarray(entries, dtype=cast("type[Any]", numbers.number))


def _stacked(
    output: Output, values_by_node: Mapping[int, Any], batch: tuple[int, ...], kind: Any
) -> object:
    """The entries of an output as one array (..., *shape)."""
    import numpy as np

    flat = np.empty((*batch, len(output.nodes)), dtype=kind)
    for k, i in enumerate(output.nodes):
        flat[..., k] = values_by_node[i]
    return flat.reshape((*batch, *output.shape))
