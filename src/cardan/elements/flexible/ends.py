"""The ends of an element: at the origin of a node, fixed to a node at an offset, or to the ground.

A node has q = [w x y z, px py pz] and u = [omega (its axes), v (ground axes)]. Data of an end that
is not at a node itself are a rotation R (3, 3), axes of the end to those of the node or ground, and
a position (3) in axes of the node or ground.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ...ir.arithmetic import Scalar, select
from ...ir.function import Block
from ...ir.graph import Graph
from ...ir.matrix import Matrix
from ...spatial.exponential import conjugate, multiply, quaternion_of
from ...spatial.rotations.quaternion import Quaternion

NODE, OFFSET, GROUND = "node", "offset", "ground"
NAMES = ("start", "end")
COORDINATES = ("w", "x", "y", "z", "px", "py", "pz")
SPEEDS = ("wx", "wy", "wz", "vx", "vy", "vz")
Q_UNITS = ("", "", "", "", "m", "m", "m")
U_UNITS = ("rad/s",) * 3 + ("m/s",) * 3
UDOT_UNITS = ("rad/s^2",) * 3 + ("m/s^2",) * 3
DU_UNITS = ("rad",) * 3 + ("m",) * 3
LOADS = ("N*m",) * 3 + ("N",) * 3


@dataclass(frozen=True)
class Pose:
    """Where an end is.

    Attributes:
        quaternion: Unit quaternion (4, 1), axes of the end to ground axes.
        rotation: The same as R (3, 3).
        position: In ground axes (3, 1) [m].
    """

    quaternion: Matrix
    rotation: Matrix
    position: Matrix


@dataclass(frozen=True)
class Motion:
    """How an end moves.

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


def relative_quaternion(start: Pose, end: Pose) -> tuple[Scalar, Matrix, Matrix]:
    """Axes of ``end`` to those of ``start``: (w, v) with w >= 0, and the rotation (3, 3)."""
    quaternion = multiply(conjugate(start.quaternion), end.quaternion)
    rotation = Quaternion().matrix(quaternion)
    # of the two quaternions that are this rotation the one that turns by less than pi
    negative = quaternion[0].apply("lt", 0.0)
    w, *v = (select(negative, -x, x) for x in quaternion)
    return w, Matrix.vector(quaternion.graph, v), rotation


@dataclass(frozen=True)
class Ends:
    """The two ends of an element, as its functions read them.

    Attributes:
        graph: Where the expressions live.
        kinds: Of both: "node", "offset" or "ground".
        data: Names of the entries of p.
    """

    graph: Graph
    kinds: tuple[str, str]
    data: tuple[str, ...]

    @staticmethod
    def names(kinds: Sequence[str]) -> tuple[str, ...]:
        """Names of the data that say where ends are."""
        entries = [*(f"R{i}{j}" for i in "123" for j in "123"), "px", "py", "pz"]
        apart = [name for name, kind in zip(NAMES, kinds, strict=True) if kind != NODE]
        return tuple(f"{name}_{entry}" for name in apart for entry in entries)

    @property
    def nodes(self) -> tuple[int, ...]:
        """Indices of the ends that move with a node."""
        return tuple(k for k, kind in enumerate(self.kinds) if kind != GROUND)

    def number(self, name: str) -> Scalar:
        """An entry of the data."""
        return Scalar(self.graph, self.graph.var("p", self.data.index(name)))

    def vector(self, *names: str) -> Matrix:
        """Entries of the data as a column."""
        return Matrix.vector(self.graph, [self.number(name) for name in names])

    def block(self, letter: str, node: int, first: int, size: int) -> Matrix:
        """Entries of q, u, udot or du of a node as a column."""
        start = (7 if letter == "q" else 6) * self.nodes.index(node) + first
        g = self.graph
        return Matrix(g, size, 1, [g.var(letter, start + k) for k in range(size)])

    def offset(self, k: int) -> tuple[Matrix, Matrix]:
        """Rotation (3, 3) and position (3, 1) of an end that is not at its node itself."""
        name = NAMES[k]
        entries = [self.number(f"{name}_R{i}{j}") for i in "123" for j in "123"]
        R = Matrix(self.graph, 3, 3, [x.node for x in entries])
        return R, self.vector(*(f"{name}_p{x}" for x in "xyz"))

    def node_rotation(self, k: int) -> Matrix:
        """R (3, 3) of the node of an end."""
        return Quaternion().matrix(self.block("q", k, 0, 4))

    def pose(self, k: int) -> Pose:
        """Where end k is."""
        if self.kinds[k] == GROUND:
            R, p = self.offset(k)
            return Pose(quaternion_of(R), R, p)
        quaternion, position = self.block("q", k, 0, 4), self.block("q", k, 4, 3)
        rotation = Quaternion().matrix(quaternion)
        if self.kinds[k] == NODE:
            return Pose(quaternion, rotation, position)
        R, p = self.offset(k)
        quaternion = multiply(quaternion, quaternion_of(R))
        return Pose(quaternion, rotation @ R, position + rotation @ p)

    def motion(self, k: int) -> Motion:
        """How end k moves."""
        if self.kinds[k] == GROUND:
            return Motion(*[Matrix.zeros(self.graph, 3)] * 4)
        omega, velocity = self.block("u", k, 0, 3), self.block("u", k, 3, 3)
        rate, acceleration = self.block("udot", k, 0, 3), self.block("udot", k, 3, 3)
        if self.kinds[k] == NODE:
            return Motion(omega, velocity, rate, acceleration)
        rotation = self.node_rotation(k)
        R, p = self.offset(k)
        arm = omega.cross(p)
        return Motion(
            R.T @ omega,
            velocity + rotation @ arm,
            R.T @ rate,
            acceleration + rotation @ (rate.cross(p) + omega.cross(arm)),
        )

    def increments(self) -> list[Matrix]:
        """Finite increments of both ends to first order: rotations in their axes, positions."""
        found: list[Matrix] = []
        for k, kind in enumerate(self.kinds):
            if kind == GROUND:
                found += [Matrix.zeros(self.graph, 3)] * 2
                continue
            turn, move = self.block("du", k, 0, 3), self.block("du", k, 3, 3)
            if kind == OFFSET:
                R, p = self.offset(k)
                turn, move = R.T @ turn, move + self.node_rotation(k) @ turn.cross(p)
            found += [turn, move]
        return found

    def blocks(self, *letters: str) -> tuple[Block, ...]:
        """The input blocks that functions of these ends may read."""
        known = {
            "q": (COORDINATES, Q_UNITS),
            "u": (SPEEDS, U_UNITS),
            "udot": (SPEEDS, UDOT_UNITS),
            "du": (SPEEDS, DU_UNITS),
        }
        found = []
        for letter in letters:
            if letter == "p":
                found.append(Block("p", self.data, ("",) * len(self.data)))
                continue
            entries, units = known[letter]
            names = tuple(f"{NAMES[k]}.{entry}" for k in self.nodes for entry in entries)
            found.append(Block(letter, names, units * len(self.nodes)))
        return tuple(found)

    # what acts on the ends, told for the nodes

    def told(self, loads: Sequence[Matrix]) -> Matrix:
        """Moments and forces on ends 1 and 2 as one column of their nodes.

        Args:
            loads: Moment on end 1 in its axes, force on end 1 in ground axes, and of end 2.
        """
        parts: list[Matrix] = []
        for k in self.nodes:
            moment, force = loads[2 * k], loads[2 * k + 1]
            if self.kinds[k] == OFFSET:
                R, p = self.offset(k)
                moment = R @ moment + p.cross(self.node_rotation(k).T @ force)
            parts += [moment, force]
        return Matrix.vstack(*parts)

    def derivative(
        self, blocks: Sequence[Sequence[Matrix]], loads: Sequence[Matrix] | None = None
    ) -> Matrix:
        """Derivatives of :meth:`told` from those of the loads by the increments of the ends.

        Args:
            blocks: 4 x 4 blocks (3, 3).
            loads: The loads where the derivative is one along positions: offsets turn with nodes.
        """
        maps = [self._map(k) for k in range(2)]
        rows: list[Matrix] = []
        for i in self.nodes:
            row: list[Matrix] = []
            for j in self.nodes:
                part = [list(line[2 * j : 2 * j + 2]) for line in blocks[2 * i : 2 * i + 2]]
                part = _by(_transposed(maps[i]), part) if maps[i] else part
                part = _by(part, maps[j]) if maps[j] else part
                if i == j and loads is not None and maps[i]:
                    part[0][0] = part[0][0] + self._turned(i, loads[2 * i + 1])
                row.append(Matrix.vstack(*(Matrix.hstack(*line) for line in part)))
            rows.append(Matrix.hstack(*row))
        return Matrix.vstack(*rows)

    def _map(self, k: int) -> list[list[Matrix]]:
        """Increments of end k from those of its node; empty where they are the same."""
        if self.kinds[k] != OFFSET:
            return []
        R, p = self.offset(k)
        zero, one = Matrix.zeros(self.graph, 3, 3), Matrix.identity(self.graph, 3)
        return [[R.T, zero], [-(self.node_rotation(k) @ p.skew), one]]

    def _turned(self, k: int, force: Matrix) -> Matrix:
        """What the turning arm adds to the derivative of the moment on a node."""
        _, p = self.offset(k)
        return p.skew @ (self.node_rotation(k).T @ force).skew


def _transposed(blocks: list[list[Matrix]]) -> list[list[Matrix]]:
    return [[blocks[j][i].T for j in range(2)] for i in range(2)]


def _by(a: list[list[Matrix]], b: list[list[Matrix]]) -> list[list[Matrix]]:
    """Product of 2 x 2 blocks."""
    return [[a[i][0] @ b[0][j] + a[i][1] @ b[1][j] for j in range(2)] for i in range(2)]
