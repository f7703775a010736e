"""Rows of a table of which many are alike: told by their pattern, made when they are asked for.

A manifest has a row for every coordinate. Where a beam has a hundred thousand nodes their rows
differ by a number only; they are kept as a :class:`Run` and read like any others.
"""

from __future__ import annotations

import base64
from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from typing import Any, Generic, TypeVar, final, overload

import numpy as np
from numpy.typing import NDArray

from .fields import SIZES, Kind, Misfit, Record, dumped, integer_from, listed

R = TypeVar("R", bound=Record)
# the key of an entry of a pattern that differs from row to row
TEXT, INTEGER, VALUE = "text", "integer", "value"
TYPES: Mapping[str, list[list[type]]] = {
    TEXT: [[str, int, str]],
    INTEGER: [[int, int], [int, int, int]],
    VALUE: [[int]],
}
# repetitions of which rows are made at once
SOME = 1024
SCHEMA: Mapping[str, Any] = {
    "type": "object",
    "description": "Instead of a list: rows that are there, then runs of rows that repeat a "
    "pattern, where beams have more than 1000 nodes inside. Entries of a pattern are plain, or of "
    "repetition k: {text: [before, first, behind]}, {integer: [first, step]} or {integer: "
    "[first, step, size]} (the pair of both), {value: column}. Values are little-endian doubles "
    "in base 64, (count, columns).",
    "properties": {
        "listed": {"type": "array"},
        "runs": {
            "type": "array",
            "items": {
                "type": "object",
                "properties": {
                    "count": {"type": "integer", "minimum": 1},
                    "pattern": {"type": "array", "items": {"type": "object"}, "minItems": 1},
                    "values": {"type": "string"},
                },
                "required": ["count", "pattern", "values"],
                "additionalProperties": False,
            },
        },
    },
    "required": ["listed", "runs"],
    "additionalProperties": False,
}


class Run(Generic[R]):
    """Rows that repeat a pattern.

    Args:
        record: What rows are.
        count: How often.
        pattern: Rows whose entries are plain, or of repetition k = 0, 1, ... one of
            ``{"text": [before, first, behind]}``: before, the number first + k, behind;
            ``{"integer": [first, step]}`` and ``{"integer": [first, step, size]}``: the integer
            first + k step, or the pair of it and the size; ``{"value": column}``: of ``values``.
        values: (count, columns).
        saved: Whether they are of a saved run.

    Raises:
        Misfit: the first or the last row of an entry of the pattern is not one.
    """

    def __init__(
        self,
        record: type[R],
        count: int,
        pattern: Sequence[Mapping[str, Any]],
        values: NDArray[np.float64],
        saved: bool = False,
    ) -> None:
        self.record, self.count, self.values = record, count, values
        self.pattern = tuple({k: x for k, x in row.items() if x is not None} for row in pattern)
        for entry in (entry for row in self.pattern for entry in row.values() if _varies(entry)):
            _fit(entry)
        # in between numbers only grow or fall
        for k in (count - 1, 0):
            rows = [record.read(self._plain(row, k), saved) for row in self.pattern]
        self._constant = [vars(row) for row in rows]
        self._changing = [
            {key: entry for key, entry in row.items() if _varies(entry) and key in vars(first)}
            for row, first in zip(self.pattern, rows, strict=True)
        ]

    def __len__(self) -> int:
        return self.count * len(self.pattern)

    def _plain(self, row: Mapping[str, object], k: int) -> dict[str, Any]:
        """A row as JSON would have it."""
        which = range(k, k + 1)
        entries = {key: self._entries(entry, which)[0] for key, entry in row.items()}
        return {key: list(x) if isinstance(x, tuple) else x for key, x in entries.items()}

    def row(self, number: int) -> R:
        """One of its rows."""
        k, one = divmod(number, len(self.pattern))
        which = range(k, k + 1)
        entries = {key: self._entries(x, which)[0] for key, x in self._changing[one].items()}
        return self.record.trusted({**self._constant[one], **entries})

    def _entries(self, entry: object, which: range) -> list[Any]:
        """An entry of one row of the pattern in some repetitions."""
        rule: Mapping[str, Any] = entry if isinstance(entry, dict) else {}
        if TEXT in rule:
            before, first, behind = rule[TEXT]
            return [f"{before}{first + k}{behind}" for k in which]
        if INTEGER in rule:
            first, step, *size = rule[INTEGER]
            integers = [first + k * step for k in which]
            return [(k, *size) for k in integers] if size else integers
        if VALUE in rule:
            some: list[Any] = self.values[which.start : which.stop, rule[VALUE]].tolist()
            return some
        return [entry] * len(which)

    def __iter__(self) -> Iterator[R]:
        for start in range(0, self.count, SOME):
            which = range(start, min(start + SOME, self.count))
            columns = []
            for constant, changing in zip(self._constant, self._changing, strict=True):
                entries = [self._entries(entry, which) for entry in changing.values()]
                rows = zip(*entries, strict=True) if entries else ((),) * len(which)
                columns.append([{**constant, **dict(zip(changing, x, strict=True))} for x in rows])
            for some in zip(*columns, strict=True):
                yield from map(self.record.trusted, some)

    def column(self, key: str) -> list[Any]:
        """The entries of a key in all rows, None where a row has none."""
        entries: list[Any] = [None] * len(self)
        for one, (constant, changing) in enumerate(
            zip(self._constant, self._changing, strict=True)
        ):
            entry = changing.get(key, constant.get(key))
            entries[one :: len(self.pattern)] = self._entries(entry, range(self.count))
        return entries

    @property
    def ends(self) -> list[R]:
        """The first and the last row of every kind."""
        kinds = len(self.pattern)
        return [self.row(k) for k in (*range(kinds), *range(len(self) - kinds, len(self)))]

    def plain(self) -> dict[str, Any]:
        """JSON form: values are the bytes of little-endian doubles in base 64."""
        values = base64.b64encode(self.values.astype("<f8").tobytes()).decode()
        return {"count": self.count, "pattern": list(self.pattern), "values": values}

    @staticmethod
    def of(data: Mapping[str, Any], record: type[R], saved: bool = False) -> Run[R]:
        """From JSON.

        Raises:
            ValueError, KeyError, TypeError, AttributeError, IndexError: it is damaged.
        """
        count = data["count"]
        values = np.frombuffer(base64.b64decode(data["values"]), "<f8").astype(np.float64)
        if not (_is_count(count) and data["pattern"]):
            raise Misfit("is a run of rows without rows, or of too many")
        return Run(record, count, data["pattern"], values.reshape(count, -1), saved)


# repetitions of a pattern
_is_count = integer_from(1, SIZES)


def _fit(entry: Mapping[str, object]) -> None:
    """Make sure that what differs from row to row is counted: texts times numbers are texts, too.

    Raises:
        Misfit: it is of other types.
    """
    for rule, what in entry.items():
        types = [type(one) for one in what] if isinstance(what, list | tuple) else [type(what)]
        if types not in TYPES.get(rule, []):
            raise Misfit(f"has a run of rows with the entry {entry!r:.60}")


def _varies(entry: object) -> bool:
    return isinstance(entry, dict) and not entry.keys().isdisjoint((TEXT, INTEGER, VALUE))


@final
class Rows(Sequence[R]):
    """Rows that are there, then runs of others.

    Args:
        listed: The first rows.
        runs: The others.
    """

    def __init__(self, listed: Sequence[R], runs: Sequence[Run[R]]) -> None:
        self.listed, self.runs = list(listed), tuple(runs)
        self._starts = np.cumsum([len(self.listed), *map(len, self.runs)])

    def __len__(self) -> int:
        return int(self._starts[-1])

    @overload
    def __getitem__(self, number: int) -> R: ...

    @overload
    def __getitem__(self, number: slice) -> list[R]: ...

    def __getitem__(self, number: int | slice) -> R | list[R]:
        if isinstance(number, slice):
            return [self[k] for k in range(*number.indices(len(self)))]
        k = number + len(self) if number < 0 else number
        if not 0 <= k < len(self):
            raise IndexError(number)
        if k < len(self.listed):
            return self.listed[k]
        run = int(np.searchsorted(self._starts, k, side="right")) - 1
        return self.runs[run].row(int(k - self._starts[run]))

    def __iter__(self) -> Iterator[R]:
        yield from self.listed
        for run in self.runs:
            yield from run

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Rows) and dumped(self) == dumped(other)

    __hash__ = None  # type: ignore[assignment]

    @property
    def ends(self) -> list[R]:
        """The listed rows, and the first and the last of each kind of the others."""
        return [*self.listed, *(row for run in self.runs for row in run.ends)]

    def plain(self) -> dict[str, Any]:
        """JSON form."""
        return {"listed": self.listed, "runs": self.runs}


def column(rows: Sequence[Record], key: str) -> list[Any]:
    """The entries of a key in all rows, None where a row has none."""
    if not isinstance(rows, Rows):
        return [getattr(row, key, None) for row in rows]
    return [
        *(getattr(row, key, None) for row in rows.listed),
        *(entry for run in rows.runs for entry in run.column(key)),
    ]


def having(rows: Sequence[R], key: str) -> Iterator[R]:
    """Rows in which a key says something; runs that say nothing are passed over."""
    parts: list[Iterable[R]] = [rows]
    if isinstance(rows, Rows):
        parts = [rows.listed, *rows.runs]
    for part in parts:
        if not isinstance(part, Run) or any(row.get(key) for row in part.pattern):
            yield from (row for row in part if getattr(row, key, None))


def among(rows: Sequence[R], key: str, values: Container[object]) -> Iterator[R]:
    """Rows in which a key has one of some values; runs in which it has others are passed over."""
    parts: list[Iterable[R]] = [rows]
    if isinstance(rows, Rows):
        parts = [rows.listed, *rows.runs]
    for part in parts:
        if not isinstance(part, Run) or any(
            _varies(entry := row.get(key)) or entry in values for row in part.pattern
        ):
            yield from (row for row in part if getattr(row, key, None) in values)


def ends(rows: Sequence[R]) -> Sequence[R]:
    """The rows that say what all are: of runs the first and the last of each kind."""
    return rows.ends if isinstance(rows, Rows) else rows


def rows_of(record: type[R]) -> Kind:
    """Rows as a list, or as what repeats."""
    plain_rows = listed(record)

    def read(value: object, run: bool) -> Sequence[R]:
        if not (isinstance(value, dict) and value.keys() == {"listed", "runs"}):
            return list(plain_rows.read(value, run))
        try:
            runs = [Run.of(data, record, run) for data in value["runs"]]
        except Misfit:
            raise
        except (
            ValueError,
            KeyError,
            TypeError,
            AttributeError,
            IndexError,
            OverflowError,
        ) as error:
            raise Misfit(f"has a run of rows that is damaged: {error!r}") from error
        return Rows(plain_rows.read(value["listed"], run), runs)

    return Kind(read, {"anyOf": [plain_rows.schema, {"$ref": "#/$defs/runs"}]})
