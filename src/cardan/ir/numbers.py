"""Kinds of numbers that expressions can be evaluated in."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Mapping
from functools import cache
from typing import Any

from ..records import dataclass
from . import elimination
from .ops import OPERATORS
from .table import Table

Operators = dict[str, Callable[..., Any]]

# spelled the same in math, cmath and mpmath
_FUNCTIONS = (
    *("sqrt", "exp", "log", "sin", "cos", "tan", "asin", "acos", "atan"),
    *("sinh", "cosh", "tanh", "asinh", "acosh", "atanh"),
)


@dataclass(frozen=True)
class Numbers:
    """A kind of number.

    Attributes:
        name: ``float``, ``complex``, ``numpy`` or ``mp``.
        number: Conversion of a constant or an input entry.
        operators: Operator name -> its evaluation; ``stumpff`` takes k as an int.
        real: The part of a number that comparisons look at.
        eps: Relative rounding.
    """

    name: str
    number: Callable[[Any], Any]
    operators: Mapping[str, Callable[..., Any]]
    real: Callable[[Any], Any]
    eps: Any

    def table(self, table: Table, derivative: int, x: object) -> Any:
        """Derivative of a table at x."""
        interval = table.interval(self.real(x))
        h = x - self.number(table.breaks[interval])
        total = self.number(0.0)
        coefficients = table.coefficients[interval]
        for c, factor in zip(coefficients, table.factors(derivative), strict=False):
            total = total * h + self.number(c) * factor
        return total

    def solve(self, kind: str, n: int, m: int, entries: list[Any]) -> list[Any]:
        """X (n m, row by row) of A X = B, from the entries of A and B row by row."""
        a = [entries[i * n : (i + 1) * n] for i in range(n)]
        right = entries[n * n :]
        b = [right[i * m : (i + 1) * m] for i in range(n)]
        return [x for row in elimination.solve(kind, a, b, self.eps) for x in row]


def _logic(real: Callable[[Any], Any], one: object, zero: object) -> Operators:
    """Comparisons and choices, by the real part."""
    return {
        "lt": lambda a, b: one if real(a) < real(b) else zero,
        "le": lambda a, b: one if real(a) <= real(b) else zero,
        "eq": lambda a, b: one if real(a) == real(b) else zero,
        "and": lambda a, b: one if a != 0 and b != 0 else zero,
        "or": lambda a, b: one if a != 0 or b != 0 else zero,
        "not": lambda a: one if a == 0 else zero,
        "select": lambda c, a, b: a if c != 0 else b,
        "min": lambda a, b: b if real(b) < real(a) else a,
        "max": lambda a, b: b if real(b) > real(a) else a,
        "abs": lambda a: -a if real(a) < 0 else a,
        "sign": lambda a: one * ((real(a) > 0) - (real(a) < 0)),
    }


# floats: as C computes them


def _floats() -> Numbers:
    operators: Operators = {name: op.value for name, op in OPERATORS.items()}
    outside: Operators = {
        "div": lambda a, b: math.nan if a == 0 or a != a else math.copysign(math.inf, a) * _unit(b),
        "log": lambda a: -math.inf if a == 0 else math.nan,
        "exp": lambda a: math.inf,
        "cosh": lambda a: math.inf,
        "sinh": lambda a: math.copysign(math.inf, a),
        "floor": lambda a: a,
        "atanh": lambda a: math.copysign(math.inf, a) if abs(a) == 1 else math.nan,
        "pow": _power_outside,
        "stumpff": lambda k, x: math.inf if x < 0 else math.nan,
    }
    for name in (*outside, "sqrt", "sin", "cos", "tan", "asin", "acos", "acosh"):
        operators[name] = _guarded(operators[name], outside.get(name, lambda *a: math.nan))
    return Numbers("float", float, operators, lambda x: x, math.ulp(1.0))


def _unit(b: float) -> float:
    return math.copysign(1.0, b)


def _power_outside(a: float, b: float) -> float:
    """Result of C's pow where Python's raises."""
    if a < 0 and b != math.floor(b):
        return math.nan
    odd = b % 2 == 1
    if a == 0 or (abs(a) > 1) == (b > 0):
        return math.copysign(math.inf, a) if odd else math.inf
    return math.nan


def _guarded(f: Callable[..., float], outside: Callable[..., float]) -> Callable[..., float]:
    def guarded(*operands: float) -> float:
        try:
            return f(*operands)
        except (ValueError, OverflowError, ZeroDivisionError):
            return math.nan if any(x != x for x in operands) else outside(*operands)

    return guarded


# complex numbers: analytic continuation, for derivatives by complex steps


def _complexes() -> Numbers:
    def real(z: complex) -> float:
        return complex(z).real

    nan = complex(math.nan, math.nan)
    operators: Operators = {name: OPERATORS[name].value for name in ("add", "sub", "mul", "neg")}
    operators |= {name: _or(getattr(cmath, name), nan) for name in _FUNCTIONS}
    operators |= {
        "div": _or(lambda a, b: a / b, nan),
        "pow": _or(lambda a, b: a**b, nan),
        "floor": lambda a: complex(math.floor(real(a))),
        "atan2": _or(_complex_atan2, nan),
        "stumpff": _or(_complex_stumpff, nan),
    }
    operators |= _logic(real, 1 + 0j, 0j)
    return Numbers("complex", complex, operators, real, math.ulp(1.0))


def _or(f: Callable[..., Any], otherwise: object) -> Callable[..., Any]:
    """f, or a fixed value outside its domain."""

    def guarded(*operands: object) -> Any:
        try:
            return f(*operands)
        except (ValueError, OverflowError, ZeroDivisionError):
            return otherwise

    return guarded


def _complex_atan2(y: complex, x: complex) -> complex:
    """Continuation of atan2 from real arguments that keeps tiny imaginary parts."""
    a, b = y.real, x.real
    if abs(a) > abs(b):
        return math.copysign(math.pi / 2, a) - cmath.atan(x / y)
    if b == 0:
        return 0j
    return cmath.atan(y / x) + (0.0 if b > 0 else math.copysign(math.pi, a))


def _complex_stumpff(k: int, x: complex) -> complex:
    if 2.0 * abs(x) < (k + 1) * (k + 2):
        term = total = complex(1.0 / math.factorial(k))
        for i in range(k, k + 48, 2):
            term *= -x / ((i + 1) * (i + 2))
            total += term
        return total
    if k < 2:
        # cos or cosh by the sign, so that the root of a nearly real number is nearly real
        root = cmath.sqrt(x if x.real > 0 else -x)
        if k == 0:
            return cmath.cos(root) if x.real > 0 else cmath.cosh(root)
        return (cmath.sin(root) if x.real > 0 else cmath.sinh(root)) / root
    return (1.0 / math.factorial(k - 2) - _complex_stumpff(k - 2, x)) / x


# any number of digits


@cache
def digits_of(n: int) -> Numbers:
    """Numbers of n decimal digits, each a ``mpf`` of an mpmath context of its own.

    Raises:
        ModuleNotFoundError: mpmath is not installed.
    """
    import mpmath

    context = mpmath.MPContext()
    context.dps = n
    zero, one, nan = context.zero, context.one, context.nan

    def real(x: object) -> Any:
        return x

    def of_real(f: Callable[..., Any]) -> Callable[..., Any]:
        guarded = _or(f, nan)

        def real_only(*operands: object) -> Any:
            value = guarded(*operands)
            return value if isinstance(value, context.mpf) else nan

        return real_only

    operators: Operators = {name: OPERATORS[name].value for name in ("add", "sub", "mul", "neg")}
    operators |= {name: of_real(getattr(context, name)) for name in (*_FUNCTIONS, "atan2", "floor")}
    operators |= {
        "div": lambda a, b: a / b if b != 0 else nan if a == 0 else context.inf * context.sign(a),
        "pow": of_real(context.power),
        "stumpff": lambda k, x: _many_digits_stumpff(context, k, x),
    }
    operators |= _logic(real, one, zero)
    return Numbers("mp", context.mpf, operators, real, +context.eps)


def _many_digits_stumpff(context: Any, k: int, x: Any) -> Any:
    """c_k(x) by its series; digits that cancel are carried on top."""
    if not context.isfinite(x):
        return context.nan
    lost = int(1.5 * math.sqrt(abs(float(x)))) + 30
    with context.extraprec(lost):
        term = total = context.one / math.factorial(k)
        while abs(term) > context.eps * abs(total):
            term *= -x / ((k + 1) * (k + 2))
            total += term
            k += 2
    return +total


FLOATS = _floats()
COMPLEXES = _complexes()
