"""A wheel with a circular cross section on a plane: what a wheel and a thin disk have in common."""

from __future__ import annotations

import math
from abc import abstractmethod

from ...ir.arithmetic import Scalar, cos, sin, sqrt
from ...ir.matrix import Matrix
from ...spatial.axis import complement, rotation_about, unit
from ..quantity import Direction
from .joint import Component, Joint, locked_along


class Rolling(Joint):
    """A torus that touches a plane of the parent; its center is the origin of the child.

    q = [x, y, yaw, lean, spin]: the point of contact in the plane, the heading, the inclination
    about the heading (0: upright) and the angle about the axle. With the normal z, the wheel heads
    along x and its axle is y where all are 0; for another normal they are the two directions that
    make a right-handed triad with it. The speeds are the rates of the coordinates.
    """

    normal: Direction

    @abstractmethod
    def radii(self, data: dict[str, Matrix]) -> tuple[Scalar, Scalar]:
        """Radius of the circle of the centers of the cross sections, and of a cross section [m]."""

    @property
    @abstractmethod
    def slips(self) -> tuple[Component, ...]:
        """Slips that vanish, of ``longitudinal`` and ``lateral``."""

    @property
    def coordinates(self) -> tuple[Component, ...]:
        lean = Component("lean", "rad", reach=math.pi / 2)
        place = Component("x", "m"), Component("y", "m")
        return (*place, Component("yaw", "rad"), lean, Component("spin", "rad"))

    @property
    def coincident(self) -> bool:
        return False

    def pose(self, q: Matrix, **data: Matrix) -> tuple[Matrix, Matrix]:
        n, first, second = _triad(data)
        large, small = self.radii(data)
        tilted = rotation_about(n, q[2]) @ rotation_about(first, q[3])
        contact = first * q[0] + second * q[1] + n * small
        return tilted @ rotation_about(second, q[4]), contact + (tilted @ n) * large

    def motion(self, q: Matrix, **data: Matrix) -> Matrix:
        # in axes that yaw and lean but do not spin, then in those of the child
        n, first, second = _triad(data)
        large, _ = self.radii(data)
        lean, yaw = rotation_about(first, q[3]).T, rotation_about(n, q[2]).T
        zero = Matrix.zeros(q.graph, 3)
        angular = Matrix.hstack(zero, zero, lean @ n, first, second)
        sliding = Matrix.hstack(
            lean @ (yaw @ first),
            lean @ (yaw @ second),
            first * (large * sin(q[3])),
            -(second * large),
            zero,
        )
        back = rotation_about(second, q[4]).T
        return Matrix.vstack(back @ angular, back @ sliding)

    def convective(self, q: Matrix, u: Matrix, **data: Matrix) -> Matrix:
        # components along heading, axle and up of axes that yaw and lean but do not spin
        n, first, second = _triad(data)
        large, _ = self.radii(data)
        c, s = cos(q[3]), sin(q[3])
        yaw, lean, spin = u[2], u[3], u[4]
        level, tipped = yaw * c, yaw * s
        angular = (
            first * -(spin * level) + second * (lean * level) + n * (lean * spin - lean * tipped)
        )
        pulled = (
            first * (2.0 * lean * level)
            + second * (tipped * level)
            - n * (lean * lean + tipped * tipped)
        )
        back = rotation_about(second, q[4]).T
        return Matrix.vstack(back @ angular, back @ (pulled * large))

    def constrained(self, q: Matrix, **data: Matrix) -> Matrix:
        # the force along the normal at the point of contact
        n, first, second = _triad(data)
        large, _ = self.radii(data)
        back = rotation_about(second, q[4]).T
        up = back @ (rotation_about(first, q[3]).T @ n)
        return Matrix.vstack(back @ first * (large * sin(q[3])), up)

    def closure(self, R: Matrix, p: Matrix, **data: Matrix) -> Matrix:
        n, first, second = _triad(data)
        large, small = self.radii(data)
        axle = R @ second
        upright = sqrt(first.dot(axle) ** 2 + second.dot(axle) ** 2)
        return Matrix.vector(R.graph, [n.dot(p) - small - large * upright])

    @property
    def locked(self) -> tuple[Component, ...]:
        return (Component(locked_along(self.normal, "p"), "m"),)

    def slip(self, R: Matrix, p: Matrix, twist: Matrix, **data: Matrix) -> Matrix:
        n, first, second = _triad(data)
        large, small = self.radii(data)
        axle = R @ second
        along, across = first.dot(axle), second.dot(axle)
        upright = sqrt(along * along + across * across)
        R.graph.note(upright.node, "upright")
        heading = ((first * across - second * along) / upright).note("heading")
        sideways = ((first * along + second * across) / upright).note("sideways")
        # velocity of the wheel's point at the contact
        up = (n - axle * n.dot(axle)) / upright
        arm = (-(up.note("up") * large) - n * small).note("arm")
        angular, sliding = R @ twist.block(slice(0, 3)), R @ twist.block(slice(3, 6))
        velocity = sliding.note("sliding") + angular.note("turning").cross(arm)
        velocity.note("velocity")
        return self._rows(heading.dot(velocity), sideways.dot(velocity))

    def sliding(self, q: Matrix, u: Matrix, **data: Matrix) -> Matrix:
        large, small = self.radii(data)
        c, s = cos(q[2]), sin(q[2])
        rolled = (large + small * cos(q[3])) * u[4]
        heading, sideways = c * u[0] + s * u[1] - rolled, c * u[1] - s * u[0] + small * u[3]
        return self._rows(heading, sideways)

    def _rows(self, heading: Scalar, sideways: Scalar) -> Matrix:
        by_name = {"longitudinal": heading, "lateral": sideways}
        return Matrix.vector(heading.graph, [by_name[c.name] for c in self.slips])

    @property
    def domain(self) -> str:
        return "the wheel does not lie flat: |lean| < 90 degrees"


def _triad(data: dict[str, Matrix]) -> tuple[Matrix, Matrix, Matrix]:
    """Normal, heading and axle in the parent, where all angles are 0."""
    n = unit(data["normal"])
    return (n, *complement(n))
