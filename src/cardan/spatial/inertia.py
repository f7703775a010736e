"""Mass properties of rigid bodies: moved, turned, put together."""

from __future__ import annotations

from dataclasses import dataclass
from functools import reduce
from typing import Any

from ..errors import ModelError
from ..ir.arithmetic import Scalar
from .dyadics import Dyadic, dyad
from .frames import Frame
from .twists import Twist, Wrench, same_point
from .vectors import Vector


@dataclass(frozen=True, eq=False)
class RigidInertia:
    """Mass, center of mass and inertia of a rigid body.

    Attributes:
        mass: [kg].
        com: Center of mass from the reference point [m].
        central: Inertia about the center of mass [kg m²], in the same frame.
        point: Name of the reference point.
    """

    mass: Scalar
    com: Vector
    central: Dyadic
    point: str

    def about_point(self) -> Dyadic:
        """Inertia about the reference point: parallel axes.

        Source: Roberson and Schwertassek, Dynamics of Multibody Systems, section 3.1 (Steiner).
        """
        return self.central + parallel_axes(self.mass, self.com)

    def moved(self, point: str, by: Vector) -> RigidInertia:
        """The same body told at another reference point.

        Args:
            point: Its name.
            by: Position of the new point from the present one [m].
        """
        return RigidInertia(self.mass, self.com - by, self.central, point)

    def express(self, frame: Frame) -> RigidInertia:
        """The same body by components in another frame."""
        return RigidInertia(
            self.mass, self.com.express(frame), self.central.express(frame), self.point
        )

    def __add__(self, other: RigidInertia) -> RigidInertia:
        """Both bodies, welded together.

        Raises:
            ModelError: reference points or frames differ.
        """
        same_point(self.point, other.point)
        mass = self.mass + other.mass
        com = (self.com * self.mass + other.com * other.mass) / mass
        # the reduced mass at the distance of the centers
        reduced = self.mass * other.mass / mass
        central = self.central + other.central + parallel_axes(reduced, other.com - self.com)
        return RigidInertia(mass, com, central, self.point)

    def momentum(self, twist: Twist) -> Wrench:
        """Angular momentum about the reference point [kg m²/s] and linear momentum [kg m/s]."""
        same_point(self.point, twist.point)
        linear = (twist.linear + twist.angular.cross(self.com)) * self.mass
        return Wrench(self.central @ twist.angular + self.com.cross(linear), linear, self.point)

    def kinetic_energy(self, twist: Twist) -> Scalar:
        """[J], of a body with that motion."""
        return self.momentum(twist).power(twist) * 0.5


def composite(*bodies: RigidInertia) -> RigidInertia:
    """All bodies, welded together.

    Raises:
        ModelError: none given; reference points or frames differ.
    """
    if not bodies:
        raise ModelError("composite: no bodies are given; give at least one")
    return reduce(RigidInertia.__add__, bodies)


def parallel_axes(mass: Scalar, r: Vector) -> Dyadic:
    """m (r² 1 - r r): what a point mass at r adds to the inertia."""
    return (Dyadic.identity(r.frame) * r.dot(r) - dyad(r, r)) * mass


def principal(inertia: Any) -> tuple[Any, Any]:
    """Principal moments and axes of a numeric inertia matrix.

    Args:
        inertia: (3, 3), symmetric [kg m²].

    Returns:
        Moments in increasing order, (3,), and a rotation matrix whose columns are their axes,
        (3, 3). Each of the first two axes has its largest component positive.

    Raises:
        ModelError: not a symmetric 3 x 3 matrix of finite numbers.

    Source: Roberson and Schwertassek, Dynamics of Multibody Systems, section 3.1.
    """
    import numpy as np

    matrix = np.asarray(inertia, dtype=float)
    if matrix.shape != (3, 3) or not np.isfinite(matrix).all():
        raise ModelError(
            f"principal: the inertia has shape {matrix.shape}; give 3 x 3 finite numbers"
        )
    # entries of a symmetric matrix that was turned differ by a few roundings
    if np.abs(matrix - matrix.T).max() > 1e-12 * np.abs(matrix).max():
        raise ModelError("principal: the inertia is not symmetric; give Iyx = Ixy and so on")
    moments, axes = np.linalg.eigh((matrix + matrix.T) / 2)
    for k in range(2):
        axes[:, k] *= np.sign(axes[np.abs(axes[:, k]).argmax(), k])
    axes[:, 2] = np.cross(axes[:, 0], axes[:, 1])
    return moments, axes
