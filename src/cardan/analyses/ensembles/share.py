"""Parts of an ensemble: which of its runs one of several jobs computes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ...errors import ArgumentError, ModelError, brief, counted
from ...records import dataclass

Block = tuple[int, int]
SUCH = "give (k, n), part k of n, such as part=(3, 8); parts are counted from 1 to n"


@dataclass(frozen=True)
class Share:
    """A part of the runs of an ensemble.

    Attributes:
        number, count: Part number ``number`` of ``count``, from 1 on.
        first, last: Number of its first run, and of the run behind its last one, in the whole.
        runs: Of the whole ensemble.
    """

    number: int
    count: int
    first: int
    last: int
    runs: int

    def __str__(self) -> str:
        return f"part {self.number} of {self.count}"

    def __len__(self) -> int:
        return self.last - self.first

    @property
    def undivided(self) -> bool:
        """True where it is all there is."""
        return self.count == 1


def part_of(part: object) -> tuple[int, int] | None:
    """Number of a part and of all parts, as a user says them; None where nothing is said.

    Raises:
        ArgumentError: they are none.
    """
    if part is None:
        return None
    pair = tuple(part) if isinstance(part, tuple | list) else ()
    integers = all(isinstance(x, int | np.integer) and not isinstance(x, bool) for x in pair)
    if len(pair) != 2 or not integers or not 1 <= pair[0] <= pair[1]:
        raise ArgumentError(f"part={brief(part)}: {SUCH}")
    return int(pair[0]), int(pair[1])


def share_of(
    part: tuple[int, int], blocks: Sequence[Block], name: str
) -> tuple[Share, list[Block]]:
    """A part, and its blocks by the numbers that its runs have in it.

    Blocks are never divided: statistics over runs have the same bits however many parts there are.

    Args:
        part: Its number, and that of all parts.
        blocks: First and last run of every block of the whole ensemble.
        name: Of the model.

    Raises:
        ModelError: there are fewer blocks than parts.
    """
    number, count = part
    runs, total = blocks[-1][1], len(blocks)
    if count > total:
        raise ModelError(
            f"part={part}: the {counted(runs, 'run')} of '{name}' are done in "
            f"{counted(total, 'block')}, so that there are at most {counted(total, 'part')}: "
            f"take fewer, part=(k, {total})"
        )
    chosen = blocks[(number - 1) * total // count : number * total // count]
    share = Share(number, count, chosen[0][0], chosen[-1][1], runs)
    return share, [(first - share.first, last - share.first) for first, last in chosen]
