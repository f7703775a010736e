"""Elements with their quantities as expressions, as the system graph gives them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from cardan.elements.quantity import Quantity
from cardan.ir.graph import Graph
from cardan.ir.matrix import Matrix


def converted(
    graph: Graph, quantities: Mapping[str, Quantity]
) -> tuple[dict[str, Matrix], dict[str, list[float]]]:
    """Data of an element, and the numbers of block ``p`` where they became parameters.

    Zeros, and in ratios +-1, are structural; expressions see their local symbols as atoms.
    """
    data: dict[str, Matrix] = {}
    numbers: list[float] = []
    for name, quantity in quantities.items():
        entries = quantity.value if isinstance(quantity.value, Sequence) else [quantity.value]
        nodes = [_node(graph, quantity, entry, numbers) for entry in entries]
        data[name] = Matrix(graph, len(nodes), 1, nodes)
    return data, {"p": numbers}


def _node(graph: Graph, quantity: Quantity, entry: Any, numbers: list[float]) -> int:
    if hasattr(entry, "free_symbols"):
        from cardan.ir.forms.sympy_bridge import from_sympy

        symbols = {s: graph.atom(s.name) for s in entry.free_symbols}
        assert {s.name for s in symbols} <= set(quantity.local)
        return from_sympy(graph, entry, symbols)
    if entry == 0 or (quantity.ratio and abs(entry) == 1):
        return graph.const(entry)
    numbers.append(entry)
    return graph.var("p", len(numbers) - 1)
