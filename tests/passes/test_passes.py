"""Every pass keeps the value in 40 digits and the number of operations does not rise."""

from __future__ import annotations

from collections.abc import Callable

import mpmath
import pytest
from hypothesis import given, settings

from cardan.equations.record import EquationRecord
from cardan.ir.function import Function, cost
from cardan.ir.grammar import check
from cardan.ir.graph import Graph, SystemNames
from cardan.ir.interpreter import evaluate
from cardan.ir.matrix import Matrix
from cardan.ir.solve import solve
from cardan.passes import PASSES, optimize, standard
from equations.trees import TREES, state, tree
from ir.expressions import function, functions, y
from table import each

Pass = Callable[[Function], Function]


def close(a: list[mpmath.mpf], b: list[mpmath.mpf]) -> bool:
    """Equal in 40 digits, of numbers with 80."""
    return all(
        abs(x - z) <= mpmath.mpf(10) ** -40 * (1 + abs(x)) for x, z in zip(a, b, strict=True)
    )


@pytest.mark.parametrize("name", PASSES)
@settings(max_examples=80, deadline=None)
@given(f=functions())
def test_random_functions(name: str, f: Function) -> None:
    made = check(PASSES[name](f))
    assert close(y(f, None, "mp", 80), y(made, None, "mp", 80))
    if name != "unroll":
        before, after = f.operations(), made.operations()
        assert sum(after.values()) <= sum(before.values())
        assert cost(after) <= cost(before)


@settings(max_examples=40, deadline=None)
@given(functions())
def test_all_passes_in_a_row(f: Function) -> None:
    staged = optimize(f, tuple(PASSES))
    assert close(y(f, None, "mp", 80), y(staged.function, None, "mp", 80))


@settings(max_examples=40, deadline=None)
@given(functions())
def test_passes_come_to_rest(f: Function) -> None:
    for name in ("unroll", "fold", "trig"):
        once = PASSES[name](f)
        twice = PASSES[name](once)
        assert twice.operations() == once.operations()


METHODS = {
    "composite": "forward_dynamics",
    "articulated": "forward_dynamics",
    "newton_euler": "inverse_dynamics",
    "kane": "energy",
}


@each("name", TREES)
@each("method", METHODS)
def test_functions_of_trees(name: str, method: str) -> None:
    system, p = TREES[name].system, TREES[name].exact
    f = EquationRecord(system, method).function(METHODS[method])
    with mpmath.workdps(80):
        exact = [mpmath.mpf(x.numerator) / x.denominator for x in p]
    values = {**state(system, seed=5), "p": exact}
    expected = evaluate(f, values, "mp", 80)
    made = f
    for step in PASSES:
        before, made = made, check(PASSES[step](made))
        if step != "unroll":
            assert sum(made.operations().values()) <= sum(before.operations().values())
        found = evaluate(made, values, "mp", 80)
        assert all(close(expected[o.name], found[o.name]) for o in f.outputs)


def test_derivation_and_passes_are_deterministic() -> None:
    def made() -> Function:
        f = EquationRecord(TREES["branched"].system, "composite").function("forward_dynamics")
        return optimize(f, tuple(PASSES)).function

    first, second = made(), made()
    assert first.graph.nodes == second.graph.nodes
    assert first.roots == second.roots
    assert first.graph.labels == second.graph.labels


def test_standard_passes() -> None:
    composite = EquationRecord(TREES["chain"].system, "composite").function("forward_dynamics")
    arm = tree("rprr", range(-1, 3)).system
    articulated = EquationRecord(arm, "articulated").function("forward_dynamics")
    assert standard(articulated) == ("reassociate",)
    assert standard(composite) == ("unroll", "reassociate")
    seven = EquationRecord(tree("r" * 7, range(-1, 6)).system, "composite").function(
        "forward_dynamics"
    )
    assert standard(seven) == ("unroll",)
    assert "solve" in composite.operations()
    assert "solve" not in optimize(composite).operations()
    depth = optimize(articulated).function.critical_path()
    assert depth < articulated.critical_path()


def test_optimize_refuses_what_breaks_the_grammar() -> None:
    g = Graph()
    with pytest.raises(ValueError, match="placeholder is left"):
        optimize(function(g, [g.atom("velocity")]))


def test_unroll_shares_the_factor_and_keeps_zeros() -> None:
    g = Graph()
    q = [g.var("q", k) for k in range(4)]
    # two branches on one root: rows 1 and 2 do not touch
    a = Matrix(g, 3, 3, [q[0], q[1], q[2], q[1], q[3], 0, q[2], 0, q[3]])
    one = solve("spd", a, Matrix(g, 3, 1, [g.var("u", k) for k in range(3)]))
    two = solve("spd", a, Matrix(g, 3, 2, [g.var("p", k) for k in range(3)] * 2))
    made = PASSES["unroll"](function(g, [*one.nodes, *two.nodes]))
    counts = made.operations()
    assert "solve" not in counts
    assert counts["div"] == 3 - 1, "one reciprocal for both equal pivots, shared by both systems"
    indefinite = solve("symmetric_indefinite", a, Matrix(g, 3, 1, one.nodes))
    made = PASSES["unroll"](function(g, indefinite.nodes))
    assert made.operations()["solve"] == 1, "kinds that pivot stay"


def test_unroll_names_the_factor_after_its_matrix() -> None:
    g = Graph()
    with g.made_by("M", "factor"):
        a = Matrix(g, 2, 2, [g.var("q", k) for k in (0, 1, 1, 2)])
        right = Matrix(g, 2, 1, [g.var("u", 0), g.var("u", 1)])
        x = solve("spd", a, right, SystemNames("M", ("shoulder", "elbow"), ("drive",)))
    with g.made_by("elbow", "udot"):
        root = g.label(g.mul(x.nodes[1], x.nodes[1]), "elbow", "square")
        g.label(x.nodes[0], "shoulder", "udot")
    made = PASSES["unroll"](function(g, [root, x.nodes[0]])).graph
    names = {*made.labels.values(), *made.hints.values()}
    assert {("M", "factor_D_inverse_shoulder"), ("M", "factor_D_inverse_elbow")} <= names
    assert {("M", "factor_L_elbow_shoulder"), ("drive", "y_shoulder")} <= names
    assert {("elbow", "square"), ("shoulder", "udot")} <= names
    assert {made.origins[i] for i, n in enumerate(made.nodes) if n[0] == "div"} == {("M", "factor")}
