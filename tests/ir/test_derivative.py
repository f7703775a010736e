"""Derivatives of compositions: corners, systems, both sweeps, higher orders."""

from __future__ import annotations

import math

import mpmath
import pytest
from hypothesis import given, settings

from cardan.ir.arithmetic import Scalar, norm, stumpff
from cardan.ir.derivative import forward, gradient, jacobian
from cardan.ir.function import Function
from cardan.ir.graph import ONE, ZERO, Graph
from cardan.ir.matrix import Matrix
from cardan.ir.solve import KINDS, solve
from ir.expressions import STATE, function, functions, leaves, y
from table import each

KINDS_OF_NUMBERS = ("float", "complex", "numpy", "mp")


def slopes(g: Graph, root: int, q: list[int]) -> Function:
    """Derivatives by both sweeps, one after the other."""
    return function(g, [forward(g, [root], {x: ONE})[0] for x in q] + gradient(g, root, q))


CORNERS = {
    "sqrt at 0": (lambda g, q: g.apply("sqrt", q[0]), [0, 0], [0, 0]),
    "norm at 0": (lambda g, q: norm(Scalar(g, q[0]), Scalar(g, q[1])).node, [0, 0], [0, 0]),
    "norm": (lambda g, q: norm(Scalar(g, q[0]), Scalar(g, q[1])).node, [3, -4], [0.6, -0.8]),
    "norm of one": (lambda g, q: norm(Scalar(g, q[0])).node, [-3, 0], [-1, 0]),
    "norm of one at 0": (lambda g, q: norm(Scalar(g, q[0])).node, [0, 0], [0, 0]),
    "angle of the origin": (lambda g, q: g.apply("atan2", *q), [0, 0], [0, 0]),
    "angle on the cut": (lambda g, q: g.apply("atan2", *q), [0, -2], [-0.5, 0]),
    "angle straight up": (lambda g, q: g.apply("atan2", *q), [2, 0], [0, -0.5]),
    "abs at 0": (lambda g, q: g.apply("abs", q[0]), [0, 0], [0, 0]),
    "abs below 0": (lambda g, q: g.apply("abs", q[0]), [-2, 0], [-1, 0]),
    "asin at 1": (lambda g, q: g.apply("asin", q[0]), [1, 0], [0, 0]),
    "acos at -1": (lambda g, q: g.apply("acos", q[0]), [-1, 0], [0, 0]),
    "acosh at 1": (lambda g, q: g.apply("acosh", q[0]), [1, 0], [0, 0]),
    "root power at 0": (lambda g, q: g.apply("pow", q[0], g.const(0.3)), [0, 0], [0, 0]),
    "power of 0": (lambda g, q: g.apply("pow", *q), [0, 2], [0, 0]),
    "square at 0": (lambda g, q: g.power(q[0], 2.0), [0, 0], [0, 0]),
    "min of equals": (lambda g, q: g.apply("min", *q), [1, 1], [1, 0]),
    "max of equals": (lambda g, q: g.apply("max", *q), [1, 1], [1, 0]),
    "floor": (lambda g, q: g.apply("floor", q[0]), [1.5, 0], [0, 0]),
    "comparison": (lambda g, q: g.apply("lt", *q), [1, 1], [0, 0]),
    "logic": (lambda g, q: g.apply("and", q[0], g.apply("not", q[1])), [1, 0], [0, 0]),
    "stumpff at 0": (lambda g, q: stumpff(1, Scalar(g, q[0])).node, [0, 0], [-1 / 6, 0]),
    "other side infinite": (
        lambda g, q: g.apply("select", q[0], g.div(q[1], q[0]), q[1]),
        [0, 3],
        [0, 1],
    ),
}


@each("kind", KINDS_OF_NUMBERS)
@each("name", CORNERS)
def test_corners_have_the_documented_derivative(name: str, kind: str) -> None:
    make, at, expected = CORNERS[name]
    g = Graph()
    q = [g.var("q", k) for k in range(2)]
    f = slopes(g, make(g, q), q)
    values = [complex(x) for x in y(f, {"q": [*at, 0, 0]}, kind)]
    # the sixth is the only number that is not exact
    assert values == pytest.approx([complex(x) for x in expected * 2], abs=math.ulp(1.0))


def test_second_derivative_of_a_norm_is_finite_at_zero() -> None:
    g = Graph()
    q = [g.var("q", k) for k in range(3)]
    length = norm(*[Scalar(g, x) for x in q]).node
    first = gradient(g, length, q)
    f = function(g, [x for row in jacobian(g, first, q) for x in row])
    assert y(f, {"q": [0, 0, 0, 0]}) == [0.0] * 9
    # (1 - v vᵀ/|v|²)/|v| elsewhere
    v = [2.0, -1.0, 2.0]
    expected = [((i == j) - v[i] * v[j] / 9) / 3 for i in range(3) for j in range(3)]
    assert y(f, {"q": [*v, 0]}) == pytest.approx(expected, abs=4 * math.ulp(1.0))


def systems(kind: str) -> tuple[Graph, list[int], int]:
    """An expression of both entries of a solution, A and B depending on q and u."""
    g = Graph()
    x = leaves(g)
    a = Matrix(g, 2, 2, [g.add(g.const(3.0), g.square(x[0])), x[1], x[1], g.apply("exp", x[2])])
    if kind == "rank_revealing":
        a = Matrix(g, 2, 2, [a.nodes[0], x[4], x[1], a.nodes[3]])
    b = Matrix(g, 2, 2, [g.apply("sin", x[3]), ZERO, g.mul(x[4], x[5]), x[6]])
    s = solve(kind, a, b).nodes
    return g, x, g.add(g.mul(s[0], s[3]), g.apply("sin", g.add(s[1], s[2])))


@pytest.mark.parametrize("kind", KINDS)
def test_derivative_of_a_system(kind: str) -> None:
    g, x, root = systems(kind)
    f = function(g, [root])
    both = y(slopes(g, root, x), None, "mp")
    with mpmath.workdps(40):
        h = mpmath.mpf(10) ** -14
        for k, (block, i) in enumerate((n[1], n[2]) for n in map(g.nodes.__getitem__, x)):
            ends = []
            for s in (1, -1):
                moved = {b: [mpmath.mpf(v) for v in values] for b, values in STATE.items()}
                moved[block][i] += s * h
                ends.append(y(f, moved, "mp")[0])
            expected = (ends[0] - ends[1]) / (2 * h)
            # h² = 1e-28 of a central difference, 1e-40/h of rounding
            assert abs(both[k] - expected) < 1e-24
            assert abs(both[k + len(x)] - expected) < 1e-24


def test_second_derivatives_of_a_system_are_symmetric() -> None:
    g, x, root = systems("spd")
    rows = [gradient(g, d, x) for d in gradient(g, root, x)]
    n = len(x)
    h = y(function(g, [e for row in rows for e in row]), None, "mp")
    assert max(abs(h[i * n + j] - h[j * n + i]) for i in range(n) for j in range(n)) < 1e-37
    assert max(map(abs, h)) > 0.1


@settings(max_examples=60, deadline=None)
@given(functions())
def test_both_sweeps_agree(f: Function) -> None:
    g, x = f.graph, leaves(f.graph)
    for root in f.roots:
        values = y(slopes(g, root, x), None, "mp", 80)
        ahead, back = values[: len(x)], values[len(x) :]
        size = 1 + max(map(abs, values))
        assert all(abs(a - b) <= 1e-40 * size for a, b in zip(ahead, back, strict=True))


@settings(max_examples=60, deadline=None)
@given(functions())
def test_derivative_along_a_direction_is_the_limit_of_differences(f: Function) -> None:
    g, x = f.graph, leaves(f.graph)
    seeds = {node: g.const(0.25 * (k % 5) - 0.5) for k, node in enumerate(x)}
    slope = y(function(g, forward(g, f.roots, seeds)), None, "mp", 60)
    with mpmath.workdps(60):
        h = mpmath.mpf(10) ** -20
        ends = []
        for s in (h, -h):
            moved = {b: [mpmath.mpf(v) for v in values] for b, values in STATE.items()}
            for node, seed in seeds.items():
                _, block, i = g.nodes[node]
                moved[block][i] += s * g.nodes[seed][1]
            ends.append(y(f, moved, "mp", 60))
        for a, b, d in zip(*ends, slope, strict=True):
            expected = (a - b) / (2 * h)
            # 1e-40 times a third derivative of random expressions; steps of choices are not met
            assert abs(d - expected) <= 1e-20 * (1 + abs(expected))


def test_seeds_may_be_inner_nodes() -> None:
    g = Graph()
    q = [g.var("q", k) for k in range(2)]
    inner = g.apply("sin", q[0])
    root = g.mul(inner, g.add(inner, q[0]))
    # with sin(q) as the variable: 2 s + q
    expected = g.add(g.add(inner, q[0]), inner)
    f = function(g, [*forward(g, [root], {inner: ONE}), *gradient(g, root, [inner]), expected])
    a, b, c = y(f)
    assert a == b == c


def test_what_does_not_depend_has_the_structural_zero() -> None:
    g = Graph()
    q = [g.var("q", k) for k in range(3)]
    root = g.mul(q[0], g.apply("cos", q[1]))
    assert forward(g, [root, ZERO, q[2]], {q[2]: ONE}) == [ZERO, ZERO, ONE]
    assert gradient(g, root, [q[2]]) == [ZERO]
    assert jacobian(g, [root], [q[2], q[0]]) == [[ZERO, g.apply("cos", q[1])]]


@pytest.mark.parametrize("rows", [1, 3])
def test_jacobian_is_by_rows(rows: int) -> None:
    g = Graph()
    q = [g.var("q", k) for k in range(2)]
    roots = [g.mul(g.const(float(k + 1)), g.mul(q[0], q[1])) for k in range(rows)]
    values = y(function(g, [x for row in jacobian(g, roots, q) for x in row]), {"q": [2, 5, 0, 0]})
    assert values == [(k + 1) * x for k in range(rows) for x in (5, 2)]


def test_derivatives_belong_to_who_is_differentiated_or_who_asks() -> None:
    g = Graph()
    q = g.var("q", 0)
    with g.made_by("arm", "velocity"):
        root = g.apply("sin", g.mul(q, q))
    made = len(g)
    forward(g, [root], {q: ONE})
    assert {g.origins[i] for i in range(made, len(g))} == {("arm", "velocity")}
    with g.made_by("wrist", "rate"):
        g.mul(q, q)
        made = len(g)
        forward(g, [g.apply("exp", root)], {q: ONE})
    assert {g.origins[i] for i in range(made, len(g))} == {("wrist", "rate")}
