"""The ends of an element, as its functions read them and as what acts on them is told."""

from __future__ import annotations

from collections.abc import Sequence

from ...ir.arithmetic import Scalar, select
from ...ir.function import Block
from ...ir.graph import ONE, Graph
from ...ir.matrix import Matrix
from ...records import dataclass
from ...spatial.exponential import conjugate, multiply
from ...spatial.rotations.quaternion import Quaternion
from ...spatial.short_rotations import rotation_vector
from .node_set import Ground, Motion, Node, Offset, Place, Pose
from .plane import PlaneGround, PlaneNode, PlaneOffset

PLACES: dict[str, type[Place]] = {
    place.kind: place for place in (Node, Offset, Ground, PlaneNode, PlaneOffset, PlaneGround)
}
NODE, OFFSET, GROUND = "node", "offset", "ground"
# the center of a gravity field is an end of its own where it moves
CENTER = "center"
NAMES = ("start", "end")
ENDS = (*NAMES, CENTER)
CELLS = tuple(i + j for i in "xyz" for j in "xyz")
RATES = {"q": "", "u": "/s", "udot": "/s^2", "du": ""}
LOADS = {"rad": "N*m", "m": "N"}
STRESSES = ("m1", "m2", "m3", "n1", "n2", "n3")
STRESS_UNITS = ("N*m",) * 3 + ("N",) * 3
# entries of strain and stress that are zero in the plane
OUTSIDE = (0, 1, 5)
Loads = Sequence[Matrix]


def relative_rotation(start: Pose, end: Pose) -> tuple[Matrix, Matrix]:
    """Rotation vector (3, 1) of ``end`` seen from ``start``, and the rotation (3, 3)."""
    if start.angle is not None and end.angle is not None:
        turn = end.angle - start.angle
        rotation = start.rotation.T @ end.rotation
        return Matrix.vector(rotation.graph, [0.0, 0.0, turn]), rotation
    assert start.quaternion is not None
    assert end.quaternion is not None
    quaternion = multiply(conjugate(start.quaternion), end.quaternion).note("relative")
    rotation = Quaternion().matrix(quaternion).note("r")
    # of the two quaternions that are this rotation the one that turns by less than pi
    negative = quaternion[0].apply("lt", 0.0)
    short = [select(negative, -x, x) for x in quaternion]
    w, *v = Matrix.vector(quaternion.graph, short).note("short")
    return rotation_vector(w, Matrix.vector(quaternion.graph, v)), rotation


@dataclass(frozen=True)
class Ends:
    """The two ends of an element, and a third one where it acts on one more place.

    Attributes:
        graph: Where the expressions live.
        kinds: Of all of them, by name.
        data: Names of the entries of p.
    """

    graph: Graph
    kinds: tuple[str, ...]
    data: tuple[str, ...]

    @staticmethod
    def names(kinds: Sequence[str]) -> tuple[str, ...]:
        """Names of the data that say where start and end are; a center is among the common data."""
        places = [PLACES[kind] for kind in kinds[:2]]
        return tuple(
            f"{name}_{entry}"
            for name, place in zip(NAMES, places, strict=True)
            for entry in place.data
        )

    def number(self, name: str) -> Scalar:
        """An entry of the data."""
        return Scalar(self.graph, self.graph.var("p", self.data.index(name)))

    def vector(self, *names: str) -> Matrix:
        """Entries of the data as a column."""
        return Matrix.vector(self.graph, [self.number(name) for name in names])

    @property
    def places(self) -> tuple[Place, ...]:
        """All ends."""
        places: list[Place] = []
        q = u = 0
        for name, kind in zip(ENDS, self.kinds, strict=False):
            place = PLACES[kind]
            attributes = tuple(self.number(f"{name}_{entry}") for entry in place.data)
            places.append(place(self.graph, attributes, q, u))
            q, u = q + len(place.coordinates), u + len(place.speeds)
        return tuple(places)

    @property
    def planar(self) -> bool:
        """True when nothing leaves the plane z = 0; see :data:`OUTSIDE`."""
        return all(kind.startswith("plane") for kind in self.kinds)

    @property
    def speeds(self) -> tuple[str, ...]:
        """Names of the entries of u."""
        return self._entries("u").entries

    @property
    def load_units(self) -> tuple[str, ...]:
        """Units of what acts along them."""
        return tuple(LOADS[unit] for place in self.places for _, unit in place.speeds)

    def pose(self, k: int) -> Pose:
        """Pose of end k."""
        pose = self.places[k].pose()
        pose.rotation.hint("", f"{ENDS[k]}_R", CELLS)
        return pose

    def motion(self, k: int) -> Motion:
        """Motion of end k."""
        return self.places[k].motion()

    def increments(self) -> list[Matrix]:
        """Finite increments of both ends to first order: rotations in their axes, positions."""
        increments: list[Matrix] = []
        for place in self.places:
            change = place.to_space() @ place.entries("du")
            increments += [change.block(slice(3)), change.block(slice(3, 6))]
        return increments

    def directions(self, letter: str) -> list[dict[int, int]]:
        """Changes of a block at unit increments of each of its entries; of q along the speeds."""
        if letter == "q":
            return [seeds for place in self.places for seeds in place.directions()]
        return [{self.graph.var(letter, k): ONE} for k in range(len(self.speeds))]

    def blocks(self, *letters: str) -> tuple[Block, ...]:
        """The input blocks that functions of these ends may read."""
        return tuple(self._entries(letter) for letter in letters)

    def _entries(self, letter: str) -> Block:
        if letter == "p":
            return Block("p", self.data, ("",) * len(self.data))
        if letter == "z":
            return Block("z", STRESSES, STRESS_UNITS)
        names: list[str] = []
        units: list[str] = []
        for name, place in zip(ENDS, self.places, strict=False):
            for entry, unit in place.coordinates if letter == "q" else place.speeds:
                names.append(f"{name}.{entry}")
                units.append(unit + RATES[letter] if unit else "")
        return Block(letter, tuple(names), tuple(units))

    # what acts on the ends, told along the speeds

    def assembled(self, loads: Loads) -> Matrix:
        """Moments and forces on the ends as one column (nu, 1).

        Args:
            loads: Moment on end 1 in its axes, force on end 1 in ground axes, and of the others.
        """
        total = Matrix.zeros(self.graph, len(self.speeds))
        for k, to_end in enumerate(self._spreads()):
            total = total + to_end.T @ Matrix.vstack(*loads[2 * k : 2 * k + 2])
        return total

    def derivative(self, blocks: Sequence[Loads], loads: Loads) -> Matrix:
        """Derivative of :meth:`assembled` along q from that of the loads by increments of the ends.

        Args:
            blocks: 4 x 4 blocks (3, 3).
            loads: The loads themselves: they act elsewhere as the ends move.
        """
        spreads, nu = self._spreads(), len(self.speeds)
        total = Matrix.zeros(self.graph, nu, nu)
        for i, place in enumerate(self.places):
            for j in range(2):
                lines = [line[2 * j : 2 * j + 2] for line in blocks[2 * i : 2 * i + 2]]
                part = Matrix.vstack(*(Matrix.hstack(*line) for line in lines))
                total = total + spreads[i].T @ part @ spreads[j]
            bent = place.bent(*loads[2 * i : 2 * i + 2])
            total = total + self._wide(self._wide(bent, place.u).T, place.u).T
        return total

    def _spreads(self) -> list[Matrix]:
        """Increments of each end from those of all speeds (6, nu)."""
        return [self._wide(place.to_space(), place.u) for place in self.places]

    def _wide(self, columns: Matrix, first: int) -> Matrix:
        """Columns of speeds from ``first`` on (n, its own) among those of all (n, nu)."""
        left = len(self.speeds) - first - columns.columns
        zeros = [Matrix.zeros(self.graph, columns.rows, count) for count in (first, left)]
        return Matrix.hstack(zeros[0], columns, zeros[1])
