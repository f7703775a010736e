"""The grammar names the node and the rule that is broken."""

from __future__ import annotations

import math
from typing import Any

import pytest
from hypothesis import given, settings

from cardan.ir.function import Block, Function, Output
from cardan.ir.grammar import check
from cardan.ir.graph import ONE, Graph
from ir.expressions import function, functions
from table import each


@settings(max_examples=60, deadline=None)
@given(functions())
def test_what_the_constructors_make_is_right(f: Function) -> None:
    assert check(f) is f


# nodes put in behind the constructors' back; node 3 is q[0], 4 a positive definite system
WRONG: dict[str, tuple[Any, ...]] = {
    r"operand 99 does not stand before it": ("add", 3, 99),
    r"operand -1 does not stand before it": ("neg", -1),
    r"operator 'root' does not exist": ("root", 3),
    r"add takes 2 operands": ("add", 3),
    r"reads the solve node 4": ("neg", 4),
    r"must be a finite float": ("const", math.inf),
    r"a constant must be a finite float": ("const", 7),
    r"block 'q' has 4 entries": ("var", "q", 7),
    r"its block is none of q, u, p": ("var", "w", 0),
    r"a placeholder is left": ("atom", "velocity"),
    r"kind must be one of spd": ("solve", "cholesky", 1, 1, 3, 3),
    r"it needs 6 entries": ("solve", "spd", 2, 1, 3, 3),
    r"must be positive": ("solve", "spd", 0, 1),
    r"node 3 is not a solve node": ("item", 3, 0),
    r"no such entry": ("item", 4, 1),
    r"names a solve node and the number": ("item", 4, "x"),
    r"operand 3 must be a whole number": ("stumpff", 3, 3),
    r"operand 2 must be a whole number": ("stumpff", 2, 3),
    r"stumpff takes 2 operands": ("stumpff", 1),
    r"the graph has 0 tables": ("table", 0, 0, 3),
}


@each("rule", WRONG)
def test_broken_rules_are_named(rule: str) -> None:
    g = Graph()
    q = g.var("q", 0)
    g.intern(("solve", "spd", 1, 1, q, ONE))
    node = g.intern(WRONG[rule])
    # a solve node is read through its items
    f = function(g, [g.intern(("item", node, 0)) if WRONG[rule][0] == "solve" else node], "broken")
    with pytest.raises(ValueError, match=rf"function 'broken', node 5 .*({rule})"):
        check(f)


def result(*outputs: Output, units: tuple[str, ...] = ("",)) -> Function:
    g = Graph()
    g.intern(("solve", "spd", 1, 1, g.var("q", 0), ONE))
    return Function("f", g, (Block("q", ("a",), units),), outputs)


@pytest.mark.parametrize(
    ("f", "rule"),
    [
        (result(Output("y", (2,), (0,))), r"1 nodes do not fill \(2,\)"),
        (result(Output("y", (1,), (0,), ("a", "b"))), "2 names or units for 1 nodes"),
        (result(Output("y", (1,), (9,))), "node 9 does not exist"),
        (result(Output("y", (1,), (4,))), "solve node 4 is not a single value"),
        (result(Output("y", (), (0,)), Output("y", (), (0,))), "two results have one name"),
        (result(units=()), "0 units for 1 entries"),
    ],
)
def test_results_and_blocks(f: Function, rule: str) -> None:
    with pytest.raises(ValueError, match=rule):
        check(f)
