"""The graph: interning, order, local simplification, provenance."""

from __future__ import annotations

import math

import pytest
from hypothesis import given, settings

from cardan.ir.function import Function, live, operands
from cardan.ir.graph import MINUS_ONE, ONE, ZERO, Graph
from ir.expressions import SIZES, function, functions, y
from table import each


@settings(max_examples=60, deadline=None)
@given(functions())
def test_nodes_are_unique_and_stand_after_their_operands(f: Function) -> None:
    g = f.graph
    assert len(set(g.nodes)) == len(g.nodes) == len(g.origins)
    for i, node in enumerate(g.nodes):
        assert g.intern(node) == i
        assert all(k < i for k in operands(node))


@settings(max_examples=60, deadline=None)
@given(functions())
def test_live_nodes_are_those_the_results_reach(f: Function) -> None:
    reached: set[int] = set()
    stack = list(f.roots)
    while stack:
        i = stack.pop()
        if i not in reached:
            reached.add(i)
            stack.extend(operands(f.graph.nodes[i]))
    assert f.live() == sorted(reached) == live(f.graph, f.roots)


def test_numbers_zero_one_and_minus_one_have_fixed_places() -> None:
    g = Graph()
    assert [g.const(x) for x in (0.0, -0.0, 1.0, -1.0)] == [ZERO, ZERO, ONE, MINUS_ONE]
    assert g.nodes[:3] == [("const", 0.0), ("const", 1.0), ("const", -1.0)]


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf])
def test_constants_are_finite(value: float) -> None:
    with pytest.raises(ValueError, match="must be finite"):
        Graph().const(value)


def test_simplification() -> None:
    g = Graph()
    a, b = g.var("q", 0), g.var("q", 1)
    two = g.const(2.0)
    assert g.add(a, ZERO) == g.add(ZERO, a) == g.sub(a, ZERO) == g.mul(ONE, a) == a
    assert g.mul(a, ZERO) == g.sub(a, a) == g.div(ZERO, a) == g.neg(ZERO) == ZERO
    assert g.div(a, a) == ONE
    assert g.mul(MINUS_ONE, a) == g.div(a, MINUS_ONE) == g.sub(ZERO, a) == g.neg(a)
    assert g.neg(g.neg(a)) == a
    assert g.add(a, g.neg(b)) == g.sub(a, b)
    assert g.sub(a, g.neg(b)) == g.add(a, b)
    assert g.sub(b, a) == g.neg(g.sub(a, b))
    assert g.mul(g.neg(a), g.neg(b)) == g.mul(b, a)
    assert g.div(g.neg(a), b) == g.neg(g.div(a, b))
    assert g.mul(g.const(-2.0), a) == g.neg(g.mul(two, a))
    assert g.value(g.div(g.const(3.0), two)) == 1.5


def test_functions_fold_and_use_symmetry() -> None:
    g = Graph()
    a, b = g.var("q", 0), g.var("q", 1)
    assert g.apply("cos", g.neg(a)) == g.apply("cos", a)
    assert g.apply("sin", g.neg(a)) == g.neg(g.apply("sin", a))
    assert g.apply("sqrt", g.square(a)) == g.apply("abs", a)
    assert g.apply("max", a, b) == g.apply("max", b, a)
    assert g.apply("atan2", a, b) != g.apply("atan2", b, a)
    assert g.value(g.apply("cos", ZERO)) == 1.0
    assert g.apply("select", ONE, a, b) == g.apply("select", g.var("u", 0), a, a) == a
    with pytest.raises(ValueError, match=r"sqrt\(-4.0\) is not a finite number"):
        g.apply("sqrt", g.const(-4.0))
    with pytest.raises(ZeroDivisionError, match="structural zero"):
        g.div(a, ZERO)


@each("exponent", [0, 1, 2, 3, 7, 16, 0.5, 2.5, -1, -3, -0.5, 17, 0.3, -1.7])
def test_powers(exponent: float) -> None:
    g = Graph()
    f = function(g, [g.power(g.var("q", 0), exponent)])
    assert y(f, {"q": [1.7, 0, 0, 0]})[0] == pytest.approx(1.7**exponent, rel=1e-14)
    whole = exponent == int(exponent * 2) / 2 and abs(exponent) <= 16
    assert ("pow" in f.operations()) is not whole


def test_a_fork_is_independent() -> None:
    g = Graph()
    with g.made_by("arm", "x"):
        a = g.label(g.apply("tanh", g.var("q", 0)), "arm", "bent")
    other = g.fork()
    b = other.apply("cos", other.var("q", 0))
    assert other.nodes[a] == g.nodes[a]
    assert other.labels[a] == ("arm", "bent")
    assert len(other) == len(g) + 1 == b + 1
    assert g.apply("exp", a) == b, "the first graph numbers on by itself"


def test_origins() -> None:
    g = Graph()
    q = g.var("q", 0)
    with g.made_by("upper", "velocity"):
        a = g.apply("sin", q)
        with g.made_by("lower"):
            assert g.apply("sin", q) == a
            b = g.mul(a, a)
    assert (g.origins[a], g.origins[b]) == (("upper", "velocity"), ("lower", ""))
    assert g.shared == {a: {("lower", "")}}
    assert g.origin == ("", "")
    g.label(q, "upper", "angle")
    g.label(b, "upper", "first")
    assert g.label(b, "upper", "second") == b
    assert g.labels == {b: ("upper", "first")}, "leaves have names, the first label stays"
    sine = g.label(g.apply("sin", q), "upper", "R_xx")
    assert sine not in g.labels, "a sine is called after its angle"


def test_a_changed_sign_leaves_the_name_to_what_it_changes() -> None:
    g = Graph()
    square = g.square(g.var("q", 0))
    g.label(g.neg(square), "arm", "force_x")
    assert not g.labels, "it may be a term of a sum"
    assert g.hints[square] == ("arm", "minus_force_x")


def test_notes_belong_to_what_is_made() -> None:
    g = Graph()
    with g.made_by("arm", "inertia"):
        step = g.note(g.square(g.var("q", 0)), "trace")
    assert g.hints == {step: ("arm", "inertia_trace")}
    other = g.fork()
    copy = other.square(other.var("q", 1))
    other.adopt(copy, g, step)
    assert other.hints[copy] == ("arm", "inertia_trace")


def test_counts() -> None:
    g = Graph()
    q = [g.var("q", k) for k in range(SIZES["q"])]
    root = g.add(g.mul(q[0], q[1]), g.apply("sin", g.mul(q[2], q[3])))
    f = function(g, [root, g.neg(root)])
    assert f.operations() == {"mul": 2, "add": 1, "sin": 1, "neg": 1}
    assert f.cost() == 2 + 1 + 20
    assert f.critical_path() == 1 + 20 + 1
