"""Equations in notebooks: formulas that browsers set by themselves, and tables that unfold.

Loads SymPy: import it on demand.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from ..errors import DerivationError
from ..ir.html import Html, block, details, paragraph, table, written
from .circuits_told import circuits_told
from .formula import LONGEST, SEARCHED, rates_are_speeds
from .notation import Notation, notation, symbols

if TYPE_CHECKING:
    from .record import Equations

# intermediates of what is long
LISTED = 40
GENERAL = "M u̇ + h = f + τ"
BOUND = GENERAL + " + Gᵀλ, G u̇ = γ"
PARTS = (
    ("M", "mass_matrix"),
    ("h", "bias"),
    ("f", "applied"),
    ("q̇", "qdot"),
    ("g", "constraints"),
    ("G", "constraint_jacobian"),
    ("γ", "constraint_bias"),
)


def html(equations: Equations) -> str:
    """Names, formulas, intermediates and counts."""
    s = equations.system
    bodies = sum(bool(b.parts) for b in s.bodies)
    sizes = ((bodies, "body", "bodies"), (s.nq, "coordinate", ""), (s.nu, "speed", ""))
    told = (f"{n} {one if n == 1 else several or one + 's'}" for n, one, several in sizes)
    about = Html(f"<b>{written(s.name)}</b> by {equations.method}: {', '.join(told)}")
    parts = [paragraph(about), paragraph(BOUND if s.closed else GENERAL)]
    parts += [paragraph(line.strip()) for line in circuits_told(equations)]
    formulas = Formulas(equations)
    known = set(equations.names())
    parts += [formulas.part(sign, name) for sign, name in PARTS if name in known]
    if formulas.definitions:
        parts.append(formulas.following())
    parts.append(details("coordinates, speeds, parameters", _names(equations)))
    parts.append(details("operations at every call", _counts(equations)))
    return block(*parts)


class Formulas:
    """Formulas of one set of equations."""

    def __init__(self, equations: Equations) -> None:
        self.equations = equations
        self.definitions: dict[Any, Any] = {}
        self._notation = dict(symbols(equations))

    def part(self, sign: str, name: str) -> Html:
        """One matrix; what does not have to be said is left out."""
        equations = self.equations
        if len(equations.as_described.function(name).live()) > SEARCHED and not equations.follows:
            # a search takes seconds and seldom finds what can be read: no time for that here
            return self._long(sign, name)
        try:
            definitions, matrix = equations.named(name)
        except DerivationError:
            return self._long(sign, name)
        if not len(matrix):
            return paragraph(f"{sign}: none")
        if name == "qdot" and rates_are_speeds(equations, matrix):
            return paragraph("q̇ = u")
        if matrix.is_zero_matrix:
            return paragraph(f"{sign} = 0")
        if sum(entry.count_ops() for entry in matrix) > LONGEST:
            return self._long(sign, name)
        self.definitions |= dict(definitions)
        return self._equation(sign, self.set(matrix))

    def set(self, expression: Any) -> str:
        """An expression as MathML; symbols of circuits with what they are differentiated by."""
        from .mathml import Printer

        for symbol in expression.free_symbols:
            if symbol.name not in self._notation:
                self._notation[symbol.name] = followed(symbol.name)
        return f'<math displaystyle="true">{Printer(self._notation).written(expression)}</math>'

    def following(self) -> Html:
        """What circuits determine."""
        lines = [
            self._equation(Html(self.set(symbol)), self.set(value))
            for symbol, value in self.definitions.items()
            if value.count_ops() <= LONGEST
        ]
        more = len(self.definitions) - len(lines)
        if more:
            lines.append(paragraph(f"and {more} longer ones: equations.named(...)"))
        return details("with what the circuits determine", Html("".join(lines)), shown=True)

    def _long(self, sign: str, name: str) -> Html:
        """Intermediates folded away, or how to get at them."""
        replacements, matrix = self.equations.symbolic(name)
        count = f"{sign}: {len(replacements)} intermediates, equations.symbolic('{name}')"
        if len(replacements) > LISTED:
            return paragraph(count)
        lines = [self._equation(Html(self.set(a)), self.set(b)) for a, b in replacements]
        lines.append(self._equation(sign, self.set(matrix)))
        return details(count, Html("".join(lines)))

    @staticmethod
    def _equation(left: str, right: str) -> Html:
        return paragraph(Html(f"{written(left)} = {right}"))


def followed(name: str) -> Notation:
    """``phi.theta.theta`` as a phi with the index theta theta; other names as they are set."""
    head, *by = name.split(".")
    if not by or re.search(r"\W", "".join((head, *by))):
        return notation(name)
    first = notation(head)
    index = "".join(notation(part).character for part in by)
    return Notation(first.letter, ",".join(filter(None, (first.index, index))))


def _names(equations: Equations) -> Html:
    rows: list[tuple[str, str, str]] = []
    for what, letter in (("coordinate", "q"), ("speed", "u"), ("input", "r")):
        entries = equations.blocks[letter]
        rows += [(what, n, u) for n, u in zip(entries.entries, entries.units, strict=True)]
    rows += [("parameter", f"{p.name} = {p.value:g}", p.unit) for p in equations.system.parameters]
    return table(("", "name", "unit"), rows)


def _counts(equations: Equations) -> Html:
    return table(("function", "mul", "add", "div", "trig", "all"), _rows(equations))


def _rows(equations: Equations) -> Iterable[tuple[object, ...]]:
    for name, n in equations.operations.items():
        add, trig = n.get("add", 0) + n.get("sub", 0), n.get("sin", 0) + n.get("cos", 0)
        yield name, n.get("mul", 0), add, n.get("div", 0), trig, n.total
