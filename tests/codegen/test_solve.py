"""Linear systems inside generated functions: the kernels that pivot."""

import numpy as np
import pytest

from cardan.codegen import generate
from cardan.ir.function import Function, Output
from cardan.ir.interpreter import evaluate
from codegen.functions import solving
from codegen.running import call, compilers
from table import each

PIVOTING = ("symmetric_indefinite", "rank_revealing")


def system(kind: str, seed: int, n: int = 4, m: int = 2) -> tuple[np.ndarray, np.ndarray]:
    """A regular system without usable diagonal, so that elimination in order would fail."""
    rng = np.random.default_rng(seed)
    a = rng.uniform(-1, 1, (n, n))
    if kind == "symmetric_indefinite":
        a = a + a.T
        np.fill_diagonal(a, 0)
    a[0, 0] = 0
    return a, rng.uniform(-1, 1, (n, m))


@each("compiler", sorted(compilers()))
@each("kind", [*PIVOTING, "spd"])
@each("of", ["q", "p"])
def test_solution_has_a_small_residual(kind: str, of: str, compiler: str) -> None:
    cfile = generate(solving(kind, of=of))
    for seed in range(10):
        a, b = system(kind, seed)
        if kind == "spd":
            a = a @ a.T + np.eye(4)
        answer = call(cfile, {of: [*a.ravel(), *b.ravel()]}, compiler)
        x = answer.out[:8].reshape(4, 2)
        assert answer.status == 0
        # backward stable: the residual is rounding of |A| |x|
        bound = 50 * np.finfo(float).eps * (np.abs(a) @ np.abs(x) + np.abs(b)).max()
        assert np.abs(a @ x - b).max() <= bound
        assert answer.out[8] == pytest.approx(x.sum(), rel=1e-13)


@pytest.mark.parametrize("compiler", sorted(compilers()))
@pytest.mark.parametrize("m", [8, 15, 30])
def test_many_columns_of_a_tree(m: int, compiler: str) -> None:
    """The kernel that takes eight columns at once, with the zeros that branches leave in A."""
    n = 12
    cfile = generate(solving("spd", n, m), chosen=())
    assert "CARDAN_SOLVE(spd, 12" in cfile.text
    rng = np.random.default_rng(m)
    factor = np.tril(rng.uniform(-1, 1, (n, n)))
    factor[8:, 4:8] = 0
    np.fill_diagonal(factor, rng.uniform(1, 2, n))
    a, x = factor.T @ factor, rng.uniform(-1, 1, (n, m))
    # only the lower triangle is read
    given = np.where(np.triu(np.ones((n, n)), 1) == 1, 77.0, a)
    answer = call(cfile, {"q": [*given.ravel(), *(a @ x).ravel()]}, compiler)
    assert answer.status == 0
    bound = 50 * np.finfo(float).eps * np.linalg.cond(a)
    assert np.abs(answer.out[: n * m].reshape(n, m) - x).max() <= bound


@pytest.mark.parametrize("kind", [*PIVOTING, "spd"])
def test_solutions_are_read_in_other_parts(kind: str) -> None:
    """A long function is split behind its systems; entries that are computed are stored at once."""
    plain = solving(kind)
    g = plain.graph
    _, _, n, m, *entries = next(node for node in g.nodes if node[0] == "solve")
    twice = [g.mul(g.const(2.0), k) for k in entries]
    node = g.intern(("solve", kind, n, m, *twice))
    items = [g.intern(("item", node, k)) for k in range(n * m)]
    squares = [g.mul(a, g.add(a, b)) for a in items for b in items]
    outputs = (Output("x", (n, m), tuple(items)), Output("y", (len(squares),), tuple(squares)))
    function = Function("solving", g, plain.inputs, outputs)
    cfile = generate(function, chosen=(), longest=20)
    assert "solving_part3" in cfile.text
    a, b = system(kind, 3)
    a = a @ a.T + np.eye(4) if kind == "spd" else a
    x = call(cfile, {"q": [*a.ravel(), *b.ravel()]}).out
    assert np.allclose(x[:8].reshape(4, 2), np.linalg.solve(a, b), rtol=1e-11)
    expected = np.outer(x[:8], np.ones(8)) * (x[:8, None] + x[None, :8])
    assert np.allclose(x[8:], expected.ravel(), rtol=1e-13)


@pytest.mark.parametrize("pivot", [0.0, -1.0, np.nan])
def test_what_is_not_positive_definite_has_no_solution(pivot: float) -> None:
    cfile = generate(solving("spd", 3, 2), chosen=())
    a = np.array([[1.0, 0, 0], [0, pivot, 0], [0, 0, 1]])
    answer = call(cfile, {"q": [*a.ravel(), *np.ones(6)]})
    assert answer.status == 1
    assert np.isnan(answer.out).all()


def test_redundant_equations_are_solved() -> None:
    cfile = generate(solving("rank_revealing", 4, 1))
    rng = np.random.default_rng(7)
    left, right = rng.uniform(-1, 1, (4, 2)), rng.uniform(-1, 1, (2, 4))
    a = left @ right
    b = a @ rng.uniform(-1, 1, 4)
    answer = call(cfile, {"q": [*a.ravel(), *b]})
    assert answer.status == 0
    assert np.abs(a @ answer.out[:4] - b).max() <= 1e-14
    # two unknowns are free and became 0
    assert np.sum(answer.out[:4] == 0) == 2


@pytest.mark.parametrize("kind", ["semidefinite", "basic"])
@pytest.mark.parametrize("size", [1e-13, 1e-30, 1e-120])
def test_rows_of_which_rounding_is_left_have_no_direction(kind: str, size: float) -> None:
    function = solving(kind, 3, 1)
    rows = np.array([[1.0, 2, 0], [0, 3, 1], [0, 0, size]])
    right = np.array([1.0, 2, 1e-3])
    a = rows @ rows.T if kind == "semidefinite" else rows
    given = {"q": [*a.ravel(), *right]}
    x = call(generate(function), given).out[:3]
    if kind == "semidefinite":
        wanted = [*np.linalg.solve(a[:2, :2], right[:2]), 0.0]
    else:
        # 1 is the largest entry of what 3 leaves: the last unknown is free
        wanted = [*np.linalg.solve(rows[:2, :2], right[:2]), 0.0]
    np.testing.assert_allclose(x, wanted, rtol=1e-13)
    np.testing.assert_allclose(np.ravel(evaluate(function, given)["x"]), x, rtol=1e-14)


@pytest.mark.parametrize("kind", PIVOTING)
def test_contradiction_is_said_in_numbers_and_status(kind: str) -> None:
    cfile = generate(solving(kind, 3, 1))
    a = np.array([[1.0, 1, 0], [1, 1, 0], [0, 0, 1]])
    answer = call(cfile, {"q": [*a.ravel(), 1.0, 2.0, 3.0]})
    assert answer.status == 1
    assert np.isnan(answer.out[:3]).all()


@pytest.mark.parametrize("kind", PIVOTING)
def test_nan_comes_through(kind: str) -> None:
    cfile = generate(solving(kind, 3, 1))
    answer = call(cfile, {"q": [np.nan] * 12})
    assert answer.status == 1
    assert np.isnan(answer.out).all()


def test_symmetric_kernel_reads_the_lower_triangle() -> None:
    cfile = generate(solving("symmetric_indefinite", 3, 1))
    a = np.array([[0.0, 2, 1], [2, 0, 3], [1, 3, 0]])
    upper = np.where(np.triu(np.ones((3, 3)), 1) == 1, 77.0, a)
    x = np.array([1.0, -2, 3])
    answer = call(cfile, {"q": [*upper.ravel(), *(a @ x)]})
    assert np.allclose(answer.out[:3], x, rtol=1e-14)


def test_only_functions_with_systems_include_the_kernels() -> None:
    assert generate(solving("rank_revealing")).includes == ("cardan.h", "solve.h")
    assert generate(solving("spd")).includes == ("cardan.h",)
