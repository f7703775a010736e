"""Energies of elements as SymPy expressions. Loads SymPy: import it on demand.

The formulas that readers see are evaluated with symbols for the entries of everything that has a
name, so that an energy is told in strains, stresses and velocities, with definitions beside it.
"""

from __future__ import annotations

import ast
import operator
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TypeAlias

import sympy

from ...elements.formulas import Lines, Shape, Shapes
from ...records import dataclass

# a number, a matrix, or the solution of a system
Value: TypeAlias = "sympy.Basic"
Values: TypeAlias = "dict[str, Value]"

LETTERS = "xyz"

# names of vectors and of rotations, whatever element they are of
VECTOR = re.compile(r"(p|v|vdot|omega|omegadot|g)(_\w+)?")
ROTATION = re.compile(r"R(_\w+)?")
# rows that one digit tells apart
MOST_DIGITS = 9
# operations of a definition that is put into what reads it
SHORT = 2


@dataclass(frozen=True)
class EnergyExpressions:
    """Kinetic and potential energy of one element, in names that the definitions explain.

    Attributes:
        kinetic, potential: SymPy expressions; 0 where there is none.
        definitions: SymPy equations, each in names of those before it and of the state: poses
            ``R_1``, ``p_1``, velocities ``v_1``, ``omega_1`` and data. Entries of vectors in space
            end with x, y, z, and others with numbers. Stresses that a system determines stand on
            the left sides of its rows.
    """

    kinetic: sympy.Expr
    potential: sympy.Expr
    definitions: tuple[sympy.Eq, ...]


def energy_of(elements: Sequence[tuple[Lines, Shapes]]) -> EnergyExpressions:
    """Sum of the energies of elements that share their ends.

    Args:
        elements: Formulas of each, and shapes of names that they do not define; others are numbers.
    """
    totals = {"T": sympy.Integer(0), "V": sympy.Integer(0)}
    definitions: dict[sympy.Eq, None] = {}
    for lines, shapes in elements:
        written = _Written(lines, shapes)
        for letter in totals:
            totals[letter] += written.energy(letter)
        definitions |= dict.fromkeys(written.read())
    return EnergyExpressions(totals["T"], totals["V"], tuple(definitions))


class _Written:
    """Formulas with symbols for everything that has a name."""

    def __init__(self, lines: Lines, shapes: Shapes) -> None:
        self.values: Values = dict(FUNCTIONS)
        self.shapes = shapes
        self.definitions: dict[str, list[sympy.Eq]] = {}
        self.totals: Values = {}
        sides = [formula.partition(" = ")[::2] for _, formula in lines]
        # what follows the energies is not needed for them
        last = max((n for n, (left, _) in enumerate(sides) if left in ("T", "V")), default=-1)
        for left, right in sides[: last + 1]:
            self._define(left, right)

    def _define(self, left: str, right: str) -> None:
        for name in _names(right):
            if name not in self.values:
                self.values[name] = _symbols_of(name, self._shape(name))
        value = _value(ast.parse(right, mode="eval").body, self.values)
        if left in ("T", "V"):
            self.totals[left] = shorter(_entries_of(value)[0])
        self.values[left], self.definitions[left] = _symbols(left, value)
        if left == "s" and len(_entries_of(self.values["s"])) == 6:
            self.values |= {"s_m": self.values["s"][:3, :], "s_n": self.values["s"][3:, :]}

    def _shape(self, name: str) -> Shape | tuple[()]:
        if name in self.shapes:
            return self.shapes[name]
        if VECTOR.fullmatch(name):
            return (3, 1)
        return (3, 3) if ROTATION.fullmatch(name) else ()

    def energy(self, letter: str) -> sympy.Expr:
        """An energy; parts of it that have names are put in."""
        total = self.totals.get(letter, sympy.Integer(0))
        parts = {name: self._right_side(name) for name in self.definitions if name != letter
                 and name.startswith(f"{letter}_")}  # fmt: skip
        return total.xreplace({sympy.Symbol(name): value for name, value in parts.items()})

    def _right_side(self, name: str) -> sympy.Expr:
        """Right side of a number's definition."""
        (equation,) = self.definitions[name]
        return shorter(equation.rhs)

    def read(self) -> Iterator[sympy.Eq]:
        """Definitions that the energies need, in order."""
        needed = set[sympy.Symbol]()
        for letter in self.totals:
            needed |= self.energy(letter).free_symbols
        needed_equations: list[list[sympy.Eq]] = []
        for name, equations in reversed(self.definitions.items()):
            of_name = set(_entries(self.values[name]))
            if name in ("T", "V") or not of_name & needed:
                continue
            needed_equations.append(equations)
            for equation in equations:
                needed |= equation.free_symbols
        for equations in reversed(needed_equations):
            yield from equations


def shorter(expression: sympy.Expr) -> sympy.Expr:
    """An energy as it came, or multiplied out where that has fewer operations."""
    return min(expression, sympy.expand(expression), key=sympy.count_ops)


OPERATIONS: Mapping[type[ast.AST], Callable[..., Value]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.MatMult: operator.matmul,
    ast.Div: operator.truediv,
    ast.Pow: operator.pow,
    ast.Lt: operator.lt,
    ast.Gt: operator.gt,
}


def _value(node: ast.expr, values: Values) -> Value:
    """A formula in terms of values."""
    if isinstance(node, ast.Constant):
        return sympy.Rational(str(node.value))
    if isinstance(node, ast.Name):
        return values[node.id]
    if isinstance(node, ast.UnaryOp):
        return -_value(node.operand, values)
    if isinstance(node, ast.Attribute):
        return _value(node.value, values).T
    if isinstance(node, ast.IfExp):
        case = _value(node.body, values), _value(node.test, values)
        return sympy.Piecewise(case, (_value(node.orelse, values), True))
    if isinstance(node, ast.Call):
        function = _value(node.func, values)
        return function(*(_value(x, values) for x in node.args))
    if isinstance(node, ast.Compare):
        sides = _value(node.left, values), _value(node.comparators[0], values)
        return OPERATIONS[type(node.ops[0])](*sides)
    assert isinstance(node, ast.BinOp)
    left, right = _value(node.left, values), _value(node.right, values)
    return OPERATIONS[type(node.op)](left, right)


def _symbols(name: str, value: Value) -> tuple[Value, list[sympy.Eq]]:
    """Symbols for a value, and what they stand for; what is short stands for itself."""
    if isinstance(value, _Implicit):
        unknown = _symbols_of(name, value.right.shape)
        rows = zip(value.matrix * unknown, value.right, strict=True)
        return unknown, [sympy.Eq(left, right) for left, right in rows]
    if not isinstance(value, sympy.MatrixBase):
        value = sympy.sympify(value, strict=True)
        if _short(value):
            return value, []
        symbol = sympy.Symbol(name)
        return symbol, [sympy.Eq(symbol, value)]
    named, equations = _symbols_of(name, value.shape), list[sympy.Eq]()
    for k, entry in enumerate(value):
        if _short(entry):
            named[k] = entry
        else:
            equations.append(sympy.Eq(named[k], entry))
    return named, equations


def _short(entry: sympy.Expr) -> bool:
    return bool(entry.is_Atom or sympy.count_ops(entry) <= SHORT)


def _entries(value: Value) -> list[sympy.Expr]:
    return [x for x in _entries_of(value) if x.is_Symbol]


def _names(right: str) -> list[str]:
    """Names that a formula reads."""
    return [node.id for node in ast.walk(ast.parse(right)) if isinstance(node, ast.Name)]


# the functions of formulas


class _Implicit:
    """The solution of a linear system whose inverse nobody would read."""

    def __init__(self, matrix: sympy.Matrix, right: sympy.Matrix = None) -> None:
        self.matrix, self.right = matrix, right

    def __matmul__(self, right: sympy.Matrix) -> _Implicit:
        return _Implicit(self.matrix, right)


def _symbols_of(name: str, shape: Shape | tuple[()]) -> Value:
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
    """``v_1x`` of vectors in space, ``y_4`` and ``F_12`` of others, ``K_3_11`` of large ones."""
    gap = "_" if size > MOST_DIGITS else ""
    index = gap.join(LETTERS[k] if size == 3 else str(k + 1) for k in places)
    return sympy.Symbol(f"{name}{index}" if name[-1].isdigit() and size == 3 else f"{name}_{index}")


def _entries_of(value: Value) -> list[sympy.Expr]:
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
    return _Implicit(matrix)


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
    "matrix": lambda *entries: sympy.Matrix(3, 3, entries),
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
