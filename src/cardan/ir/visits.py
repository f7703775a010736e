"""Evaluation of recursions in Python, visit by visit."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cached_property
from itertools import chain, repeat
from operator import itemgetter
from typing import TYPE_CHECKING, NamedTuple

from .function import Function, Output
from .interpreter import evaluate
from .recursion import STORE, Recursion, Turns, Visit
from .straight_line import OFTEN, Floats, read, repeated, straight_line

if TYPE_CHECKING:
    from ..arrays import Array

# states up to which a visit of each takes less than one of arrays
SINGLE = 40
# gives the entries of a block at some places
Places = Callable[[Sequence[object]], Sequence[float]]


class _Run(NamedTuple):
    """A visit, ready to be run.

    Attributes:
        step: Number of the step.
        reads: (block, places) of what it reads, in the order of the inputs of the step.
        stores, outs: As of :class:`.recursion.Visit`.
    """

    step: int
    reads: tuple[tuple[str, Places], ...]
    stores: Sequence[int]
    outs: Sequence[int]


class RepeatedRecursion:
    """A recursion for many calls: its visits are laid out once, its steps become straight lines.

    Args:
        recursion: The recursion.
    """

    def __init__(self, recursion: Recursion) -> None:
        self.recursion = recursion
        self._blocks = [read(step) for step in recursion.steps]
        self._used = {name for names in self._blocks for name in names}

    def __call__(self, values: Mapping[str, Floats]) -> dict[str, list[float]]:
        """Output name -> its entries, row by row, for block name -> its entries.

        Raises:
            ValueError: a block is missing or has another length. SolveError: as of its steps.
        """
        self._check({name: len(value) for name, value in values.items()})
        room = [0.0] * self.recursion.size
        results = [0.0] * sum(o.size for o in self.recursion.outputs)
        blocks: dict[str, Sequence[float]] = {**values, STORE: room}
        lines = self._lines
        for step, reads, stores, outs in self._runs:
            numbers = lines[step](*[places(blocks[name]) for name, places in reads])
            for place, number in zip(stores, numbers, strict=False):
                room[place] = number
            for place, number in zip(outs, numbers[len(stores) :], strict=True):
                results[place] = number
        return self._by_name(results)

    def over(self, values: Mapping[str, object]) -> dict[str, Array]:
        """Output name -> an array (..., *shape), for arrays (..., n) of block name -> entries.

        The leading axes are those of the blocks that visits read.
        """
        import numpy as np

        arrays = {name: np.asarray(x) for name, x in values.items() if name in self._used}
        self._check({name: x.shape[-1] for name, x in arrays.items()})
        kind = np.result_type(np.float64, *arrays.values())
        batch = np.broadcast_shapes(*(x.shape[:-1] for x in arrays.values() if x.shape[-1]))
        if kind == np.float64 and math.prod(batch) <= SINGLE:
            return self._one_by_one(arrays, batch)
        blocks: dict[str, Sequence[object]] = {
            name: list(np.moveaxis(x, -1, 0)) for name, x in arrays.items()
        }
        blocks[STORE] = room = [np.zeros((), kind)] * self.recursion.size
        results = [np.zeros((), kind)] * sum(o.size for o in self.recursion.outputs)
        for step, reads, stores, outs in self._runs:
            inputs = {
                name: np.stack(np.broadcast_arrays(*places(blocks[name])), axis=-1)
                for name, places in reads
            }
            stored, outcome = evaluate(self.recursion.steps[step], inputs, "numpy").values()
            for k, place in enumerate(stores):
                room[place] = stored[..., k]
            for k, place in enumerate(outs):
                results[place] = outcome[..., k]
        flat = [np.broadcast_to(x, batch) for x in results]
        return {
            o.name: np.stack(flat[at : at + o.size], axis=-1).reshape((*batch, *o.shape))
            if o.size
            else np.zeros((*batch, *o.shape), kind)
            for at, o in self._starts
        }

    def _one_by_one(self, arrays: Mapping[str, Array], batch: tuple[int, ...]) -> dict[str, Array]:
        """The same for few states: floats, one after another."""
        import numpy as np

        count = math.prod(batch)
        wide = {
            name: [x.tolist()] * count
            if x.ndim == 1
            else np.broadcast_to(x, (*batch, x.shape[-1])).reshape(count, x.shape[-1]).tolist()
            for name, x in arrays.items()
        }
        rows = [self({name: x[k] for name, x in wide.items()}) for k in range(count)]
        return {
            o.name: np.reshape([row[o.name] for row in rows], (*batch, *o.shape)).astype(float)
            for o in self.recursion.outputs
        }

    def _check(self, sizes: Mapping[str, int]) -> None:
        """Refuse blocks that are missing or have another length.

        Raises:
            ValueError: see above.
        """
        name = self.recursion.name
        for block in self.recursion.inputs:
            if block.name in self._used and block.name not in sizes:
                available = ", ".join(sorted(sizes)) or "none"
                raise ValueError(
                    f"function '{name}' reads block '{block.name}'; given: {available}"
                )
            if block.name in self._used and sizes[block.name] != len(block):
                raise ValueError(
                    f"block '{block.name}' of function '{name}' has {len(block)} entries, not "
                    f"{sizes[block.name]}"
                )

    @property
    def _starts(self) -> list[tuple[int, Output]]:
        starts, at = [], 0
        for output in self.recursion.outputs:
            starts.append((at, output))
            at += output.size
        return starts

    def _by_name(self, results: list[float]) -> dict[str, list[float]]:
        return {o.name: results[at : at + o.size] for at, o in self._starts}

    @cached_property
    def _runs(self) -> list[_Run]:
        """All visits in their order."""
        parts = chain.from_iterable(sweep.parts for sweep in self.recursion.sweeps)
        return list(chain.from_iterable(map(self._runs_of, parts)))

    def _runs_of(self, part: Visit | Turns) -> Iterable[_Run]:
        """The visits of a part, those of turns from one table."""
        turns = part if isinstance(part, Turns) else Turns((part,), (part,), 1)
        columns = []
        for visit, stride in zip(turns.visits, turns.strides, strict=True):
            names = self._blocks[visit.step]
            tables = [
                [(name, _places(entries)) for entries in _ahead(visit, stride, name, turns.times)]
                for name in names
            ]
            reads = zip(*tables, strict=True) if tables else repeat((), turns.times)
            stores = _rows(visit.stores, stride.stores, turns.times)
            outs = _rows(visit.outs, stride.outs, turns.times)
            columns.append(map(_Run, repeat(visit.step), reads, stores, outs))
        return chain.from_iterable(zip(*columns, strict=True))

    @cached_property
    def _lines(self) -> list[Callable[..., list[float]]]:
        """The work of a visit of every step: straight lines where that pays."""
        runs = [0] * len(self.recursion.steps)
        for run in self._runs:
            runs[run.step] += 1
        return [
            straight_line(step) if count >= OFTEN else _interpreted(step)
            for step, count in zip(self.recursion.steps, runs, strict=True)
        ]


def repeated_recursion(recursion: Recursion) -> RepeatedRecursion:
    """A recursion for many calls: the same one every time."""
    cache: dict[str, RepeatedRecursion] = recursion.__dict__
    if "_repeated" not in cache:
        cache["_repeated"] = RepeatedRecursion(recursion)
    return cache["_repeated"]


def _ahead(visit: Visit, stride: Visit, block: str, times: int) -> list[list[int]]:
    """Entries of a block that the visits of all turns read."""
    return _rows(visit.reads[block], stride.reads[block], times)


def _rows(first: Sequence[int], stride: Sequence[int], times: int) -> list[list[int]]:
    """Places of the first turn and of those that follow."""
    if times == 1:
        return [list(first)]
    import numpy as np

    turns = np.arange(times)[:, None]
    rows: list[list[int]] = (
        np.array(first, np.int64) + turns * np.array(stride, np.int64)
    ).tolist()
    return rows


def _places(entries: Sequence[int]) -> Places:
    """Getter of the entries of a block at places."""
    first, count = entries[0], len(entries)
    # a single one, too, must come as a sequence
    if count == 1 or list(entries) == list(range(first, first + count)):
        return itemgetter(slice(first, first + count))
    return itemgetter(*entries)


def _interpreted(step: Function) -> Callable[..., list[float]]:
    """A step that few visits run: interpreted until that does not pay."""
    line, blocks = repeated(step), read(step)

    def results(*values: Floats) -> list[float]:
        named = line(dict(zip(blocks, values, strict=True)))
        return [x for output in step.outputs for x in named[output.name]]

    return results
