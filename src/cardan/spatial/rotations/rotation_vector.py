"""Cartesian rotation vector."""

from __future__ import annotations

from ...ir.arithmetic import Scalar, stumpff
from ...ir.matrix import Matrix
from ...records import dataclass
from ..exponential import exp, log
from .rotation import Rotation


@dataclass(frozen=True)
class RotationVector(Rotation):
    """v = phi n, with c_k the Stumpff functions of phi²: nothing is singular at 0.

    omega = T(v) vdot with T = 1 - c_2 [v] + c_3 [v]², which is singular at full turns only.

    Source: Géradin and Cardona, Flexible Multibody Dynamics (2001), section 4.6.
    """

    name: str = "rotation_vector"
    components: tuple[str, ...] = ("x", "y", "z")
    units: tuple[str, ...] = ("rad", "rad", "rad")
    defaults: tuple[float, ...] = (0.0, 0.0, 0.0)
    domain: str = "rotations by less than 2 pi"

    def matrix(self, q: Matrix) -> Matrix:
        return exp(q)

    def rates(self, q: Matrix, omega: Matrix) -> Matrix:
        x, across = q.dot(q), q.cross(omega)
        # (1 - c_1 / (2 c_2)) / x without its cancellation at 0
        factor = (stumpff(3, x) - 2 * stumpff(4, x)) / (2 * stumpff(2, x))
        return omega + across * 0.5 + q.cross(across) * factor

    def omega(self, q: Matrix, qdot: Matrix) -> Matrix:
        x, across = q.dot(q), q.cross(qdot)
        return qdot - across * stumpff(2, x) + q.cross(across) * stumpff(3, x)

    def from_matrix(self, R: Matrix) -> Matrix:
        return log(R)

    def margin(self, q: Matrix) -> Scalar:
        return stumpff(1, q.dot(q) * 0.25).apply("abs")
