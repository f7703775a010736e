"""Interface of the parametrizations of a rotation; each is one file."""

from __future__ import annotations

from abc import ABC, abstractmethod

from ...ir.arithmetic import Scalar
from ...ir.matrix import Matrix
from ...literature import HasSource
from ..exponential import exp, log


class Rotation(HasSource, ABC):
    """Coordinates q of the rotation from axes P to axes C.

    R takes coordinates in C to coordinates in P; omega is the angular velocity of C against P in
    axes C. All methods work on expressions.

    Attributes:
        name: What a user writes, as in ``Spherical(rotation="quaternion")``.
        components: Names of the coordinates.
        units: Their units.
        defaults: The coordinates of the identity.
        domain: Where the coordinates are regular, in words.
    """

    name: str
    components: tuple[str, ...]
    units: tuple[str, ...]
    defaults: tuple[float, ...]
    domain: str

    @abstractmethod
    def matrix(self, q: Matrix) -> Matrix:
        """R, (3, 3)."""

    @abstractmethod
    def rates(self, q: Matrix, omega: Matrix) -> Matrix:
        """qdot of the angular velocity in axes C."""

    @abstractmethod
    def omega(self, q: Matrix, qdot: Matrix) -> Matrix:
        """Angular velocity in axes C, (3, 1), of given rates."""

    @abstractmethod
    def from_matrix(self, R: Matrix) -> Matrix:
        """The coordinates of a rotation matrix."""

    @abstractmethod
    def margin(self, q: Matrix) -> Scalar:
        """Distance from the singular set: 1 where the coordinates are best, 0 on the set."""

    @property
    def unit_quaternion(self) -> bool:
        """True where q is a unit quaternion that an integrator has to keep normalized."""
        return False

    def integrate(self, q: Matrix, du: Matrix) -> Matrix:
        """The coordinates of R(q) exp(du), du a rotation vector in axes C."""
        return self.from_matrix(self.matrix(q) @ exp(du))

    def difference(self, q0: Matrix, q1: Matrix) -> Matrix:
        """The rotation vector from q0 to q1 in axes C: integrate(q0, difference) = q1."""
        return log(self.matrix(q0).T @ self.matrix(q1))
