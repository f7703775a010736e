"""The tangent operator against differences of the exponential in many digits."""

from __future__ import annotations

import numpy as np
import pytest

from cardan.ir.graph import Graph
from cardan.spatial.exponential import exp, tangent
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


def test_tangent_is_exact_at_zero() -> None:
    graph = Graph()
    v, zero = block(graph, "v", 3), np.zeros(3)
    assert np.array_equal(numbers(tangent(v), v=zero), np.eye(3))
