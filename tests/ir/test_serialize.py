"""Saved functions: they come back as they were, and damaged ones are refused."""

from __future__ import annotations

import copy
import json
from typing import Any

import pytest
from hypothesis import given, settings

from cardan.ir.function import Function
from cardan.ir.graph import Graph
from cardan.ir.matrix import Matrix
from cardan.ir.serialize import from_dict, to_dict
from cardan.ir.solve import solve
from cardan.ir.table import Table
from ir.expressions import function, functions, y
from table import each


@settings(max_examples=60, deadline=None)
@given(functions())
def test_saved_functions_come_back(f: Function) -> None:
    saved = json.loads(json.dumps(to_dict(f)))
    back = from_dict(saved)
    assert to_dict(back) == saved
    assert back.inputs == f.inputs
    assert y(back, None, "mp") == y(f, None, "mp")
    assert back.operations() == f.operations()


def rich() -> dict[str, Any]:
    """A saved function with every kind of node."""
    g = Graph()
    q = [g.var("q", k) for k in range(3)]
    table = Table((0.0, 0.1, 1.0), ((1.0, 1 / 3), (0.7, 0.2)))
    x = solve("symmetric_indefinite", Matrix(g, 1, 1, (q[0],)), Matrix(g, 1, 1, (q[1],)))
    c = g.apply("stumpff", g.const(3.0), x.nodes[0])
    saved = to_dict(function(g, [g.add(g.interpolate(table, c, 1), g.const(0.1))]))
    result: dict[str, Any] = json.loads(json.dumps(saved))
    return result


def test_every_kind_of_node_comes_back() -> None:
    saved = rich()
    assert to_dict(from_dict(saved)) == saved
    assert {node[0] for node in saved["nodes"]} >= {"solve", "item", "table", "stumpff", "var"}
    assert y(from_dict(saved), {"q": [2, 1, 0, 0]})[0] == 0.7 + 0.1


def put(path: tuple[Any, ...], value: Any) -> dict[str, Any]:
    """The saved function with one entry changed."""
    saved = copy.deepcopy(rich())
    place: Any = saved
    for key in path[:-1]:
        place = place[key]
    place[path[-1]] = value
    return saved


DAMAGE: list[tuple[tuple[Any, ...], Any, str]] = [
    (("schema",), 99, "'schema': 1"),
    (("nodes",), "0", "needs the list 'nodes'"),
    (("nodes", -1), ["add", 0, 99], "operand 99 does not stand before it"),
    (("nodes", -1), ["add", 0, True], "operand True"),
    (("nodes", -1), ["add", 0, 1.5], "operand 1.5"),
    (("nodes", -1), "add", "expected a list that begins with an operator"),
    (("nodes", -1), ["root", 0], "operator 'root' does not exist"),
    (("nodes", -1), ["const", "1"], "a constant holds one number"),
    (("nodes", -1), ["const", float("nan")], "finite"),
    (("nodes", -1), ["var", "x", 0], "its block is none of q, u, p"),
    (("nodes", -1), ["var", "q", [0]], "block"),
    (("nodes", -1), ["solve", "spd", [1], 1, 0, 0], "neither names nor whole numbers"),
    (("outputs", 0, "nodes"), [999], "not among the"),
    (("outputs", 0, "shape"), [2], "do not fill"),
    (("outputs", 0, "shape"), [-1, -1], "whole numbers"),
    (("outputs", 0, "entries"), [1], "must hold texts"),
    (("inputs", 0, "name"), None, "needs the text 'name'"),
    (("inputs", 0, "units"), [], "0 units for 4 entries"),
    (("tables", 0, "breaks"), [0.0, 0.0, 1.0], "rising breaks"),
    (("tables", 0, "coefficients"), [[1.0]], "one row of coefficients per piece"),
    (("tables", 0, "breaks", 0), "x", "finite numbers"),
    (("tables",), [], "the graph has 0 tables"),
    (("about",), 3, "needs the text 'about'"),
]


@each(("path", "value", "message"), DAMAGE)
def test_damaged_functions_are_refused(path: tuple[Any, ...], value: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        from_dict(put(path, value))


@pytest.mark.parametrize("data", [None, [], "f", {}])
def test_other_data_is_refused(data: Any) -> None:
    with pytest.raises(ValueError, match="'schema': 1"):
        from_dict(data)
