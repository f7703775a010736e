"""What the file of an ensemble must be before anything of it is used."""

from __future__ import annotations

import dataclasses
import json
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import takewhile
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...arrays import Array
from ...runtime.formats.contents import Contents, Variable
from ...schema.fields import Record, count, field, is_text, listed, number, one_of, table, text
from .lane_runner import NUMBERS
from .reductions import Bins

NOTES = ("messages", "ensemble")
MOST = 127  # words of a status
AXES = ("run", "time", "entry", "bin")


class Notes(Record):
    """What an ensemble says about itself."""

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


@dataclass
class Read:
    """The parts of a file.

    Attributes:
        told: What the ensemble says about itself.
        final, codes, times: As of :class:`.result.Ensemble`.
        messages, statistics, varied, results: The same, by name.
    """

    told: Notes
    final: Array
    codes: NDArray[np.int8]
    messages: dict[int, str]
    times: Array = dataclasses.field(default_factory=lambda: np.empty(0))
    statistics: dict[str, Array] = dataclasses.field(default_factory=dict)
    varied: dict[str, Array] = dataclasses.field(default_factory=dict)
    results: dict[str, Any] = dataclasses.field(default_factory=dict)


def checked(held: Contents) -> Read:
    """The parts of a file, which fit each other.

    Raises:
        ValueError: a part is missing, or does not fit the others.
    """
    variables = dict(held.variables)
    if "ensemble" not in held.notes:
        return _filled(*_older(held))
    told = Notes.read(json.loads(held.notes["ensemble"]))
    words = told.words
    _require(0 < len(words) <= MOST, "it has no words for a status")
    for name in ("final", "status", "entry"):
        _require(name in variables, f"it has no '{name}'")
    status = _texts(variables.pop("status"))
    _require(set(status) <= set(words), "a status is none of its words")
    _require(_texts(variables.pop("entry")) == told.entries, "its entries have other names")
    places = {word: k for k, word in enumerate(words)}
    codes = np.array([places[word] for word in status], dtype=np.int8)
    return _filled(held, told, codes, variables)


def _filled(
    held: Contents, told: Notes, codes: NDArray[np.int8], variables: dict[str, Variable]
) -> Read:
    final = variables.pop("final").values
    runs = len(codes)
    _require(final.shape == (runs, len(told.entries)), f"'final' has shape {final.shape}")
    _require(final.dtype.kind == "f", "'final' is a text")
    counts = told.counts
    _require(counts is None or sum(counts) <= final.shape[1], "it has too many speeds")
    read = Read(told, final, codes, _messages(held.notes.get("messages", "{}"), runs))
    edges: dict[str, Array] = {}
    # times first, which others are as long as
    for name, one in sorted(variables.items(), key=lambda item: item[0] != "time"):
        kind = one.attributes.get("kind")
        if kind is None:
            continue
        own = json.loads(one.attributes.get("name", "null"))
        _require(is_text(own) and one.values.dtype.kind == "f", f"'{name}' is damaged")
        _put(read, edges, kind, own, one)
    for name, found in read.results.items():
        if isinstance(found, Bins):
            own = edges.get(name, np.empty(0))
            _require(own.shape == (len(found.counts) + 1,), f"'{name}' has no edges")
            read.results[name] = Bins(found.counts, own, found.below, found.above)
    _require(set(read.statistics) == set(NUMBERS), "it has other statistics")
    # files have their own order
    read.results = _ordered(read.results, told.axes)
    read.varied = _ordered(read.varied, told.names)
    return read


def _ordered(found: dict[str, Any], names: Iterable[str]) -> dict[str, Any]:
    """Those with these names first, in this order."""
    return {name: found[name] for name in dict.fromkeys([*names, *found]) if name in found}


def _put(read: Read, edges: dict[str, Array], kind: str, own: str, one: Variable) -> None:
    """One array to its place."""
    values, runs = one.values, len(read.final)
    if kind in ("statistic", "varied"):
        _require(len(values.shape) in (1, 2) and len(values) == runs, f"'{own}' has another length")
        _require(kind == "varied" or values.ndim == 1, f"'{own}' has another shape")
        (read.statistics if kind == "statistic" else read.varied)[own] = values
    elif kind == "time":
        _require(values.ndim == 1, "its times are damaged")
        read.times = values
    elif kind == "edges":
        edges[own] = values
    elif kind == "bins":
        whole = values.ndim == 1 and bool(((values >= 0) & (values < 2**53)).all())
        outside = json.loads(one.attributes.get("below_and_above", "[0, 0]"))
        _require(whole, f"'{own}' is damaged")
        listed(count, 2).read(outside, False)
        read.results[own] = Bins(values.astype(np.intp), np.empty(0), *outside)
    elif kind == "reduction":
        sizes = {"run": runs, "time": len(read.times), "entry": read.final.shape[1]}
        axes = read.told.axes.get(own, ())
        told = tuple(sizes.get(axis, -1) for axis in axes)
        _require(values.shape[: len(axes)] == told, f"'{own}' has shape {values.shape}")
        read.results[own] = values


def _messages(told: str, runs: int) -> dict[int, str]:
    found = json.loads(told)
    _require(
        isinstance(found, dict) and all(map(is_text, found.values())), "its messages are damaged"
    )
    _require(all(k.isdecimal() and k.isascii() and len(k) < 16 for k in found), "of no run")
    messages = {int(k): words for k, words in found.items()}
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


def _older(
    held: Contents,
) -> tuple[Contents, Notes, NDArray[np.int8], dict[str, Variable]]:
    """The parts of a file whose variables have the names of reductions, with blanks."""
    variables = dict(held.variables)
    for name in ("final", "status"):
        _require(name in variables, f"it has no '{name}'")
    names = json.loads(variables["final"].attributes.get("names", "null"))
    entries = listed(text).read(names, False)
    status = variables.pop("status")
    words = listed(text).read(json.loads(status.attributes.get("words", "null")), False)
    _require(0 < len(words) <= MOST and status.values.ndim == 1, "it has no status")
    known = bool(np.isin(status.values, np.arange(len(words))).all())
    _require(known and status.values.dtype.kind == "f", "a status is none of its words")
    end = variables["t"].values if "t" in variables else np.empty(0)
    last = float(end[np.isfinite(end)].max(initial=0.0))
    found: dict[str, Variable] = {"final": variables.pop("final")}
    varied: list[str] = []
    axes: dict[str, list[str]] = {}
    for name, one in variables.items():
        kind, own = _older_kind(name, variables)
        if kind == "varied":
            varied.append(own)
        shared = list(takewhile(lambda axis: axis in ("run", "time"), one.dimensions))
        axes |= {own: shared} if kind == "reduction" else {}
        found[name] = Variable(one.dimensions, one.values, {"kind": kind, "name": json.dumps(own)})
    told = Notes(
        model=held.notes.get("title", "").removeprefix("ensemble of "),
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
        words=words,
        seconds=math.nan,
        restored=0,
    )
    return held, told, status.values.astype(np.int8), found


def _older_kind(name: str, variables: Mapping[str, Variable]) -> tuple[str, str]:
    if name in (*NUMBERS, "time"):
        return ("time" if name == "time" else "statistic"), name
    for kind, word in (("varied", "varied "), ("edges", "edges of ")):
        own = name.removeprefix(word)
        if own != name and (kind == "varied" or own in variables):
            return kind, own
    return ("bins" if f"edges of {name}" in variables else "reduction"), name
