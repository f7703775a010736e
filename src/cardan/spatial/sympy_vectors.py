"""Vectors and dyadics of ``sympy.physics.vector``, there and back. SymPy is loaded on demand."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ..errors import ModelError
from ..ir.arithmetic import Scalar
from ..ir.graph import Graph
from ..ir.matrix import Matrix
from .dyadics import Dyadic
from .frames import Frame
from .vectors import Vector

Names = Mapping[tuple[str, int], Any]


def vector_to_sympy(vector: Vector, axes: Any, names: Names | None = None) -> Any:
    """A vector in a SymPy ReferenceFrame.

    Args:
        vector: What to convert.
        axes: The ``sympy.physics.vector.ReferenceFrame`` that stands for the vector's frame.
        names: (block, k) -> SymPy symbol, see :func:`cardan.ir.sympy_bridge.to_sympy`.
    """
    from ..ir.sympy_bridge import to_sympy

    entries = to_sympy(vector.components, names)
    return sum((x * e for x, e in zip(entries, axes, strict=True)), _zero())


def dyadic_to_sympy(dyadic: Dyadic, axes: Any, names: Names | None = None) -> Any:
    """A dyadic in a SymPy ReferenceFrame; arguments as for :func:`vector_to_sympy`."""
    from sympy.physics.vector import Dyadic as SymPyDyadic

    from ..ir.sympy_bridge import to_sympy

    entries, e = to_sympy(dyadic.components, names), list(axes)
    terms = (entries[i, j] * e[i].outer(e[j]) for i in range(3) for j in range(3))
    return sum(terms, SymPyDyadic([]))


def vector_from_sympy(
    vector: Any, frame: Frame, axes: Mapping[Any, Frame], symbols: Mapping[Any, int]
) -> Vector:
    """A vector of SymPy, in one frame.

    Args:
        vector: ``sympy.physics.vector.Vector``, with parts in any frames.
        frame: The frame of the result.
        axes: SymPy ReferenceFrame -> the frame it stands for. SymPy's own rotations between its
            frames are not read.
        symbols: SymPy symbol, or any other expression such as ``q(t)``, -> its node.

    Raises:
        ModelError: a frame or a symbol that is not known.
    """
    total = Vector(frame, Matrix.zeros(frame.graph, 3))
    for measures, there in vector.args:
        own = _frame(there, axes)
        entries = _nodes(frame.graph, measures, symbols)
        total = total + Vector(own, Matrix(frame.graph, 3, 1, entries)).express(frame)
    return total


def dyadic_from_sympy(
    dyadic: Any, frame: Frame, axes: Mapping[Any, Frame], symbols: Mapping[Any, int]
) -> Dyadic:
    """A dyadic of SymPy, in one frame; arguments as for :func:`vector_from_sympy`."""
    graph = frame.graph
    total = Matrix.zeros(graph, 3, 3)
    for measure, left, right in dyadic.args:
        a = vector_from_sympy(left, frame, axes, symbols)
        b = vector_from_sympy(right, frame, axes, symbols)
        (node,) = _nodes(graph, [measure], symbols)
        total = total + a.components.outer(b.components) * Scalar(graph, node)
    return Dyadic(frame, total)


def _frame(there: Any, axes: Mapping[Any, Frame]) -> Frame:
    if there not in axes:
        known = ", ".join(sorted(str(known) for known in axes)) or "none"
        raise ModelError(
            f"SymPy frame '{there}' stands for no frame here; add it to axes. Known: {known}"
        )
    return axes[there]


def _nodes(graph: Graph, entries: Any, symbols: Mapping[Any, int]) -> list[int]:
    from ..ir.sympy_bridge import from_sympy

    return [from_sympy(graph, entry, symbols) for entry in entries]


def _zero() -> Any:
    from sympy.physics.vector import Vector as SymPyVector

    return SymPyVector([])
