"""Rodrigues parameters."""

from __future__ import annotations

from ...ir.arithmetic import Scalar, sqrt
from ...ir.matrix import Matrix
from ...records import dataclass
from ..exponential import quaternion_of
from .rotation import Rotation


@dataclass(frozen=True)
class Rodrigues(Rotation):
    """r = tan(phi/2) n, also called the Gibbs vector: rational, infinite at half a turn.

    Source: Roberson and Schwertassek, Dynamics of Multibody Systems, section 2.3.
    """

    name: str = "rodrigues"
    components: tuple[str, ...] = ("x", "y", "z")
    units: tuple[str, ...] = ("", "", "")
    defaults: tuple[float, ...] = (0.0, 0.0, 0.0)
    domain: str = "rotations by less than pi"

    def matrix(self, q: Matrix) -> Matrix:
        skew, factor = q.skew, 2 / (1 + q.dot(q))
        square = q.outer(q) - Matrix.identity(q.graph, 3) * q.dot(q)
        return Matrix.identity(q.graph, 3) + (skew + square) * factor

    def rates(self, q: Matrix, omega: Matrix) -> Matrix:
        return (omega + q * q.dot(omega) + q.cross(omega)) * 0.5

    def omega(self, q: Matrix, qdot: Matrix) -> Matrix:
        return (qdot - q.cross(qdot)) * (2 / (1 + q.dot(q)))

    def from_matrix(self, R: Matrix) -> Matrix:
        quaternion = quaternion_of(R)
        return quaternion.block(slice(1, 4)) / quaternion[0]

    def margin(self, q: Matrix) -> Scalar:
        return 1 / sqrt(1 + q.dot(q))
