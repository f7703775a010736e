"""What SymPy expressions speak of. Loads SymPy."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import sympy
from sympy.core.function import AppliedUndef


def leaves(expressions: Iterable[Any]) -> list[Any]:
    """Symbols, functions of time, derivatives and tables in expressions, as they appear."""
    seen: set[Any] = set()
    found: list[Any] = []
    stack = [sympy.sympify(e, strict=True) for e in expressions][::-1]
    while stack:
        e = stack.pop()
        if e in seen:
            continue
        seen.add(e)
        if e.is_Symbol or isinstance(e, (AppliedUndef, sympy.Derivative)) or is_table(e):
            found.append(e)
        else:
            stack.extend(reversed(e.args))
    return found


def is_table(e: Any) -> bool:
    """Whether an expression interpolates measured data."""
    return getattr(e, "cardan_table", None) is not None
