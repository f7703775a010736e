"""Matrices of expressions against NumPy; structural zeros stay."""

from __future__ import annotations

import numpy as np
import pytest

from cardan.ir.arithmetic import Scalar
from cardan.ir.function import live
from cardan.ir.graph import ONE, ZERO, Graph
from cardan.ir.matrix import Matrix
from cardan.ir.solve import ltl, solve, substitute
from ir.expressions import function, y

A = np.arange(1.0, 10.0).reshape(3, 3) / 4 + np.diag([3.0, -1.0, 2.0])
B = np.array([[0.5, -2.0, 1.0], [0.25, 4.0, 0.0], [-1.0, 3.0, 8.0]])


def constant(g: Graph, x: np.ndarray) -> Matrix:
    """A matrix of dyadic numbers; what is computed with them is folded exactly."""
    return Matrix.of(g, np.atleast_2d(x).tolist())


def numbers(m: Matrix) -> np.ndarray:
    return np.array([s.value for s in m], dtype=float).reshape(m.rows, m.columns)


def test_algebra() -> None:
    g = Graph()
    a, b = constant(g, A), constant(g, B)
    np.testing.assert_array_equal(numbers(a + b - -a), 2 * A + B)
    np.testing.assert_array_equal(numbers(a @ b.T), A @ B.T)
    np.testing.assert_array_equal(numbers(a * 0.5 + b / 2.0), (A + B) / 2)
    np.testing.assert_array_equal(numbers(2 * a), 2 * A)
    s = b.T @ b
    np.testing.assert_array_equal(numbers(a.congruence(s)), A @ (B.T @ B) @ A.T)
    assert a.dot(b).value == (A * B).sum()


def test_vectors() -> None:
    g = Graph()
    v, w = A[0], B[2]
    a, b = Matrix.vector(g, v.tolist()), Matrix.vector(g, w.tolist())
    np.testing.assert_array_equal(numbers(a.cross(b)).ravel(), np.cross(v, w))
    np.testing.assert_array_equal(numbers(a.skew @ b).ravel(), np.cross(v, w))
    np.testing.assert_array_equal(numbers(a.outer(b)), np.outer(v, w))


def test_blocks() -> None:
    g = Graph()
    a = constant(g, A)
    top, low = a.block(slice(0, 1)), a.block(slice(1, 3))
    assert Matrix.vstack(top, low).nodes == a.nodes
    left, right = a.block(slice(None), slice(0, 2)), a.column(2)
    assert Matrix.hstack(left, right).nodes == a.nodes
    assert a[1, 2].value == A[1, 2]
    assert [x.value for x in a.T] == A.T.ravel().tolist()
    assert len(Matrix.vector(g, [])) == 0


def test_zeros_are_structural() -> None:
    g = Graph()
    x = Matrix(g, 3, 1, [g.var("q", k) for k in range(3)])
    assert (Matrix.zeros(g, 3, 3) @ x).is_zero
    assert (Matrix.identity(g, 3) @ x).nodes == x.nodes
    assert x.cross(x).is_zero


def test_shapes_and_graphs_must_fit() -> None:
    g = Graph()
    with pytest.raises(ValueError, match="columns 3 and rows 1 differ"):
        constant(g, A) @ constant(g, A[0])
    with pytest.raises(ValueError, match="shapes 3x3 and 1x3 differ"):
        constant(g, A) + constant(g, A[0])
    with pytest.raises(ValueError, match="2 entries do not fill 3 x 1"):
        Matrix(g, 3, 1, (0, 0))
    with pytest.raises(ValueError, match="different graphs"):
        Scalar(g, ONE) + Scalar(Graph(), ONE)
    with pytest.raises(ValueError, match="cannot solve 3x3 with 1x3"):
        solve("spd", constant(g, A), constant(g, A[0]))
    with pytest.raises(ValueError, match="kind of solve must be one of spd"):
        solve("lu", constant(g, A), constant(g, A))


def test_labels() -> None:
    g = Graph()
    x = Matrix(g, 3, 1, [g.apply("exp", g.var("q", k)) for k in range(3)]).label("arm", "v")
    assert [g.labels[n] for n in x.nodes] == [("arm", f"v_{c}") for c in "xyz"]


def test_factor_of_a_tree_has_no_fill() -> None:
    # joints 1 and 2 both hang on joint 0, joint 3 on joint 1: 2 touches neither 1 nor 3
    pattern = [[1, 1, 1, 1], [1, 1, 0, 1], [1, 0, 1, 0], [1, 1, 0, 1]]
    rng = np.random.default_rng(1)
    dense = rng.normal(size=(4, 4))
    m = (dense @ dense.T + 4 * np.eye(4)) * pattern
    g = Graph()
    upper = {(i, j): g.var("m", 4 * i + j) for i in range(4) for j in range(4)}
    nodes = [
        upper[min(i, j), max(i, j)] if pattern[i][j] else ZERO for i in range(4) for j in range(4)
    ]
    lower, inverse = ltl(Matrix(g, 4, 4, nodes))
    assert [[int(x != ZERO) for x in row] for row in lower] == [
        [0, 0, 0, 0],
        [1, 0, 0, 0],
        [1, 0, 0, 0],
        [1, 1, 0, 0],
    ]
    x = substitute(lower, inverse, g, [g.var("u", 0), g.var("u", 1), g.var("u", 2), ONE])
    values = {"m": m.ravel().tolist(), "u": [0.3, -1.0, 2.0]}
    solved = y(function(g, x), values)
    # condition of m is below 20
    np.testing.assert_allclose(m @ solved, [0.3, -1.0, 2.0, 1.0], rtol=0, atol=1e-14)


def test_live_nodes_of_a_small_part_of_a_large_graph() -> None:
    g = Graph()
    x = g.var("q", 0)
    for _ in range(200):
        x = g.apply("sin", x)
    small = g.mul(g.var("u", 0), g.var("u", 1))
    assert live(g, [small]) == [g.var("u", 0), g.var("u", 1), small]
    assert len(live(g, [x, small])) == 204
    assert live(g, [x], stop={x}) == [x]
    assert live(g, []) == []
