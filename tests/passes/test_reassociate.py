"""Reassociate: shallower sums of the same value, shared sums untouched."""

from __future__ import annotations

from cardan.ir.graph import Graph
from cardan.passes import stage
from cardan.passes.reassociate import reassociate
from ir.expressions import function, y


def chain(g: Graph, terms: list[int], signs: str) -> int:
    total = terms[0]
    for x, sign in zip(terms[1:], signs, strict=True):
        total = g.add(total, x) if sign == "+" else g.sub(total, x)
    return total


def test_a_chain_becomes_a_tree() -> None:
    g = Graph()
    terms = [g.mul(g.var("q", i), g.var("u", j)) for i in range(4) for j in range(2)]
    f = function(g, [chain(g, terms, "+-+-+-+")])
    made = reassociate(f)
    assert made.cost() == f.cost()
    assert sum(made.operations().values()) == sum(f.operations().values())
    assert (f.critical_path(), made.critical_path()) == (8, 4)
    assert abs(y(made)[0] - y(f)[0]) < 1e-15


def test_the_term_known_last_is_added_last() -> None:
    g = Graph()
    late = g.apply("sin", g.var("q", 0))
    f = function(g, [chain(g, [late, *(g.var("u", k) for k in range(3))], "+++")])
    made = reassociate(f)
    root = made.graph.nodes[made.roots[0]]
    assert "sin" in {made.graph.nodes[k][0] for k in root[1:]}


def test_parameters_are_added_before_the_call() -> None:
    g = Graph()
    p, q = [g.var("p", k) for k in range(3)], [g.var("q", k) for k in range(2)]
    f = function(g, [chain(g, [q[0], p[0], q[1], p[1], p[2]], "+-+-")])
    assert sum(stage(f).operations().values()) == 4
    staged = stage(reassociate(f))
    assert sum(staged.operations().values()) == 2
    assert sum(staged.prepare_operations().values()) == 2


def test_shared_partial_sums_stay() -> None:
    g = Graph()
    u = [g.var("u", k) for k in range(3)]
    shared = g.add(u[0], u[1])
    f = function(g, [g.add(g.add(shared, u[2]), g.var("q", 0)), g.mul(shared, u[2])])
    made = reassociate(f)
    assert (
        "add",
        *sorted(made.graph.nodes.index(("var", "u", k)) for k in (0, 1)),
    ) in made.graph.nodes
    assert made.operations() == f.operations()


def test_all_terms_negative() -> None:
    g = Graph()
    u = [g.neg(g.var("u", k)) for k in range(3)] + [g.neg(g.var("q", 0))]
    f = function(g, [chain(g, u, "+++")])
    made = reassociate(f)
    assert y(made)[0] == y(f)[0]
    assert sum(made.operations().values()) <= sum(f.operations().values())
