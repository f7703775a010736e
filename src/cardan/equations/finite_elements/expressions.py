"""Formulas in the names of a scene in absolute coordinates: their values and gradients.

Outputs are sums over elements. Formulas read their values as the block v.
"""

from __future__ import annotations

from ...ir.derivative import gradient
from ...ir.function import Block, Function, Output
from ...ir.graph import Graph
from ...schema.blocks import ORDER
from ...schema.finite_elements import EXPRESSION, EXPRESSION_GRADIENT
from ..functions.blocks import internals, parameters
from ..functions.expression import named, node_of
from .record import FiniteElementRecord

ABOUT = "a formula in the names of the model, outputs in v"


def expression_of(absolute: FiniteElementRecord, form: str, formula: str, symbol: str) -> Function:
    """The value of a formula, or its derivatives by t, q as it is stored, u, z, r, p and outputs.

    Args:
        absolute: The equations.
        form: Which of both.
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
    root = node_of(graph, formula, nodes)
    blocks = tuple(
        Block(letter, tuple(names[letter]), ("",) * len(names[letter]))
        for letter in ORDER
        if letter in names
    )
    if form == EXPRESSION:
        return Function(symbol, graph, blocks, (Output("value", (), (root,)),), about=ABOUT)
    assert form == EXPRESSION_GRADIENT
    leaves = [graph.var(letter, k) for letter, some in names.items() for k in range(len(some))]
    slopes = tuple(gradient(graph, root, leaves))
    return Function(symbol, graph, blocks, (Output("slopes", (len(slopes),), slopes),), about=ABOUT)
