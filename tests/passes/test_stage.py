"""Stage: what is prepared, and the order of what is left."""

from __future__ import annotations

from hypothesis import given, settings

from cardan.ir.function import Function, operands
from cardan.ir.graph import ONE, Graph
from cardan.ir.matrix import Matrix
from cardan.ir.rewrite import rebuild
from cardan.ir.solve import solve
from cardan.passes import optimize, stage
from ir.expressions import function, functions, y


def test_parameters_are_prepared_where_the_call_needs_them() -> None:
    g = Graph()
    q, (m, r, h) = g.var("q", 0), (g.var("p", k) for k in range(3))
    inertia = g.mul(m, g.square(r))
    root = g.add(g.mul(inertia, q), g.mul(h, g.apply("sin", q)))
    staged = stage(function(g, [root, inertia, ONE, g.add(inertia, ONE)]))
    names = {h: "h", inertia: "m r²", g.add(inertia, ONE): "m r² + 1"}
    assert {names[i] for i in staged.prepare} == {"h", "m r²", "m r² + 1"}
    assert staged.operations() == {"mul": 2, "add": 1, "sin": 1}
    assert staged.prepare_operations() == {"mul": 2, "add": 1}


def test_entries_of_a_prepared_solution_are_prepared_one_by_one() -> None:
    g = Graph()
    p = [g.var("p", k) for k in range(3)]
    x = solve("rank_revealing", Matrix(g, 1, 1, (p[0],)), Matrix(g, 1, 2, (p[1], p[2])))
    staged = stage(function(g, [g.mul(x.nodes[1], g.var("q", 0))]))
    assert staged.prepare == (x.nodes[1],)
    assert "solve" in staged.prepare_operations()
    assert staged.operations() == {"mul": 1}


def test_without_parameters_nothing_is_prepared() -> None:
    g = Graph()
    staged = stage(function(g, [g.mul(g.const(2.0), g.var("q", 0)), g.const(4.0)]))
    assert staged.prepare == ()
    assert staged.prepare_operations() == {}


@settings(max_examples=80, deadline=None)
@given(functions())
def test_the_call_reads_w_only_and_w_reads_p_only(f: Function) -> None:
    staged = optimize(f)
    g, w = staged.function.graph, staged.prepare
    assert not any(g.nodes[i][:2] == ("var", "p") for i in staged.body())
    blocks = {g.nodes[i][1] for i in staged.prepared() if g.nodes[i][0] == "var"}
    assert blocks <= {"p"}
    assert not any(g.nodes[i][0] in ("const", "solve") for i in w)
    # the call, given w, has the value of the whole
    values = y(function(g, w), None, "mp", 60)
    slots = {node: g.var("u", 3 + k) for k, node in enumerate(w)}
    graph, roots = rebuild(g, staged.function.roots, slots, into=g)
    call = Function("call", graph, (), (f.outputs[0].__class__("y", (len(roots),), tuple(roots)),))
    state = {"q": [0.3, -0.7, 1.1, 0.45], "u": [0.9, -1.3, 0.2, *values]}
    expected = y(f, None, "mp", 60)
    for a, b in zip(y(call, state, "mp", 60), expected, strict=True):
        assert abs(a - b) <= 1e-40 * (1 + abs(b))


@settings(max_examples=80, deadline=None)
@given(functions())
def test_the_order_is_complete_and_after_operands(f: Function) -> None:
    staged = optimize(f)
    place = {i: k for k, i in enumerate(staged.order)}
    assert sorted(place) == staged.function.live()
    assert len(staged.order) == len(place)
    nodes = staged.function.graph.nodes
    assert all(place[k] < place[i] for i in place for k in operands(nodes[i]))
