"""Table of a tree: bodies depth first, speeds level by level, what adds to entries."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from ...records import dataclass

# entries that a vector of C holds: paths and rows of M begin at multiples of it
CHUNK = 8
# columns that go together, at most
PANEL = 2 * CHUNK
# numbers of a body and of a speed: of tree_mass.h, of tree_derivatives.h
MASS_BODY, MASS_SPEED, MASS_STRIDE = 10, 6, 16
BODY, SPEED = 28, 22
# scratch of tree_sides.h: of a body, of a level; of tree_articulated.h: of a body, of a speed
SIDE_STRIDE, PATHS = 24, 21
MATRIX, GAINS, CAUSE = 9 * CHUNK, 2 * CHUNK + 10, 7 * CHUNK
# speeds of a joint, at most
MOST_SPEEDS = 6
S, ETA_Q, ZETA_Q, LOAD = 6, 12, 15, 21
WRENCH = 22


class BodyRow(NamedTuple):
    """Row of the table of a body, depth first.

    Attributes:
        parent: Its parent in this order, -1 for the ground.
        first, speeds: First speed of its joint and their number.
        numbers: Place of its numbers, those of its speeds behind them.
        modes: Place of the changes of the columns of its joint, -1 where these are fixed to it.
    """

    parent: int
    first: int
    speeds: int
    numbers: int
    modes: int


class SpeedRow(NamedTuple):
    """Row of the table of a speed.

    Attributes:
        slot: Of u.
        level: Number of speeds between it and the ground.
        run, before: First speed of the run that it belongs to, and the speed inboard of that, -1
            for none.
        place: Of its row of M.
    """

    slot: int
    level: int
    run: int
    before: int
    place: int


class OutputRow(NamedTuple):
    """Columns of a result: ``first`` ones of the right sides, or M or its inverse.

    Attributes:
        of_mass: 1 for M or its inverse.
        columns, first: Number of columns, and the first.
    """

    of_mass: int
    columns: int
    first: int


class Entry(NamedTuple):
    """A number that is added at a row and a column: of right sides, or of M.

    Attributes:
        row, column: A speed; a column, or for M a speed that is not outboard of the first.
        place: Of the number.
    """

    row: int
    column: int
    place: int


@dataclass(frozen=True)
class Tree:
    """Table that a kernel loops over.

    Attributes:
        bodies, speeds: Rows, depth first.
        rotors: Entries added to M.
        outputs: Results of derivatives.
        changes: Entries added to the right sides.
        columns: Right sides besides those along q and u.
        forward: Whether derivatives are those of accelerations.
    """

    bodies: tuple[BodyRow, ...]
    speeds: tuple[SpeedRow, ...]
    rotors: tuple[Entry, ...] = ()
    outputs: tuple[OutputRow, ...] = ()
    changes: tuple[Entry, ...] = ()
    columns: int = 0
    forward: bool = False

    @property
    def depth(self) -> int:
        """Levels of the longest path, rounded up to a chunk."""
        return chunks(max((speed.level + 1 for speed in self.speeds), default=0))

    @property
    def width(self) -> int:
        """Right sides: along q and along u, each rounded up to chunks, and others."""
        return 2 * chunks(len(self.speeds)) + self.columns

    @property
    def rows(self) -> int:
        """Room of the rows of M."""
        return max((s.place + chunks(s.level + 1) for s in self.speeds), default=0)

    def inboard(self, k: int) -> Iterator[int]:
        """A speed and those between it and the ground, from the speed inward."""
        while k >= 0:
            yield k
            k = self.speeds[k].before if k == self.speeds[k].run else k - 1

    @property
    def pairs(self) -> int:
        """Number of pairs of a speed and one of its ancestors."""
        return sum(speed.level for speed in self.speeds)

    @property
    def reads(self) -> tuple[str, ...]:
        """Input blocks that the kernel reads."""
        if not self.outputs:
            return ()
        return ("tau",) if self.forward else ("udot",)

    @property
    def branching(self) -> dict[int, int]:
        """Bodies with several children, numbered: the first child of a body stands behind it."""
        several = {b.parent for i, b in enumerate(self.bodies) if 0 <= b.parent < i - 1}
        return {body: number for number, body in enumerate(sorted(several))}

    def ends(self) -> list[int]:
        """The speed behind those that a body carries, of every body."""
        ends = [body.first + body.speeds for body in self.bodies]
        for i in range(len(ends) - 1, -1, -1):
            parent = self.bodies[i].parent
            if parent >= 0:
                ends[parent] = max(ends[parent], ends[i])
        return ends

    def table(self) -> tuple[int, ...]:
        """All rows, one behind the other, with what follows from them."""
        branching = self.branching
        bodies = [
            (*body, end, branching.get(i, -1))
            for i, (body, end) in enumerate(zip(self.bodies, self.ends(), strict=True))
        ]
        joints = [body.first for body in self.bodies for _ in range(body.speeds)]
        of_slot = {speed.slot: k for k, speed in enumerate(self.speeds)}
        speeds = [(*speed, joints[k], of_slot[k]) for k, speed in enumerate(self.speeds)]
        changes = sorted(self.changes, key=lambda entry: entry.column)
        rows = (*bodies, *speeds, *self.outputs, *changes, *self.rotors)
        return tuple(number for row in rows for number in row)


def chunks(count: int) -> int:
    """A number rounded up to full chunks."""
    return -(-count // CHUNK) * CHUNK
