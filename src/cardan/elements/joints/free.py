"""Free joint: six degrees of freedom."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ...ir.matrix import Matrix
from ...spatial.rotations import Rotation, parametrization
from .joint import Component, Joint


@dataclass(frozen=True)
class Free(Joint):
    """No constraint: the child moves freely against the parent.

    q = [rotation, px, py, pz]: the position of the child's origin in parent axes [m].
    u = [omega, v]: angular velocity in child axes [rad/s], velocity in parent axes [m/s].

    Args:
        rotation: How the rotation is described: "quaternion" (w, x, y, z), a sequence of angles
            ("XYZ" body-fixed, "xyz" space-fixed, SciPy's rule), "rodrigues", "mrp", "conformal",
            "rotation_vector", "linear", "euler_rodrigues" or "dcm".

    Raises:
        ModelError: the parametrization does not exist.

    Source: Featherstone, Rigid Body Dynamics Algorithms, section 4.4 (with speeds of our own).
    """

    kind: ClassVar[str] = "free"
    source: ClassVar[str] = "R. Featherstone, Rigid Body Dynamics Algorithms, 2008, section 4.4"
    rotation: str = "quaternion"

    def __post_init__(self) -> None:
        parametrization(self.rotation, "free joint")

    @property
    def parameters(self) -> Rotation:
        """The parametrization of the rotation."""
        return parametrization(self.rotation)

    @property
    def coordinates(self) -> tuple[Component, ...]:
        r = self.parameters
        turning = tuple(map(Component, r.components, r.units, r.defaults))
        return turning + tuple(Component(name, "m") for name in ("px", "py", "pz"))

    @property
    def speeds(self) -> tuple[Component, ...]:
        turning = tuple(Component(name, "rad/s") for name in "xyz")
        return turning + tuple(Component(name, "m/s") for name in ("px", "py", "pz"))

    def _split(self, q: Matrix) -> tuple[Matrix, Matrix]:
        n = len(q) - 3
        return q.block(slice(0, n)), q.block(slice(n, None))

    def pose(self, q: Matrix, **data: Matrix) -> tuple[Matrix, Matrix]:
        rotation, position = self._split(q)
        return self.parameters.matrix(rotation), position

    def motion(self, q: Matrix, **data: Matrix) -> Matrix:
        R = self.parameters.matrix(self._split(q)[0])
        zero = Matrix.zeros(q.graph, 3, 3)
        return Matrix.vstack(
            Matrix.hstack(Matrix.identity(q.graph, 3), zero), Matrix.hstack(zero, R.T)
        )

    def constrained(self, q: Matrix, **data: Matrix) -> Matrix:
        return Matrix.zeros(q.graph, 6, 0)

    def closure(self, R: Matrix, p: Matrix, **data: Matrix) -> Matrix:
        return Matrix.zeros(R.graph, 0)

    @property
    def held(self) -> tuple[Component, ...]:
        return ()

    def rates(self, q: Matrix, u: Matrix, **data: Matrix) -> Matrix:
        omega, v = self._split(u)
        return Matrix.vstack(self.parameters.rates(self._split(q)[0], omega), v)

    def speeds_of(self, q: Matrix, qdot: Matrix, **data: Matrix) -> Matrix:
        turning, v = self._split(qdot)
        return Matrix.vstack(self.parameters.omega(self._split(q)[0], turning), v)

    def convective(self, q: Matrix, u: Matrix, **data: Matrix) -> Matrix:
        return Matrix.zeros(q.graph, 6)

    def integrate(self, q: Matrix, du: Matrix, **data: Matrix) -> Matrix:
        (rotation, position), (turn, step) = self._split(q), self._split(du)
        return Matrix.vstack(self.parameters.integrate(rotation, turn), position + step)

    def difference(self, q0: Matrix, q1: Matrix, **data: Matrix) -> Matrix:
        (rotation0, position0), (rotation1, position1) = self._split(q0), self._split(q1)
        turn = self.parameters.difference(rotation0, rotation1)
        return Matrix.vstack(turn, position1 - position0)

    @property
    def quaternion(self) -> int | None:
        return 0 if self.parameters.unit_quaternion else None

    @property
    def domain(self) -> str:
        return self.parameters.domain
