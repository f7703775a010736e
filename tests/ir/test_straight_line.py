"""Functions as Python functions: the numbers of the interpreter, to the bit."""

from __future__ import annotations

import math
import struct
from collections.abc import Sequence

import pytest
from hypothesis import given, settings

from cardan.errors import SolveError
from cardan.ir.function import Function
from cardan.ir.graph import Graph
from cardan.ir.interpreter import evaluate
from cardan.ir.matrix import Matrix
from cardan.ir.ops import OPERATORS
from cardan.ir.solve import KINDS, solve
from cardan.ir.straight_line import read, straight_line
from cardan.ir.table import Table
from ir.expressions import STATE, function, functions, y
from table import each

EDGES = (0.0, -0.0, 1.0, -1.0, 0.5, -2.5, 3.0, 1e300, -1e-300, math.inf, -math.inf, math.nan)


def bits(numbers: Sequence[float]) -> list[bytes]:
    """Numbers as they stand in memory, but for the kind of a NaN."""
    return [b"nan" if x != x else struct.pack("d", x) for x in numbers]


def called(f: Function, values: dict[str, list[float]]) -> list[float]:
    """Its results as a Python function."""
    return straight_line(f)(*[values[name] for name in read(f)])


@settings(max_examples=80, deadline=None)
@given(functions())
def test_random_functions(f: Function) -> None:
    assert bits(called(f, STATE)) == bits(y(f))


@each("name", sorted(set(OPERATORS) - {"table", "stumpff"}))
def test_operators_at_the_ends_of_their_domains(name: str) -> None:
    g = Graph()
    arity = OPERATORS[name].arity
    # as it stands: what simplifies has no part in it
    f = function(g, [g.intern((name, *(g.var("q", k) for k in range(arity))))])
    quick, blocks = straight_line(f), read(f)
    assert blocks == ("q",)
    for a in EDGES:
        for b in EDGES:
            for c in EDGES if arity == 3 else (0.0,):
                q = [a, b, c, 0.0]
                assert bits(quick(q)) == bits(evaluate(f, {"q": q})["y"]), q


@pytest.mark.parametrize("kind", KINDS)
def test_systems(kind: str) -> None:
    g = Graph()
    q = [g.var("q", k) for k in range(3)]
    four, right = g.const(4.0), Matrix(g, 2, 1, [q[0], q[2]])
    a = Matrix(g, 2, 2, [g.add(q[0], four), q[1], q[1], g.add(q[2], four)])
    f = function(g, solve(kind, a, right).nodes)
    assert bits(called(f, STATE)) == bits(y(f))
    if kind in ("spd", "symmetric_indefinite"):
        # rows that repeat each other, with sides that do not
        f = function(g, solve(kind, Matrix(g, 2, 2, [q[1]] * 4), right).nodes)
        with pytest.raises(SolveError):
            called(f, STATE)


def test_tables() -> None:
    """A table is evaluated on its piece, derivatives too."""
    g = Graph()
    table = Table((0.0, 1.0, 3.0), ((1.0, 2.0, 3.0, 4.0), (0.5, -1.0, 0.25, 2.0)))
    x = g.var("q", 0)
    f = function(g, [g.interpolate(table, x, k) for k in range(3)])
    for at in (-0.5, 0.3, 1.0, 2.5, 4.0, math.nan):
        values = {"q": [at, 0.0, 0.0, 0.0]}
        assert bits(called(f, values)) == bits(evaluate(f, values)["y"])
