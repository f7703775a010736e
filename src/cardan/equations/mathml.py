"""SymPy expressions as MathML in the notation of the model. Loads SymPy: import it on demand."""

from __future__ import annotations

from collections.abc import Mapping
from html import escape
from typing import Any

from sympy.printing.mathml import MathMLPresentationPrinter

from .notation import Notation

DOTS = {1: "˙", 2: "¨"}


class Printer(MathMLPresentationPrinter):  # type: ignore[misc]
    """SymPy's printer with our symbols; text nodes of that printer are written as they are.

    Args:
        symbols: Notation by name; other symbols are words.
    """

    def __init__(self, symbols: Mapping[str, Notation]) -> None:
        super().__init__({"mat_delim": "["})
        self._symbols = symbols

    def _print_Symbol(self, sym: Any, style: str = "plain") -> Any:
        sign = self._symbols.get(sym.name) or Notation(sym.name)
        base = self._text("mi", sign.character)
        if len(sign.character) > 1:
            base.setAttribute("mathvariant", "normal")
        if sign.dots:
            base = self._of("mover", base, self._text("mo", DOTS[sign.dots]))
            base.setAttribute("accent", "true")
        return self._of("msub", base, self._text("mi", sign.index)) if sign.index else base

    def _text(self, tag: str, text: str) -> Any:
        node = self.dom.createElement(tag)
        node.appendChild(self.dom.createTextNode(escape(text)))
        return node

    def _of(self, tag: str, *children: Any) -> Any:
        node = self.dom.createElement(tag)
        for child in children:
            node.appendChild(child)
        return node
