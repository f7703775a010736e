"""Trig: which sums of squares become one, and which must not."""

from __future__ import annotations

from cardan.ir.arithmetic import Scalar
from cardan.ir.graph import ONE, Graph
from cardan.passes.trig import trig
from ir.expressions import function, y


def angle(g: Graph, k: int = 0) -> tuple[Scalar, Scalar]:
    q = g.var("q", k)
    return Scalar(g, g.apply("sin", q)), Scalar(g, g.apply("cos", q))


def test_one() -> None:
    g = Graph()
    s, c = angle(g)
    made = trig(function(g, [(s * s + c * c).node]))
    assert made.roots == (ONE,)


def test_common_factors_are_kept() -> None:
    g = Graph()
    s, c = angle(g)
    a, u = Scalar(g, g.var("p", 0)), Scalar(g, g.var("u", 0))
    x, z = a * c * u, a * s * u
    f = function(g, [(x * x + z * z).node, (a * s * s + c * (a * c)).node])
    made = trig(f)
    assert made.operations() == {"mul": 2}, "(a u)²; the other is a itself"
    assert y(made, None, "mp", 60)[1] == 1.5
    assert abs(y(made, None, "mp", 60)[0] - y(f, None, "mp", 60)[0]) < 1e-55


def test_replaced_sums_meet_again() -> None:
    g = Graph()
    (s, c), (s1, c1) = angle(g), angle(g, 1)
    total = (s * s1) * (s * s1) + (c * s1) * (c * s1) + c1 * c1
    assert trig(function(g, [total.node])).roots == (ONE,)


def test_rest_of_one() -> None:
    g = Graph()
    s, c = angle(g)
    f = function(g, [(1 - s * s).node, (1 - c * c).node, c.node])
    made = trig(f)
    assert made.operations() == {"sin": 1, "cos": 1, "mul": 2}
    # 1 - sin² has lost these digits in floats
    assert abs(y(made, {"q": [1e-9, 0, 0, 0]})[1] - 1e-18) < 1e-33


def test_tangent_of_an_angle_whose_sine_is_there() -> None:
    g = Graph()
    s, c = angle(g)
    t = g.apply("tan", g.var("q", 0))
    assert trig(function(g, [t, s.node, c.node])).operations() == {"sin": 1, "cos": 1, "div": 1}
    assert trig(function(g, [t, s.node])).operations() == {"sin": 1, "tan": 1}


def test_what_is_not_one_stays() -> None:
    g = Graph()
    (s, c), (s1, c1) = angle(g), angle(g, 1)
    a, b = Scalar(g, g.var("p", 0)), Scalar(g, g.var("p", 1))
    different = [
        s * s + c1 * c1,
        a * s * s + b * c * c,
        s * s - c * c,
        s * c + c * s1,
        s * c * c + c * s * s,
    ]
    f = function(g, [x.node for x in different])
    assert trig(f) is f


def test_a_sum_stays_where_its_terms_are_needed_and_the_product_is_long() -> None:
    g = Graph()
    s, c = angle(g)
    p = [Scalar(g, g.var("p", k)) for k in range(4)]
    x = s * s * p[0] * p[1] * p[2] * p[3]
    z = c * c * p[0] * p[1] * p[2] * p[3]
    f = function(g, [(x + z).node, x.node, z.node])
    assert trig(f) is f
    single = function(g, [(x + z).node])
    made = trig(single)
    assert sum(made.operations().values()) <= 3
