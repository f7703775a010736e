"""Copying expressions: values, sharing, provenance, replacements."""

from __future__ import annotations

from collections.abc import Mapping

import pytest
from hypothesis import given, settings

from cardan.ir.function import Function
from cardan.ir.graph import ONE, ZERO, Graph
from cardan.ir.rewrite import rebuild, rebuild_function
from cardan.ir.table import Table
from ir.expressions import function, functions, y


@settings(max_examples=60, deadline=None)
@given(functions())
@pytest.mark.parametrize("thorough", [False, True])
def test_a_copy_has_the_same_value_and_no_more_operations(thorough: bool, f: Function) -> None:
    copy = rebuild_function(f, thorough=thorough)
    assert y(copy, None, "mp") == y(f, None, "mp")
    assert copy.operations() == f.operations()
    # nothing but what is needed, 0, 1 and -1
    assert set(range(3, len(copy.graph))) <= set(copy.live())


@settings(max_examples=40, deadline=None)
@given(functions())
def test_copying_into_the_same_graph_without_replacements_changes_nothing(f: Function) -> None:
    size = len(f.graph)
    graph, roots = rebuild(f.graph, f.roots, {}, into=f.graph)
    assert graph is f.graph
    assert (tuple(roots), len(graph)) == (f.roots, size)


def test_replacements_are_simplified() -> None:
    g = Graph()
    q, u = g.var("q", 0), g.var("u", 0)
    root = g.add(g.mul(q, u), g.apply("sin", g.sub(q, u)))
    _, roots = rebuild(g, [root, q], {u: ZERO}, into=g)
    assert roots == [g.apply("sin", q), q]
    _, roots = rebuild(g, [root], {u: q}, into=g)
    assert roots == [g.mul(q, q)]


def test_replacements_are_taken_as_they_are() -> None:
    g = Graph()
    q, u = g.var("q", 0), g.var("u", 0)
    _, roots = rebuild(g, [g.mul(q, u)], {q: u, u: q}, into=g)
    assert roots == [g.mul(q, u)], "exchanged, not replaced again"


def test_what_only_replaced_nodes_read_is_not_copied() -> None:
    g = Graph()
    inner = g.apply("exp", g.atom("velocity"))
    target, roots = rebuild(g, [g.add(inner, g.var("q", 0))], {inner: ONE})
    assert not any(node[0] == "atom" for node in target.nodes)
    assert target.nodes[roots[0]][0] == "add"


def test_a_rule_decides_node_by_node() -> None:
    g = Graph()
    q = g.var("q", 0)
    root = g.add(g.apply("sin", q), g.apply("cos", q))

    def small_angles(target: Graph, i: int, copies: Mapping[int, int]) -> int | None:
        node = g.nodes[i]
        return copies[node[1]] if node[0] == "sin" else ONE if node[0] == "cos" else None

    target, roots = rebuild(g, [root], small_angles)
    assert roots == [target.add(ONE, target.var("q", 0))]


def test_origins_labels_and_tables_go_along() -> None:
    g = Graph()
    table = Table((0.0, 1.0), ((1.0, 0.0),))
    with g.made_by("upper", "velocity"):
        a = g.label(g.apply("exp", g.var("q", 0)), "upper", "v_x")
        b = g.interpolate(table, a)
    with g.made_by("lower", "velocity"):
        g.apply("exp", g.var("q", 0))
    target, roots = rebuild(g, [b])
    copy = target.nodes[roots[0]][3]
    assert target.tables == [table]
    assert target.origins[roots[0]] == target.origins[copy] == ("upper", "velocity")
    assert target.labels == {copy: ("upper", "v_x")}
    assert ("lower", "velocity") in target.shared[copy]
    assert target.origin == g.origin == ("", "")


def test_a_function_keeps_its_names() -> None:
    g = Graph()
    f = function(g, [g.var("q", 1), ONE], "rhs")
    copy = rebuild_function(f)
    assert (copy.name, copy.inputs, copy.owners) == ("rhs", f.inputs, f.owners)
    assert [(o.name, o.shape) for o in copy.outputs] == [("y", (2,))]


def test_names_go_where_the_values_go() -> None:
    g = Graph()
    place, speed = g.atom("place"), g.var("u", 0)
    node = g.label(g.mul(place, speed), "arm", "moment")
    _, (placed,) = rebuild(g, [node], {place: g.var("q", 0)}, into=g)
    _, (rest,) = rebuild(g, [node], {speed: g.var("p", 0)}, into=g)
    assert g.labels[placed] == ("arm", "moment"), "a placeholder stands for what replaces it"
    assert rest not in g.labels, "at another speed it is not the moment"
