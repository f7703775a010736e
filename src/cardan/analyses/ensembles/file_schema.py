"""Checks of an ensemble file before anything of it is used."""

from __future__ import annotations

import dataclasses
import json
import math
from collections.abc import Iterable, Mapping, Sequence
from itertools import takewhile
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...arrays import Array
from ...records import dataclass
from ...runtime.formats.contents import Contents, Variable
from ...schema.fields import Record, count, field, is_text, listed, number, one_of, table, text
from .lane_runner import NUMBERS
from .reductions import Bins

NOTES = ("messages", "ensemble")
MOST = 127  # words of a status
AXES = ("run", "time", "entry", "bin")


class Notes(Record):
    """Description of an ensemble in its file."""

    model: str = field(text)
    method: str = field(text)
    settings: str = field(text)
    hands: str = field(text)
    reason: str = field(text)
    kept: str = field(text)
    entries: Sequence[str] = field(listed(text))
    counts: Sequence[int] | None = field(listed(count, 2), default=None)
    start: float = field(number)
    end: float = field(number)
    names: Sequence[str] = field(listed(text))
    lanes: int = field(count)
    axes: Mapping[str, Sequence[str]] = field(table(listed(one_of(*AXES))))
    words: Sequence[str] = field(listed(text))
    seconds: float = field(number)
    restored: int = field(count)
    share: Sequence[int] | None = field(listed(count, 5), default=None)


@dataclass
class Read:
    """The parts of a file.

    Attributes:
        notes: What the ensemble says about itself.
        final, codes, times: As of :class:`.result.Ensemble`.
        messages, statistics, varied, results: The same, by name.
    """

    notes: Notes
    final: Array
    codes: NDArray[np.int8]
    messages: dict[int, str]
    times: Array = dataclasses.field(default_factory=lambda: np.empty(0))
    statistics: dict[str, Array] = dataclasses.field(default_factory=dict)
    varied: dict[str, Array] = dataclasses.field(default_factory=dict)
    results: dict[str, Any] = dataclasses.field(default_factory=dict)


def checked(contents: Contents) -> Read:
    """The parts of a file, which fit each other.

    Raises:
        ValueError: a part is missing, or does not fit the others.
    """
    variables = dict(contents.variables)
    if "ensemble" not in contents.notes:
        return _filled(*_older(contents))
    notes = Notes.read(json.loads(contents.notes["ensemble"]))
    statuses = notes.words
    _require(0 < len(statuses) <= MOST, "it has no words for a status")
    for name in ("final", "status", "entry"):
        _require(name in variables, f"it has no '{name}'")
    status = _texts(variables.pop("status"))
    _require(set(status) <= set(statuses), "a status is none of its words")
    _require(_texts(variables.pop("entry")) == notes.entries, "its entries have other names")
    places = {word: k for k, word in enumerate(statuses)}
    codes = np.array([places[word] for word in status], dtype=np.int8)
    return _filled(contents, notes, codes, variables)


def _filled(
    contents: Contents, notes: Notes, codes: NDArray[np.int8], variables: dict[str, Variable]
) -> Read:
    final = variables.pop("final").values
    runs = len(codes)
    _require(final.shape == (runs, len(notes.entries)), f"'final' has shape {final.shape}")
    _require(final.dtype.kind == "f", "'final' is a text")
    counts = notes.counts
    _require(counts is None or sum(counts) <= final.shape[1], "it has too many speeds")
    read = Read(notes, final, codes, _messages(contents.notes.get("messages", "{}"), runs))
    edges: dict[str, Array] = {}
    # times first, which others are as long as
    for name, one in sorted(variables.items(), key=lambda item: item[0] != "time"):
        kind = one.attributes.get("kind")
        if kind is None:
            continue
        label = json.loads(one.attributes.get("name", "null"))
        _require(is_text(label) and one.values.dtype.kind == "f", f"'{name}' is damaged")
        _put(read, edges, kind, label, one)
    for name, value in read.results.items():
        if isinstance(value, Bins):
            label = edges.get(name, np.empty(0))
            _require(label.shape == (len(value.counts) + 1,), f"'{name}' has no edges")
            read.results[name] = Bins(value.counts, label, value.below, value.above)
    _require(set(read.statistics) == set(NUMBERS), "it has other statistics")
    # files have their own order
    read.results = _ordered(read.results, notes.axes)
    read.varied = _ordered(read.varied, notes.names)
    return read


def _ordered(values: dict[str, Any], names: Iterable[str]) -> dict[str, Any]:
    """Reorder entries: those with these names first, in this order."""
    return {name: values[name] for name in dict.fromkeys([*names, *values]) if name in values}


def _put(read: Read, edges: dict[str, Array], kind: str, label: str, one: Variable) -> None:
    """One array to its place."""
    values, runs = one.values, len(read.final)
    if kind in ("statistic", "varied"):
        _require(
            len(values.shape) in (1, 2) and len(values) == runs, f"'{label}' has another length"
        )
        _require(kind == "varied" or values.ndim == 1, f"'{label}' has another shape")
        (read.statistics if kind == "statistic" else read.varied)[label] = values
    elif kind == "time":
        _require(values.ndim == 1, "its times are damaged")
        read.times = values
    elif kind == "edges":
        edges[label] = values
    elif kind == "bins":
        counts = values.ndim == 1 and bool(((values >= 0) & (values < 2**53)).all())
        outside = json.loads(one.attributes.get("below_and_above", "[0, 0]"))
        _require(counts, f"'{label}' is damaged")
        listed(count, 2).read(outside, False)
        read.results[label] = Bins(values.astype(np.intp), np.empty(0), *outside)
    elif kind == "reduction":
        sizes = {"run": runs, "time": len(read.times), "entry": read.final.shape[1]}
        axes = read.notes.axes.get(label, ())
        expected = tuple(sizes.get(axis, -1) for axis in axes)
        _require(values.shape[: len(axes)] == expected, f"'{label}' has shape {values.shape}")
        read.results[label] = values


def _messages(text: str, runs: int) -> dict[int, str]:
    messages_by_key = json.loads(text)
    _require(
        isinstance(messages_by_key, dict) and all(map(is_text, messages_by_key.values())),
        "its messages are damaged",
    )
    _require(
        all(k.isdecimal() and k.isascii() and len(k) < 16 for k in messages_by_key), "of no run"
    )
    messages = {int(k): message for k, message in messages_by_key.items()}
    _require(all(k < runs for k in messages), "a message is of no run")
    return dict(sorted(messages.items()))


def _texts(one: Variable) -> list[str]:
    """Texts out of their letters."""
    _require(one.values.dtype.kind == "S" and one.values.ndim == 2, "a text is damaged")
    width = one.values.shape[1]
    data = np.ascontiguousarray(one.values).tobytes()
    rows = (data[k : k + width] for k in range(0, len(data), width))
    return [row.rstrip(b"\0").decode() for row in rows]


def _require(good: bool, what: str) -> None:
    if not good:
        raise ValueError(what)


# files of older versions


def _older(contents: Contents) -> tuple[Contents, Notes, NDArray[np.int8], dict[str, Variable]]:
    """The parts of a file whose variables have the names of reductions, with blanks."""
    variables = dict(contents.variables)
    for name in ("final", "status"):
        _require(name in variables, f"it has no '{name}'")
    names = json.loads(variables["final"].attributes.get("names", "null"))
    entries = listed(text).read(names, False)
    status = variables.pop("status")
    statuses = listed(text).read(json.loads(status.attributes.get("words", "null")), False)
    _require(0 < len(statuses) <= MOST and status.values.ndim == 1, "it has no status")
    # codes index the list of statuses: check before they are used
    complete = bool(np.isin(status.values, np.arange(len(statuses))).all())
    _require(complete and status.values.dtype.kind == "f", "a status is none of its words")
    end = variables["t"].values if "t" in variables else np.empty(0)
    last = float(end[np.isfinite(end)].max(initial=0.0))
    renamed: dict[str, Variable] = {"final": variables.pop("final")}
    varied: list[str] = []
    axes: dict[str, list[str]] = {}
    for name, one in variables.items():
        kind, label = _older_kind(name, variables)
        if kind == "varied":
            varied.append(label)
        shared = list(takewhile(lambda axis: axis in ("run", "time"), one.dimensions))
        axes |= {label: shared} if kind == "reduction" else {}
        renamed[name] = Variable(
            one.dimensions, one.values, {"kind": kind, "name": json.dumps(label)}
        )
    notes = Notes(
        model=contents.notes.get("title", "").removeprefix("ensemble of "),
        method="not told",
        settings="not told",
        hands="not told",
        reason="",
        kept="",
        entries=entries,
        start=0.0,
        end=last,
        names=varied,
        lanes=1,
        axes=axes,
        words=statuses,
        seconds=math.nan,
        restored=0,
    )
    return contents, notes, status.values.astype(np.int8), renamed


def _older_kind(name: str, variables: Mapping[str, Variable]) -> tuple[str, str]:
    if name in (*NUMBERS, "time"):
        return ("time" if name == "time" else "statistic"), name
    for kind, word in (("varied", "varied "), ("edges", "edges of ")):
        label = name.removeprefix(word)
        if label != name and (kind == "varied" or label in variables):
            return kind, label
    return ("bins" if f"edges of {name}" in variables else "reduction"), name
