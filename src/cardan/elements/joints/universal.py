"""Universal joint."""

from __future__ import annotations

from typing import ClassVar

from ...errors import ModelError
from ...ir.arithmetic import sqrt
from ...ir.matrix import Matrix
from ...records import dataclass
from ...spatial.axis import rotation_about, unit
from ..quantity import RATIO, Direction, Units
from ..validation import parallel
from .joint import POSITIONS, Component, Joint, Step


@dataclass(frozen=True)
class Universal(Joint):
    """Rotation about an axis of the parent, then about a second one that turns with it.

    q = [angle1, angle2]. Both axes are given in the parent frame at q = 0; the second is fixed in
    the child. The axes need not be perpendicular, but not parallel.

    Args:
        axis1, axis2: Directions: "x", "y", "z", "-x", ... or three numbers or expressions.

    Raises:
        ModelError: an axis is zero, NaN or not a direction, or both are parallel.

    Source: R. Featherstone, Rigid Body Dynamics Algorithms, 2008, section 4.4.
    """

    kind: ClassVar[str] = "universal"
    units: ClassVar[Units] = {"axis1": RATIO, "axis2": RATIO}
    axis1: Direction = "x"
    axis2: Direction = "y"

    def __post_init__(self) -> None:
        super().__post_init__()
        if parallel(self.axis1, self.axis2):
            raise ModelError(
                f"universal joint: axis1 {self.axis1} and axis2 {self.axis2} are parallel; take a "
                "Revolute for one axis, or two directions that differ"
            )

    @property
    def coordinates(self) -> tuple[Component, ...]:
        return Component("angle1", "rad"), Component("angle2", "rad")

    def steps(self) -> tuple[Step, ...]:
        return Step("angle1", self.axis1), Step("angle2", self.axis2)

    def pose(self, q: Matrix, **data: Matrix) -> tuple[Matrix, Matrix]:
        first = rotation_about(unit(data["axis1"]), q[0])
        second = rotation_about(unit(data["axis2"]), q[1])
        return first @ second, Matrix.zeros(q.graph, 3)

    def _axes(self, q: Matrix, data: dict[str, Matrix]) -> tuple[Matrix, Matrix]:
        """Both axes in the child: the first one turned back by the second angle."""
        second = unit(data["axis2"])
        return rotation_about(second, q[1]).T @ unit(data["axis1"]), second

    def motion(self, q: Matrix, **data: Matrix) -> Matrix:
        axes = Matrix.hstack(*self._axes(q, data))
        return Matrix.vstack(axes, Matrix.zeros(q.graph, 3, 2))

    def constrained(self, q: Matrix, **data: Matrix) -> Matrix:
        first, second = self._axes(q, data)
        across, zero = first.cross(second), Matrix.zeros(q.graph, 3)
        forces = Matrix.vstack(Matrix.zeros(q.graph, 3, 3), Matrix.identity(q.graph, 3))
        return Matrix.hstack(Matrix.vstack(across, zero), forces)

    def closure(self, R: Matrix, p: Matrix, **data: Matrix) -> Matrix:
        # the angle between the two axes stays as it is
        first, second = unit(data["axis1"]), unit(data["axis2"])
        lever = first.cross(second)
        mismatch = (first.dot(second) - first.dot(R @ second)) / sqrt(lever.dot(lever))
        return Matrix.vstack(Matrix.vector(R.graph, [mismatch]), p)

    @property
    def locked(self) -> tuple[Component, ...]:
        return (Component("r", "rad"), *POSITIONS)

    def convective(self, q: Matrix, u: Matrix, **data: Matrix) -> Matrix:
        # the first axis turns back in the child with the second angle
        first, second = self._axes(q, data)
        angular = first.cross(second) * (u[0] * u[1])
        return Matrix.vstack(angular, Matrix.zeros(q.graph, 3))
