"""Small dense matrices of expressions; structural zeros cost nothing."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import lru_cache

from .arithmetic import Number, Scalar
from .graph import MINUS_ONE, ONE, ZERO, Graph

Name = Callable[[int, str, str], int]


class Matrix:
    """A rows x columns matrix of nodes of one graph, stored row by row.

    A vector is a matrix with one column. Slices and products of ``int`` indices give
    :class:`Scalar`; slices give matrices.
    """

    __slots__ = ("columns", "graph", "nodes", "rows")

    def __init__(self, graph: Graph, rows: int, columns: int, nodes: Iterable[int]) -> None:
        self.graph = graph
        self.rows = rows
        self.columns = columns
        self.nodes = tuple(nodes)
        if len(self.nodes) != rows * columns:
            raise ValueError(f"{len(self.nodes)} entries do not fill {rows} x {columns}")

    # makers

    @staticmethod
    def of(graph: Graph, rows: Sequence[Sequence[Number]]) -> Matrix:
        """From nested rows of scalars and numbers."""
        flat = [x.node if isinstance(x, Scalar) else graph.const(x) for row in rows for x in row]
        return Matrix(graph, len(rows), len(rows[0]) if rows else 0, flat)

    @staticmethod
    def vector(graph: Graph, entries: Sequence[Number]) -> Matrix:
        return Matrix.of(graph, [[x] for x in entries]) if entries else Matrix(graph, 0, 1, ())

    @staticmethod
    def zeros(graph: Graph, rows: int, columns: int = 1) -> Matrix:
        return Matrix(graph, rows, columns, (ZERO,) * (rows * columns))

    @staticmethod
    def identity(graph: Graph, n: int) -> Matrix:
        return Matrix(graph, n, n, [ONE if i == j else ZERO for i in range(n) for j in range(n)])

    @staticmethod
    def hstack(*blocks: Matrix) -> Matrix:
        first = blocks[0]
        nodes = [x for i in range(first.rows) for b in blocks for x in b.row(i)]
        return Matrix(first.graph, first.rows, sum(b.columns for b in blocks), nodes)

    @staticmethod
    def vstack(*blocks: Matrix) -> Matrix:
        first = blocks[0]
        nodes = [x for b in blocks for x in b.nodes]
        return Matrix(first.graph, sum(b.rows for b in blocks), first.columns, nodes)

    # access

    def __repr__(self) -> str:
        return f"Matrix({self.rows}x{self.columns}, nodes {self.nodes})"

    def __len__(self) -> int:
        return self.rows

    def __iter__(self) -> Iterator[Scalar]:
        """The entries, row by row."""
        return (Scalar(self.graph, x) for x in self.nodes)

    def row(self, i: int) -> tuple[int, ...]:
        return self.nodes[i * self.columns : (i + 1) * self.columns]

    @property
    def mirrored(self) -> Matrix:
        """Square, with the lower triangle for both."""
        n = self.rows
        nodes = [self.nodes[max(i, j) * n + min(i, j)] for i in range(n) for j in range(n)]
        return Matrix(self.graph, n, n, nodes)

    def column(self, j: int) -> Matrix:
        return Matrix(self.graph, self.rows, 1, self.nodes[j :: self.columns])

    def __getitem__(self, key: int | tuple[int, int]) -> Scalar:
        """Entry (i, j), or entry i of a vector."""
        if isinstance(key, tuple):
            i, j = key
            return Scalar(self.graph, self.nodes[i * self.columns + j])
        return Scalar(self.graph, self.nodes[key])

    def block(self, rows: slice, columns: slice = slice(None)) -> Matrix:
        """The submatrix of the two slices."""
        i, j = range(self.rows)[rows], range(self.columns)[columns]
        return Matrix(
            self.graph, len(i), len(j), [self.nodes[r * self.columns + c] for r in i for c in j]
        )

    @property
    def T(self) -> Matrix:
        nodes = [x for j in range(self.columns) for x in self.nodes[j :: self.columns]]
        return Matrix(self.graph, self.columns, self.rows, nodes)

    @property
    def is_zero(self) -> bool:
        """True when every entry is a structural zero."""
        return not any(self.nodes)

    # algebra

    def map(self, f: Callable[[int], int]) -> Matrix:
        """The matrix of f(node)."""
        return Matrix(self.graph, self.rows, self.columns, [f(x) for x in self.nodes])

    def _zip(self, other: Matrix, f: Callable[[int, int], int]) -> Matrix:
        if (self.rows, self.columns) != (other.rows, other.columns):
            raise ValueError(
                f"shapes {self.rows}x{self.columns} and {other.rows}x{other.columns} differ"
            )
        pairs = zip(self.nodes, other.nodes, strict=True)
        return Matrix(self.graph, self.rows, self.columns, [f(a, b) for a, b in pairs])

    def __add__(self, other: Matrix) -> Matrix:
        return self._zip(other, self.graph.add)

    def __sub__(self, other: Matrix) -> Matrix:
        return self._zip(other, self.graph.sub)

    def __neg__(self) -> Matrix:
        return self.map(self.graph.neg)

    def __mul__(self, factor: Number) -> Matrix:
        graph = self.graph
        node = factor.node if isinstance(factor, Scalar) else graph.const(factor)
        return self.map(lambda x: graph.mul(node, x))

    __rmul__ = __mul__

    def __truediv__(self, divisor: Number) -> Matrix:
        graph = self.graph
        node = divisor.node if isinstance(divisor, Scalar) else graph.const(divisor)
        return self.map(lambda x: graph.div(x, node))

    def __matmul__(self, other: Matrix) -> Matrix:
        if self.columns != other.rows:
            raise ValueError(f"columns {self.columns} and rows {other.rows} differ in a product")
        columns = [other.nodes[j :: other.columns] for j in range(other.columns)]
        nodes = [
            inner(self.graph, self.row(i), column) for i in range(self.rows) for column in columns
        ]
        return Matrix(self.graph, self.rows, other.columns, nodes)

    def dot(self, other: Matrix) -> Scalar:
        """Sum of the products of corresponding entries."""
        return Scalar(self.graph, inner(self.graph, self.nodes, other.nodes))

    def cross(self, other: Matrix) -> Matrix:
        """Vector product of two 3-vectors."""
        g, (a, b, c), (x, y, z) = self.graph, self.nodes, other.nodes
        mul, sub = g.mul, g.sub
        return Matrix(
            g,
            3,
            1,
            (sub(mul(b, z), mul(c, y)), sub(mul(c, x), mul(a, z)), sub(mul(a, y), mul(b, x))),
        )

    @property
    def skew(self) -> Matrix:
        """The matrix [v] with [v] w = v x w, of a 3-vector v."""
        g, (x, y, z) = self.graph, self.nodes
        neg = g.neg
        return Matrix(g, 3, 3, (ZERO, neg(z), y, z, ZERO, neg(x), neg(y), x, ZERO))

    def outer(self, other: Matrix) -> Matrix:
        """v wᵀ."""
        return self @ other.T

    def congruence(self, symmetric: Matrix) -> Matrix:
        """A X Aᵀ for symmetric X: the lower triangle is mirrored, not computed."""
        g, half = self.graph, (self @ symmetric).note("half_turned")
        n = self.rows
        upper = {(i, j): inner(g, half.row(i), self.row(j)) for i in range(n) for j in range(i, n)}
        return Matrix(g, n, n, [upper[min(i, j), max(i, j)] for i in range(n) for j in range(n)])

    def label(self, owner: str, quantity: str, components: Sequence[str] = "xyz") -> Matrix:
        """Name the entries ``quantity_<component>`` of an owner; returns the matrix."""
        return self._name(self.graph.label, owner, quantity, components)

    def hint(self, owner: str, quantity: str, components: Sequence[str] = "xyz") -> Matrix:
        """The same for entries that need no line of their own, see :meth:`Graph.hint`."""
        return self._name(self.graph.hint, owner, quantity, components)

    def note(self, word: str) -> Matrix:
        """Name the entries as a step to what is made here, see :meth:`Graph.note`."""
        for node, place in zip(self.nodes, _places(self.rows, self.columns), strict=True):
            if node > MINUS_ONE:
                self.graph.note(node, f"{word}_{place}")
        return self

    def _name(self, name: Name, owner: str, quantity: str, components: Sequence[str]) -> Matrix:
        begin = f"{quantity}_" if quantity else ""
        for node, component in zip(self.nodes, components, strict=False):
            if node > MINUS_ONE:
                name(node, owner, f"{begin}{component}" if component else quantity)
        return self


@lru_cache(maxsize=256)
def _places(rows: int, columns: int) -> tuple[str, ...]:
    """Words for the entries of a matrix: axes of vectors and tensors of space, else numbers."""
    if columns == 1 and rows == 6:
        return "wx", "wy", "wz", "vx", "vy", "vz"
    if columns == 1 and rows == 4:
        return "w", "x", "y", "z"
    if rows <= 3 and columns <= 3:
        down, across = ("xyz"[:n] if n > 1 else ("",) for n in (rows, columns))
        return tuple(i + j for i in down for j in across)
    return tuple(f"{i + 1}_{j + 1}" for i in range(rows) for j in range(columns))


def inner(graph: Graph, a: Sequence[int], b: Sequence[int]) -> int:
    """Sum of products of two rows of nodes, skipping structural zeros."""
    total, mul, add = ZERO, graph.mul, graph.add
    for x, y in zip(a, b, strict=True):
        if x and y:
            term = mul(x, y)
            total = add(total, term) if total else term
    return total
