"""Equations with names for what closed loops determine, as SymPy. Loads SymPy."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import sympy

from ...errors import DerivationError
from ...ir.forms.readable import TooLong, readable
from ...ir.forms.sympy_out import to_sympy_shared
from ...ir.graph import Graph
from ...ir.matrix import Matrix

if TYPE_CHECKING:
    from .readable import Readable

# operations of a definition as it comes that is worth a search for a short form
LONGEST = 3000
Definitions = list[tuple[sympy.Expr, sympy.Expr]]


def named(equations: Readable, name: str) -> tuple[Definitions, sympy.Matrix]:
    """Definitions and matrix of a function; see :meth:`.Readable.named`.

    Raises:
        DerivationError: an entry is too long to write out.
    """
    function, coefficients = equations.named_function(name)
    try:
        matrix = readable(function, equations.symbols)
    except TooLong as problem:
        raise DerivationError(
            f"{name} has an entry of {problem.operations:,} operations, with names for what "
            f"follows: too long to write out. Use equations.symbolic('{name}')"
        ) from problem
    definitions: Definitions = []
    for symbol in coefficients.used(function.graph, function.roots):
        node = coefficients.definitions[symbol]
        definitions += _definition(function.graph, symbol, node, equations.symbols)
    return definitions, matrix


def _definition(
    g: Graph, symbol: str, node: int, names: Mapping[tuple[str, int], sympy.Expr]
) -> Definitions:
    """Definition of a symbol, by intermediates of its own where it is long."""
    value = Matrix(g, 1, 1, [node])
    try:
        return [(sympy.Symbol(symbol), readable(value, names, longest=LONGEST)[0])]
    except TooLong:
        parts, (total,) = to_sympy_shared(value, names)
        part_symbols = {part: sympy.Symbol(f"{symbol}.{part}") for part, _ in parts}
        definitions = [(part_symbols[part], x.xreplace(part_symbols)) for part, x in parts]
        return [*definitions, (sympy.Symbol(symbol), total.xreplace(part_symbols))]
