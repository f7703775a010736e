"""Twists and wrenches: a vector that is the same everywhere, and one that belongs to a point."""

from __future__ import annotations

from dataclasses import dataclass

from ..errors import ModelError
from ..ir.arithmetic import Scalar, select
from ..ir.matrix import Matrix
from .frames import Frame
from .vectors import Vector, same_frame


@dataclass(frozen=True)
class Screw:
    """A line with a direction, and what goes along it.

    Attributes:
        direction: Unit vector; zero where everything is zero.
        position: From the reference point to the nearest point of the line.
        around: Rate of turning of a twist [rad/s], or length of the force of a wrench [N]; >= 0.
        along: Rate of sliding along the line [m/s], or torque about it [N m].
    """

    direction: Vector
    position: Vector
    around: Scalar
    along: Scalar

    @property
    def pitch(self) -> Scalar:
        """along / around [m/rad] or [m]; infinite where nothing turns, or no force acts."""
        return self.along / self.around


@dataclass(frozen=True, eq=False)
class Twist:
    """Motion of a rigid body.

    Attributes:
        angular: Angular velocity [rad/s].
        linear: Velocity of the body's point at the reference point [m/s], in the same frame.
        point: Name of the reference point.
    """

    angular: Vector
    linear: Vector
    point: str

    def __post_init__(self) -> None:
        same_frame(self.angular.frame, self.linear.frame)

    @property
    def column(self) -> Matrix:
        """(6, 1), angular part first."""
        return Matrix.vstack(self.angular.components, self.linear.components)

    def __add__(self, other: Twist) -> Twist:
        same_point(self.point, other.point)
        return Twist(self.angular + other.angular, self.linear + other.linear, self.point)

    def __sub__(self, other: Twist) -> Twist:
        same_point(self.point, other.point)
        return Twist(self.angular - other.angular, self.linear - other.linear, self.point)

    def moved(self, point: str, by: Vector) -> Twist:
        """The same motion told at another reference point.

        Args:
            point: Its name.
            by: Position of the new point from the present one [m].
        """
        return Twist(self.angular, self.linear + self.angular.cross(by), point)

    def express(self, frame: Frame) -> Twist:
        """The same twist by components in another frame."""
        return Twist(self.angular.express(frame), self.linear.express(frame), self.point)

    def screw(self) -> Screw:
        """Instantaneous screw axis; of a pure translation, the line through the reference point.

        Source: Featherstone, Rigid Body Dynamics Algorithms, section 2.3.
        """
        return _screw(self.angular, self.linear)


@dataclass(frozen=True, eq=False)
class Wrench:
    """Forces on a rigid body.

    Attributes:
        torque: About the reference point [N m].
        force: [N], in the same frame.
        point: Name of the reference point.
    """

    torque: Vector
    force: Vector
    point: str

    def __post_init__(self) -> None:
        same_frame(self.torque.frame, self.force.frame)

    @property
    def column(self) -> Matrix:
        """(6, 1), angular part first."""
        return Matrix.vstack(self.torque.components, self.force.components)

    def __add__(self, other: Wrench) -> Wrench:
        same_point(self.point, other.point)
        return Wrench(self.torque + other.torque, self.force + other.force, self.point)

    def __sub__(self, other: Wrench) -> Wrench:
        same_point(self.point, other.point)
        return Wrench(self.torque - other.torque, self.force - other.force, self.point)

    def moved(self, point: str, by: Vector) -> Wrench:
        """The same forces told at another reference point.

        Args:
            point: Its name.
            by: Position of the new point from the present one [m].
        """
        return Wrench(self.torque + self.force.cross(by), self.force, point)

    def express(self, frame: Frame) -> Wrench:
        """The same wrench by components in another frame."""
        return Wrench(self.torque.express(frame), self.force.express(frame), self.point)

    def power(self, twist: Twist) -> Scalar:
        """Power on a body with that motion [W].

        Raises:
            ModelError: reference points or frames differ.
        """
        same_point(self.point, twist.point)
        return self.torque.dot(twist.angular) + self.force.dot(twist.linear)

    def screw(self) -> Screw:
        """Central axis, where the torque is along the force; of a pure torque, the line through
        the reference point.

        Source: Featherstone, Rigid Body Dynamics Algorithms, section 2.4.
        """
        return _screw(self.force, self.torque)


def _screw(whole: Vector, local: Vector) -> Screw:
    """Screw of a vector that is the same at all points, and one that is local to the reference."""
    turns = (whole.length * 0).apply("lt", whole.length)
    slides = (local.length * 0).apply("lt", local.length)
    # nothing below divides by zero, and the unused side of every choice is finite
    size = select(turns, whole.length, 1)
    direction = whole.components * select(turns, 1 / size, 0) + local.components * select(
        turns, 0, select(slides, 1 / select(slides, local.length, 1), 0)
    )
    axis = Vector(whole.frame, direction)
    position = whole.cross(local) / (size * size)
    return Screw(axis, position, whole.length, axis.dot(local))


def same_point(one: str, other: str) -> None:
    """Two quantities must belong to one reference point.

    Raises:
        ModelError: they do not; both points are named.
    """
    if one != other:
        raise ModelError(
            f"quantities at points '{one}' and '{other}' cannot be combined: use .moved() to "
            "bring one to the point of the other"
        )
