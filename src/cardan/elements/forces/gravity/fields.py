"""Fields of gravity: their pull on a mass, and on a body of some extent to second order.

Bodies stand at r from the center of the field; all vectors and tensors in common axes. Of a body of
some extent the potential is m phi(r) + tr(I H) / 2 with the gradient H of the field: phi is
harmonic, so that the tensor of inertia I says all that the second moments of the mass would.

Source: P. C. Hughes, Spacecraft Attitude Dynamics, 1986, chapter 8.
"""

from __future__ import annotations

from abc import ABC, abstractmethod

from ....ir.arithmetic import Scalar, norm
from ....ir.matrix import Matrix
from ....records import dataclass


@dataclass(frozen=True)
class Pull:
    """Action of a gravity field.

    Attributes:
        force: (3, 1), at the center of mass.
        torque: About the center of mass (3, 1).
        potential: Its potential energy.
    """

    force: Matrix
    torque: Matrix
    potential: Scalar

    def __add__(self, other: Pull) -> Pull:
        return Pull(
            self.force + other.force, self.torque + other.torque, self.potential + other.potential
        )


class Field(ABC):
    """A field of gravity about a center."""

    @abstractmethod
    def on_mass(self, r: Matrix, mass: Scalar) -> Pull:
        """Force on a mass at r."""

    @abstractmethod
    def on_inertia(self, r: Matrix, inertia: Matrix) -> Pull:
        """Additional action on a body of some extent: terms with its inertia (3, 3)."""


@dataclass(frozen=True)
class Central(Field):
    """The field of a point or of spherical layers.

    Attributes:
        mu: Constant of gravitation times mass [m^3/s^2].
    """

    mu: Scalar

    def on_mass(self, r: Matrix, mass: Scalar) -> Pull:
        distance = norm(*r)
        weight = self.mu * mass / distance
        force = r * -(weight / (distance * distance))
        return Pull(force, Matrix.zeros(r.graph, 3), -weight)

    def on_inertia(self, r: Matrix, inertia: Matrix) -> Pull:
        distance, e, strength = _scaled(r, self.mu, 3)
        leaning = (inertia @ e).note("leaning")
        along, trace = e.dot(leaning), _trace(inertia)
        r.graph.note(along.node, "along")
        r.graph.note(trace.node, "trace")
        force = (e * (along * 5 - trace) - leaning * 2) * (strength * 1.5 / distance)
        torque = e.cross(leaning) * (strength * 3)
        return Pull(force, torque, (along * 3 - trace) * (strength * 0.5))


@dataclass(frozen=True)
class Oblate(Field):
    """Correction by the flattening of a planet to its central field.

    Attributes:
        strength: mu J2 R^2 / 2 [m^5/s^2].
        pole: Unit vector along the axis of the planet (3, 1).
    """

    strength: Scalar
    pole: Matrix

    def on_mass(self, r: Matrix, mass: Scalar) -> Pull:
        distance, e, strength = _scaled(r, self.strength * mass, 3)
        s = e.dot(self.pole)
        square = s * s
        force = (e * (square * 15 - 3) - self.pole * (s * 6)) * (strength / distance)
        return Pull(force, Matrix.zeros(r.graph, 3), (square * 3 - 1) * strength)

    def on_inertia(self, r: Matrix, inertia: Matrix) -> Pull:
        distance, e, strength = _scaled(r, self.strength, 5)
        pole, s = self.pole, e.dot(self.pole)
        le, lp = inertia @ e, inertia @ pole
        a, b, c, d = _trace(inertia), e.dot(le), pole.dot(lp), pole.dot(le)
        square = s * s
        potential = c * -6 + s * d * 60 + (b * 15) * (1 - square * 7) + a * (square * 15 - 3)
        along = c * 30 - s * d * 420 + b * (square * 945 - 105) - a * (square * 105 - 15)
        force = e * along + pole * (d * 60 - s * b * 210 + s * a * 30)
        force = force + le * (30 - square * 210) + lp * (s * 60)
        torque = (pole.cross(le) + e.cross(lp)) * (s * 30) - pole.cross(lp) * 6
        torque = torque + e.cross(le) * (15 - square * 105)
        half = strength * 0.5
        return Pull(force * -(half / distance), torque * strength, potential * half)


def _scaled(r: Matrix, strength: Scalar, power: int) -> tuple[Scalar, Matrix, Scalar]:
    """Distance, unit vector, and strength over a power of the distance."""
    distance, graph = norm(*r.note("r")), r.graph
    graph.note(distance.node, "distance")
    strength = strength / distance**power
    graph.note(strength.node, "strength")
    return distance, (r / distance).note("direction"), strength


def _trace(x: Matrix) -> Scalar:
    return x[0, 0] + x[1, 1] + x[2, 2]
