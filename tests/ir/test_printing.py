"""Text and drawings of functions."""

from __future__ import annotations

from cardan.ir.function import Block, Function, Output
from cardan.ir.graph import ONE, Graph
from cardan.ir.matrix import Matrix
from cardan.ir.printing import dot, text
from cardan.ir.solve import solve


def sample() -> Function:
    g = Graph()
    q, u = g.var("q", 0), g.var("u", 0)
    with g.made_by("upper", "velocity"):
        v = g.label(g.mul(g.apply("sin", q), u), "upper", "v_x")
    low = g.apply("select", g.apply("lt", v, g.const(0.5)), g.neg(v), g.atom("load"))
    x = solve("spd", Matrix(g, 1, 1, (g.add(ONE, g.square(q)),)), Matrix(g, 1, 1, (low,)))
    blocks = (Block("q", ('an"gle',), ("rad",)), Block("u", ("rate",), ("rad/s",)))
    return Function("f", g, blocks, (Output("udot", (1,), x.nodes, ("rate",), ("N",)),), (), "why")


def test_text_names_inputs_owners_results_and_units() -> None:
    assert text(sample()) == (
        "f(q(1), u(1)): why\n"
        "  n5 = sin(q[0])                          # upper.velocity\n"
        "  n6 = u[0] * n5                          # upper.v_x\n"
        "  n8 = n6 < 0.5\n"
        "  n9 = -n6\n"
        "  n11 = select(n8, n9, load)\n"
        "  n12 = q[0] * q[0]\n"
        "  n13 = 1 + n12\n"
        "  n14 = solve spd 1x1 for 1: A = n13; B = n11\n"
        "  n15 = n14[0]\n"
        "  udot[0] = n15  # rate  [N]\n"
    )


def test_drawing_groups_by_owner() -> None:
    drawing = dot(sample())
    assert drawing.startswith('digraph "f" {\n')
    assert 'label="upper";' in drawing
    assert "n5 -> n6;" in drawing
    assert '"udot[0]" [shape=box];' in drawing
    assert drawing.count("{") == drawing.count("}")


def test_numbers_are_written_exactly() -> None:
    g = Graph()
    f = Function("f", g, (), (Output("y", (2,), (g.const(0.1 + 0.2), g.const(250.0))),))
    assert "y[0] = 0.30000000000000004  # 0" in text(f)
    assert "y[1] = 250  # 1" in text(f)
