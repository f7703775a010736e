"""Ends of elements: at a node, at an offset from it, on the ground; points; planes.

A node has q = [w x y z, px py pz] and u = [omega (its axes), v (ground axes)]; a point
q = [px py pz]; a node of the plane z = 0 has q = [x, y, angle]. Of points and plane nodes q just
adds up. Data of an end that is not at a node itself are a rotation R (3, 3), axes of the end to
those of node or ground, and a position (3) in axes of node or ground; in the plane x, y and angle.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import field
from typing import ClassVar

from ...ir.arithmetic import Scalar
from ...ir.graph import ONE, ZERO, Graph
from ...ir.matrix import Matrix
from ...records import dataclass
from ...spatial.exponential import multiply, quaternion_of
from ...spatial.rotations.quaternion import Quaternion

# names with units; of speeds those of their increments
Entries = tuple[tuple[str, str], ...]
POSITION: Entries = (("px", "m"), ("py", "m"), ("pz", "m"))
VELOCITY: Entries = (("vx", "m"), ("vy", "m"), ("vz", "m"))
OMEGA: Entries = (("wx", "rad"), ("wy", "rad"), ("wz", "rad"))
FRAME = (*(f"R{i}{j}" for i in "123" for j in "123"), "px", "py", "pz")


@dataclass(frozen=True)
class Pose:
    """Pose of an end.

    Attributes:
        rotation: R (3, 3), axes of the end to ground axes.
        position: In ground axes (3, 1) [m].
        quaternion: Unit quaternion (4, 1) of the same rotation; None in the plane.
        angle: About z, of what stays in the plane.
    """

    rotation: Matrix
    position: Matrix
    quaternion: Matrix | None = None
    angle: Scalar | None = None


@dataclass(frozen=True)
class Motion:
    """Motion of an end.

    Attributes:
        omega: Angular velocity in axes of the end (3, 1) [rad/s].
        velocity: Of the end in ground axes (3, 1) [m/s].
        omega_rate: Derivative of omega (3, 1) [rad/s²].
        acceleration: In ground axes (3, 1) [m/s²].
    """

    omega: Matrix
    velocity: Matrix
    omega_rate: Matrix
    acceleration: Matrix


@dataclass(frozen=True)
class Place(ABC):
    """An end of an element, and what of it is unknown.

    Attributes:
        kind: Its name.
        coordinates, speeds: Its entries of q and u.
        data: Names of its data behind the name of the end.
        graph: Where expressions live.
        attributes: Its data.
        q, u: Its first entries among those of the element.
    """

    kind: ClassVar[str]
    coordinates: ClassVar[Entries] = ()
    speeds: ClassVar[Entries] = ()
    data: ClassVar[tuple[str, ...]] = ()
    graph: Graph = field(repr=False)
    attributes: tuple[Scalar, ...]
    q: int
    u: int

    def entries(self, letter: str) -> Matrix:
        """Its entries of q, u, udot or du as a column."""
        first, names = (self.q, self.coordinates) if letter == "q" else (self.u, self.speeds)
        nodes = [self.graph.var(letter, first + k) for k in range(len(names))]
        return Matrix(self.graph, len(names), 1, nodes)

    @abstractmethod
    def pose(self) -> Pose:
        """Pose of the end."""

    @abstractmethod
    def motion(self) -> Motion:
        """Motion of the end."""

    @abstractmethod
    def to_space(self) -> Matrix:
        """Increments of the end, rotation in its axes and position, from those of u (6, nu)."""

    def bent(self, moment: Matrix, force: Matrix) -> Matrix:
        """Change along q of loads on u as the end moves under a constant load (nu, nu).

        Args:
            moment: On the end, in its axes (3, 1).
            force: On the end, in ground axes (3, 1).
        """
        return Matrix.zeros(self.graph, len(self.speeds), len(self.speeds))

    @abstractmethod
    def directions(self) -> list[dict[int, int]]:
        """Changes of q, and of what is made of it, at unit increments of each speed."""


class Ground(Place):
    """Fixed to the ground."""

    kind: ClassVar[str] = "ground"
    data: ClassVar[tuple[str, ...]] = FRAME

    def pose(self) -> Pose:
        R, p = _frame(self)
        return Pose(R, p, quaternion_of(R))

    def motion(self) -> Motion:
        return Motion(*[Matrix.zeros(self.graph, 3)] * 4)

    def to_space(self) -> Matrix:
        return Matrix.zeros(self.graph, 6, 0)

    def directions(self) -> list[dict[int, int]]:
        return []


class Node(Place):
    """At a node itself."""

    kind: ClassVar[str] = "node"
    coordinates: ClassVar[Entries] = (("qw", ""), ("qx", ""), ("qy", ""), ("qz", ""), *POSITION)
    speeds: ClassVar[Entries] = (*OMEGA, *VELOCITY)

    def pose(self) -> Pose:
        quaternion, position = _halves(self.entries("q"), 4)
        return Pose(Quaternion().matrix(quaternion), position, quaternion)

    def motion(self) -> Motion:
        (omega, v), (rate, a) = (_halves(self.entries(x), 3) for x in ("u", "udot"))
        return Motion(omega, v, rate, a)

    def to_space(self) -> Matrix:
        return Matrix.identity(self.graph, 6)

    def directions(self) -> list[dict[int, int]]:
        quaternion, position = _halves(self.entries("q"), 4)
        rotation, directions = Quaternion().matrix(quaternion), list[dict[int, int]]()
        for n in range(3):
            axis = Matrix(self.graph, 3, 1, [ONE if i == n else ZERO for i in range(3)])
            rates, rotation_slope = Quaternion().rates(quaternion, axis), rotation @ axis.skew
            nodes = (*quaternion.nodes, *rotation.nodes)
            directions.append(dict(zip(nodes, (*rates.nodes, *rotation_slope.nodes), strict=True)))
        return directions + [{node: ONE} for node in position.nodes]


class Offset(Place):
    """Fixed to a node beside its origin, or in other axes."""

    kind: ClassVar[str] = "offset"
    coordinates: ClassVar[Entries] = Node.coordinates
    speeds: ClassVar[Entries] = Node.speeds
    data: ClassVar[tuple[str, ...]] = FRAME

    @property
    def node(self) -> Node:
        """The node."""
        return Node(self.graph, (), self.q, self.u)

    def pose(self) -> Pose:
        at, (R, p) = self.node.pose(), _frame(self)
        assert at.quaternion is not None
        quaternion = multiply(at.quaternion, quaternion_of(R))
        return Pose(at.rotation @ R, at.position + at.rotation @ p, quaternion)

    def motion(self) -> Motion:
        at, (R, p), rotation = self.node.motion(), _frame(self), self.node.pose().rotation
        arm = at.omega.cross(p)
        return Motion(
            R.T @ at.omega,
            at.velocity + rotation @ arm,
            R.T @ at.omega_rate,
            at.acceleration + rotation @ (at.omega_rate.cross(p) + at.omega.cross(arm)),
        )

    def to_space(self) -> Matrix:
        (R, p), rotation = _frame(self), self.node.pose().rotation
        zero, one = Matrix.zeros(self.graph, 3, 3), Matrix.identity(self.graph, 3)
        arm = -(rotation @ p.skew)
        return Matrix.vstack(Matrix.hstack(R.T, zero), Matrix.hstack(arm, one))

    def bent(self, moment: Matrix, force: Matrix) -> Matrix:
        _, p = _frame(self)
        block = p.skew @ (self.node.pose().rotation.T @ force).skew
        nodes = [
            block.nodes[3 * i + j] if i < 3 and j < 3 else ZERO for i in range(6) for j in range(6)
        ]
        return Matrix(self.graph, 6, 6, nodes)

    def directions(self) -> list[dict[int, int]]:
        return self.node.directions()


def _halves(column: Matrix, first: int) -> tuple[Matrix, Matrix]:
    return column.block(slice(first)), column.block(slice(first, None))


def _frame(place: Place) -> tuple[Matrix, Matrix]:
    """Rotation (3, 3) and position (3, 1) from the data of an end."""
    nodes = [x.node for x in place.attributes]
    return Matrix(place.graph, 3, 3, nodes[:9]), Matrix(place.graph, 3, 1, nodes[9:])
