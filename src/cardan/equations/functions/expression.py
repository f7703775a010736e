"""Values of formulas in the names of a model, such as a cost along a motion."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ...errors import DerivationError, ModelError
from ...ir.function import Output
from ...ir.graph import Graph
from .context import Context, recipe
from .functions import give_accelerations

KINDS = {
    **{"q": "a coordinate", "u": "a speed", "z": "an internal state"},
    **{"r": "an input", "p": "a parameter"},
}


@recipe
def expression(c: Context) -> tuple[Output, ...]:
    """The value of the formula ``c.of``.

    Raises:
        DerivationError: it cannot be read, or a name is unknown or stands for two things.
    """
    formula = c.of or ""
    return (Output("expression", (), (node_of(c.k.graph, formula, _names(c)),), (formula,)),)


def node_of(graph: Graph, formula: str, nodes: Mapping[str, Mapping[str, int]]) -> int:
    """The value of a formula.

    Args:
        graph: Where it is made.
        formula: As scene files have them.
        nodes: Name -> what it is the name of -> node.

    Raises:
        DerivationError: it cannot be read, or a name is unknown or stands for two things.
    """
    import sympy

    from ...ir.forms.sympy_bridge import from_sympy
    from ...scene.files.expression import parse

    symbols = {name: sympy.Symbol(name) for name in nodes}
    try:
        value = parse(formula, symbols, where="expression")
        twice = sorted(str(x) for x in value.free_symbols if len(nodes[str(x)]) > 1)
        if twice:
            raise DerivationError(
                f"expression: '{twice[0]}' is the name of {' and of '.join(nodes[twice[0]])}; "
                "rename one of them"
            )
        leaves = {symbols[name]: next(iter(each.values())) for name, each in nodes.items()}
        return from_sympy(graph, value, leaves)
    except ModelError as problem:
        raise DerivationError(str(problem)) from problem


def _names(c: Context) -> dict[str, dict[str, int]]:
    """Name -> what it is the name of -> node."""
    system, nodes = c.k.system, named(c.k.graph, c.names)
    if system.outputs:
        give_accelerations(c)
    for output in system.outputs:
        nodes.setdefault(output.name, {})["an output"] = c.k.resolve([output.node])[0]
    # outputs first, as people name them first
    outputs = {output.name: nodes[output.name] for output in system.outputs}
    return outputs | nodes


def named(graph: Graph, names: Mapping[str, Sequence[str]]) -> dict[str, dict[str, int]]:
    """Entries of blocks by name -> what it is the name of -> node."""
    nodes = {"t": {"the time": graph.var("t", 0)}}
    for block, kind in KINDS.items():
        for k, name in enumerate(names[block]):
            nodes.setdefault(name, {})[kind] = graph.var(block, k)
    return nodes
