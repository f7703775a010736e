"""The operator table: what each operator means, costs and is spelled like in C.

A node is a tuple ``(operator, operand, ...)``. Leaves carry data instead of operands:

* ``("const", value)``: a finite double,
* ``("var", block, k)``: entry ``k`` of an input block such as ``q`` or ``p``,
* ``("atom", name)``: a named placeholder that a later stage replaces.

Two operators stand outside the table because they do not map scalars to one scalar: ``solve``
(several results, see :mod:`cardan.ir.solve`) and ``item`` (one of those results).
"""

from __future__ import annotations

import math
from collections.abc import Callable

from ..records import dataclass

LEAVES = frozenset({"const", "var", "atom"})
COMMUTATIVE = frozenset({"add", "mul", "min", "max", "eq", "and", "or"})


@dataclass(frozen=True, slots=True)
class Operator:
    """One scalar operator.

    Attributes:
        name: Name used in nodes and dumps.
        arity: Number of operands.
        cost: Relative run time, one addition being 1.
        c: C spelling with ``{0} {1} ...`` for the operands.
        value: Evaluation on Python floats; raises ValueError outside the domain.
    """

    name: str
    arity: int
    cost: float
    c: str
    value: Callable[..., float]


def stumpff(k: int, x: float) -> float:
    """Stumpff function c_k(x) = sum_i (-x)^i / (k + 2 i)!, for every real x.

    c_0(x) = cos(sqrt(x)), c_1(x) = sin(sqrt(x))/sqrt(x), c_2(x) = (1 - cos(sqrt(x)))/x, ...
    They are the sinc-like functions of rotation vectors, smooth through x = 0.

    Source: K. Stumpff, Himmelsmechanik I, 1959.
    """
    if 2.0 * abs(x) < (k + 1) * (k + 2):
        # the series: its terms fall at once, so that nothing cancels
        term = total = 1.0 / math.factorial(k)
        i = k
        while abs(term) > 1e-17 * abs(total):
            term *= -x / ((i + 1) * (i + 2))
            total += term
            i += 2
        return total
    if k < 2:
        root = math.sqrt(abs(x))
        if k == 0:
            return math.cos(root) if x > 0 else math.cosh(root)
        return (math.sin(root) if x > 0 else math.sinh(root)) / root
    if k == 2:
        # half angle: keeps the digits where 1 - cos vanishes
        return 0.5 * stumpff(1, 0.25 * x) ** 2
    return (1.0 / math.factorial(k - 2) - stumpff(k - 2, x)) / x


def _sign(x: float) -> float:
    return float((x > 0) - (x < 0))


def _operators() -> dict[str, Operator]:
    def row(
        name: str, arity: int, cost: float, c: str, value: Callable[..., float]
    ) -> tuple[str, Operator]:
        return name, Operator(name, arity, cost, c, value)

    rows = [
        row("add", 2, 1, "{0} + {1}", lambda a, b: a + b),
        row("sub", 2, 1, "{0} - {1}", lambda a, b: a - b),
        row("mul", 2, 1, "{0} * {1}", lambda a, b: a * b),
        row("div", 2, 8, "{0} / {1}", lambda a, b: a / b),
        row("neg", 1, 0, "-{0}", lambda a: -a),
        row("sqrt", 1, 8, "cardan_sqrt({0})", math.sqrt),
        row("sin", 1, 20, "cardan_sin({0})", math.sin),
        row("cos", 1, 20, "cardan_cos({0})", math.cos),
        row("tan", 1, 30, "cardan_tan({0})", math.tan),
        row("asin", 1, 30, "cardan_asin({0})", math.asin),
        row("acos", 1, 30, "cardan_acos({0})", math.acos),
        row("atan", 1, 30, "cardan_atan({0})", math.atan),
        row("atan2", 2, 40, "cardan_atan2({0}, {1})", math.atan2),
        row("exp", 1, 20, "cardan_exp({0})", math.exp),
        row("log", 1, 20, "cardan_log({0})", math.log),
        row("sinh", 1, 30, "cardan_sinh({0})", math.sinh),
        row("cosh", 1, 30, "cardan_cosh({0})", math.cosh),
        row("tanh", 1, 30, "cardan_tanh({0})", math.tanh),
        row("asinh", 1, 30, "cardan_asinh({0})", math.asinh),
        row("acosh", 1, 30, "cardan_acosh({0})", math.acosh),
        row("atanh", 1, 30, "cardan_atanh({0})", math.atanh),
        row("pow", 2, 50, "cardan_pow({0}, {1})", math.pow),
        row("abs", 1, 1, "cardan_abs({0})", abs),
        row("sign", 1, 2, "cardan_sign({0})", _sign),
        row("min", 2, 1, "cardan_min({0}, {1})", min),
        row("max", 2, 1, "cardan_max({0}, {1})", max),
        row("floor", 1, 2, "cardan_floor({0})", lambda a: float(math.floor(a))),
        row("lt", 2, 1, "cardan_lt({0}, {1})", lambda a, b: float(a < b)),
        row("le", 2, 1, "cardan_le({0}, {1})", lambda a, b: float(a <= b)),
        row("eq", 2, 1, "cardan_eq({0}, {1})", lambda a, b: float(a == b)),
        row("and", 2, 1, "cardan_and({0}, {1})", lambda a, b: float(a != 0 and b != 0)),
        row("or", 2, 1, "cardan_or({0}, {1})", lambda a, b: float(a != 0 or b != 0)),
        row("not", 1, 1, "cardan_not({0})", lambda a: float(a == 0)),
        row("select", 3, 1, "cardan_select({0}, {1}, {2})", lambda c, a, b: a if c != 0 else b),
        # stumpff(k, x): k is a constant node 0.0, 1.0, 2.0, ...
        row("stumpff", 2, 40, "cardan_stumpff({0}, {1})", lambda k, x: stumpff(int(k), x)),
        # table(k, d, x): derivative d of the k-th interpolation table of the graph
        row("table", 3, 20, "cardan_table({0}, {1}, {2})", lambda k, d, x: math.nan),
    ]
    return dict(rows)


OPERATORS: dict[str, Operator] = _operators()
