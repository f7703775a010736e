"""Expressions in files: arithmetic, declared names and a fixed list of functions.

The text is parsed here, never run as code. Lengths, depths and the sizes of numbers are checked
before anything is computed with them.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from functools import cache
from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING, Any

from ...errors import ModelError, near
from ...records import dataclass

if TYPE_CHECKING:
    import sympy

LONGEST = 4000
DEEPEST = 50
LONGEST_NUMBER = 60
LARGEST_EXPONENT = 1000
MOST_BITS = 2000

# words that take names: coordinates and speeds of joints, motion of frames
MOTION = ("q", "u", "state", "position", "velocity", "acceleration", "angular_velocity", "rotation")
AGAINST = ("wrt", "in")
RELATIONS = {"<": "Lt", "<=": "Le", ">": "Gt", ">=": "Ge", "==": "Eq", "!=": "Ne"}
_SAME = "sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh exp log sqrt sign floor atan2"
# names in files -> names in SymPy; select is apart
FUNCTIONS = {name: name for name in _SAME.split()} | {
    "abs": "Abs",
    "min": "Min",
    "max": "Max",
    "ceil": "ceiling",
    "step": "Heaviside",
    "mod": "Mod",
    "and": "And",
    "or": "Or",
    "not": "Not",
}
ARGUMENTS = {"atan2": (2, 2), "min": (1, 99), "max": (1, 99), "step": (1, 2), "mod": (2, 2),
             "and": (1, 99), "or": (1, 99)}  # fmt: skip

_TOKEN = re.compile(
    r"""\s*(?:(?P<number>(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)
    |(?P<name>[^\W\d]\w*(?:\.\w+)*)
    |(?P<quoted>"(?:[^"\\]|\\.)*")
    |(?P<sign>\*\*|<=|>=|==|!=|[-+*/^(),.<>]))""",
    re.VERBOSE,
)


@dataclass(frozen=True)
class Token:
    """A word of the text: its sort, what it says and the column where it begins."""

    sort: str
    text: str
    column: int


def parse(text: str, symbols: Mapping[Any, Any], *, where: str) -> sympy.Expr:
    """A SymPy expression.

    Args:
        text: Such as ``-l/2`` or ``k*sin(q(elbow))``.
        symbols: What names stand for: symbols, callables for measured functions, and for
            ``("q", "elbow")`` or ``("velocity", "tip", "x", None, "cart")`` the motion of joints
            and frames.
        where: Head of messages.

    Raises:
        ModelError: no expression, an unknown name, or an absurd size; with the column.
    """
    if len(text) > LONGEST:
        raise ModelError(f"{where}: an expression has at most {LONGEST} characters")
    try:
        return _Parser(_tokens(text, where), symbols, where).parse()
    except ModelError:
        raise
    except (ArithmeticError, RecursionError, TypeError, ValueError) as problem:
        reason = " ".join(str(problem).split())[:120]
        raise ModelError(f"{where}: '{text[:60]}' has no value: {reason}") from problem


def _tokens(text: str, where: str) -> list[Token]:
    tokens, position = [], 0
    while text[position:].strip():
        match = _TOKEN.match(text, position)
        if match is None:
            column = len(text) - len(text[position:].lstrip()) + 1
            wrong = text[column - 1 : column + 9]
            raise ModelError(f"{where}: column {column}: '{wrong}' is not a part of an expression")
        sort = str(match.lastgroup)
        tokens.append(Token(sort, match.group(sort), match.start(sort) + 1))
        position = match.end()
    return [*tokens, Token("end", "", len(text) + 1)]


class _Parser:
    """Recursive descent; sums and products are made of all their parts at once."""

    def __init__(self, tokens: list[Token], symbols: Mapping[Any, Any], where: str) -> None:
        self.tokens = tokens
        self.symbols = symbols
        self.where = where
        self.at = 0
        self.depth = 0

    @property
    def next(self) -> Token:
        return self.tokens[self.at]

    def take(self) -> Token:
        token = self.tokens[self.at]
        self.at = min(self.at + 1, len(self.tokens) - 1)
        return token

    def accept(self, *signs: str) -> str:
        """The sign that comes next, where it is one of these; "" otherwise."""
        return self.take().text if self.next.sort == "sign" and self.next.text in signs else ""

    def error(self, token: Token, message: str) -> ModelError:
        return ModelError(f"{self.where}: column {token.column}: {message}")

    def unexpected(self, token: Token) -> ModelError:
        if token.sort == "end":
            return self.error(token, "the expression ends too early")
        message = f"'{token.text[:40]}' is not expected here"
        if token.sort == "name":
            message += "; values with units stand under parameters, such as {value: 2, unit: kg}"
        return self.error(token, message)

    def parse(self) -> sympy.Expr:
        expression = self.relation()
        if self.next.sort != "end":
            raise self.unexpected(self.next)
        if _is_condition(expression):
            raise ModelError(
                f"{self.where}: a condition is not a value; use select(condition, a, b)"
            )
        return expression

    def relation(self) -> sympy.Expr:
        token, left = self.next, self.sum()
        sign = self.accept(*RELATIONS)
        if not sign:
            return left
        right = self.value(self.next, self.sum())
        relation = getattr(_sympy(), RELATIONS[sign])
        return relation(self.value(token, left), right, evaluate=False)

    def sum(self) -> sympy.Expr:
        self.depth += 1
        if self.depth > DEEPEST:
            raise self.error(self.next, f"parentheses and powers go at most {DEEPEST} deep")
        terms = [self.product(1)]
        while sign := self.accept("+", "-"):
            terms.append(self.product(1 if sign == "+" else -1))
        self.depth -= 1
        return terms[0] if len(terms) == 1 else self.sized(_sympy().Add, *terms)

    def product(self, sign: int) -> sympy.Expr:
        while unary := self.accept("+", "-"):
            sign = sign if unary == "+" else -sign
        factors = [self.power()]
        while operator := self.accept("*", "/"):
            token = self.next
            factor = self.value(token, self.signed())
            if operator == "/" and factor.is_zero:
                raise self.error(token, "division by zero")
            factors.append(factor if operator == "*" else _power(factor, _sympy().Integer(-1)))
        factors = [_sympy().Integer(-1), *factors] if sign < 0 else factors
        return factors[0] if len(factors) == 1 else self.sized(_sympy().Mul, *factors)

    def signed(self) -> sympy.Expr:
        """A factor with its own sign, as in ``2*-x``."""
        sign = 1
        while unary := self.accept("+", "-"):
            sign = sign if unary == "+" else -sign
        token = self.next
        return self.power() if sign > 0 else -self.value(token, self.power())

    def power(self) -> sympy.Expr:
        token, base = self.next, self.operand()
        if not self.accept("^", "**"):
            return base
        self.value(token, base)
        self.depth += 1
        if self.depth > DEEPEST:
            raise self.error(token, f"parentheses and powers go at most {DEEPEST} deep")
        exponent = self.value(self.next, self.signed())
        self.depth -= 1
        if any(abs(n) > LARGEST_EXPONENT for n in exponent.atoms(_sympy().Number)):
            raise self.error(token, f"exponents go up to {LARGEST_EXPONENT}")
        if not exponent.is_number:
            return _power(base, exponent)
        if not abs(exponent) <= LARGEST_EXPONENT:
            raise self.error(token, f"exponents go up to {LARGEST_EXPONENT}")
        if _bits(base) * abs(float(exponent)) > MOST_BITS:
            raise self.error(token, "this power is too large a number")
        if base.is_zero and not exponent.is_positive:
            raise self.error(token, "zero has no such power")
        return self.checked(token, _power(base, exponent))

    def value(self, token: Token, expression: sympy.Expr) -> sympy.Expr:
        if _is_condition(expression):
            raise self.error(token, "a condition is not a value; use select(condition, a, b)")
        return expression

    def sized(self, make: Callable[..., sympy.Expr], *parts: sympy.Expr) -> sympy.Expr:
        """A sum or product, unless its numbers grow beyond all use."""
        for part in parts:
            self.value(self.next, part)
        if sum(map(_bits, parts)) > MOST_BITS * 8:
            raise self.error(self.next, "the numbers of this expression are too large")
        return make(*parts)

    def operand(self) -> sympy.Expr:
        token = self.take()
        if token.sort == "number":
            return self.number(token)
        if token.text == "(" and token.sort == "sign":
            expression = self.relation()
            self.close(token)
            return expression
        if token.sort == "name" and self.accept("("):
            return self.motion(token) if token.text in MOTION else self.call(token)
        if token.sort in ("name", "quoted"):
            return self.named(token)
        raise self.unexpected(token)

    def number(self, token: Token) -> sympy.Expr:
        if len(token.text) > LONGEST_NUMBER:
            raise self.error(token, f"a number of {len(token.text)} characters is too long")
        if token.text.isdigit():
            return _sympy().Integer(int(token.text))
        value = float(token.text)
        if abs(value) > 1e300:
            raise self.error(token, f"{token.text} is too large; numbers go up to 1e300")
        return _sympy().Float(value)

    def close(self, opening: Token) -> None:
        if not self.accept(")"):
            missing = f"before the ) that belongs to column {opening.column}"
            if self.next.sort == "end":
                # a comma ends a plain text inside [] and {}
                hint = "; in [] and {} an expression with commas needs quotes"
                raise self.error(self.next, f"the expression ends {missing}{hint}")
            raise self.error(self.next, f"'{self.next.text[:40]}' stands {missing}")

    # names and functions

    def named(self, token: Token) -> sympy.Expr:
        name = unquoted(token)
        try:
            symbol = self.symbols[name]
        except KeyError:
            symbol = _sympy().pi if token.text == "pi" else None
        if symbol is None:
            hint = near(name, [*map(str, self.symbols), *FUNCTIONS, *MOTION])
            raise self.error(token, f"'{name[:80]}' is not known here.{hint}")
        if not hasattr(symbol, "free_symbols"):
            raise self.error(token, f"'{name[:80]}' is a function; write {name[:80]}(x)")
        return symbol

    def motion(self, token: Token) -> sympy.Expr:
        """``q(elbow)``, ``velocity(tip).x``, ``velocity(tip wrt base in cart).x``."""
        name = self.name()
        if token.text in ("q", "u", "state"):
            self.close(token)
            return self.moving(token, (token.text, name))
        against: dict[str, str | None] = dict.fromkeys(AGAINST)
        for word in AGAINST:
            if self.next.sort == "name" and self.next.text == word:
                self.take()
                against[word] = self.name()
        self.close(token)
        if not self.accept("."):
            raise self.error(self.next, f"say which component: {token.text}(...).x")
        return self.moving(token, (token.text, name, self.name(), *against.values()))

    def moving(self, token: Token, key: tuple[str | None, ...]) -> sympy.Expr:
        symbol = self.symbols.get(key)
        if symbol is None:
            raise self.error(token, f"{token.text}({key[1]}): nothing moves here")
        return symbol

    def name(self) -> str:
        word = self.take()
        if word.sort not in ("name", "quoted"):
            raise self.unexpected(word)
        return unquoted(word)

    def call(self, token: Token) -> sympy.Expr:
        arguments = [self.relation()]
        while self.accept(","):
            arguments.append(self.relation())
        self.close(token)
        name = token.text
        if name == "select":
            return self.select(token, arguments)
        logical = name in ("and", "or", "not")
        for argument in arguments:
            if _is_condition(argument) != logical:
                expected = "conditions such as t < 1" if logical else "values, no conditions"
                raise self.error(token, f"{name[:80]} takes {expected}")
        if name in self.symbols:
            return self.table(token, arguments)
        if name not in FUNCTIONS:
            names = [*FUNCTIONS, "select"]
            raise self.error(token, f"there is no function '{name[:80]}'." + near(name, names))
        least, most = ARGUMENTS.get(name, (1, 1))
        if not least <= len(arguments) <= most:
            raise self.error(token, f"{name} does not take {len(arguments)} values")
        if name == "mod" and arguments[1].is_zero:
            raise self.error(token, "division by zero")
        function = getattr(_sympy(), FUNCTIONS[name])
        if name == "sqrt":
            return self.checked(token, _power(arguments[0], _sympy().Rational(1, 2)))
        # not evaluated: SymPy would work out numbers of any size, or try to for hours
        return self.checked(token, function(*map(_plain, arguments), evaluate=False))

    def table(self, token: Token, arguments: list[sympy.Expr]) -> sympy.Expr:
        """The value of a measured function."""
        function = self.symbols[token.text]
        if hasattr(function, "free_symbols") or len(arguments) != 1:
            what = f"'{token.text[:80]}' is not a function of {len(arguments)} values"
            raise self.error(token, what)
        return function(*arguments)

    def checked(self, token: Token, expression: sympy.Expr) -> sympy.Expr:
        """A result that, where it is a number, is real and of sane size."""
        sympy = _sympy()
        if expression.has(sympy.zoo, sympy.oo, -sympy.oo, sympy.nan):
            raise self.error(token, f"'{token.text[:40]}' is not finite here")
        if not getattr(expression, "is_number", False) or expression.is_Rational:
            return expression
        value = expression.evalf(17)
        if not value.is_Float and not value.is_Rational:
            raise self.error(token, f"'{token.text[:40]}' is not a real number here")
        if abs(value) > 1e300:
            raise self.error(token, f"'{token.text[:40]}' is too large here")
        # functions of numbers are numbers; roots stay what they are
        return expression if expression.is_Pow or expression.is_Float else sympy.Float(float(value))

    def select(self, token: Token, arguments: list[sympy.Expr]) -> sympy.Expr:
        """``select(condition, a, condition, b, c)``: the first value whose condition holds."""
        sympy = _sympy()
        if len(arguments) < 3 or len(arguments) % 2 == 0:
            raise self.error(token, "select takes condition, value, ..., and a value otherwise")
        *cases, otherwise = arguments
        branches = list(zip(cases[1::2], cases[::2], strict=True))
        if not all(_is_condition(condition) for _, condition in branches):
            raise self.error(token, "select needs a condition such as t < 1 before each value")
        if any(condition.has(sympy.Piecewise) for _, condition in branches):
            raise self.error(token, "a condition has no select in it; write and, or, not")
        if any(map(_is_condition, (otherwise, *cases[1::2]))):
            raise self.error(token, "select chooses between values, not conditions")
        return sympy.Piecewise(*branches, (otherwise, True), evaluate=False)


def unquoted(token: Token) -> str:
    """The name a token says."""
    return re.sub(r"\\(.)", r"\1", token.text[1:-1]) if token.sort == "quoted" else token.text


def _bits(e: sympy.Expr) -> int:
    """Bits of the largest number in an expression, as far as it is exact."""
    return max(
        (max(abs(int(n.p)), int(n.q)).bit_length() for n in e.atoms() if n.is_Rational), default=1
    )


def _power(base: sympy.Expr, exponent: sympy.Expr) -> sympy.Expr:
    """A power; one of functions is not evaluated: SymPy would ask at length for their signs."""
    if base.is_Pow and base.exp.is_Rational and exponent.is_Integer:
        base, exponent = base.base, base.exp * exponent
    simple = exponent.is_number and not base.has(_sympy().Function)
    return base**exponent if simple else _sympy().Pow(base, exponent, evaluate=False)


def _plain(argument: sympy.Expr) -> sympy.Expr:
    """Numbers that are roots or multiples of pi as floats."""
    if getattr(argument, "is_number", False) and not argument.is_Number:
        return _sympy().Float(float(argument))
    return argument


def _is_condition(e: sympy.Expr) -> bool:
    return bool(getattr(e, "is_Relational", False) or getattr(e, "is_Boolean", False))


@cache
def _sympy() -> ModuleType:
    return import_module("sympy")
