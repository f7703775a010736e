"""A point of the child that is guided in the parent, about which the child turns freely."""

from __future__ import annotations

from abc import abstractmethod

from ...ir.matrix import Matrix
from ...spatial.exponential import tangent
from ...spatial.rotations import Rotation, parametrization
from .joint import Component, Joint, Step


def turns(rotation: str) -> tuple[Step, ...]:
    """The turns of a sequence of angles: about axes that turn along, or that stay; else ()."""
    if len(rotation) != 3 or not set(rotation.lower()) <= set("xyz"):
        return ()
    steps = tuple(Step(f"angle{k + 1}", axis) for k, axis in enumerate(rotation.lower()))
    return steps if rotation.isupper() else steps[::-1]


class Guided(Joint):
    """Rotation in any parametrization, and the place of the child's origin by k coordinates c.

    q = [rotation, c]; u = [angular velocity in child axes [rad/s], rates of c], whatever the
    parametrization: where it is singular, only qdot is.
    """

    rotation: str

    def __post_init__(self) -> None:
        super().__post_init__()
        parametrization(self.rotation, self.called)

    @property
    @abstractmethod
    def guides(self) -> tuple[Component, ...]:
        """The coordinates c of the place."""

    @abstractmethod
    def place(self, c: Matrix, **data: Matrix) -> Matrix:
        """Origin of C in P axes [m], (3, 1)."""

    @abstractmethod
    def slope(self, c: Matrix, **data: Matrix) -> Matrix:
        """Derivatives of the place by the coordinates, (3, k)."""

    @abstractmethod
    def blocked(self, c: Matrix, **data: Matrix) -> Matrix:
        """Directions in P in which the place cannot move, (3, 3 - k)."""

    @abstractmethod
    def bend(self, c: Matrix, rate: Matrix, **data: Matrix) -> Matrix:
        """Acceleration of the place at constant rates, (3, 1) in P axes."""

    @property
    def parameters(self) -> Rotation:
        """The parametrization of the rotation."""
        return parametrization(self.rotation)

    @property
    def coordinates(self) -> tuple[Component, ...]:
        r = self.parameters
        return (*map(Component, r.components, r.units, r.defaults), *self.guides)

    @property
    def speeds(self) -> tuple[Component, ...]:
        rates = tuple(Component(c.name, c.unit + "/s") for c in self.guides)
        return tuple(Component(name, "rad/s") for name in "xyz") + rates

    def split(self, q: Matrix) -> tuple[Matrix, Matrix]:
        """Rotation and place of coordinates or speeds."""
        n = len(q) - len(self.guides)
        return q.block(slice(0, n)), q.block(slice(n, None))

    def pose(self, q: Matrix, **data: Matrix) -> tuple[Matrix, Matrix]:
        rotation, c = self.split(q)
        return self.parameters.matrix(rotation), self.place(c, **data)

    def motion(self, q: Matrix, **data: Matrix) -> Matrix:
        rotation, c = self.split(q)
        graph, k = q.graph, len(c)
        R = self.parameters.matrix(rotation)
        angular = Matrix.hstack(Matrix.identity(graph, 3), Matrix.zeros(graph, 3, k))
        sliding = Matrix.hstack(Matrix.zeros(graph, 3, 3), R.T @ self.slope(c, **data))
        return Matrix.vstack(angular, sliding)

    def constrained(self, q: Matrix, **data: Matrix) -> Matrix:
        rotation, c = self.split(q)
        blocked = self.blocked(c, **data)
        forces = self.parameters.matrix(rotation).T @ blocked
        return Matrix.vstack(Matrix.zeros(q.graph, 3, blocked.columns), forces)

    def rates(self, q: Matrix, u: Matrix, **data: Matrix) -> Matrix:
        omega, rate = self.split(u)
        return Matrix.vstack(self.parameters.rates(self.split(q)[0], omega), rate)

    def speeds_of(self, q: Matrix, qdot: Matrix, **data: Matrix) -> Matrix:
        rotation_rates, rate = self.split(qdot)
        return Matrix.vstack(self.parameters.omega(self.split(q)[0], rotation_rates), rate)

    def bracket(self, u: Matrix, v: Matrix) -> Matrix:
        (omega, rate), other_omega = self.split(u), self.split(v)[0]
        return Matrix.vstack(omega.cross(other_omega), Matrix.zeros(u.graph, rate.rows))

    def convective(self, q: Matrix, u: Matrix, **data: Matrix) -> Matrix:
        rotation, c = self.split(q)
        bend = self.bend(c, self.split(u)[1], **data)
        sliding = bend if bend.is_zero else self.parameters.matrix(rotation).T @ bend
        return Matrix.vstack(Matrix.zeros(q.graph, 3), sliding)

    def integrate(self, q: Matrix, du: Matrix, **data: Matrix) -> Matrix:
        (rotation, c), (turn, step) = self.split(q), self.split(du)
        return Matrix.vstack(self.parameters.integrate(rotation, turn), c + step)

    def difference(self, q0: Matrix, q1: Matrix, **data: Matrix) -> Matrix:
        (rotation0, c0), (rotation1, c1) = self.split(q0), self.split(q1)
        return Matrix.vstack(self.parameters.difference(rotation0, rotation1), c1 - c0)

    def tangent(self, du: Matrix) -> Matrix:
        turn, n = tangent(self.split(du)[0]), len(du)
        nodes = list(Matrix.identity(du.graph, n).nodes)
        for i in range(3):
            nodes[i * n : i * n + 3] = turn.row(i)
        return Matrix(du.graph, n, n, nodes)

    @property
    def quaternion(self) -> int | None:
        return 0 if self.parameters.unit_quaternion else None

    @property
    def domain(self) -> str:
        return self.parameters.domain
