"""Rows of a table of which many are alike: told by their pattern, made when they are asked for.

A manifest has a row for every coordinate. Where a beam has a hundred thousand nodes their rows
differ by a number only; they are kept as a :class:`Run` and read like any others.
"""

from __future__ import annotations

import base64
import json
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, final, overload

import numpy as np
from numpy.typing import NDArray

Row = dict[str, Any]
# the key of an entry of a pattern that differs from row to row
TEXT, INTEGER, VALUE = "text", "integer", "value"
# repetitions of which rows are made at once
SOME = 1024


@dataclass(frozen=True, eq=False)
class Run:
    """Rows that repeat a pattern.

    Attributes:
        count: How often.
        pattern: Rows whose entries are plain, or of repetition k = 0, 1, ... one of
            ``{"text": [before, first, behind]}``: before, the number first + k, behind;
            ``{"integer": [first, step]}`` and ``{"integer": [first, step, size]}``: the integer
            first + k step, or the pair of it and the size; ``{"value": column}``: of ``values``.
        values: (count, columns).
    """

    count: int
    pattern: tuple[Row, ...]
    values: NDArray[np.float64]

    def __len__(self) -> int:
        return self.count * len(self.pattern)

    def row(self, number: int) -> Row:
        """One of its rows."""
        k, one = divmod(number, len(self.pattern))
        return {key: self._entry(entry, k) for key, entry in self.pattern[one].items()}

    def _entry(self, entry: Any, k: int) -> Any:
        return self._entries(entry, range(k, k + 1))[0]

    def _entries(self, entry: Any, which: range) -> list[Any]:
        """An entry of one row of the pattern in some repetitions."""
        told: Mapping[str, Any] = entry if isinstance(entry, dict) else {}
        if TEXT in told:
            before, first, behind = told[TEXT]
            return [f"{before}{first + k}{behind}" for k in which]
        if INTEGER in told:
            first, step, *size = told[INTEGER]
            found = [first + k * step for k in which]
            return [[k, *size] for k in found] if size else found
        if VALUE in told:
            some: list[Any] = self.values[which.start : which.stop, told[VALUE]].tolist()
            return some
        return [entry] * len(which)

    def __iter__(self) -> Iterator[Row]:
        for start in range(0, self.count, SOME):
            which = range(start, min(start + SOME, self.count))
            made = [
                [dict(zip(row, entries, strict=True)) for entries in zip(*columns, strict=True)]
                for row in self.pattern
                for columns in [[self._entries(entry, which) for entry in row.values()]]
            ]
            for rows in zip(*made, strict=True):
                yield from rows

    def column(self, key: str) -> list[Any]:
        """The entries of a key in all rows, None where a row has none."""
        found: list[Any] = [None] * len(self)
        for one, row in enumerate(self.pattern):
            found[one :: len(self.pattern)] = self._entries(row.get(key), range(self.count))
        return found

    def plain(self) -> Row:
        """As JSON has it: values are the bytes of little-endian doubles in base 64."""
        values = base64.b64encode(self.values.astype("<f8").tobytes()).decode()
        return {"count": self.count, "pattern": list(self.pattern), "values": values}

    @staticmethod
    def of(told: Mapping[str, Any]) -> Run:
        """From JSON.

        Raises:
            ValueError, KeyError, TypeError, AttributeError, IndexError: it is damaged.
        """
        count = int(told["count"])
        values = np.frombuffer(base64.b64decode(told["values"]), "<f8").astype(np.float64)
        if count <= 0 or not told["pattern"]:
            raise ValueError("a run of rows without rows")
        made = Run(count, tuple(told["pattern"]), values.reshape(count, -1))
        # a pattern that cannot be read is found now, not when somebody asks for a row
        for k in range(len(made.pattern)):
            made.row(k)
        return made


@final
class Rows(Sequence[Row]):
    """Rows that are there, then runs of others.

    Args:
        listed: The first rows.
        runs: The others.
    """

    def __init__(self, listed: Sequence[Row], runs: Sequence[Run]) -> None:
        self.listed, self.runs = list(listed), tuple(runs)
        self._starts = np.cumsum([len(self.listed), *map(len, self.runs)])

    def __len__(self) -> int:
        return int(self._starts[-1])

    @overload
    def __getitem__(self, number: int) -> Row: ...

    @overload
    def __getitem__(self, number: slice) -> list[Row]: ...

    def __getitem__(self, number: int | slice) -> Row | list[Row]:
        if isinstance(number, slice):
            return [self[k] for k in range(*number.indices(len(self)))]
        k = number + len(self) if number < 0 else number
        if not 0 <= k < len(self):
            raise IndexError(number)
        if k < len(self.listed):
            return self.listed[k]
        run = int(np.searchsorted(self._starts, k, side="right")) - 1
        return self.runs[run].row(int(k - self._starts[run]))

    def __iter__(self) -> Iterator[Row]:
        yield from self.listed
        for run in self.runs:
            yield from run

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Rows) and self.plain() == other.plain()

    __hash__ = None  # type: ignore[assignment]

    @property
    def kinds(self) -> list[Row]:
        """The listed rows, and the first of each kind of the others."""
        firsts = (run.row(k) for run in self.runs for k in range(len(run.pattern)))
        return [*self.listed, *firsts]

    def plain(self) -> dict[str, Any]:
        """As JSON has it."""
        return {"listed": self.listed, "runs": [run.plain() for run in self.runs]}


def column(rows: Sequence[Row], key: str) -> list[Any]:
    """The entries of a key in all rows, None where a row has none."""
    if not isinstance(rows, Rows):
        return [row.get(key) for row in rows]
    return [
        *(row.get(key) for row in rows.listed),
        *(entry for run in rows.runs for entry in run.column(key)),
    ]


def having(rows: Sequence[Row], key: str) -> Iterator[Row]:
    """Rows in which a key says something; runs that say nothing are passed over."""
    parts: list[Iterable[Row]] = [rows]
    if isinstance(rows, Rows):
        parts = [rows.listed, *rows.runs]
    for part in parts:
        if not isinstance(part, Run) or any(row.get(key) for row in part.pattern):
            yield from (row for row in part if row.get(key))


def dumped(data: Any, **options: Any) -> str:
    """Data with such rows as JSON."""
    return json.dumps(data, default=_plain, **options)


def _plain(rows: Any) -> Any:
    if isinstance(rows, Rows):
        return rows.plain()
    raise TypeError(f"{type(rows).__name__} cannot be written as JSON")


def opened(data: Any) -> Any:
    """What JSON holds with its runs as rows.

    Raises:
        ValueError: a run is damaged.
    """
    if not isinstance(data, dict):
        return data
    try:
        return {key: _opened(entry) for key, entry in data.items()}
    except (KeyError, TypeError, AttributeError, IndexError, OverflowError) as error:
        raise ValueError(f"a run of rows is damaged: {error!r}") from error


def _opened(entry: Any) -> Any:
    if isinstance(entry, dict) and entry.keys() == {"listed", "runs"}:
        return Rows(entry["listed"], [Run.of(run) for run in entry["runs"]])
    return entry
