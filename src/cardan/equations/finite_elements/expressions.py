"""Formulas in the names of a scene in absolute coordinates: values, gradients and curvatures.

Outputs are sums over elements. Formulas read their values as the block v.
"""

from __future__ import annotations

from ...ir.derivative import forward, gradient
from ...ir.function import Block, Function, Output
from ...ir.graph import Graph
from ...schema.blocks import ORDER
from ...schema.finite_elements import EXPRESSION, EXPRESSION_CURVATURE
from ..functions.blocks import internals, parameters
from ..functions.expression import named, node_of
from .record import FiniteElementRecord

ABOUT = "a formula in the names of the model, outputs in v"


def expression_of(absolute: FiniteElementRecord, form: str, formula: str, symbol: str) -> Function:
    """The value of a formula, its derivatives by t, q as it is stored, u, z, r, p and outputs, or
    the changes of these along a direction, which v has behind the outputs.

    Args:
        absolute: The equations.
        form: Which of these.
        formula: In names of coordinates, speeds, internal states, inputs, parameters, outputs, t.
        symbol: Its C name.

    Raises:
        DerivationError: it cannot be read, or a name is unknown or stands for two things.
    """
    names = {
        **{"t": ("t",), "q": absolute.coordinates, "u": absolute.speeds},
        "z": tuple(name for name, _, _ in internals(absolute.system)),
        **{"r": absolute.inputs, "p": parameters(absolute.system).entries, "v": absolute.outputs},
    }
    graph = Graph()
    nodes = named(graph, names)
    for k, name in enumerate(absolute.outputs):
        nodes.setdefault(name, {})["an output"] = graph.var("v", k)
    nodes = {name: nodes[name] for name in absolute.outputs} | nodes
    root = node_of(graph, formula, nodes)
    leaves = [graph.var(letter, k) for letter, some in names.items() for k in range(len(some))]
    along = {}
    if form == EXPRESSION_CURVATURE:
        names["v"] = (*names["v"], *(f"direction{k + 1}" for k in range(len(leaves))))
        first = len(absolute.outputs)
        along = {leaf: graph.var("v", first + k) for k, leaf in enumerate(leaves)}
    blocks = tuple(
        Block(letter, tuple(names[letter]), ("",) * len(names[letter]))
        for letter in ORDER
        if letter in names
    )
    if form == EXPRESSION:
        return Function(symbol, graph, blocks, (Output("value", (), (root,)),), about=ABOUT)
    slopes = gradient(graph, root, leaves)
    results = tuple(forward(graph, slopes, along) if along else slopes)
    output = Output("slopes", (len(results),), results)
    return Function(symbol, graph, blocks, (output,), about=ABOUT)
