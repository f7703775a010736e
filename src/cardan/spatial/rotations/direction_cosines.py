"""Direction cosines: two columns of the rotation matrix."""

from __future__ import annotations

from ...ir.arithmetic import Scalar, sqrt
from ...ir.matrix import Matrix
from ...records import dataclass
from .rotation import Rotation


@dataclass(frozen=True)
class DirectionCosines(Rotation):
    """The first two columns of R, six numbers for three speeds; the third is their product.

    Regular for every rotation. The columns must be orthonormal: the equations keep them so, an
    integrator only to its accuracy.

    Source: Roberson and Schwertassek, Dynamics of Multibody Systems, section 2.2.
    """

    name: str = "dcm"
    components: tuple[str, ...] = ("xx", "yx", "zx", "xy", "yy", "zy")
    units: tuple[str, ...] = ("",) * 6
    defaults: tuple[float, ...] = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0)
    domain: str = "every rotation; the two columns must be orthonormal"

    def _columns(self, q: Matrix) -> tuple[Matrix, Matrix, Matrix]:
        first, second = q.block(slice(0, 3)), q.block(slice(3, 6))
        return first, second, first.cross(second)

    def matrix(self, q: Matrix) -> Matrix:
        return Matrix.hstack(*self._columns(q))

    def rates(self, q: Matrix, omega: Matrix) -> Matrix:
        first, second, third = self._columns(q)
        x, y, z = omega
        return Matrix.vstack(second * z - third * y, third * x - first * z)

    def omega(self, q: Matrix, qdot: Matrix) -> Matrix:
        _, second, third = self._columns(q)
        first_rate, second_rate = qdot.block(slice(0, 3)), qdot.block(slice(3, 6))
        return Matrix.vector(
            q.graph, [third.dot(second_rate), -third.dot(first_rate), second.dot(first_rate)]
        )

    def from_matrix(self, R: Matrix) -> Matrix:
        return Matrix.vstack(R.column(0), R.column(1))

    def margin(self, q: Matrix) -> Scalar:
        third = self._columns(q)[2]
        return sqrt(third.dot(third)).apply("min", 1.0)
