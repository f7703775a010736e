"""Visits as rows of numbers, and those at regular distances as turns: tables that do not grow."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import chain
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from .recursion import Turns, Visit

# visits of the longest turn that is looked for: joints whose axes alternate
LONGEST = 6
# turns from which it pays to tell them as such
FEWEST = 4


class Layout(NamedTuple):
    """Meaning of the numbers of the visits of a step.

    Attributes:
        blocks: (name, number of entries) of the blocks that they read, in order.
        stores, outs: Numbers of places and results that they write.
    """

    blocks: tuple[tuple[str, int], ...]
    stores: int
    outs: int

    @classmethod
    def of(cls, visit: Visit) -> Layout:
        blocks = tuple([(name, len(places)) for name, places in visit.reads.items()])
        return cls(blocks, len(visit.stores), len(visit.outs))

    @property
    def width(self) -> int:
        return sum(count for _, count in self.blocks) + self.stores + self.outs

    def visit(self, step: int, numbers: Sequence[int]) -> Visit:
        """The visit, or the stride, of a row of numbers."""
        reads, at = {}, 0
        for name, count in self.blocks:
            reads[name] = tuple(numbers[at : at + count])
            at += count
        end = at + self.stores
        return Visit(step, reads, tuple(numbers[at:end]), tuple(numbers[end : end + self.outs]))


class VisitRows(NamedTuple):
    """Visits in their order.

    Attributes:
        bodies: Whose they are.
        kinds: Of every visit, which step and layout.
        rows: Of every visit its numbers, zeros behind them.
        steps: Step and layout of a kind.
    """

    bodies: npt.NDArray[np.int64]
    kinds: npt.NDArray[np.int64]
    rows: npt.NDArray[np.int64]
    steps: tuple[tuple[int, Layout], ...]

    @classmethod
    def joined(
        cls, parts: Sequence[tuple[npt.NDArray[np.int64], int, Layout, npt.NDArray[np.int64]]]
    ) -> VisitRows:
        """Visits of (bodies, step, layout, a row for each body), in the order of the bodies."""
        width = max((layout.width for _, _, layout, _ in parts), default=0)
        bodies = np.concatenate([np.zeros(0, dtype=np.int64), *(part[0] for part in parts)])
        rows = np.zeros((len(bodies), width), dtype=np.int64)
        kinds, at = np.empty(len(bodies), dtype=np.int64), 0
        steps = dict.fromkeys((step, layout) for _, step, layout, _ in parts)
        number = {key: n for n, key in enumerate(steps)}
        for members, step, layout, of_members in parts:
            end = at + len(members)
            rows[at:end, : layout.width] = of_members
            kinds[at:end] = number[step, layout]
            at = end
        order = np.argsort(bodies, kind="stable")
        return cls(bodies[order], kinds[order], rows[order], tuple(steps))

    def reversed(self) -> VisitRows:
        """The same visits from the last to the first."""
        return VisitRows(self.bodies[::-1], self.kinds[::-1], self.rows[::-1], self.steps)

    def turns(self) -> tuple[Visit | Turns, ...]:
        """The visits, repeated ones as turns."""
        count = len(self.kinds)
        times = np.array([self._times(n) for n in range(1, LONGEST + 1)]).reshape(LONGEST, count)
        lengths = np.where(times >= FEWEST, times, 0) * np.arange(1, LONGEST + 1)[:, None]
        longest = lengths.argmax(axis=0)
        parts: list[Visit | Turns] = []
        at = 0
        while at < count:
            n = int(longest[at])
            length = int(lengths[n, at])
            if length:
                parts.append(self._turns(at, n + 1, int(times[n, at])))
                at += length
            else:
                parts.append(self._visit(at, self.rows[at]))
                at += 1
        return tuple(parts)

    def _times(self, n: int) -> npt.NDArray[np.int64]:
        """Repetitions of the n visits from every visit on, at regular distances."""
        count, times = len(self.kinds), np.ones(len(self.kinds), dtype=np.int64)
        if count <= n:
            return times
        alike = self.kinds[n:] == self.kinds[:-n]
        strides = self.rows[n:] - self.rows[:-n]
        regular = np.zeros(max(count - 2 * n, 0), dtype=bool)
        if count > 2 * n:
            regular = alike[n:] & alike[:-n] & (strides[n:] == strides[:-n]).all(axis=1)
        repeated = _run(alike, count) >= n
        return np.where(repeated, 2 + _run(regular, count) // n, times)

    def _visit(self, at: int, numbers: npt.NDArray[np.int64]) -> Visit:
        step, layout = self.steps[int(self.kinds[at])]
        row: list[int] = numbers.tolist()
        return layout.visit(step, row)

    def _turns(self, at: int, n: int, times: int) -> Turns:
        visits = [self._visit(k, self.rows[k]) for k in range(at, at + n)]
        strides = [self._visit(k, self.rows[k + n] - self.rows[k]) for k in range(at, at + n)]
        return Turns(tuple(visits), tuple(strides), times)


def _run(true: npt.NDArray[np.bool_], count: int) -> npt.NDArray[np.int64]:
    """Number of places that are true from every place on without a break."""
    places = np.arange(count)
    complete = np.zeros(count, dtype=bool)
    complete[: len(true)] = true
    broken = np.where(complete, count, places)
    return np.minimum.accumulate(broken[::-1])[::-1] - places


def as_turns(visits: Iterable[Visit]) -> tuple[Visit | Turns, ...]:
    """Visits in their order, repeated ones as turns."""
    alike: dict[tuple[int, Layout], tuple[list[int], list[list[int]]]] = {}
    for k, visit in enumerate(visits):
        numbers = [*chain.from_iterable(visit.reads.values()), *visit.stores, *visit.outs]
        places, rows = alike.setdefault((visit.step, Layout.of(visit)), ([], []))
        places.append(k)
        rows.append(numbers)
    parts = [
        (np.array(k), step, layout, np.array(rows, dtype=np.int64).reshape(len(k), layout.width))
        for (step, layout), (k, rows) in alike.items()
    ]
    return VisitRows.joined(parts).turns()
