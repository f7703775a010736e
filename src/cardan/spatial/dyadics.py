"""Dyadics that know their axes: inertia, stress, rotation, projection."""

from __future__ import annotations

from typing import overload

from ..ir.arithmetic import Scalar
from ..ir.derivative import forward
from ..ir.matrix import Matrix
from .frames import Frame, Rates
from .vectors import InFrame, Vector, same_frame


class Dyadic(InFrame):
    """A linear map of vectors by its components in one frame.

    ``D @ v`` is D · v and ``D.T @ v`` is v · D. As with vectors, frames are never changed silently.

    Attributes:
        frame: The axes of the components.
        components: (3, 3).
    """

    size = (3, 3)

    @staticmethod
    def identity(frame: Frame) -> Dyadic:
        """The map of every vector to itself."""
        return Dyadic(frame, Matrix.identity(frame.graph, 3))

    @overload
    def __matmul__(self, other: Vector) -> Vector: ...
    @overload
    def __matmul__(self, other: Dyadic) -> Dyadic: ...
    def __matmul__(self, other: Dyadic | Vector) -> Dyadic | Vector:
        product = self.components @ self._with(other)
        return type(other)(self.frame, product)

    @property
    def T(self) -> Dyadic:
        """The transpose."""
        return Dyadic(self.frame, self.components.T)

    @property
    def trace(self) -> Scalar:
        c = self.components
        return c[0, 0] + c[1, 1] + c[2, 2]

    def express(self, frame: Frame) -> Dyadic:
        """The same map by components in another frame, R D Rᵀ."""
        if frame is self.frame:
            return self
        R = self.frame.rotation_in(frame)
        return Dyadic(frame, R @ self.components @ R.T)

    def derivative(self, observer: Frame, rates: Rates) -> Dyadic:
        """Time derivative as seen from a frame, in the axes of this dyadic.

        Args:
            observer: Seen from another frame than its own, ``omega x D - D x omega`` is added.
            rates: Node of a variable -> node of its rate; all else is constant.

        Source: Roberson and Schwertassek, Dynamics of Multibody Systems, section 2.1.
        """
        graph = self.components.graph
        own = Matrix(graph, 3, 3, forward(graph, self.components.nodes, rates))
        if observer is not self.frame:
            spin = self.frame.angular_velocity_in(observer, rates).skew
            own = own + spin @ self.components - self.components @ spin
        return Dyadic(self.frame, own)


def dyad(a: Vector, b: Vector) -> Dyadic:
    """The dyadic a b, which maps v to a (b · v)."""
    same_frame(a.frame, b.frame)
    return Dyadic(a.frame, a.components.outer(b.components))
