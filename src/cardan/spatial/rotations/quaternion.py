"""Euler parameters: the unit quaternion."""

from __future__ import annotations

from ...ir.arithmetic import Scalar, sqrt
from ...ir.matrix import Matrix
from ...records import dataclass
from ..exponential import conjugate, exp_quaternion, log_quaternion, multiply, quaternion_of
from .rotation import Rotation


@dataclass(frozen=True)
class Quaternion(Rotation):
    """Euler parameters w = cos(phi/2), (x, y, z) = n sin(phi/2), bound by w² + x² + y² + z² = 1.

    Regular for every rotation; q and -q are the same rotation. The functions assume a unit
    quaternion and do not normalize.

    Source: A. L. Schwab, J. P. Meijaard, How to draw Euler angles and utilize Euler parameters,
        2006.
    """

    name: str = "quaternion"
    components: tuple[str, ...] = ("qw", "qx", "qy", "qz")
    units: tuple[str, ...] = ("", "", "", "")
    defaults: tuple[float, ...] = (1.0, 0.0, 0.0, 0.0)
    domain: str = "every rotation; the four numbers must have length 1"

    def matrix(self, q: Matrix) -> Matrix:
        w, x, y, z = q
        # twice the products, so that an entry is a sum of two of them
        x2, y2, z2 = 2 * x, 2 * y, 2 * z
        wx, wy, wz = w * x2, w * y2, w * z2
        xx, xy, xz, yy, yz, zz = x * x2, x * y2, x * z2, y * y2, y * z2, z * z2
        return Matrix.of(
            q.graph,
            [
                [1 - (yy + zz), xy - wz, xz + wy],
                [xy + wz, 1 - (xx + zz), yz - wx],
                [xz - wy, yz + wx, 1 - (xx + yy)],
            ],
        )

    def rates(self, q: Matrix, omega: Matrix) -> Matrix:
        w, x, y, z = q
        a, b, c = omega * 0.5
        return Matrix.vector(
            q.graph,
            [
                -(x * a + y * b + z * c),
                w * a - z * b + y * c,
                z * a + w * b - x * c,
                w * c - y * a + x * b,
            ],
        )

    def omega(self, q: Matrix, qdot: Matrix) -> Matrix:
        return multiply(conjugate(q), qdot).block(slice(1, 4)) * 2.0

    def from_matrix(self, R: Matrix) -> Matrix:
        return quaternion_of(R)

    def margin(self, q: Matrix) -> Scalar:
        return sqrt(q.dot(q)).apply("min", 1.0)

    @property
    def unit_quaternion(self) -> bool:
        return True

    def integrate(self, q: Matrix, du: Matrix) -> Matrix:
        return multiply(q, exp_quaternion(du))

    def difference(self, q0: Matrix, q1: Matrix) -> Matrix:
        return log_quaternion(multiply(conjugate(q0), q1))
