"""Vectors and dyadics of a system, to look at and to calculate with."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, final

from ...errors import ArgumentError, DerivationError, brief, near
from ...ir.arithmetic import Scalar
from ...ir.graph import ZERO
from ...ir.matrix import Matrix
from ...records import dataclass
from ...topology.system import GROUND, Part
from ..finite_elements.record import FiniteElementRecord
from ..formalisms.barycentric import augmented
from ..kinematics import paths
from ..record import EquationRecord
from .moving_axes import MovingAxes, Place
from .vector_algebra import Dyadic, Factor, Vector

if TYPE_CHECKING:
    import sympy


@final
@dataclass(frozen=True, eq=False)
class AugmentedBody:
    """A body with all that its outboard joints carry, as mass points at these joints.

    Attributes:
        mass: Of the body and of everything it carries.
        barycenter: Barycentric vector: from the origin of the inboard joint to the center of mass
            of the augmented body.
        inertia: Of the augmented body about the origin of the inboard joint.
    """

    mass: sympy.Expr
    barycenter: Vector
    inertia: Dyadic


@final
class Vectors:
    """Vectors and dyadics of a system; made by :func:`vectors`.

    Frames are given as frames or bodies of the scene or by their names; ``"ground"`` is one. All
    that take them raise ArgumentError where the scene has no such frame.
    """

    def __init__(self, equations: EquationRecord | FiniteElementRecord) -> None:
        self._axes = MovingAxes(equations)

    @property
    def frames(self) -> tuple[str, ...]:
        """Names of all frames; bodies are among them."""
        return tuple(self._axes.frames)

    def __repr__(self) -> str:
        return f"Vectors of '{self._axes.name}': {', '.join(self.frames)}"

    def vector(self, components: Sequence[Factor], frame: Place = "ground") -> Vector:
        """A vector by its components in the axes of a frame.

        Args:
            components: Three numbers, or SymPy expressions in the names of the equations.
            frame: Frame or body, or its name.

        Raises:
            ArgumentError: other than three components, text, or no such frame.
        """
        if len(components) != 3:
            raise ArgumentError(f"a vector has 3 components, not {len(components)}")
        axes, number = self._axes, self._axes.frame(frame)
        column = Matrix.vector(axes.k.graph, [axes.scalar(x) for x in components])
        rotated = paths.frame_axes(axes.k, number) @ column
        return Vector(axes, {axes.body_of(frame): rotated})

    def axes(self, frame: Place) -> tuple[Vector, Vector, Vector]:
        """Unit vectors along x, y and z of a frame."""
        x, y, z = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
        return self.vector(x, frame), self.vector(y, frame), self.vector(z, frame)

    @property
    def identity(self) -> Dyadic:
        """The dyadic that leaves every vector as it is."""
        return Dyadic(self._axes, {(GROUND, GROUND): Matrix.identity(self._axes.k.graph, 3)})

    @property
    def gravity(self) -> Vector:
        """Acceleration of gravity [m/s^2], uniform; fields of gravity are forces."""
        axes = self._axes
        return Vector(axes, {GROUND: axes.k.vector(axes.system.gravity)})

    def rotation(self, frame: Place, wrt: Place = "ground") -> sympy.Matrix:
        """R (3, 3): coordinates in axes of ``frame`` to coordinates in those of ``wrt``."""
        axes, number = self._axes, self._axes.frame(frame)
        columns = paths.frame_axes(axes.k, number)
        return axes.written(axes.in_frame(columns, axes.body_of(frame), wrt))

    def position(self, frame: Place, wrt: Place = "ground") -> Vector:
        """From the origin of ``wrt`` to that of ``frame`` [m], a sum over the path between."""
        axes = self._axes
        start, end = axes.body_of(wrt), axes.body_of(frame)
        top = paths.common_ancestor(axes.k, start, end)
        there = self._from_ancestor(axes.frame(frame), top)
        return there - self._from_ancestor(axes.frame(wrt), top)

    def _from_ancestor(self, frame: int, top: int) -> Vector:
        """From the origin of a body to that of a frame which it carries."""
        axes = self._axes
        body = axes.system.frames[frame].body
        total = Vector(axes, {body: axes.k.place(frame)})
        for i in axes.path(body, top):
            step = Vector(axes, {axes.system.bodies[i].parent: axes.k.pose_of(i).position})
            total = total + step
        return total

    def velocity(self, frame: Place, wrt: Place = "ground") -> Vector:
        """Velocity of the origin of ``frame`` as seen from ``wrt`` [m/s]."""
        return self.position(frame, wrt).dt(wrt)

    def acceleration(self, frame: Place, wrt: Place = "ground") -> Vector:
        """Acceleration of the origin of ``frame`` as seen from ``wrt`` [m/s^2]."""
        return self.velocity(frame, wrt).dt(wrt)

    def angular_velocity(self, frame: Place, wrt: Place = "ground") -> Vector:
        """Angular velocity of ``frame`` against ``wrt`` [rad/s], the sum of those of joints."""
        axes = self._axes
        return Vector(axes, axes.angular_velocity(axes.body_of(frame), axes.body_of(wrt)))

    def angular_acceleration(self, frame: Place, wrt: Place = "ground") -> Vector:
        """Angular acceleration of ``frame`` against ``wrt`` [rad/s^2]."""
        return self.angular_velocity(frame, wrt).dt(wrt)

    def mass(self, body: Place) -> sympy.Expr:
        """Mass of a body [kg]."""
        return self._axes.written(self._mass_properties(body)[1])

    def center_of_mass(self, body: Place, wrt: Place = "ground") -> Vector:
        """From the origin of ``wrt`` to the center of mass of a body [m].

        Raises:
            ArgumentError: no body of the scene that moves, or one without mass.
        """
        part, mass, moment, _ = self._mass_properties(body)
        self._check_mass(part, mass)
        axes, number = self._axes, part.frame
        i = axes.system.frames[number].body
        from_origin = Vector(axes, {i: moment / mass - axes.k.place(number)})
        return self.position(part.name, wrt) + from_origin

    def inertia(self, body: Place, about: Place | None = None) -> Dyadic:
        """Inertia of a body [kg m^2].

        Args:
            body: A body of the scene, or its name.
            about: Frame or body about whose origin it is; the center of mass by default.

        Raises:
            ArgumentError: no body of the scene that moves, or one without mass.
        """
        axes = self._axes
        part, mass, moment, tensor = self._mass_properties(body)
        i = axes.system.frames[part.frame].body
        if about is not None and axes.body_of(about) == i:
            # parallel axes within the body: from its origin straight to the point
            d = axes.k.place(axes.frame(about))
            shift = _pair(moment, d) + _pair(d, moment) - _pair(d, d) * mass
            return Dyadic(axes, {(i, i): tensor - shift})
        self._check_mass(part, mass)
        central = Dyadic(axes, {(i, i): tensor - _pair(moment, moment) / mass})
        if about is None:
            return central
        d_about = self.center_of_mass(body, about)
        around = self.identity._times(d_about._dot(d_about)) - d_about.outer(d_about)
        return central + around._times(mass)

    def _mass_properties(self, body: Place) -> tuple[Part, Scalar, Matrix, Matrix]:
        """A body of the user: mass, first moment and inertia, about the origin it is told from."""
        axes = self._axes
        k, name = axes.k, body if isinstance(body, str) else body.name
        parts = {part.name: part for i in axes.system.bodies for part in i.parts}
        if name not in parts:
            raise ArgumentError(f"'{axes.name}' has no moving body '{name}'.{near(name, parts)}")
        part = parts[name]
        mass = Scalar(k.graph, k.resolve([part.mass])[0])
        return part, mass, k.vector(part.first_moment), k.matrix(3, 3, part.inertia)

    def _check_mass(self, part: Part, mass: Scalar) -> None:
        if mass.node == ZERO:
            raise ArgumentError(
                f"body '{part.name}' has no mass, and so no center of mass; give it mass="
            )

    def path_vectors(self, frame: Place) -> dict[str, Vector]:
        """Path vectors from the ground to a frame: body -> vector in it along the path.

        The vector in a body leads from the origin of its inboard joint to that of the next joint
        on the path; the last one leads to the origin of the frame. Their sum is its position.

        Source: Roberson and Schwertassek, Dynamics of Multibody Systems (1988), chapter 8.
        """
        axes, number = self._axes, self._axes.frame(frame)
        result, parent = dict[str, Vector](), GROUND
        for i in axes.path(axes.body_of(frame)):
            result[axes.body(parent)] = Vector(axes, {parent: axes.k.pose_of(i).position})
            parent = i
        return result | {axes.body(parent): Vector(axes, {parent: axes.k.place(number)})}

    def augmented_bodies(self) -> dict[str, AugmentedBody]:
        """Augmented bodies by name: mass, barycentric vector and inertia.

        Bodies that fixed joints hold together are one, under the name of the innermost. From the
        barycenter of body i to the joint that leads to body j it is ``path_vectors(j)[i]`` less
        the barycentric vector of i. A body that has no mass and carries none has no barycenter
        and is left out; beams have their mass elsewhere.

        Source: Roberson and Schwertassek, Dynamics of Multibody Systems (1988), chapter 11;
        Wittenburg, Dynamics of Multibody Systems (2008), chapter 5.
        """
        axes, result = self._axes, dict[str, AugmentedBody]()
        for i, body in enumerate(augmented(axes.k)):
            if body.total_mass.node == ZERO:
                continue
            result[axes.body(i)] = AugmentedBody(
                axes.written(body.total_mass),
                Vector(axes, {i: body.moment / body.total_mass}),
                Dyadic(axes, {(i, i): body.tensor}),
            )
        return result


def _pair(a: Matrix, b: Matrix) -> Matrix:
    """(a . b) 1 - a bᵀ."""
    return Matrix.identity(a.graph, 3) * a.dot(b) - a @ b.T


def vectors(equations: EquationRecord | FiniteElementRecord) -> Vectors:
    """Vectors and dyadics of a system: positions, velocities, inertias, with their algebra.

    They are symbolic, in the names of coordinates and speeds that ``print(equations)`` shows:
    ``.express(frame)`` gives SymPy components in the axes of any frame, ``.dt(frame)`` the time
    derivative in any frame, ``.evaluate(q, u)`` numbers.

    In scenes with beams they are those of bodies, frames and named nodes, in the coordinates of
    joints and nodes.

    Args:
        equations: Of :func:`cardan.derive`.

    Raises:
        DerivationError: the equations have no frames, as those of :func:`cardan.from_sympy`, or
            nodes that stay in a plane.
        ArgumentError: no equations.

    Source: Roberson and Schwertassek, Dynamics of Multibody Systems (1988), chapters 2 and 8.
    """
    if not isinstance(equations, EquationRecord | FiniteElementRecord):
        raise ArgumentError(
            f"cd.vectors takes equations, not {brief(equations)}: give cd.derive(scene)"
        )
    if equations.system.written:
        raise DerivationError(
            f"'{equations.system.name}' was given by equations of motion, which have no frames; "
            "make vectors of a scene with bodies and joints"
        )
    return Vectors(equations)
