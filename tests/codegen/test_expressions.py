"""Printed expressions mean what the graph says, to the bit: parentheses, sides, signs."""

import math
import random
import re

from cardan.codegen.languages.expressions import definitions
from cardan.codegen.program.program import Scope
from cardan.ir.graph import Graph
from table import each

NAMES = "abcdef"


def graph() -> tuple[Graph, list[int]]:
    g = Graph()
    return g, [g.var("q", k) for k in range(len(NAMES))]


def text(g: Graph, i: int) -> str:
    """The node with everything inlined; q[k] is called a, b, c ..."""
    names = {g.var("q", k): name for k, name in enumerate(NAMES)}
    return definitions(Scope(g, range(len(g)), names))[0][i]


def test_sums_keep_their_association() -> None:
    g, (a, b, c, d, *_) = graph()
    left = g.add(g.add(a, b), g.add(c, d))
    assert text(g, left) == "a + b + (c + d)"
    assert text(g, g.sub(a, g.add(b, c))) == "a - (b + c)"
    assert text(g, g.sub(g.sub(a, b), c)) == "a - b - c"


def test_commutative_operators_change_sides_to_save_parentheses() -> None:
    g, (a, b, c, d, *_) = graph()
    assert text(g, g.add(a, g.add(b, c))) == "b + c + a"
    assert text(g, g.mul(a, g.mul(b, c))) == "b * c * a"
    assert text(g, g.mul(g.mul(a, b), g.mul(c, d))) == "a * b * (c * d)"
    assert text(g, g.mul(a, g.div(b, c))) == "b / c * a"
    assert text(g, g.mul(g.add(a, b), g.const(2.0))) == "2.0 * (a + b)"


def test_quotients() -> None:
    g, (a, b, c, *_) = graph()
    assert text(g, g.div(a, g.mul(b, c))) == "a / (b * c)"
    assert text(g, g.div(g.div(a, b), c)) == "a / b / c"
    assert text(g, g.div(a, g.div(b, c))) == "a / (b / c)"
    assert text(g, g.div(g.add(a, b), c)) == "(a + b) / c"


def test_signs_move_out_of_the_way() -> None:
    g, (a, b, c, *_) = graph()
    assert text(g, g.neg(g.mul(a, b))) == "-a * b"
    assert text(g, g.neg(g.add(a, b))) == "-(a + b)"
    # what only interning without simplification makes is still right
    minus = g.intern(("neg", g.mul(a, b)))
    assert text(g, g.intern(("add", c, minus))) == "c - a * b"
    assert text(g, g.intern(("add", minus, c))) == "c - a * b"
    assert text(g, g.intern(("sub", c, minus))) == "c + a * b"
    assert text(g, g.intern(("neg", minus))) == "a * b"
    assert text(g, g.add(a, g.const(-0.5))) == "a - 0.5"


def test_numbers_are_complete_and_never_integers() -> None:
    g, (a, *_) = graph()
    for value in (1.0, 0.1, 1e22, 1e-300, math.pi, 123456789.0):
        shown = text(g, g.mul(a, g.const(3 * value)))
        number = re.search(r"[\d.]+(e[+-]\d+)?", shown)
        assert number is not None
        assert float(number[0]) == 3 * value
        assert "." in number[0] or "e" in number[0]


@each("seed", range(200))
def test_random_arithmetic_evaluates_to_the_same_bits(seed: int) -> None:
    # C and Python read + - * / and signs alike: Python judges the text
    rng = random.Random(seed)
    g, pool = graph()
    pool.append(g.const(-1.5))
    for _ in range(12):
        op = rng.choice(("add", "sub", "mul", "div", "neg"))
        x = [rng.choice(pool) for _ in range(1 if op == "neg" else 2)]
        # raw nodes too: the printer must not rely on simplification
        made = g.intern((op, *x)) if rng.random() < 0.5 else g.apply(op, *x) if x[-1] else x[0]
        pool.append(made)
    values = {name: rng.uniform(-3, 3) for name in NAMES}
    results: dict[int, float] = {}
    for i, node in enumerate(g.nodes):
        if node[0] == "const":
            results[i] = node[1]
        elif node[0] == "var":
            results[i] = values[NAMES[node[2]]]
        else:
            results[i] = evaluated(node[0], *[results[k] for k in node[1:]])
    for i, node in enumerate(g.nodes):
        if node[0] not in ("var", "const") and math.isfinite(results[i]):
            assert eval(text(g, i), {}, values) == results[i], text(g, i)


def evaluated(op: str, a: float, b: float = 0.0) -> float:
    if op == "neg":
        return -a
    if op == "div":
        return a / b if b else math.nan
    return {"add": a + b, "sub": a - b, "mul": a * b}[op]
