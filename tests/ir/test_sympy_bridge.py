"""SymPy in and out."""

from __future__ import annotations

import math

import pytest
import sympy as sp
from hypothesis import given, settings

from cardan.errors import ModelError
from cardan.ir.arithmetic import Scalar
from cardan.ir.forms.sympy_bridge import from_sympy, to_sympy, to_sympy_shared
from cardan.ir.function import Block, Function, Output
from cardan.ir.graph import Graph
from cardan.ir.matrix import Matrix
from cardan.ir.solve import solve
from cardan.ir.table import Table
from ir.expressions import STATE, function, functions, y
from table import each

a, b, c = sp.symbols("a b c")
EPS = math.ulp(1.0)

EXPRESSIONS = [
    3 * a - b / 2 + sp.pi,
    sp.Rational(1, 3) * a * b / c**2,
    -a / (b * c),
    sp.sqrt(a) * b ** sp.Rational(3, 2) + c ** sp.Rational(1, 3),
    a**b - 2**c + a**-3,
    sp.exp(-(a**2)) * sp.log(b + c) + sp.E**a,
    sp.sin(a) + sp.cos(b) * sp.tan(c),
    sp.asin(a) + sp.acos(b) + sp.atan(c) + sp.atan2(a, b),
    sp.sinh(a) - sp.cosh(b) / sp.tanh(c),
    sp.asinh(a) + sp.acosh(c) + sp.atanh(b),
    sp.cot(a) + sp.sec(b) + sp.csc(c) + sp.acot(a) + sp.asec(c) + sp.acsc(c),
    sp.coth(a) + sp.sech(b) + sp.csch(c) + sp.acoth(c) + sp.asech(a) + sp.acsch(b),
    sp.sinc(a) * sp.Abs(b - c) * sp.sign(b - c),
    sp.Min(a, b, c) + sp.Max(a, -b, c) + sp.floor(3 * c) + sp.ceiling(5 * a) + sp.Mod(c, a),
    sp.frac(7 * a),
    sp.Heaviside(a - b) + sp.Heaviside(b - a) * c,
    sp.Piecewise((a, a > b), (b**2, sp.And(a < 1, b <= c)), (c, True)),
    sp.Piecewise((a, sp.Or(a > 1, sp.Not(sp.Eq(b, c)))), (c, True)),
    sp.Piecewise((a, sp.Xor(a > 0, b > 1)), (c, True)) + sp.Piecewise((1, sp.Ne(a, b)), (2, True)),
    sp.Piecewise((a, sp.ITE(a > b, b > c, c > b)), (b, True)),
    sp.Integer(7),
    sp.S.Half + sp.sqrt(2) + sp.GoldenRatio,
]
POINT = {"q": [0.7, 0.3, 1.4, 0.0]}


def converted(expression: sp.Expr) -> Function:
    g = Graph()
    symbols = {s: g.var("q", k) for k, s in enumerate((a, b, c))}
    return function(g, [from_sympy(g, expression, symbols)])


@each("expression", EXPRESSIONS)
def test_values_agree_with_sympy(expression: sp.Expr) -> None:
    exact = expression.subs(
        {a: sp.Float("0.7", 30), b: sp.Float("0.3", 30), c: sp.Float("1.4", 30)}
    )
    value = y(converted(expression), POINT)[0]
    # POINT is rounded to doubles: conditions of these expressions stay below ten
    assert value == pytest.approx(float(exact), rel=20 * EPS)


@each("expression", EXPRESSIONS)
def test_there_and_back(expression: sp.Expr) -> None:
    f = converted(expression)
    names = {("q", k): s for k, s in enumerate((a, b, c))}
    again = converted(to_sympy(f, names)[0])
    assert y(again, POINT)[0] == pytest.approx(y(f, POINT)[0], rel=4 * EPS)


@each(
    ("expression", "message"),
    [
        (sp.Symbol("aa") * b, r"symbol 'aa' in 'aa\*b' is not known.*Did you mean 'a'\?"),
        (sp.Symbol("a", positive=True), "other assumptions"),
        (sp.gamma(a), "'gamma' in 'gamma\\(a\\)' is not a function"),
        (sp.Function("f")(a), "'f' in 'f\\(a\\)' is not a function"),
        (sp.I * a, "not a finite real number"),
        (a + sp.zoo, "not a finite real number"),
        (sp.Integer(10) ** 400 * a, "too large"),
        (sp.Piecewise((a, a > b)), "end it with the piece"),
        (sp.Heaviside(a).diff(a), "DiracDelta"),
    ],
)
def test_what_cannot_be_converted_is_named(expression: sp.Expr, message: str) -> None:
    with pytest.raises(ModelError, match=message):
        converted(expression)


def test_any_subexpression_may_be_given() -> None:
    g = Graph()
    x = sp.Function("x")(sp.Symbol("t"))
    speed = x.diff(sp.Symbol("t"))
    node = from_sympy(g, x * speed, {x: g.var("q", 0), speed: g.var("u", 0)})
    assert node == g.mul(g.var("q", 0), g.var("u", 0))


def test_long_expressions_need_no_recursion() -> None:
    e: sp.Expr = a
    for _ in range(3000):
        e = sp.sin(e, evaluate=False)
    g = Graph()
    from_sympy(g, e, {a: g.var("q", 0)})
    assert len(g) == 3 + 1 + 3000


def test_tables() -> None:
    table = Table((0.0, 1.0), ((3.0, 2.0, 1.0),))
    g = Graph()
    q = g.var("q", 0)
    f = function(g, [g.interpolate(table, q), g.interpolate(table, q, 1)])
    out = to_sympy(f)
    other = Graph()
    symbol = {sp.Symbol("q0"): other.var("q", 0)}
    back = function(other, [from_sympy(other, e, symbol) for e in out])
    assert other.tables == [table]
    assert y(back, {"q": [2, 0, 0, 0]}) == y(f, {"q": [2, 0, 0, 0]}) == [17, 14]


def substituted(e: sp.Expr) -> complex:
    values = {sp.Symbol(f"{k}{i}"): v for k, vs in STATE.items() for i, v in enumerate(vs)}
    return complex(e.subs(values).evalf(30))


@settings(max_examples=25, deadline=None)
@given(functions(most=12))
def test_random_expressions_out(f: Function) -> None:
    full = to_sympy(f)
    replacements, shared = to_sympy_shared(f)
    for value, e, s in zip(y(f), full, shared, strict=True):
        for symbol, inner in reversed(replacements):
            s = s.subs(symbol, inner)
        assert substituted(e) == pytest.approx(value, rel=1e-10, abs=1e-10)
        assert substituted(s) == pytest.approx(value, rel=1e-10, abs=1e-10)


def test_shapes_names_and_numbers() -> None:
    g = Graph()
    q = g.var("q", 0)
    nodes = (q, g.const(0.375), g.const(math.pi / 2), g.atom("load"), g.const(0.1), g.const(-2.0))
    f = Function("f", g, (Block("q", ("elbow",), ("rad",)),), (Output("M", (2, 3), nodes),))
    elbow, load = sp.symbols("elbow load")
    assert to_sympy(f) == sp.Matrix([[elbow, sp.Rational(3, 8), sp.pi / 2], [load, 0.1, -2]])
    assert to_sympy(Matrix(g, 1, 1, (q,)), {("q", 0): a}) == sp.Matrix([[a]])
    assert to_sympy(Scalar(g, g.square(q))) == sp.Symbol("q0") ** 2


def test_shared_expressions_avoid_the_users_names() -> None:
    g = Graph()
    s = g.apply("sin", g.var("q", 0))
    names = {("q", 0): sp.Symbol("x0")}
    replacements, m = to_sympy_shared(Matrix(g, 1, 1, (g.mul(s, s),)), names)
    x0, x1 = sp.symbols("x0 x1")
    assert replacements == [(x1, sp.sin(x0))]
    assert m == sp.Matrix([[x1**2]])


@pytest.mark.parametrize("kind", ["spd", "rank_revealing"])
def test_systems_are_written_out(kind: str) -> None:
    g = Graph()
    p = [g.var("p", k) for k in range(4)]
    x = solve(kind, Matrix(g, 2, 2, [p[0], p[1], p[1], p[2]]), Matrix.vector(g, [1.0, 0.0]))
    p0, p1, p2 = sp.symbols("p0 p1 p2")
    expected = sp.Matrix([p2, -p1]) / (p0 * p2 - p1**2)
    assert sp.simplify(to_sympy(x) - expected) == sp.zeros(2, 1)
