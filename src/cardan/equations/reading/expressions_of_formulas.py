"""Functions of formulas on SymPy matrices. Loads SymPy: import it on demand."""

from __future__ import annotations

from typing import TypeAlias

import sympy

from ...elements.formulas import Shape

# a number, a matrix, or the solution of a system
Value: TypeAlias = "sympy.Basic"

LETTERS = "xyz"


class Implicit:
    """The solution of a linear system whose inverse nobody would read."""

    def __init__(self, matrix: sympy.Matrix, right: sympy.Matrix = None) -> None:
        self.matrix, self.right = matrix, right

    def __matmul__(self, right: sympy.Matrix) -> Implicit:
        return Implicit(self.matrix, right)


def symbols_of(name: str, shape: Shape | tuple[()]) -> Value:
    """A symbol, or a matrix of symbols for its entries.

    Args:
        name: Of all of it.
        shape: () for a number, (rows, columns), or "diagonal" and "symmetric" with a size.
    """
    if not shape:
        return sympy.Symbol(name)
    rows, columns = shape
    if rows == "diagonal":
        return sympy.diag(*[_entry(name, columns, k) for k in range(columns)])
    if isinstance(rows, str):
        return sympy.Matrix(
            columns, columns, lambda i, j: _entry(name, columns, min(i, j), max(i, j))
        )
    size = max(rows, columns)
    return sympy.Matrix(
        rows,
        columns,
        lambda i, j: _entry(name, rows, i) if columns == 1 else _entry(name, size, i, j),
    )


def _entry(name: str, size: int, *places: int) -> sympy.Symbol:
    """``v_1x`` of vectors in space, ``y_4`` and ``F_12`` of others."""
    index = "".join(LETTERS[k] if size == 3 else str(k + 1) for k in places)
    return sympy.Symbol(f"{name}{index}" if name[-1].isdigit() and size == 3 else f"{name}_{index}")


def entries_of(value: Value) -> list[sympy.Expr]:
    """Entries of a matrix, or the number itself."""
    if isinstance(value, sympy.MatrixBase):
        return list(value)
    return [sympy.sympify(value, strict=True)]


def _skew(v: sympy.Matrix) -> sympy.Matrix:
    x, y, z = v
    return sympy.Matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def _inverse(matrix: sympy.Matrix) -> Value:
    if matrix.is_diagonal():
        return sympy.diag(*(1 / matrix[k, k] for k in range(matrix.rows)))
    return Implicit(matrix)


def _rotation_vector(r: sympy.Matrix) -> sympy.Matrix:
    """Of a rotation by less than half a turn."""
    angle = sympy.acos((r.trace() - 1) / 2)
    vector = sympy.Matrix([r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]])
    return vector * (angle / (2 * sympy.sin(angle)))


def _block(a: Value, b: Value, c: Value, d: Value) -> sympy.Matrix:
    return sympy.Matrix.vstack(sympy.Matrix.hstack(a, b), sympy.Matrix.hstack(c, d))


FUNCTIONS: dict[str, Value] = {
    "skew": _skew,
    "dot": lambda a, b: (a.T * b)[0, 0],
    "column": lambda *parts: sympy.Matrix.vstack(*parts),
    "row": lambda *parts: sympy.Matrix.hstack(*parts),
    "block": _block,
    "diagonal": lambda *entries: sympy.diag(*entries),
    "inverse": _inverse,
    "rotation_vector": _rotation_vector,
    "cot": sympy.cot,
    "sin": sympy.sin,
    "cos": sympy.cos,
    "sqrt": sympy.sqrt,
    "max": sympy.Max,
    "trace": lambda x: x.trace(),
    "I": sympy.eye(3),
    "O": sympy.zeros(3, 3),
    "i": sympy.Matrix([1, 0, 0]),
}
