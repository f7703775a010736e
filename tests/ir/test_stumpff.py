"""Stumpff functions: every branch, their derivatives, their joints."""

from __future__ import annotations

import math

import mpmath
import numpy as np
import pytest

from cardan.ir.arrays import stumpff as of_arrays
from cardan.ir.derivative import forward, gradient
from cardan.ir.graph import ONE, Graph
from cardan.ir.ops import stumpff
from ir.expressions import function, y
from table import each

EPS = math.ulp(1.0)
ORDERS = range(8)
SIZES = (0.0, 1e-300, 1e-9, 1e-3, 0.3, 0.999999, 1.0, 1.000001, 3.0, 6.0, 9.8, 15.0, 36.0, 120.0)
POINTS = sorted({s * x for x in SIZES for s in (1, -1)})


def exact(k: int, x: float) -> mpmath.mpf:
    """The defining series in 60 digits."""
    with mpmath.workdps(60):
        terms = [(-mpmath.mpf(x)) ** i / mpmath.factorial(k + 2 * i) for i in range(120)]
        return mpmath.fsum(terms)


def amplitude(k: int, x: float) -> float:
    """What rounding errors are relative to: c_0 and c_1 swing through zero for x > 0."""
    if x > 1 and k < 2:
        return 1.0 if k == 0 else 1.0 / math.sqrt(x)
    return abs(float(exact(k, x)))


@each("k", ORDERS)
@each("x", POINTS)
def test_value(k: int, x: float) -> None:
    # root, sine, two divisions: half a dozen roundings; cosh and sinh amplify those of the root
    bound = (8 + math.sqrt(abs(x))) * EPS * amplitude(k, x)
    assert abs(stumpff(k, x) - exact(k, x)) <= bound
    assert abs(float(of_arrays(k, np.array([x, 0.5]))[0]) - exact(k, x)) <= bound
    assert of_arrays(k, np.array([0.5]))[0] == pytest.approx(stumpff(k, 0.5), rel=4 * EPS)


@each("k", ORDERS)
def test_no_step_where_the_formula_changes(k: int) -> None:
    change = (k + 1) * (k + 2) / 2
    for edge in (change, -change):
        below, above = math.nextafter(edge, 0), math.nextafter(edge, 2 * edge)
        assert stumpff(k, below) == pytest.approx(stumpff(k, above), rel=8 * EPS)


def test_half_turns_keep_their_digits() -> None:
    # 1 - cos vanishes after full turns; its digits hang on those of the angle
    x = (2 * math.pi + 1e-5) ** 2
    root = mpmath.sqrt(mpmath.mpf(x))
    expected = (1 - mpmath.cos(root)) / x
    assert stumpff(2, x) == pytest.approx(float(expected), rel=1e-9)


@each("k", range(6))
@each("x", POINTS)
def test_derivative(k: int, x: float) -> None:
    g = Graph()
    q = g.var("q", 0)
    root = g.apply("stumpff", g.const(float(k)), q)
    roots = [forward(g, [root], {q: ONE})[0], gradient(g, root, [q])[0]]
    with mpmath.workdps(60):
        h = mpmath.mpf(10) ** -18
        ends = (exact_mp(k, mpmath.mpf(x) + h), exact_mp(k, mpmath.mpf(x) - h))
        expected = (ends[0] - ends[1]) / (2 * h)
    for value in y(function(g, roots), {"q": [x, 0, 0, 0]}, "mp", 50):
        assert abs(value - expected) <= mpmath.mpf(10) ** -30 * (1 + abs(expected))


def exact_mp(k: int, x: mpmath.mpf) -> mpmath.mpf:
    return mpmath.fsum((-x) ** i / mpmath.factorial(k + 2 * i) for i in range(120))


@each("k", range(6))
@each("x", POINTS)
def test_complex_step(k: int, x: float) -> None:
    g = Graph()
    q = g.var("q", 0)
    f = function(g, [g.apply("stumpff", g.const(float(k)), q)])
    step = y(f, {"q": [x + 1e-30j, 0, 0, 0]}, "complex")[0].imag / 1e-30
    slope = forward(g, f.roots, {q: ONE})
    exactly = float(y(function(g, slope), {"q": [x, 0, 0, 0]}, "mp")[0])
    # the recursion divides differences of nearly equal numbers once per two orders
    assert step == pytest.approx(exactly, rel=2000 * EPS, abs=20 * EPS)


def test_many_digits_where_terms_cancel() -> None:
    g = Graph()
    f = function(g, [g.apply("stumpff", ONE, g.var("q", 0))])
    with mpmath.workdps(60):
        expected = mpmath.sin(mpmath.mpf(100)) / 100
        value = y(f, {"q": [10000, 0, 0, 0]}, "mp", 50)[0]
        assert abs(value - expected) < mpmath.mpf(10) ** -50
