"""Vectors and dyadics, each a sum of parts in the axes of single bodies.

The part of a vector in body i is its components there, so that nothing is rotated before components
are asked for: a position is a sum of vectors along the path in the tree, an angular velocity the
sum of those of the joints on it. A part in body i changes in the axes of body n by
``d x_i / dt + omega_i_n x x_i``.

Source: Roberson and Schwertassek, Dynamics of Multibody Systems (1988), chapters 2 and 8; Kane and
Levinson, Dynamics: Theory and Applications (1985), chapters 1 and 2, for derivatives in frames.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from typing import TYPE_CHECKING, Generic, Self, TypeAlias, TypeVar, final

from ...arguments import checked
from ...arrays import Array
from ...errors import ArgumentError
from ...ir.arithmetic import Scalar
from ...ir.graph import ZERO
from ...ir.matrix import Matrix
from .moving_axes import MovingAxes, Place

if TYPE_CHECKING:
    import sympy

# a number or an expression in the names of the equations
Factor: TypeAlias = "sympy.Expr | float"
# a body of a vector, two of a dyadic
Key = TypeVar("Key", int, tuple[int, int])


class _Sum(ABC, Generic[Key]):
    """A sum of parts, each in the axes of a body or, of dyadics, of two.

    Args:
        axes: Of the system.
        parts: Components by the body, or by the two bodies, in whose axes they are.
    """

    __slots__ = ("_axes", "_parts")

    def __init__(self, axes: MovingAxes, parts: Mapping[Key, Matrix]) -> None:
        self._axes = axes
        self._parts: dict[Key, Matrix] = {bodies: x for bodies, x in parts.items() if not x.is_zero}

    def __add__(self, other: Self) -> Self:
        if type(other) is not type(self):
            return NotImplemented
        self._same(other)
        parts = dict(self._parts)
        for bodies, x in other._parts.items():
            parts[bodies] = parts[bodies] + x if bodies in parts else x
        return type(self)(self._axes, parts)

    def __neg__(self) -> Self:
        return type(self)(self._axes, {bodies: -x for bodies, x in self._parts.items()})

    def __sub__(self, other: Self) -> Self:
        return self + (-other) if type(other) is type(self) else NotImplemented

    def __mul__(self, factor: Factor) -> Self:
        if isinstance(factor, _Sum):
            return NotImplemented
        return self._times(self._axes.scalar(factor))

    __rmul__ = __mul__

    def __truediv__(self, divisor: Factor) -> Self:
        if isinstance(divisor, _Sum):
            return NotImplemented
        return self._times(1.0 / self._axes.scalar(divisor))

    def _times(self, factor: Scalar) -> Self:
        return type(self)(self._axes, {bodies: x * factor for bodies, x in self._parts.items()})

    def _same(self, other: _Sum[int] | _Sum[tuple[int, int]]) -> None:
        if other._axes is not self._axes:
            raise ArgumentError(
                f"vectors of '{self._axes.name}' and of '{other._axes.name}' were made by two "
                "calls of cd.vectors; make both from one"
            )

    @abstractmethod
    def _components(self, frame: Place) -> Matrix:
        """Components in the axes of a frame."""

    def express(self, frame: Place = "ground") -> sympy.Matrix:
        """Components in the axes of a frame as a SymPy matrix: (3, 1), of a dyadic (3, 3).

        Args:
            frame: Frame or body, or its name.

        Raises:
            DerivationError: a component is too long to be written out.
        """
        return self._axes.written(self._components(frame))

    def evaluate(
        self,
        q: Array,
        u: Array | None = None,
        udot: Array | None = None,
        *,
        frame: Place = "ground",
        t: float = 0.0,
        r: Array | None = None,
        parameters: Mapping[str, float] | None = None,
    ) -> Array:
        """Components at states, in the axes of a frame: (..., 3), of a dyadic (..., 3, 3).

        Args:
            q, u, udot: Coordinates (..., nq), speeds (..., nu) and their derivatives, as far as
                the components contain them.
            frame: Frame or body, or its name.
            t: Time [s].
            r: Inputs (..., nr), by default theirs.
            parameters: Values by name, other than the defaults.

        Raises:
            ArgumentError: no such parameter, or the components contain a block that is missing.
        """
        blocks = {"q": q, "u": u, "udot": udot, "t": [t], "r": r}
        values = self._axes.values(self._components(frame), blocks, parameters or {})
        return values[..., 0] if isinstance(self, Vector) else values


@final
class Vector(_Sum[int]):
    """A vector of a moving system; see :func:`cardan.vectors`.

    Vectors are added and subtracted, and multiplied by numbers and by SymPy expressions in the
    names that the equations use. Each refers to one system, whose motion it contains.
    """

    __slots__ = ()

    def __repr__(self) -> str:
        if not self._parts:
            return "Vector(0)"
        parts = (f"{self._axes.text(x)} in {self._axes.body(i)}" for i, x in self._parts.items())
        return f"Vector({' + '.join(parts)})"

    @checked
    def dot(self, other: Vector | Dyadic) -> sympy.Expr | Vector:
        """Scalar product with a vector as a SymPy expression; with a dyadic a vector."""
        self._same(other)
        if isinstance(other, Dyadic):
            return other.T.dot(self)
        return self._axes.written(self._dot(other))

    def _dot(self, other: Vector) -> Scalar:
        total = Scalar(self._axes.k.graph, ZERO)
        for first, x in self._parts.items():
            for second, y in other._parts.items():
                total = total + x.dot(self._axes.rotated(y, second, first))
        return total

    @checked
    def cross(self, other: Vector) -> Vector:
        """Vector product."""
        self._same(other)
        total = Vector(self._axes, {})
        for first, x in self._parts.items():
            for second, y in other._parts.items():
                product = x.cross(self._axes.rotated(y, second, first))
                total = total + Vector(self._axes, {first: product})
        return total

    @checked
    def outer(self, other: Vector) -> Dyadic:
        """Dyadic product a b: its product with a vector c is a (b . c)."""
        self._same(other)
        return Dyadic(self._axes, {
            (first, second): x @ y.T
            for first, x in self._parts.items() for second, y in other._parts.items()
        })  # fmt: skip

    def magnitude(self) -> sympy.Expr:
        """Length as a SymPy expression."""
        return self._axes.root(self._dot(self))

    def dt(self, frame: Place = "ground") -> Vector:
        """Time derivative in a frame, ``sum of d x_i / dt + omega_i x x_i``.

        Derivatives of speeds are the names in ``equations.blocks["udot"]``.

        Args:
            frame: Frame or body in whose axes the change is observed, or its name.

        Raises:
            DerivationError: it would need derivatives of accelerations, or of what has none.
        """
        axes, observer = self._axes, self._axes.body_of(frame)
        return Vector(axes, {
            body: axes.derivative(x) + axes.spin(body, observer).cross(x)
            for body, x in self._parts.items()
        })  # fmt: skip

    def _components(self, frame: Place) -> Matrix:
        total = Matrix.zeros(self._axes.k.graph, 3)
        for body, x in self._parts.items():
            total = total + self._axes.in_frame(x, body, frame)
        return total


@final
class Dyadic(_Sum[tuple[int, int]]):
    """A dyadic of a moving system, such as an inertia; see :func:`cardan.vectors`."""

    __slots__ = ()

    def __repr__(self) -> str:
        bodies = (f"{self._axes.body(i)}, {self._axes.body(j)}" for i, j in self._parts)
        return f"Dyadic({'; '.join(bodies) or 0})"

    @property
    def T(self) -> Dyadic:
        """The transpose."""
        return Dyadic(self._axes, {(j, i): x.T for (i, j), x in self._parts.items()})

    @checked
    def dot(self, other: Vector | Dyadic) -> Vector | Dyadic:
        """Product with a vector, such as the angular momentum I . omega, or with a dyadic."""
        self._same(other)
        axes = self._axes
        if isinstance(other, Dyadic):
            product = Dyadic(axes, {})
            for (i, j), x in self._parts.items():
                for (m, n), y in other._parts.items():
                    product = product + Dyadic(axes, {(i, n): x @ axes.rotated(y, m, j)})
            return product
        total = Vector(axes, {})
        for (i, j), x in self._parts.items():
            for body, y in other._parts.items():
                total = total + Vector(axes, {i: x @ axes.rotated(y, body, j)})
        return total

    def trace(self) -> sympy.Expr:
        """Sum of the diagonal, the same in all axes, as a SymPy expression."""
        total = Scalar(self._axes.k.graph, ZERO)
        for (i, j), x in self._parts.items():
            aligned = self._axes.rotated(x, i, j)
            total = total + aligned[0, 0] + aligned[1, 1] + aligned[2, 2]
        return self._axes.written(total)

    def dt(self, frame: Place = "ground") -> Dyadic:
        """Time derivative in a frame; see :meth:`Vector.dt`."""
        axes, observer = self._axes, self._axes.body_of(frame)
        # both sides turn: omega_i x (a b) + a (omega_j x b)
        return Dyadic(axes, {
            (i, j): axes.derivative(x)
            + axes.spin(i, observer).skew @ x
            + x @ axes.spin(j, observer).skew.T
            for (i, j), x in self._parts.items()
        })  # fmt: skip

    def _components(self, frame: Place) -> Matrix:
        total = Matrix.zeros(self._axes.k.graph, 3, 3)
        for (i, j), x in self._parts.items():
            left = self._axes.in_frame(x, i, frame)
            total = total + self._axes.in_frame(left.T, j, frame).T
        return total
