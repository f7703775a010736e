"""Every operator: its kinds of numbers agree, its derivative is the limit of differences."""

from __future__ import annotations

import math

import mpmath
import pytest

from cardan.ir.derivative import forward, gradient
from cardan.ir.graph import ONE, Graph
from cardan.ir.ops import OPERATORS
from cardan.ir.table import Table
from ir.expressions import function, y
from table import each

EPS = math.ulp(1.0)

# points inside the domain and away from corners
ANY = (-7.3, -1.2, -0.4, 0.013, 0.9, 2.6)
POSITIVE = (1e-4, 0.3, 1.7, 40.0)
INSIDE = (-0.97, -0.2, 1e-5, 0.6)
POINTS: dict[str, tuple[float, ...]] = {
    "sqrt": POSITIVE,
    "log": POSITIVE,
    "asin": INSIDE,
    "acos": INSIDE,
    "atanh": INSIDE,
    "acosh": (1.001, 1.8, 30.0),
}
PAIRS = tuple((a, b) for a in (-1.3, 0.2, 2.1) for b in (-0.7, 0.9, 3.4))
POWERS = ((0.3, 2.2), (1.7, -0.6), (2.5, 17.0), (0.04, 0.5))


def arguments(name: str) -> list[tuple[float, ...]]:
    arity = OPERATORS[name].arity
    if name == "pow":
        return list(POWERS)
    if arity == 1:
        return [(x,) for x in POINTS.get(name, ANY)]
    if arity == 2:
        return list(PAIRS)
    return [(c, a, b) for c in (0.0, 1.0, -2.0) for a, b in PAIRS]


SCALAR = sorted(set(OPERATORS) - {"stumpff", "table"})
CASES = [(name, x) for name in SCALAR for x in arguments(name)]


@each(("name", "x"), CASES)
def test_derivative_is_the_limit_of_differences(name: str, x: tuple[float, ...]) -> None:
    g = Graph()
    q = [g.var("q", k) for k in range(len(x))]
    root = g.apply(name, *q)
    f = function(g, [root])
    backward = gradient(g, root, q)
    for k in range(len(x)):
        both = function(g, [forward(g, [root], {q[k]: ONE})[0], backward[k]])
        point = [*map(mpmath.mpf, x), 0, 0, 0][:4]
        with mpmath.workdps(60):
            h = mpmath.mpf(10) ** -15
            ends = [[v + s * h * (i == k) for i, v in enumerate(point)] for s in (1, -1)]
            high, low = (y(f, {"q": end}, "mp", 60)[0] for end in ends)
            # central difference: its error is h^2 = 1e-30 times the third derivative
            expected = (high - low) / (2 * h)
        for value in y(both, {"q": point}, "mp", 60):
            assert abs(value - expected) <= mpmath.mpf(10) ** -18 * (1 + abs(expected))


@each(("name", "x"), CASES)
def test_complex_step_agrees_with_the_derivative(name: str, x: tuple[float, ...]) -> None:
    g = Graph()
    q = [g.var("q", k) for k in range(len(x))]
    root = g.apply(name, *q)
    f = function(g, [root])
    for k in range(len(x)):
        values: list[complex] = [*x, 0, 0, 0][:4]
        exact = y(function(g, forward(g, [root], {q[k]: ONE})), {"q": values})[0]
        values[k] += 1e-30j
        for kind in ("complex", "numpy"):
            step = y(f, {"q": values}, kind)[0].imag / 1e-30
            # near the ends of a domain the derivative amplifies the rounding of 1 - x
            assert step == pytest.approx(exact, rel=300 * EPS, abs=4 * EPS)


@each(("name", "x"), CASES)
def test_kinds_of_numbers_agree(name: str, x: tuple[float, ...]) -> None:
    g = Graph()
    f = function(g, [g.apply(name, *[g.var("q", k) for k in range(len(x))])])
    values = {"q": [*x, 0, 0, 0][:4]}
    reference = y(f, values, "mp")[0]
    for kind in ("float", "numpy", "complex"):
        value = complex(y(f, values, kind)[0])
        assert value.imag == 0
        # 17th power of a number and its logarithm: some roundings
        assert value.real == pytest.approx(float(reference), rel=20 * EPS, abs=2 * EPS)


def test_every_operator_has_a_case() -> None:
    assert {name for name, _ in CASES} | {"stumpff", "table"} == set(OPERATORS)


def test_outside_the_domain_is_what_c_gives() -> None:
    g = Graph()
    x = [g.var("q", k) for k in range(4)]
    roots = [
        g.div(x[0], x[1]),
        g.div(x[2], x[1]),
        g.apply("sqrt", x[2]),
        g.apply("log", x[1]),
        g.apply("log", x[2]),
        g.apply("exp", x[3]),
        g.apply("sinh", g.neg(x[3])),
        g.apply("pow", x[1], x[2]),
        g.apply("pow", x[2], g.const(0.3)),
        g.apply("pow", x[3], x[3]),
        g.apply("atanh", x[0]),
        g.apply("asin", x[3]),
    ]
    f = function(g, roots)
    values = {"q": [1.0, 0.0, -1.0, 1000.0]}
    inf, nan = math.inf, math.nan
    expected = [inf, -inf, nan, -inf, nan, inf, -inf, inf, nan, inf, inf, nan]
    for kind in ("float", "numpy"):
        assert y(f, values, kind) == pytest.approx(expected, nan_ok=True)


TABLE = Table((0.0, 1.0, 2.5), ((2.0, -1.0, 0.5, 0.25), (0.5, 1.0, -2.0, 1.75)))


@each("x", [-0.5, 0.0, 0.6, 1.0, 2.2, 4.0])
@each("derivative", [0, 1, 2, 3, 4])
def test_table_and_its_derivatives(x: float, derivative: int) -> None:
    g = Graph()
    q = g.var("q", 0)
    root = g.interpolate(TABLE, q)
    for _ in range(derivative):
        root = forward(g, [root], {q: ONE})[0]
    # outside, the end pieces continue
    piece = 0 if x < 1.0 else 1
    polynomial = mpmath.polyval
    h, coefficients = x - TABLE.breaks[piece], list(TABLE.coefficients[piece])
    for _ in range(derivative):
        n = len(coefficients) - 1
        coefficients = [c * (n - k) for k, c in enumerate(coefficients[:-1])] or [0.0]
    for kind in ("float", "numpy", "complex", "mp"):
        value = y(function(g, [root]), {"q": [x, 0, 0, 0]}, kind)[0]
        assert complex(value) == pytest.approx(complex(polynomial(coefficients, h)), abs=8 * EPS)
