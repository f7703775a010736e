"""Euler-Rodrigues parameters."""

from __future__ import annotations

from ...ir.arithmetic import Scalar, sqrt
from ...ir.matrix import Matrix
from ...records import dataclass
from ..exponential import quaternion_of
from .rotation import Rotation


@dataclass(frozen=True)
class EulerRodrigues(Rotation):
    """e = 2 sin(phi/2) n.

    They are the vector part of the Euler parameters, doubled: three numbers instead of four, and
    no constraint among them. The scalar part is sqrt(1 - e²/4), so that rotations by half a turn
    and more are out of reach; Euler parameters (``"quaternion"``) have no such limit.

    Source: O. A. Bauchau, L. Trainelli, The Vectorial Parameterization of Rotation, 2003.
    """

    name: str = "euler_rodrigues"
    components: tuple[str, ...] = ("x", "y", "z")
    units: tuple[str, ...] = ("", "", "")
    defaults: tuple[float, ...] = (0.0, 0.0, 0.0)
    domain: str = "rotations by less than pi"

    def matrix(self, q: Matrix) -> Matrix:
        identity = Matrix.identity(q.graph, 3)
        square = q.outer(q) - identity * q.dot(q)
        return identity + q.skew * self.margin(q) + square * 0.5

    def rates(self, q: Matrix, omega: Matrix) -> Matrix:
        return omega * self.margin(q) + q.cross(omega) * 0.5

    def omega(self, q: Matrix, qdot: Matrix) -> Matrix:
        w = self.margin(q)
        return qdot * w - q.cross(qdot) * 0.5 + q * (q.dot(qdot) / (4 * w))

    def from_matrix(self, R: Matrix) -> Matrix:
        return quaternion_of(R).block(slice(1, 4)) * 2

    def margin(self, q: Matrix) -> Scalar:
        return sqrt(1 - q.dot(q) * 0.25)
