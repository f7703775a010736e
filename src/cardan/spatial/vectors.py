"""Vectors that know their axes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar, Self

from ..errors import ModelError
from ..ir.arithmetic import Number, Scalar, norm
from ..ir.derivative import forward
from ..ir.matrix import Matrix
from .frames import Frame, Rates


@dataclass(frozen=True, eq=False)
class InFrame:
    """Components in one frame, added and multiplied there.

    Attributes:
        frame: The axes of the components.
        components: As many as the class says.
    """

    size: ClassVar[tuple[int, int]]
    frame: Frame
    components: Matrix

    def __post_init__(self) -> None:
        found = self.components.rows, self.components.columns
        if found != self.size:
            raise ModelError(
                f"{type(self).__name__.lower()} in frame '{self.frame.name}': components are "
                f"{found[0]} x {found[1]}; give {self.size[0]} x {self.size[1]}"
            )

    def _with(self, other: InFrame) -> Matrix:
        """Components of another one, which must be in the same frame."""
        same_frame(self.frame, other.frame)
        return other.components

    def __add__(self, other: Self) -> Self:
        return type(self)(self.frame, self.components + self._with(other))

    def __sub__(self, other: Self) -> Self:
        return type(self)(self.frame, self.components - self._with(other))

    def __neg__(self) -> Self:
        return type(self)(self.frame, -self.components)

    def __mul__(self, factor: Number) -> Self:
        return type(self)(self.frame, self.components * factor)

    __rmul__ = __mul__

    def __truediv__(self, divisor: Number) -> Self:
        return type(self)(self.frame, self.components / divisor)


class Vector(InFrame):
    """A vector by its components in one frame.

    Operations of two vectors need both in the same frame; :meth:`express` changes it. This is
    never done silently, so that every rotation that costs something is seen.

    Attributes:
        frame: The axes of the components.
        components: (3, 1).
    """

    size = (3, 1)

    @staticmethod
    def of(frame: Frame, entries: Sequence[Number]) -> Vector:
        """From three scalars or numbers."""
        return Vector(frame, Matrix.vector(frame.graph, entries))

    def __getitem__(self, k: int) -> Scalar:
        """Component k."""
        return self.components[k]

    def dot(self, other: Vector) -> Scalar:
        """Scalar product."""
        return self.components.dot(self._with(other))

    def cross(self, other: Vector) -> Vector:
        """Vector product."""
        return Vector(self.frame, self.components.cross(self._with(other)))

    @property
    def length(self) -> Scalar:
        """|v|; its derivative at 0 is taken as 0."""
        return norm(*self.components)

    def express(self, frame: Frame) -> Vector:
        """The same vector by components in another frame."""
        if frame is self.frame:
            return self
        return Vector(frame, self.frame.rotation_in(frame) @ self.components)

    def derivative(self, observer: Frame, rates: Rates) -> Vector:
        """Time derivative as seen from a frame, in the axes of this vector.

        Args:
            observer: In its own frame the derivative is that of the components; seen from any
                other, ``omega x v`` is added.
            rates: Node of a variable -> node of its rate; all else is constant.

        Source: Kane and Levinson, Dynamics: Theory and Applications, section 2.3.
        """
        graph = self.components.graph
        own = Matrix(graph, 3, 1, forward(graph, self.components.nodes, rates))
        if observer is self.frame:
            return Vector(self.frame, own)
        omega = self.frame.angular_velocity_in(observer, rates)
        return Vector(self.frame, own + omega.cross(self.components))


def same_frame(one: Frame, other: Frame) -> None:
    """Two quantities must be in one frame.

    Raises:
        ModelError: they are not; both frames are named.
    """
    if one is not other:
        raise ModelError(
            f"quantities in frames '{one.name}' and '{other.name}' cannot be combined: "
            f"use .express() to bring one into the frame of the other"
        )
