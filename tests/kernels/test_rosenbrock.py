"""The coefficients of the Rosenbrock method obey the conditions of order, at both ends."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from itertools import combinations_with_replacement
from math import prod

import numpy as np
import pytest

from cardan.schema import kernel_files

# a rooted tree is the tuple of the trees that grow from its root
Tree = tuple["Tree", ...]
Array = np.ndarray


def table(name: str, rows: int, columns: int) -> Array:
    """A table of the header, short rows filled with zeros."""
    text = kernel_files.text("rosenbrock_tables.h")
    body = re.search(rf"static const real {name}\S* = (.*?);", text, re.S)
    assert body is not None
    found = np.zeros((rows, columns))
    for row, part in zip(found, re.findall(r"\{([^{}]*)\}", body[1]), strict=True):
        numbers = [float(x) for x in part.split(",") if x.strip()]
        row[: len(numbers)] = numbers
    return found


def gamma() -> float:
    text = kernel_files.text("rosenbrock_tables.h")
    return float(re.search(r"GAMMA = (\S+);", text)[1])  # type: ignore[index]


def method() -> tuple[Array, Array, Array]:
    """alpha (8, 8), Gamma (8, 8) and the weights b (8), of the method before it was transformed."""
    transformed = np.zeros((8, 8))
    transformed[:6, :5] = table("A", 6, 5)
    # the last stages stand at the one before plus its own u
    transformed[6] = transformed[5] + np.eye(8)[5]
    transformed[7] = transformed[6] + np.eye(8)[6]
    weights = transformed[7] + np.eye(8)[7]
    C = np.zeros((8, 8))
    C[:, :7] = table("C", 8, 7)
    Gamma = np.linalg.inv(np.eye(8) / gamma() - C)
    return transformed @ Gamma, Gamma, weights @ Gamma


@cache
def trees(order: int) -> tuple[Tree, ...]:
    """All rooted trees of so many vertices."""
    return tuple(_bundles(order - 1, order - 1))


def _bundles(count: int, most: int) -> Iterator[Tree]:
    """Bundles of trees with so many vertices together, none of them with more than ``most``."""
    if count == 0:
        yield ()
    for size in range(min(count, most), 0, -1):
        for how_many in range(1, count // size + 1):
            for chosen in combinations_with_replacement(trees(size), how_many):
                for rest in _bundles(count - size * how_many, size - 1):
                    yield chosen + rest


def vertices(tree: Tree) -> int:
    return 1 + sum(vertices(branch) for branch in tree)


def density(tree: Tree) -> int:
    return vertices(tree) * prod(density(branch) for branch in tree)


def weight(tree: Tree, alpha: Array, beta: Array) -> Array:
    """What every stage contributes; where a vertex has one branch the Jacobian has its say."""
    if not tree:
        return np.ones(len(alpha))
    if len(tree) == 1:
        return beta @ weight(tree[0], alpha, beta)
    return np.asarray(prod(alpha @ weight(branch, alpha, beta) for branch in tree))


def defect(order: int, b: Array, alpha: Array, Gamma: Array) -> float:
    """The largest violation among the conditions of one order."""
    return max(
        abs(b @ weight(tree, alpha, alpha + Gamma) - 1 / density(tree)) for tree in trees(order)
    )


def test_trees_are_counted_right() -> None:
    assert [len(trees(order)) for order in range(1, 7)] == [1, 1, 2, 4, 9, 20]


@pytest.mark.parametrize("order", [1, 2, 3, 4, 5])
def test_order_conditions(order: int) -> None:
    alpha, Gamma, b = method()
    # coefficients of up to 100 with 16 digits
    assert defect(order, b, alpha, Gamma) < 1e-12
    # the embedded method is that of the stage before the last
    embedded = b - Gamma[7]
    assert (defect(order, embedded, alpha, Gamma) < 1e-12) == (order < 5)


def test_no_order_more() -> None:
    alpha, Gamma, b = method()
    assert defect(6, b, alpha, Gamma) > 1e-5


def test_times_of_the_stages() -> None:
    alpha, Gamma, _ = method()
    np.testing.assert_allclose(alpha.sum(axis=1), table("NODES", 1, 8)[0], rtol=0, atol=1e-12)
    np.testing.assert_allclose(Gamma.sum(axis=1), table("SLOPES", 1, 8)[0], rtol=0, atol=1e-12)


def test_stiffly_accurate() -> None:
    alpha, Gamma, b = method()
    beta = alpha + Gamma
    np.testing.assert_allclose(beta[7], b, rtol=0, atol=1e-12)
    # what is infinitely stiff is forgotten in a step: R(inf) = 1 - b beta^-1 1
    assert abs(1 - b @ np.linalg.solve(beta, np.ones(8))) < 1e-10


@pytest.mark.parametrize("theta", [0.25, 0.5, 0.75])
def test_dense_output(theta: float) -> None:
    alpha, Gamma, b = method()
    H = table("H", 3, 8) @ Gamma
    inner = H[0] + theta * (H[1] + theta * H[2])
    inside = theta * (b + (1 - theta) * inner)
    for order in range(1, 5):
        for tree in trees(order):
            found = inside @ weight(tree, alpha, alpha + Gamma)
            assert abs(found - theta**order / density(tree)) < 1e-11
