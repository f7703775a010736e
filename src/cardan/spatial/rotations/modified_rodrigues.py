"""Modified Rodrigues parameters and the conformal rotation vector: one vector, two lengths."""

from __future__ import annotations

from ...ir.arithmetic import Scalar, sqrt
from ...ir.matrix import Matrix
from ...records import dataclass
from ..exponential import quaternion_of
from .rotation import Rotation


@dataclass(frozen=True)
class ModifiedRodrigues(Rotation):
    """scale tan(phi/4) n: rational, infinite only at a full turn.

    Scale 1 gives the modified Rodrigues parameters, scale 4 the conformal rotation vector, which
    approaches the rotation vector for small rotations.

    Source: Géradin and Cardona, Flexible Multibody Dynamics (2001), section 4.8.
    """

    name: str
    scale: float
    components: tuple[str, ...] = ("x", "y", "z")
    units: tuple[str, ...] = ("", "", "")
    defaults: tuple[float, ...] = (0.0, 0.0, 0.0)
    domain: str = "rotations by less than 2 pi"

    def _unscaled(self, q: Matrix) -> Matrix:
        return q * (1 / self.scale)

    def matrix(self, q: Matrix) -> Matrix:
        m = self._unscaled(q)
        x, identity = m.dot(m), Matrix.identity(q.graph, 3)
        inverse = 1 / (1 + x)
        square = m.outer(m) - identity * x
        return identity + (square * 8 + m.skew * ((1 - x) * 4)) * (inverse * inverse)

    def rates(self, q: Matrix, omega: Matrix) -> Matrix:
        m = self._unscaled(q)
        mapped = omega * (1 - m.dot(m)) + (m.cross(omega) + m * m.dot(omega)) * 2
        return mapped * (self.scale / 4)

    def omega(self, q: Matrix, qdot: Matrix) -> Matrix:
        m, rate = self._unscaled(q), qdot * (4 / self.scale)
        inverse = 1 / (1 + m.dot(m))
        mapped = rate * (1 - m.dot(m)) + (m * m.dot(rate) - m.cross(rate)) * 2
        return mapped * (inverse * inverse)

    def from_matrix(self, R: Matrix) -> Matrix:
        quaternion = quaternion_of(R)
        return quaternion.block(slice(1, 4)) * (self.scale / (1 + quaternion[0]))

    def margin(self, q: Matrix) -> Scalar:
        m = self._unscaled(q)
        return 1 / sqrt(1 + m.dot(m))
