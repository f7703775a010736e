"""Values of formulas in the names of a model, such as a cost along a motion."""

from __future__ import annotations

from ...errors import DerivationError, ModelError
from ...ir.function import Output
from .context import Context, recipe
from .functions import give_accelerations


@recipe
def expression(c: Context) -> tuple[Output, ...]:
    """The value of the formula ``c.of``.

    Raises:
        DerivationError: it cannot be read, or a name is unknown or stands for two things.
    """
    import sympy

    from ...ir.forms.sympy_bridge import from_sympy
    from ...scene.files.expression import parse

    formula, nodes = c.of or "", _names(c)
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
        node = from_sympy(c.k.graph, value, leaves)
    except ModelError as problem:
        raise DerivationError(str(problem)) from problem
    return (Output("expression", (), (node,), (formula,)),)


def _names(c: Context) -> dict[str, dict[str, int]]:
    """Name -> what it is the name of -> node."""
    g, system = c.k.graph, c.k.system
    kinds = {"q": "a coordinate", "u": "a speed", "z": "an internal state"}
    kinds |= {"r": "an input", "p": "a parameter"}
    nodes = {"t": {"the time": g.var("t", 0)}}
    for block, kind in kinds.items():
        for k, name in enumerate(c.names[block]):
            nodes.setdefault(name, {})[kind] = g.var(block, k)
    if system.outputs:
        give_accelerations(c)
    for output in system.outputs:
        nodes.setdefault(output.name, {})["an output"] = c.k.resolve([output.node])[0]
    return nodes
