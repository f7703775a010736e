"""Free joint: six degrees of freedom."""

from __future__ import annotations

from typing import ClassVar

from ...ir.matrix import Matrix
from ...records import dataclass
from .guided import Guided, turns
from .joint import POSITIONS, Component, Step


@dataclass(frozen=True)
class Free(Guided):
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
    rotation: str = "quaternion"

    def steps(self) -> tuple[Step, ...]:
        slides = tuple(Step(f"p{axis}", axis, slides=True) for axis in "xyz")
        rotations = turns(self.rotation)
        return slides + rotations if rotations else ()

    @property
    def guides(self) -> tuple[Component, ...]:
        return POSITIONS

    def place(self, c: Matrix, **data: Matrix) -> Matrix:
        return c

    def slope(self, c: Matrix, **data: Matrix) -> Matrix:
        return Matrix.identity(c.graph, 3)

    def blocked(self, c: Matrix, **data: Matrix) -> Matrix:
        return Matrix.zeros(c.graph, 3, 0)

    def bend(self, c: Matrix, rate: Matrix, **data: Matrix) -> Matrix:
        return Matrix.zeros(c.graph, 3)
