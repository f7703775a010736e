"""Exponential and logarithm of rotations from the identity to half a turn."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest
from scipy.spatial.transform import Rotation as SciPy

from cardan.ir.graph import Graph
from cardan.ir.matrix import Matrix
from cardan.spatial.exponential import (
    conjugate,
    exp,
    exp_quaternion,
    log,
    log_quaternion,
    multiply,
    quaternion_of,
)
from spatial.numbers_of import block, numbers
from table import each

EPS = np.finfo(float).eps
DIRECTIONS = [(1, 0, 0), (0, -1, 0), (0, 0, 1), (0.6, 0, -0.8), (-2 / 3, 1 / 3, 2 / 3)]
# the logarithm changes its formula where sin²(angle/2) is 1e-3: about 0.0632
ANGLES = [0.0, 1e-300, 1e-12, 1e-6, 0.0632, 0.0633, 1.0, 3.0, pi - 1e-6, pi - 1e-12]


@each("direction", DIRECTIONS)
@each("angle", ANGLES)
def test_logarithm_of_the_exponential(direction: tuple[float, ...], angle: float) -> None:
    v = angle * np.array(direction)
    graph = Graph()
    given = block(graph, "v", 3)
    R = exp(given)
    np.testing.assert_allclose(
        numbers(R, v=v), SciPy.from_rotvec(v).as_matrix(), atol=10 * EPS, rtol=0
    )
    # an entry of R is rounded by EPS, which is EPS of rotation; relative to the angle where small
    np.testing.assert_allclose(numbers(log(R), v=v), v, atol=20 * EPS, rtol=20 * EPS)
    through = log_quaternion(exp_quaternion(given))
    np.testing.assert_allclose(numbers(through, v=v), v, atol=0, rtol=20 * EPS)
    np.testing.assert_allclose(
        numbers(log_quaternion(-exp_quaternion(given)), v=v), v, atol=0, rtol=20 * EPS
    )


@pytest.mark.parametrize("direction", DIRECTIONS)
def test_half_a_turn_has_its_axis_with_either_sign(direction: tuple[float, ...]) -> None:
    n = np.array(direction)
    graph = Graph()
    R = Matrix(graph, 3, 3, block(graph, "R", 9).nodes)
    found = numbers(log(R), R=(2 * np.outer(n, n) - np.eye(3)).ravel())
    assert min(np.abs(found - pi * n).max(), np.abs(found + pi * n).max()) < 10 * EPS


def test_quaternions_of_matrices_are_those_of_scipy() -> None:
    graph = Graph()
    q = quaternion_of(Matrix(graph, 3, 3, block(graph, "R", 9).nodes))
    for rotation in SciPy.random(50, random_state=4):
        found = numbers(q, R=rotation.as_matrix().ravel())
        wanted = rotation.as_quat(canonical=True, scalar_first=True)
        np.testing.assert_allclose(found, wanted, atol=5 * EPS)


def test_products_of_quaternions_are_those_of_scipy() -> None:
    graph = Graph()
    p, q = block(graph, "p", 4), block(graph, "q", 4)
    product = multiply(p, conjugate(q))
    one, two = SciPy.random(2, random_state=9)
    found = numbers(product, p=one.as_quat(scalar_first=True), q=two.as_quat(scalar_first=True))
    wanted = (one * two.inv()).as_quat(scalar_first=True)
    assert min(np.abs(found - wanted).max(), np.abs(found + wanted).max()) < 5 * EPS
