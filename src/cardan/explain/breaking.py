"""Long formulas in pieces between which a line may end. Loads SymPy: import it on demand.

A sum may break before its signs, a long product between its factors, and so on inside of brackets:
whatever the width of the page, no piece but a single name is wider than the room it is given.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import sympy

from ..equations.reading.notation import Notation
from ..records import dataclass

# digits of numbers that formulas contain
DIGITS = 10
# width of an index relative to a letter on the line
SMALL = 0.7


@dataclass(frozen=True)
class Segment:
    """A part of a formula that stays together on a line.

    Attributes:
        before: Signs, brackets and names of functions that stand before it.
        body: SymPy expression, None without one.
        after: Closing brackets and commas, each with its power or None.
    """

    before: tuple[str, ...]
    body: sympy.Expr
    after: tuple[tuple[str, sympy.Expr], ...] = ()


class Breaker:
    """Takes expressions apart.

    Args:
        symbols: Notation by name: what is wide, and what is not.
        room: Letters that fit a line for sure.
    """

    def __init__(self, symbols: Mapping[str, Notation], room: float) -> None:
        self._symbols = symbols
        self._room = room
        self._widths: dict[sympy.Expr, float] = {}

    def segments(self, expression: sympy.Expr) -> list[Segment]:
        """The pieces of an expression in order."""
        return list(self._broken(short(expression)))

    def width(self, e: sympy.Expr) -> float:
        """About how many letters wide an expression is."""
        if e not in self._widths:
            self._widths[e] = float(self._width(e))
        return self._widths[e]

    def _width(self, e: sympy.Expr) -> sympy.Expr:
        if e.is_Symbol:
            sign = self._symbols.get(e.name) or Notation(e.name)
            return float(len(sign.character) + SMALL * len(sign.index))
        if not e.args:
            if e.is_Rational and not e.is_Integer:
                return float(max(len(str(e.p)), len(str(e.q))))
            return float(len(str(e)))
        inner = [self.width(arg) for arg in e.args]
        if e.is_Pow:
            raised = 0.0 if e.exp == -1 else SMALL * inner[1]
            return float(inner[0] + 2.0 * bool(e.base.is_Add) + raised)
        if e.is_Mul:
            upper, lower = self._sides(e)
            return max(self._line(upper), self._line(lower))
        if e.is_Add:
            return sum(inner) + 3.0 * (len(inner) - 1)
        return len(type(e).__name__) + sum(inner) + 2.0 * len(inner)

    def _line(self, factors: Sequence[sympy.Expr]) -> float:
        return float(sum(self.width(f) + 0.4 + 2.0 * f.is_Add for f in factors))

    def _broken(self, e: sympy.Expr) -> Iterator[Segment]:
        if self.width(e) <= self._room or not e.args:
            yield Segment((), e)
        elif e.is_Add:
            yield from self._sum(e.as_ordered_terms())
        elif e.is_Mul:
            yield from self._product(e)
        elif e.is_Pow and e.exp.is_Integer and e.exp < 0:
            yield from _led("1 /", self._enclosed(e.base, -e.exp if e.exp != -1 else None))
        elif e.is_Pow:
            yield from self._enclosed(e.base, e.exp)
        elif isinstance(e, sympy.Piecewise):
            yield from self._cases(e)
        elif e.is_Relational:
            yield from self._broken(e.lhs)
            yield from _led(RELATIONS.get(e.rel_op, e.rel_op), self._broken(e.rhs))
        else:
            yield from self._call(e)

    def _sum(self, terms: Sequence[sympy.Expr]) -> Iterator[Segment]:
        for n, term in enumerate(terms):
            minus = term.could_extract_minus_sign()
            inner = self._broken(_negated(term) if minus else term)
            sign = "−" if minus else "+" if n else ""
            yield from _led(sign, inner) if sign else inner

    def _product(self, e: sympy.Expr) -> Iterator[Segment]:
        if e.could_extract_minus_sign():
            yield from _led("−", self._broken(_negated(e)))
            return
        # numbers stand before what they multiply
        number = sympy.Mul(*(f for f in e.args if f.is_Rational))
        upper, lower = self._sides(
            sympy.Mul(*(f for f in e.args if not f.is_Rational), evaluate=False)
        )
        upper = [*([number] if number != 1 else []), *upper]
        yield from self._factors(upper) if upper else (Segment((), sympy.Integer(1)),)
        if len(lower) == 1 and not lower[0].is_Add:
            yield from _led("/", self._broken(lower[0]))
        elif lower:
            yield from _led("/", _closed(_led("(", self._factors(lower, bare=True)), None))

    def _factors(self, factors: Sequence[sympy.Expr], bare: bool = False) -> Iterator[Segment]:
        """Factors side by side as far as there is room; ``bare``: they have brackets already."""
        group: list[sympy.Expr] = []
        for factor in [*factors, None]:
            fits = factor is not None and self._line([*group, factor]) <= self._room
            if fits:
                group.append(factor)
                continue
            if group:
                segment = Segment((), sympy.Mul(*group, evaluate=False) if group[1:] else group[0])
                alone = group[0].is_Add and not group[1:] and not (bare and len(factors) == 1)
                segments: Iterator[Segment] = (
                    self._enclosed(group[0], None) if alone else iter((segment,))
                )
                yield from segments
                group = []
            if factor is None:
                return
            if self._line([factor]) <= self._room:
                group = [factor]
                continue
            inner = (
                self._enclosed(factor, None)
                if factor.is_Add and not (bare and len(factors) == 1)
                else self._broken(factor)
            )
            yield from inner

    def _sides(self, e: sympy.Expr) -> tuple[list[sympy.Expr], list[sympy.Expr]]:
        """Factors above and below the line of a fraction."""
        upper, lower = [], []
        for factor in e.args if e.is_Mul else (e,):
            if factor.is_Rational and not factor.is_Integer:
                upper += [sympy.Integer(factor.p)] if factor.p != 1 else []
                lower.append(sympy.Integer(factor.q))
            elif factor.is_Pow and factor.exp.is_number and factor.exp.is_negative:
                lower.append(factor.base ** (-factor.exp))
            else:
                upper.append(factor)
        return upper, lower

    def _enclosed(self, e: sympy.Expr, power: sympy.Expr) -> Iterator[Segment]:
        return _closed(_led("(", self._broken(e)), power)

    def _call(self, e: sympy.Expr) -> Iterator[Segment]:
        name = NAMES.get(type(e).__name__, type(e).__name__.lower())
        for n, arg in enumerate(e.args):
            inner = self._broken(arg)
            inner = _led(f"{name}(", inner) if n == 0 else inner
            yield from _closed(inner, None, ")" if n == len(e.args) - 1 else ",")

    def _cases(self, e: sympy.Expr) -> Iterator[Segment]:
        for n, (value, condition) in enumerate(e.args):
            yield from _closed(_led("{", self._broken(value)) if n == 0 else self._broken(value),
                               None, "")  # fmt: skip
            last = n == len(e.args) - 1
            inner = (
                iter((Segment(("otherwise",), None),))
                if condition == sympy.true
                else _led("if", self._broken(condition))
            )
            yield from _closed(inner, None, "}" if last else ";")


RELATIONS = {"<=": "≤", ">=": "≥", "!=": "≠", "==": "="}
NAMES = {"Abs": "abs"}


def short(expression: sympy.Expr) -> sympy.Expr:
    """The expression with numbers of a few digits."""
    if not hasattr(expression, "atoms"):
        return sympy.sympify(expression, strict=True)
    floats = {f: sympy.Float(f"{float(f):.{DIGITS}g}") for f in expression.atoms(sympy.Float)}
    return expression.xreplace(floats) if floats else expression


def _negated(e: sympy.Expr) -> sympy.Expr:
    """-e, with the brackets of e."""
    if e.is_Mul and e.args[0].is_Number:
        number = -e.args[0]
        remaining = e.args[1:]
        factors = remaining if number == 1 else (number, *remaining)
        return factors[0] if len(factors) == 1 else sympy.Mul(*factors, evaluate=False)
    return -e


def _led(sign: str, segments: Iterator[Segment]) -> Iterator[Segment]:
    """A sign before the first piece."""
    first = next(segments)
    yield replace(first, before=(sign, *first.before))
    yield from segments


def _closed(segments: Iterator[Segment], power: sympy.Expr, sign: str = ")") -> Iterator[Segment]:
    """A bracket, with its power, behind the last piece."""
    last = next(segments)
    for segment in segments:
        yield last
        last = segment
    yield replace(last, after=(*last.after, (sign, power))) if sign else last
