"""Ends of elements that stay in the plane z = 0 of the ground."""

from __future__ import annotations

from typing import ClassVar

from ...ir.arithmetic import Number, Scalar, cos, sin
from ...ir.graph import ONE, ZERO, Graph
from ...ir.matrix import Matrix
from .node_set import Entries, Ground, Motion, Place, Pose

FLAT = ("x", "y", "angle")


class PlaneNode(Place):
    """At a node of the plane itself."""

    kind: ClassVar[str] = "plane_node"
    coordinates: ClassVar[Entries] = (("x", "m"), ("y", "m"), ("angle", "rad"))
    speeds: ClassVar[Entries] = coordinates

    def pose(self) -> Pose:
        return _pose(*self.entries("q"))

    def motion(self) -> Motion:
        (v, omega), (a, rate) = (_parted(self.entries(letter)) for letter in ("u", "udot"))
        return Motion(omega, v, rate, a)

    def to_space(self) -> Matrix:
        return _to_space(Matrix.zeros(self.graph, 3))

    def directions(self) -> list[dict[int, int]]:
        """Angles change sine and cosine, which are all that they make."""
        x, y, angle = self.entries("q").nodes
        s, c = (Scalar(self.graph, angle).apply(name) for name in ("sin", "cos"))
        return [{x: ONE}, {y: ONE}, {angle: ONE, s.node: c.node, c.node: (-s).node}]


class PlaneOffset(Place):
    """Fixed to a node of the plane beside its origin, or in other axes."""

    kind: ClassVar[str] = "plane_offset"
    coordinates: ClassVar[Entries] = PlaneNode.coordinates
    speeds: ClassVar[Entries] = PlaneNode.speeds
    data: ClassVar[tuple[str, ...]] = FLAT

    @property
    def node(self) -> PlaneNode:
        """The node."""
        return PlaneNode(self.graph, (), self.q, self.u)

    def _arm(self) -> Matrix:
        """From the node in ground axes (3, 1)."""
        x, y, _ = self.attributes
        return self.node.pose().rotation @ Matrix.vector(self.graph, [x, y, 0.0])

    def pose(self) -> Pose:
        at = self.node.pose()
        assert at.angle is not None
        rotation = at.rotation @ _turn(self.attributes[2])
        return Pose(rotation, at.position + self._arm(), angle=at.angle + self.attributes[2])

    def motion(self) -> Motion:
        at, arm = self.node.motion(), self._arm()
        across = at.omega.cross(arm)
        transport = at.omega_rate.cross(arm) + at.omega.cross(across)
        return Motion(at.omega, at.velocity + across, at.omega_rate, at.acceleration + transport)

    def to_space(self) -> Matrix:
        return _to_space(self._arm())

    def bent(self, moment: Matrix, force: Matrix) -> Matrix:
        along = -self._arm().dot(force)
        return Matrix(self.graph, 3, 3, [ZERO] * 8 + [along.node])

    def directions(self) -> list[dict[int, int]]:
        return self.node.directions()


class PlaneGround(Ground):
    """Fixed to the ground in the plane."""

    kind: ClassVar[str] = "plane_ground"
    data: ClassVar[tuple[str, ...]] = FLAT

    def pose(self) -> Pose:
        return _pose(*self.attributes)


def _pose(x: Scalar, y: Scalar, angle: Scalar) -> Pose:
    return Pose(_turn(angle), Matrix.vector(x.graph, [x, y, 0.0]), angle=angle)


def _turn(angle: Scalar) -> Matrix:
    s, c = sin(angle), cos(angle)
    return Matrix.of(angle.graph, [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


def _parted(rates: Matrix) -> tuple[Matrix, Matrix]:
    """Rate of the position and of the angle, (3, 1) each."""
    x, y, angle = rates
    g: Graph = rates.graph
    return Matrix.vector(g, [x, y, 0.0]), Matrix.vector(g, [0.0, 0.0, angle])


def _to_space(arm: Matrix) -> Matrix:
    """Increments of an end at an arm in ground axes (6, 3)."""
    x, y, _ = arm
    none: list[Number] = [0.0, 0.0, 0.0]
    turns: list[Number] = [0.0, 0.0, 1.0]
    along: list[Number] = [1.0, 0.0, -y]
    across: list[Number] = [0.0, 1.0, x]
    return Matrix.of(arm.graph, [none, none, turns, along, across, none])
