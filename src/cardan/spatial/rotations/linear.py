"""Linear parameters."""

from __future__ import annotations

from ...ir.arithmetic import Scalar, sqrt
from ...ir.matrix import Matrix
from ...records import dataclass
from .rotation import Rotation


@dataclass(frozen=True)
class Linear(Rotation):
    """l = sin(phi) n: half the skew part of R, read off without arithmetic.

    Source: Géradin and Cardona, Flexible Multibody Dynamics (2001), section 4.5.
    """

    name: str = "linear"
    components: tuple[str, ...] = ("x", "y", "z")
    units: tuple[str, ...] = ("", "", "")
    defaults: tuple[float, ...] = (0.0, 0.0, 0.0)
    domain: str = "rotations by less than pi/2"

    def matrix(self, q: Matrix) -> Matrix:
        x, identity = q.dot(q), Matrix.identity(q.graph, 3)
        square = q.outer(q) - identity * x
        return identity + q.skew + square / (1 + sqrt(1 - x))

    def rates(self, q: Matrix, omega: Matrix) -> Matrix:
        c = self.margin(q)
        return (omega * (1 + c) + q.cross(omega) - q * (q.dot(omega) / (1 + c))) * 0.5

    def omega(self, q: Matrix, qdot: Matrix) -> Matrix:
        c = self.margin(q)
        inverse = 1 / (1 + c)
        return qdot - q.cross(qdot) * inverse + q * (q.dot(qdot) * inverse / c)

    def from_matrix(self, R: Matrix) -> Matrix:
        differences = [R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]
        return Matrix.vector(R.graph, differences) * 0.5

    def margin(self, q: Matrix) -> Scalar:
        return sqrt(1 - q.dot(q))
