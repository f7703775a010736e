"""Custom joint: a pose in the user's own coordinates."""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar

from ...errors import ModelError, brief
from ...ir.arithmetic import Scalar, select, sqrt
from ...ir.derivative import forward
from ...ir.graph import ONE
from ...ir.matrix import Matrix
from ...ir.rewrite import rebuild
from ...records import dataclass
from ..quantity import LocalNames, Quantity, Value
from ..validation import vector
from .joint import Component, Joint

IDENTITY = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


@dataclass(frozen=True)
class Custom(Joint):
    """A joint whose pose the user gives as expressions of coordinates; its speeds are their rates.

    The modes of motion are derivatives of the pose. Frames must coincide where all coordinates
    are 0.

    Args:
        symbols: One to six SymPy symbols, the coordinates.
        position: Origin of the child in parent axes [m], three expressions.
        rotation: R_PC, 3x3 expressions that make a rotation matrix for every value.

    Raises:
        ModelError: no, too many or repeated coordinates; wrong shapes.

    Source: Roberson and Schwertassek, Dynamics of Multibody Systems, section 8.2.
    """

    kind: ClassVar[str] = "custom"
    symbols: LocalNames
    position: Value = (0.0, 0.0, 0.0)
    rotation: Value = IDENTITY

    def __post_init__(self) -> None:
        symbols = self.symbols if isinstance(self.symbols, Sequence) else ()
        names = tuple(getattr(s, "name", s) for s in symbols)
        if not all(isinstance(name, str) for name in names):
            names = ()
        if not 1 <= len(names) <= 6 or len(set(names)) < len(names):
            raise ModelError(
                f"custom joint: coordinates are {brief(self.symbols)}; give one to "
                "six different symbols"
            )
        rows = self.rotation.tolist() if hasattr(self.rotation, "tolist") else self.rotation
        if not isinstance(rows, Sequence) or len(rows) != 3:
            raise ModelError("custom joint: rotation must have 3 rows of 3 expressions")
        entries = tuple(x for i, row in enumerate(rows) for x in _row(i, row))
        object.__setattr__(self, "symbols", names)
        object.__setattr__(self, "position", vector("custom joint", "position", self.position, 3))
        object.__setattr__(self, "rotation", entries)

    @property
    def coordinates(self) -> tuple[Component, ...]:
        if len(self.symbols) == 1:
            return (Component("", ""),)
        return tuple(Component(name, "") for name in self.symbols)

    def quantities(self) -> dict[str, Quantity]:
        cells = tuple(f"{i}{j}" for i in "xyz" for j in "xyz")
        return {
            "pose_position": Quantity(self.position, "m", local=self.symbols),
            "pose_rotation": Quantity(self.rotation, "", True, cells, local=self.symbols),
        }

    def _at(self, q: Matrix, *of: Matrix) -> list[Matrix]:
        """Expressions in the user's symbols at the coordinates q."""
        graph = q.graph
        local = {graph.atom(n): x for n, x in zip(self.symbols, q.nodes, strict=True)}
        nodes = rebuild(graph, [n for x in of for n in x.nodes], local, into=graph)[1]
        result = []
        for x in of:
            result.append(Matrix(graph, x.rows, x.columns, nodes[: len(x.nodes)]))
            nodes = nodes[len(x.nodes) :]
        return result

    def pose(self, q: Matrix, **data: Matrix) -> tuple[Matrix, Matrix]:
        rotation = Matrix(q.graph, 3, 3, data["pose_rotation"].nodes)
        rotation_matrix, position = self._at(q, rotation, data["pose_position"])
        return rotation_matrix, position

    def motion(self, q: Matrix, **data: Matrix) -> Matrix:
        graph, columns = q.graph, []
        R, p = Matrix(graph, 3, 3, data["pose_rotation"].nodes), data["pose_position"]
        for name in self.symbols:
            seed = {graph.atom(name): ONE}
            dR = Matrix(graph, 3, 3, forward(graph, R.nodes, seed))
            dp = Matrix(graph, 3, 1, forward(graph, p.nodes, seed))
            spin = R.T @ dR
            angular = Matrix.vector(graph, [spin[2, 1], spin[0, 2], spin[1, 0]])
            columns.append(Matrix.vstack(angular, R.T @ dp))
        return self._at(q, Matrix.hstack(*columns))[0]

    def constrained(self, q: Matrix, **data: Matrix) -> Matrix:
        """The last columns of Q of a Householder factorization of S, orthonormal.

        Smooth where no pivot of the factorization changes its sign; not defined where a mode of
        motion vanishes or depends on the others.
        """
        s, graph = self.motion(q, **data), q.graph
        basis = Matrix.identity(graph, 6)
        for k in range(s.columns):
            x = [s[i, k] if i >= k else Scalar(graph, 0) for i in range(6)]
            length = sqrt(sum((v * v for v in x[1:]), x[0] * x[0]))
            x[k] = x[k] + select(x[k].apply("lt", 0.0), -length, length)
            v = Matrix.vector(graph, x)
            factor = 2 / v.dot(v)
            s = s - v @ (v.T @ s) * factor
            basis = basis - (basis @ v) @ v.T * factor
        return basis.block(slice(None), slice(s.columns, 6))

    @property
    def closes_by_coordinates(self) -> bool:
        return True


def _row(i: int, row: object) -> tuple[Value, ...]:
    return vector("custom joint", f"rotation[{i}]", row, 3)
