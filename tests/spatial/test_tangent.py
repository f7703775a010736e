"""The tangent operator against differences of the exponential in many digits."""

from __future__ import annotations

import numpy as np
import pytest

from cardan.ir.graph import Graph
from cardan.spatial.exponential import exp
from cardan.spatial.tangent import inverse_tangent, tangent
from spatial.numbers_of import block, close, difference, moving, numbers, unskew

DIRECTION = np.array([2.0, -1.0, 2.0]) / 3
VECTORS = [scale * DIRECTION for scale in (0.0, 1e-20, 1e-3, 1.0, 3.14, 6.0)]
RATE = [0.4, 1.7, -0.9]


@pytest.mark.parametrize("at", VECTORS, ids=str)
def test_tangent_gives_the_angular_velocity_of_the_exponential(at: np.ndarray) -> None:
    graph = Graph()
    v, rate = block(graph, "v", 3), block(graph, "rate", 3)
    path, R = moving(at, RATE), exp(v)
    turning = numbers(R, "mp", v=at).T @ difference(lambda t: numbers(R, "mp", v=path(t)))
    found = numbers(tangent(v) @ rate, "mp", v=at, rate=RATE)
    assert close(found, unskew(turning))
    # the transpose gives it in the fixed axes
    fixed = numbers(tangent(v).T @ rate, "mp", v=at, rate=RATE)
    assert close(fixed, numbers(R, "mp", v=at) @ found, 60)


@pytest.mark.parametrize("at", VECTORS, ids=str)
def test_inverse_tangent(at: np.ndarray) -> None:
    graph = Graph()
    v = block(graph, "v", 3)
    assert close(numbers(tangent(v) @ inverse_tangent(v), "mp", v=at), np.eye(3), 60)
    # in floats too, next to 0 as well
    product = numbers(tangent(v) @ inverse_tangent(v), v=at)
    np.testing.assert_allclose(product, np.eye(3), atol=1e-13)


def test_all_are_exact_at_zero() -> None:
    graph = Graph()
    v, zero = block(graph, "v", 3), np.zeros(3)
    assert np.array_equal(numbers(tangent(v), v=zero), np.eye(3))
    assert np.array_equal(numbers(inverse_tangent(v), v=zero), np.eye(3))
