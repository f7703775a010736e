"""The binomial schedule: a run reversed with few checkpoints, and as few repeated steps as can be.

With c checkpoints, that of the start among them, and every step taken at most r times before it is
reversed, binomial(c + r, c) steps can be reversed. A run of l steps is split so that both parts are
of this kind: the first with r - 1 repeats and all checkpoints, the second with one checkpoint less.

Source: A. Griewank, A. Walther, Algorithm 799: Revolve, ACM TOMS 26 (2000) 19-45.
"""

from __future__ import annotations

from collections.abc import Iterator
from enum import Enum
from math import comb
from typing import NamedTuple


class Action(Enum):
    """What to do with a run."""

    RESUME = "resume"  # from the last checkpoint, which is at `step`
    ADVANCE = "advance"  # to `step`, without rows
    STORE = "store"  # a checkpoint at `step`
    REVERSE = "reverse"  # take the step from `step` with rows, and reverse it


class Move(NamedTuple):
    """A part of a schedule.

    Attributes:
        action: What is done.
        step: Where, or to where.
    """

    action: Action
    step: int


def repeats(steps: int, checkpoints: int) -> int:
    """The smallest r with binomial(c + r, c) not less than a number of steps."""
    r = 0
    while comb(checkpoints + r, checkpoints) < steps:
        r += 1
    return r


def repeated_steps(steps: int, checkpoints: int) -> int:
    """The least number of steps taken without rows, t(l, c) = r l - binomial(c + r, r - 1)."""
    r = repeats(steps, checkpoints)
    return r * steps - comb(checkpoints + r, r - 1) if r else 0


def schedule(steps: int, checkpoints: int) -> Iterator[Move]:
    """Reverse a run, from a checkpoint at its start, where it stands.

    Args:
        steps: Of the run, at least 1.
        checkpoints: How many there may be at a time, with that of the start: at least 1.
    """
    stored, at, end = [0], 0, steps
    while end > 0:
        if at != stored[-1]:
            at = stored[-1]
            yield Move(Action.RESUME, at)
        while end - at > 1:
            free = checkpoints - len(stored) + 1
            at += _ahead(end - at, free)
            yield Move(Action.ADVANCE, at)
            if free == 1:
                break
            stored.append(at)
            yield Move(Action.STORE, at)
        yield Move(Action.REVERSE, end - 1)
        end, at = end - 1, end
        if stored[-1] == end:
            stored.pop()


def _ahead(steps: int, free: int) -> int:
    """Steps to the next checkpoint, of several steps with so many of them, the present one too."""
    if free == 1:
        return steps - 1
    r = repeats(steps, free)
    # the parts on both sides are not longer than r - 1 and r repeats reverse
    return min(comb(free + r - 1, free), steps - comb(free + r - 2, free - 1))
