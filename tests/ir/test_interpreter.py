"""The interpreter: kinds of numbers, batches, checks of its input, systems."""

from __future__ import annotations

import math

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings

from cardan.errors import SolveError
from cardan.ir.function import Block, Function, Output
from cardan.ir.graph import ONE, ZERO, Graph
from cardan.ir.interpreter import ARITHMETICS, evaluate
from cardan.ir.matrix import Matrix
from cardan.ir.solve import KINDS, solve
from ir.expressions import STATE, function, functions, y
from table import each


@settings(max_examples=80, deadline=None)
@given(functions())
def test_kinds_of_numbers_agree(f: Function) -> None:
    reference = y(f, None, "mp", 60)
    for kind in ("float", "complex", "numpy"):
        values = [complex(x) for x in y(f, None, kind)]
        # random expressions cancel; their conditions stay below 1e6
        for value, expected in zip(values, reference, strict=True):
            assert value == pytest.approx(complex(expected), rel=1e-9, abs=1e-9)


def named() -> Function:
    g = Graph()
    q = [g.var("q", k) for k in range(3)]
    u = g.var("u", 0)
    nodes = [g.mul(u, x) for x in q] + [g.add(x, u) for x in q]
    blocks = (Block("q", ("a", "b", "c"), ("m",) * 3), Block("u", ("v",), ("m/s",)))
    outputs = (Output("M", (2, 3), tuple(nodes)), Output("c", (), (ONE,)))
    return Function("pair", g, (*blocks, Block("r", ("f",), ("N",))), outputs)


def test_batches_are_broadcast() -> None:
    f = named()
    q, u = np.arange(24.0).reshape(4, 2, 3), np.array([[[2.0]], [[3.0]], [[5.0]], [[7.0]]])
    found = evaluate(f, {"q": q, "u": u}, "numpy")
    assert found["M"].shape == (4, 2, 2, 3)
    assert found["c"].shape == (4, 2)
    np.testing.assert_array_equal(found["M"][:, :, 0], q * u)
    np.testing.assert_array_equal(found["M"][:, :, 1], q + u)


def test_one_state_has_no_batch_axes() -> None:
    found = evaluate(named(), {"q": [1, 2, 3], "u": [2]}, "numpy")
    assert found["M"].tolist() == [[2, 4, 6], [3, 4, 5]]
    assert found["c"].shape == ()
    assert evaluate(named(), {"q": [1, 2, 3], "u": [2]})["M"] == [2, 4, 6, 3, 4, 5]


@pytest.mark.parametrize("kind", ARITHMETICS)
def test_missing_and_wrong_blocks_are_named(kind: str) -> None:
    with pytest.raises(ValueError, match="'pair' reads block 'u'; given: q"):
        evaluate(named(), {"q": [1, 2, 3]}, kind)
    with pytest.raises(ValueError, match="block 'q' of function 'pair' has 3 entries, not 2"):
        evaluate(named(), {"q": [1, 2], "u": [1]}, kind)


def test_unknown_arithmetic_is_named() -> None:
    with pytest.raises(ValueError, match=r"float, complex, numpy, mp, not 'double'"):
        evaluate(named(), {}, "double")


def test_placeholders_cannot_be_evaluated() -> None:
    g = Graph()
    with pytest.raises(ValueError, match="placeholders must be replaced"):
        y(function(g, [g.add(g.atom("velocity.x"), ONE)]))


def test_digits() -> None:
    g = Graph()
    f = function(g, [g.apply("sqrt", g.const(2.0)), g.div(ONE, g.var("q", 0))])
    for digits in (25, 70):
        with mpmath.workdps(digits):
            third = y(f, {"q": [3, 0, 0, 0]}, "mp", digits)[1]
            assert abs(third * 3 - 1) < mpmath.mpf(10) ** (1 - digits)


# systems

DENSE = [[4.0, 1.0, -0.5], [1.0, 3.0, 0.25], [-0.5, 0.25, 2.0]]
RIGHT = [[1.0, -2.0], [0.5, 4.0], [3.0, 0.0]]


def system(kind: str, n: int = 3, m: int = 2) -> Function:
    """X of A X = B with A in q, B in u."""
    g = Graph()
    a = Matrix(g, n, n, [g.var("q", k) for k in range(n * n)])
    b = Matrix(g, n, m, [g.var("u", k) for k in range(n * m)])
    x = solve(kind, a, b)
    blocks = tuple(
        Block(name, tuple(map(str, range(k))), ("",) * k)
        for name, k in (("q", n * n), ("u", n * m))
    )
    return Function("x", g, blocks, (Output("X", (n, m), x.nodes),))


@each("arithmetic", ARITHMETICS)
@each("kind", KINDS)
def test_systems(kind: str, arithmetic: str) -> None:
    a, b = np.array(DENSE), np.array(RIGHT)
    if kind == "rank_revealing":
        a[0, 1] = -7.0
    found = evaluate(system(kind), {"q": a.ravel(), "u": b.ravel()}, arithmetic)["X"]
    x = np.array([complex(v).real for v in np.ravel(found)]).reshape(3, 2)
    # condition of the matrix is below 10
    np.testing.assert_allclose(a @ x, b, atol=50 * math.ulp(1.0))


@pytest.mark.parametrize("arithmetic", ["float", "complex", "mp"])
def test_pivots_are_searched(arithmetic: str) -> None:
    values = {"q": [0, 1, 0, 1, 0, 0, 0, 0, 2], "u": [1, 2, 3, 4, 6, 8]}
    for kind in ("symmetric_indefinite", "rank_revealing"):
        assert evaluate(system(kind), values, arithmetic)["X"] == [3, 4, 1, 2, 3, 4]


def test_undetermined_unknowns_are_zero_where_rank_is_revealed() -> None:
    # the rows of the first two unknowns are equal, the third stands alone
    values = {"q": [2, 1, 0, 2, 1, 0, 0, 0, 5], "u": [4, 2, 4, 2, 10, 5]}
    for arithmetic in ("float", "mp", "numpy"):
        found = np.ravel(evaluate(system("rank_revealing"), values, arithmetic)["X"])
        assert [float(x) for x in found] == [2, 1, 0, 0, 2, 1]
    batch = {"q": np.array([values["q"], np.eye(3).ravel()]), "u": np.array(values["u"])}
    found = evaluate(system("rank_revealing"), batch, "numpy")["X"]
    np.testing.assert_array_equal(found, [[[2, 1], [0, 0], [2, 1]], [[4, 2], [4, 2], [10, 5]]])


@pytest.mark.parametrize("arithmetic", ARITHMETICS)
def test_contradictions_are_refused(arithmetic: str) -> None:
    values = {"q": [2, 1, 0, 2, 1, 0, 0, 0, 5], "u": [4, 2, 5, 2, 10, 5]}
    with pytest.raises(SolveError, match="rank 2 and contradicts itself"):
        evaluate(system("rank_revealing"), values, arithmetic)


@each("arithmetic", ARITHMETICS)
@each("kind", ["spd", "symmetric_indefinite"])
def test_singular_systems_are_refused(kind: str, arithmetic: str) -> None:
    values = {"q": [1, 0, 0, 0, 0, 0, 0, 0, 1], "u": [1] * 6}
    with pytest.raises(SolveError, match="singular"):
        evaluate(system(kind), values, arithmetic)


def test_a_zero_right_side_makes_no_system() -> None:
    g = Graph()
    assert solve("spd", Matrix.identity(g, 2), Matrix.zeros(g, 2)).nodes == (ZERO, ZERO)


def test_blocks_nobody_reads_may_be_missing() -> None:
    g = Graph()
    f = function(g, [g.add(g.var("q", 0), ONE)])
    assert y(f, {"q": STATE["q"]}) == [1.3]
