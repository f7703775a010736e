"""Pieces of formulas in the math mode of TeX, for LaTeX and Markdown."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

from ..equations.reading.notation import Notation

if TYPE_CHECKING:
    import sympy

_SIGNS = {"−": "-", "≤": r"\le", "≥": r"\ge", "≠": r"\ne", "·": r"\cdot", "{": r"\{", "}": r"\}"}


class TeX:
    """Writes formulas.

    Args:
        symbols: Notation by name; other symbols are words.
        safe: What a name has to go through.
    """

    def __init__(self, symbols: Mapping[str, Notation], safe: Callable[[str], str]) -> None:
        self._symbols = symbols
        self._safe = safe

    def sign(self, sign: Notation) -> str:
        """A letter with its index."""
        return self._safe(sign.latex())

    def expression(self, expression: sympy.Expr) -> str:
        """A SymPy expression as a whole."""
        import sympy

        from .breaking import short

        expression = short(expression)
        names = {
            s: self.sign(self._symbols.get(s.name) or Notation(s.name))
            for s in expression.free_symbols
        }
        return str(sympy.latex(expression, symbol_names=names, mul_symbol=r" \, "))

    def segment(self, segment: sympy.Expr, style: str = "") -> str:
        """A piece as :mod:`.breaking` makes them."""
        parts = [_operator(mark) for mark in segment.before]
        if segment.body is not None:
            parts.append(style + self.expression(segment.body))
        for mark, power in segment.after:
            raised = f"^{{{self.expression(power)}}}" if power is not None else ""
            parts.append(_operator(mark) + raised)
        return " ".join(parts)


def _operator(mark: str) -> str:
    """Signs and brackets; words stand upright."""
    if not mark[0].isalpha():
        return _SIGNS.get(mark, mark)
    return rf"\operatorname{{{mark[:-1]}}}(" if mark.endswith("(") else rf"\text{{ {mark} }}"
