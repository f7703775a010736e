"""Statements that straight-line functions do not need: loops over tables, branches, solves."""

import numpy as np
import pytest

from cardan.codegen import CFile, generate
from cardan.codegen.languages import c
from cardan.codegen.program.program import (
    Assign,
    Declare,
    Index,
    Loop,
    Place,
    Program,
    Routine,
    Scope,
    Section,
    Table,
)
from cardan.errors import CodegenError
from cardan.ir.function import Block, Function, Output
from cardan.ir.graph import Graph
from codegen.running import call, compilers


def program(body: tuple, scope: Scope, tables: tuple[Table, ...] = ()) -> CFile:
    """A file of one function q -> out of six entries."""
    nothing = Scope(Graph(), (), {})
    routines = (
        Routine("prepare_looped", "prepare", "", nothing, ()),
        Routine("looped", "function", "six numbers", scope, body),
    )
    made = Program("looped", (("a test",),), ("cardan.h",), tables, routines, ("q",), {}, 6, 0)
    entry = {"inputs": ["q"], "output_size": 6, "work_size": 6, "prepared_size": 0}
    return CFile("looped", c.write(made), entry, made)


@pytest.mark.parametrize("compiler", sorted(compilers()))
def test_loop_over_a_table(compiler: str) -> None:
    # out[i] = 2 x + x^2 of x = q[order[i]]; work is addressed with stride and offset
    g = Graph()
    x, y = g.var("x", 0), g.var("x", 1)
    square = g.mul(x, x)
    total = g.add(g.mul(g.const(2.0), x), y)
    inner = Scope(g, range(len(g)), {x: "x", y: "y"})
    body = (
        Loop(
            "i",
            3,
            inner,
            (
                Declare("x", Place("q", Index("i", table="order"))),
                Assign(Place("work", Index("i", 2, 1)), square),
            ),
        ),
        Loop(
            "i",
            3,
            inner,
            (
                Declare("x", Place("q", Index("i", table="order"))),
                Declare("y", Place("work", Index("i", 2, 1))),
                Assign(Place("out", Index("i")), total),
                Assign(Place("out", Index("i", 1, 3)), Place("q", Index("i")), "a copy"),
            ),
        ),
    )
    tables = (Table("order", (2, 0, 1), integer=True, comment="which entry of q"),)
    cfile = program((Section("twice", body),), Scope(Graph(), (), {}), tables)
    assert "static const int order[3] = {" in cfile.text
    answer = call(cfile, {"q": [1.0, 10.0, 100.0]}, compiler)
    x = np.array([100.0, 1.0, 10.0])
    assert answer.out.tolist() == [*(2 * x + x * x), 1.0, 10.0, 100.0]


def test_number_tables_are_complete() -> None:
    values = (0.1, 1e-300, 3.0)
    text = c.write(Program("f", (), ("cardan.h",), (Table("data", values),), (), (), {}, 0, 0))
    assert "static const double data[3] = {\n    0.1, 1e-300, 3.0\n};" in text


@pytest.mark.parametrize("compiler", sorted(compilers()))
def test_many_plain_parameters_are_copied_by_a_loop(compiler: str) -> None:
    g = Graph()
    n = 300
    scaled = [g.mul(g.var("q", 0), g.var("p", n - 1 - k)) for k in range(n)]
    block = Block("p", tuple(f"p{k}" for k in range(n)), ("",) * n)
    q = Block("q", ("a",), ("",))
    function = Function("scaled", g, (q, block), (Output("y", (n,), tuple(scaled)),))
    cfile = generate(function)
    assert "for (int i = 0; i < 300; ++i) {" in cfile.text
    assert "w[prepare_scaled_target[i]] = p[prepare_scaled_source[i]];" in cfile.text
    values = [0.5 * k for k in range(n)]
    answer = call(cfile, {"q": [2.0], "p": values}, compiler)
    assert answer.out.tolist() == [2.0 * x for x in reversed(values)]


@pytest.mark.parametrize("name", ["pose__tip_", "pose____x", "pose__" + "long_" * 30 + "name"])
def test_names_of_frames_are_part_of_names(name: str) -> None:
    function = Function(name, Graph(), (), (Output("y", (1,), (1,)),))
    assert call(generate(function), {}).out.tolist() == [1.0]


def test_a_name_that_c_cannot_have_is_refused() -> None:
    for name in ("two words", "int", "9th", ""):
        function = Function(name, Graph(), (), (Output("y", (1,), (1,)),))
        with pytest.raises(CodegenError, match="cannot be the name"):
            generate(function)
