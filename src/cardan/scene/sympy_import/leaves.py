"""Symbols and functions in SymPy expressions. Loads SymPy."""

from __future__ import annotations

from collections.abc import Iterable

import sympy
from sympy.core.function import AppliedUndef


def leaves(expressions: Iterable[sympy.Basic]) -> list[sympy.Basic]:
    """Symbols, functions of time, derivatives and tables in expressions, as they appear."""
    visited: set[sympy.Basic] = set()
    collected: list[sympy.Basic] = []
    stack = [sympy.sympify(e, strict=True) for e in expressions][::-1]
    while stack:
        e = stack.pop()
        if e in visited:
            continue
        visited.add(e)
        if e.is_Symbol or isinstance(e, (AppliedUndef, sympy.Derivative)) or is_table(e):
            collected.append(e)
        else:
            stack.extend(reversed(e.args))
    return collected


def is_table(e: sympy.Basic) -> bool:
    """True when an expression interpolates measured data."""
    return getattr(e, "cardan_table", None) is not None
