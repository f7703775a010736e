"""Legs: joints with three freedoms that carry the point at which a ball joint closes a loop.

Two of the freedoms turn: the axes of a universal joint, two revolute joints whose axes meet, or two
whose axes are parallel. The third one, a motor or a slide anywhere in the loop, makes up what
these cannot: the distance from their center, or the distance from their plane.

Source: M. Hiller and A. Kecskemethy, work on characteristic pairs of joints.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

import numpy as np

from ...arrays import Array
from ...records import dataclass
from ..system import Cut, Joint
from .circuits import DEPENDENT, Numbers

# of the free joints of a loop: legs are looked for among those nearest to the cut
NEAREST = 12
SINGLE = ("revolute", "prismatic")


@dataclass(frozen=True)
class Leg:
    """Division of the work of a leg between its joints.

    Attributes:
        kind: ``"leg"``: the pair turns about a center; ``"arm"``: its axes are parallel.
        pair: A universal joint, or two revolute ones, the inner one first.
        third: The joint that makes up for the rest.
    """

    kind: str
    pair: tuple[int, ...]
    third: int

    @property
    def unknown(self) -> tuple[int, ...]:
        """All its joints, each after those it is carried by."""
        return tuple(sorted((*self.pair, self.third)))


@dataclass(frozen=True)
class Axes:
    """Axes of the joints of a tree, at the default parameters.

    Attributes:
        joints, parents: Of the tree; the body inboard of each joint.
        numbers: Values at the default parameters.
    """

    joints: Sequence[Joint]
    parents: Sequence[int]
    numbers: Numbers

    def legs(self, cut: Cut, free: Sequence[int]) -> Iterator[Leg]:
        """Legs among the free joints of a loop that a ball joint closes, nearest to it first.

        Args:
            cut: The joint that closes the loop.
            free: Joints that may be looked for, those nearest to the cut first.
        """
        if cut.element.kind != "spherical" or len(cut.rows) != 3:
            return
        side = dict(cut.path)
        legs = [
            leg
            for count in (2, 3)
            for some in _sets(free[:NEAREST], count)
            for leg in self._of(some)
        ]
        # legs whose joints carry each other before those that meet from two sides
        yield from sorted(legs, key=lambda leg: len({side[i] for i in leg.unknown}))

    def _of(self, some: tuple[int, ...]) -> Iterator[Leg]:
        """Legs of given joints."""
        kinds = {i: self.joints[i].element.kind for i in some}
        turns = [i for i in some if kinds[i] == "universal"]
        if len(some) == 2 and len(turns) == 1:
            (third,) = (i for i in some if i not in turns)
            if kinds[third] in SINGLE:
                yield Leg("leg", (turns[0],), third)
        if len(some) == 2 or not all(kind in SINGLE for kind in kinds.values()):
            return
        for inner, outer in combinations(sorted(some), 2):
            (third,) = (i for i in some if i not in (inner, outer))
            pair = self.parents[outer] == inner and kinds[inner] == kinds[outer] == "revolute"
            kind = self._pair(inner, outer) if pair else ""
            if kind == "leg" or (kind == "arm" and kinds[third] == "revolute"):
                yield Leg(kind, (inner, outer), third)

    def _pair(self, inner: int, outer: int) -> str:
        """Name of what two revolute joints, one on the other, do in series."""
        first, second, seat = self._axis(inner), self._axis(outer), self._seat(outer)
        if np.linalg.norm(np.cross(first, seat[0] @ second)) < DEPENDENT:
            return "arm"
        # the seat of the outer joint is the center, if it lies on the inner axis
        away = np.linalg.norm(np.cross(first, seat[1]))
        return "leg" if away <= DEPENDENT * max(1.0, float(np.linalg.norm(seat[1]))) else ""

    def _axis(self, i: int) -> Array:
        values = self.numbers.values(*self.joints[i].data["axis"][2])
        return np.asarray(values / np.linalg.norm(values))

    def _seat(self, i: int) -> tuple[Array, Array]:
        """R (3, 3) and p (3) of the inboard frame of a joint, in the body that carries it."""
        pose = self.numbers.pose(self.joints[i].rotation, self.joints[i].position)
        return pose.rotation, pose.position


def _sets(free: Sequence[int], count: int) -> list[tuple[int, ...]]:
    """Sets of joints, those nearest to the cut first."""
    order = {i: n for n, i in enumerate(free)}
    return sorted(
        combinations(free, count), key=lambda some: sorted((order[i] for i in some), reverse=True)
    )
