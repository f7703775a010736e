"""Numbers of expressions, in floats and in many digits, and derivatives by differences in them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from cardan.ir.arithmetic import Scalar
from cardan.ir.function import Function, Output
from cardan.ir.graph import Graph
from cardan.ir.interpreter import evaluate
from cardan.ir.matrix import Matrix

# a central difference errs by step² times a third derivative: 50 digits, of which tests ask 40
DIGITS = 80
STEP = 25


def block(graph: Graph, name: str, n: int) -> Matrix:
    """The entries of an input block as a vector."""
    return Matrix(graph, n, 1, [graph.var(name, k) for k in range(n)])


def numbers(what: Matrix | Scalar, arithmetic: str = "float", **blocks: Sequence[Any]) -> Any:
    """Array in the shape of a matrix, vectors flat; a number of a scalar."""
    if isinstance(what, Scalar):
        return numbers(Matrix.vector(what.graph, [what]), arithmetic, **blocks)[0]
    output = Output("x", (len(what.nodes),), what.nodes)
    function = Function("f", what.graph, (), (output,))
    found = evaluate(function, blocks, arithmetic, digits=DIGITS)["x"]
    array = np.array(found, dtype=object if arithmetic == "mp" else float)
    return array if what.columns == 1 else array.reshape(what.rows, what.columns)


def difference(at: Callable[[Any], Any]) -> Any:
    """d at(t)/dt at 0 by a central difference in many digits."""
    import mpmath

    with mpmath.workdps(DIGITS):
        h = mpmath.mpf(10) ** -STEP
        return (at(h) - at(-h)) / (2 * h)


def moving(q: Sequence[Any], rate: Sequence[Any]) -> Callable[[Any], list[Any]]:
    """q + t rate."""
    return lambda t: [a + t * b for a, b in zip(q, rate, strict=True)]


def close(found: Any, wanted: Any, digits: int = 40) -> bool:
    """Entries agree to that many digits after the point."""
    error = np.abs(np.asarray(found, object) - np.asarray(wanted, object))
    return bool(max(error.ravel(), default=0) < 10.0**-digits)


def unskew(m: Any) -> Any:
    """The vector of a skew matrix."""
    return np.array([m[2, 1], m[0, 2], m[1, 0]], dtype=object)
