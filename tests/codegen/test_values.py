"""Compiled C against the interpreter."""

from functools import cache

import numpy as np
import pytest

from cardan.codegen import generate
from cardan.ir.function import Function, Output
from cardan.ir.graph import Graph
from cardan.ir.interpreter import evaluate
from cardan.ir.ops import OPERATORS
from codegen.functions import EXACT, LIBRARY, apply, blocks, random_function, values
from codegen.running import SPEED, STRICT, call, compilers, expected
from table import each

COMPILERS = sorted(compilers())


def same(a: np.ndarray, b: np.ndarray) -> bool:
    """Equal to the bit, signs of zero aside; NaN equals NaN."""
    return bool(np.array_equal(a, b, equal_nan=True))


@cache
def all_operators() -> str:
    """C of the functions of all operators: compiled at once."""
    return "\n".join(generate(function).text for function in FUNCTIONS.values())


@each("compiler", COMPILERS)
@each("seed", range(8))
def test_exact_operators_agree_to_the_bit(seed: int, compiler: str) -> None:
    function, given = random_function(seed), values(seed)
    answer = call(generate(function), given, compiler)
    assert answer.status == 0
    assert same(answer.out, expected(function, given))


@pytest.mark.parametrize("seed", range(3))
def test_contraction_changes_only_rounding(seed: int) -> None:
    function = random_function(seed, 60, "add sub mul")
    given = values(seed)
    exact = evaluate(function, given, "mp")
    exact = np.array([float(x) for o in function.outputs for x in exact[o.name]])
    fast = call(generate(function), given, COMPILERS[0], (*STRICT, *SPEED, "-ffp-contract=fast"))
    # sums and products of at most 60 numbers: errors relative to the largest value involved
    scale = np.abs(exact).max()
    assert np.abs(fast.out - exact).max() <= 60 * np.finfo(float).eps * max(scale, 1.0) * 8


def of_operator(op: str) -> Function:
    """Values of an operator: of q, of p (in the prepare stage) and nested."""
    g = Graph()
    nodes = []
    for k in range(4):
        a, b, c = g.var("q", k), g.var("u", k % 3), g.var("p", k)
        for x in ((a, b, c), (c, c, a), (g.var("p", 4), c, c)):
            if op in ("stumpff", "table"):
                nodes.append(apply(g, op, k + 1, x[0]))
            else:
                nodes.append(apply(g, op, *x[: OPERATORS[op].arity]))
    return Function(f"of_{op}", g, blocks(), (Output("y", (len(nodes),), tuple(nodes)),))


FUNCTIONS = {op: of_operator(op) for op in sorted(OPERATORS)}


@each("compiler", COMPILERS)
@each("op", FUNCTIONS)
def test_every_operator(op: str, compiler: str) -> None:
    function, given = FUNCTIONS[op], values(3)
    answer = call(generate(function), given, compiler, text=all_operators()).out
    exact = evaluate(function, given, "mp")["y"]
    if op in EXACT.split():
        assert same(answer, expected(function, given))
    # libraries promise an ulp or so of the value; arguments here are well conditioned
    error = [abs(float(x - y)) for x, y in zip(exact, answer, strict=True)]
    assert max(error) <= 8 * np.finfo(float).eps * max(1.0, *(abs(float(x)) for x in exact))


@each("compiler", COMPILERS)
@each("seed", range(4))
def test_mixed_functions_with_the_mathematical_library(seed: int, compiler: str) -> None:
    operators = f"{LIBRARY} stumpff table add sub mul div select lt"
    function, given = random_function(100 + seed, 60, operators), values(seed)
    answer = call(generate(function), given, compiler).out
    exact = evaluate(function, given, "mp")
    exact = np.array([float(x) for o in function.outputs for x in exact[o.name]])
    # errors of single calls pass through up to sixty well-conditioned operators
    assert np.allclose(answer, exact, rtol=1e-10, atol=1e-10)


def test_a_function_of_numbers_and_inputs_only() -> None:
    g = Graph()
    nodes = (g.const(2.5), g.var("q", 1), g.var("p", 2), 0, g.var("q", 1))
    function = Function("plain", g, blocks(), (Output("y", (5,), nodes),))
    given = values(1)
    answer = call(generate(function), given)
    assert same(answer.out, expected(function, given))
    assert answer.w.tolist() == [given["p"][2]]


def test_parameters_are_read_by_prepare_alone() -> None:
    function = random_function(5)
    cfile = generate(function)
    body = cfile.text.split("CARDAN_API int random")[1]
    assert "p[" not in body.replace("cardan_in", "")
    assert "in->p" not in cfile.text
    assert "p" in cfile.entry["inputs"]


def test_entry_tells_sizes_blocks_and_counts() -> None:
    function = random_function(2)
    entry = generate(function, of="hand").entry
    assert entry["output_size"] == len(function.roots)
    assert [o["shape"] for o in entry["outputs"]] == [list(o.shape) for o in function.outputs]
    assert set(entry["inputs"]) <= {b.name for b in function.inputs}
    assert sum(entry["operations"].values()) <= sum(function.operations().values())
    assert entry["of"] == "hand"
