"""One text for single states and for states side by side: the same bits in every lane."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

import cardan as cd
from cardan.codegen import CFile, generate
from cardan.ir.function import Function, Output
from cardan.ir.graph import Graph
from cardan.ir.ops import OPERATORS
from codegen.functions import ARITY, EXACT, LIBRARY, apply, blocks, random_function, solving, values
from codegen.lanes import WIDTHS, call_lanes
from codegen.running import CONTRACT, SPEED, STRICT, call, compilers
from codegen.test_solve import PIVOTING, system
from equations.test_sweeps import chain
from spread import some

FLAGS = {name: (*STRICT, *SPEED, "-march=native", *CONTRACT[name]) for name in CONTRACT}
# every vector is emulated where the processor has none of its width
PLAIN = {name: tuple(f for f in flags if f != "-march=native") for name, flags in FLAGS.items()}
COMPILERS = sorted(compilers())
States = list[dict[str, list[float]]]


def agree(
    cfile: CFile, states: States, compiler: str, flags: tuple[str, ...], own: bool = False
) -> None:
    """Every width gives every state the bits that it has alone."""
    alone = [call(cfile, state, compiler, flags).out for state in states]
    for lanes in WIDTHS:
        for start in range(0, len(states), lanes):
            _, found = call_lanes(cfile, states[start : start + lanes], flags, compiler, own)
            assert same(found, alone[start : start + lanes]), lanes


def same(found: np.ndarray, expected: list[np.ndarray]) -> bool:
    """Equal bits; one NaN is as good as another."""
    a, b = (np.where(np.isnan(x), np.nan, x) for x in (found, np.array(expected)))
    return bool(a.tobytes() == b.tobytes())


def states_of(seed: int, own: bool) -> States:
    found = [values(100 * seed + k) for k in range(8)]
    return found if own else [state | {"p": found[0]["p"]} for state in found]


@pytest.mark.parametrize(
    ("seed", "own", "compiler"), some(product(range(2), (False, True), COMPILERS), 3)
)
def test_random_functions(seed: int, own: bool, compiler: str) -> None:
    operators = f"{EXACT} {LIBRARY} stumpff table"
    cfile = generate(random_function(seed, 150, operators))
    agree(cfile, states_of(seed, own), compiler, FLAGS[compiler], own)


WAYS = {"native": FLAGS, "plain": PLAIN}
# of either compiler another way first
TURNS = [
    (compiler, way)
    for compiler, ways in zip(COMPILERS, (["plain", "native"], ["native", "plain"]), strict=False)
    for way in ways
]


@pytest.mark.parametrize(("compiler", "way"), some(TURNS, 2))
def test_every_operator(compiler: str, way: str) -> None:
    flags = WAYS[way]
    # with operands of the state, of parameters and of both
    g = Graph()
    nodes = []
    for op in sorted(OPERATORS):
        a, b, c, p = g.var("q", 0), g.var("u", 1), g.var("q", 2), g.var("p", 3)
        for x in ((a, b, c), (a, p, p), (p, a, b), (p, p, p)):
            if op in ("stumpff", "table"):
                nodes.append(apply(g, op, 2, x[0]))
            else:
                nodes.append(apply(g, op, *x[: 3 if op == "select" else ARITY.get(op, 1)]))
    cfile = generate(Function("one", g, blocks(), (Output("y", (len(nodes),), tuple(nodes)),)))
    agree(cfile, states_of(7, False), compiler, flags[compiler])
    agree(cfile, states_of(7, True), compiler, flags[compiler], own=True)


@pytest.mark.parametrize(("kind", "compiler"), some(product(PIVOTING, COMPILERS), 3))
def test_pivots_differ_from_lane_to_lane(kind: str, compiler: str) -> None:
    systems = [system(kind, seed) for seed in range(8)]
    states = [{"q": [*a.ravel(), *b.ravel()]} for a, b in systems]
    agree(generate(solving(kind)), states, compiler, FLAGS[compiler])
    of_p = [{"p": state["q"]} for state in states]
    agree(generate(solving(kind, of="p")), of_p, compiler, FLAGS[compiler], own=True)


@pytest.mark.parametrize("compiler", some(COMPILERS, 2))
def test_many_columns_at_once(compiler: str) -> None:
    rng = np.random.default_rng(5)
    factors = [np.tril(rng.uniform(-0.5, 0.5, (6, 6))) + np.eye(6) for _ in range(8)]
    systems = [(x.T @ x, rng.uniform(-1, 1, (6, 11))) for x in factors]
    states = [{"q": [*a.ravel(), *b.ravel()]} for a, b in systems]
    agree(generate(solving("spd", 6, 11), chosen=()), states, compiler, FLAGS[compiler])


@pytest.mark.parametrize("kind", PIVOTING)
def test_a_lane_without_solution_leaves_the_others_alone(kind: str) -> None:
    systems = [system(kind, seed, 3, 1) for seed in range(4)]
    good = [{"q": [*a.ravel(), *b.ravel()]} for a, b in systems]
    bad = {"q": [1.0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 2, 3]}
    cfile = generate(solving(kind, 3, 1))
    compiler = COMPILERS[0]
    status, found = call_lanes(cfile, [good[0], bad, *good[2:]], FLAGS[compiler], compiler)
    assert status == 1
    assert np.isnan(found[1][:3]).all()
    for k in (0, 2, 3):
        assert same(found[k], [call(cfile, good[k], compiler, FLAGS[compiler]).out][0])


@pytest.mark.parametrize(
    ("name", "compiler"), some(product(("forward_dynamics", "inverse_dynamics"), COMPILERS), 3)
)
def test_loops_over_tables(name: str, compiler: str) -> None:
    equations = cd.derive(chain(11), method="articulated")
    recursion = equations.recursion(name)
    rng = np.random.default_rng(5)
    p = [parameter.value for parameter in equations.system.parameters]
    states = [
        {b.name: rng.uniform(-1, 1, len(b)).tolist() for b in recursion.inputs} | {"p": p}
        for _ in range(8)
    ]
    agree(generate(recursion), states, compiler, FLAGS[compiler])
    agree(generate(recursion), states, compiler, FLAGS[compiler], own=True)


@pytest.mark.parametrize("compiler", some(COMPILERS[::-1], 2))
def test_long_functions_in_parts(compiler: str) -> None:
    cfile = generate(random_function(4, 150, f"{EXACT} sin cos"), longest=20)
    assert "_part2(" in cfile.text
    agree(cfile, states_of(4, False), compiler, FLAGS[compiler])
