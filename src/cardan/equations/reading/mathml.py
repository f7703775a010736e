"""SymPy expressions as MathML in the notation of the model. Loads SymPy: import it on demand."""

from __future__ import annotations

from collections.abc import Mapping
from html import escape
from typing import TYPE_CHECKING

from sympy.printing.mathml import MathMLPresentationPrinter

from .notation import Notation

if TYPE_CHECKING:
    from xml.dom.minidom import Element

    import sympy

# combining characters would need a font that has them
DOTS = {1: ".", 2: ".."}
PRODUCT = "<mo>&InvisibleTimes;</mo>"


class Printer(MathMLPresentationPrinter):  # type: ignore[misc]
    """SymPy's printer with our symbols; text nodes of that printer are written as they are.

    Args:
        symbols: Notation by name; other symbols are words.
    """

    def __init__(self, symbols: Mapping[str, Notation]) -> None:
        super().__init__({"mat_delim": ""})
        self._symbols = symbols

    def written(self, expression: sympy.Expr) -> str:
        """MathML without names of entities; factors stand apart, since some of them are words."""
        text = str(self.doprint(expression)).replace(PRODUCT, '<mspace width="0.2em"/>')
        text = text.replace("<mo>-</mo>", "<mo>−</mo>")
        # fractions in a matrix as large as elsewhere
        return text.replace("<mtable>", '<mtable displaystyle="true">')

    def _print_Symbol(self, sym: sympy.Symbol, style: str = "plain") -> Element:
        base, index = self._parts(sym)
        return self._of("msub", base, index) if index is not None else base

    def _print_Pow(self, expr: sympy.Pow) -> Element:
        if expr.base.is_Symbol and expr.exp.is_Integer and expr.exp > 1:
            base, index = self._parts(expr.base)
            if index is not None:
                return self._of("msubsup", base, index, self._print(expr.exp))
        power: Element = super()._print_Pow(expr)
        return power

    def _parts(self, symbol: sympy.Symbol) -> tuple[Element, Element | None]:
        """The letter with its dots, and its index or None."""
        sign = self._symbols.get(symbol.name) or Notation(symbol.name)
        base = self._text("mi", sign.character)
        if len(sign.character) > 1:
            base.setAttribute("mathvariant", "normal")
        if sign.dots:
            base = self._of("mover", base, self._text("mo", DOTS[sign.dots]))
        return base, self._text("mi", sign.index) if sign.index else None

    def _text(self, tag: str, text: str) -> Element:
        node: Element = self.dom.createElement(tag)
        node.appendChild(self.dom.createTextNode(escape(text)))
        return node

    def _of(self, tag: str, *children: Element) -> Element:
        node: Element = self.dom.createElement(tag)
        for child in children:
            node.appendChild(child)
        return node
