"""Axes, their complements and the rotation about them."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation as SciPy

from cardan.ir.graph import Graph
from cardan.ir.matrix import Matrix
from cardan.spatial.axis import complement, principal, rotation_about, unit
from spatial.numbers_of import block, numbers
from table import each

EPS = np.finfo(float).eps
PRINCIPAL = [s * np.eye(3)[k] for k in range(3) for s in (1.0, -1.0)]
# also where the formula changes sides (z = 0 from both) and next to -z
OTHERS = [
    np.array(v) / np.linalg.norm(v)
    for v in [(1, 2, 3), (1, -1, 0), (1, 2, -1e-300), (0, 1e-9, -1), (-3, 1, -2), (1, 1, 1)]
]


@each("n", PRINCIPAL + OTHERS)
def test_complements_make_a_right_handed_triad(n: np.ndarray) -> None:
    structural, graph = Graph(), Graph()
    for axis, values in (
        (Matrix.vector(structural, [float(x) for x in n]), {}),
        (block(graph, "n", 3), {"n": n}),
    ):
        first, second = complement(axis)
        triad = np.stack([numbers(x, **values) for x in (first, second, axis)], axis=1)
        np.testing.assert_allclose(triad.T @ triad, np.eye(3), atol=4 * EPS)
        assert np.linalg.det(triad) == pytest.approx(1.0, abs=8 * EPS)


@each("n", PRINCIPAL + OTHERS)
@each("angle", [0.0, 0.4, -2.0, 7.0])
def test_rotation_about_an_axis_is_that_of_scipy(n: np.ndarray, angle: float) -> None:
    wanted = SciPy.from_rotvec(angle * n).as_matrix()
    for axis, values in (
        (lambda graph: Matrix.vector(graph, [float(x) for x in n]), {}),
        (lambda graph: block(graph, "n", 3), {"n": n}),
    ):
        graph = Graph()
        R = rotation_about(axis(graph), block(graph, "q", 1)[0])
        np.testing.assert_allclose(numbers(R, q=[angle], **values), wanted, atol=8 * EPS)


def test_a_principal_axis_costs_nothing() -> None:
    graph = Graph()
    y = Matrix.vector(graph, [0.0, -1.0, 0.0])
    size = len(graph)
    assert principal(y) == (1, -1)
    assert unit(y) is y
    assert len(graph) == size
    assert principal(block(graph, "n", 3)) is None


def test_other_axes_are_divided_by_their_length() -> None:
    graph = Graph()
    found = numbers(unit(block(graph, "n", 3)), n=[3.0, 0.0, -4.0])
    np.testing.assert_allclose(found, [0.6, 0.0, -0.8], rtol=2 * EPS)
