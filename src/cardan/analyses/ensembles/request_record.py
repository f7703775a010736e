"""The request of an ensemble in the checkpoint of its runs: what joining parts needs to know."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import astuple

import numpy as np

from ...arrays import Array
from ...schema.fields import Record, count, field, listed, number, table, text
from ..simulation.files.append_log import packed
from ..simulation.files.append_log import text as letters
from .job import Sizes
from .reductions import Reduction
from .result import Request
from .sensitivity import reread_all
from .share import Share


class RequestNotes(Record):
    """The request in words and numbers; its arrays stand beside it."""

    model: str = field(text)
    method: str = field(text)
    settings: str = field(text)
    reason: str = field(text)
    entries: Sequence[str] = field(listed(text))
    counts: Sequence[int] = field(listed(count, 2))
    start: float = field(number)
    end: float = field(number)
    names: Sequence[str] = field(listed(text))
    varied: Sequence[str] = field(listed(text))
    reductions: Mapping[str, str] = field(table(text))
    share: Sequence[int] = field(listed(count, 5))


def written(request: Request, share: Share, reductions: Mapping[str, Reduction]) -> bytes:
    """The request of a part as a record, the same bytes whenever it is made."""
    notes = {
        "model": request.model,
        "method": request.method,
        "settings": request.settings,
        "reason": request.reason,
        "entries": request.entries,
        "counts": request.counts,
        "start": request.start,
        "end": request.end,
        "names": request.names,
        "varied": list(request.varied),
        "reductions": {name: one.phrase() for name, one in reductions.items()},
        "share": list(astuple(share)),
    }
    columns = {f"varied {k}": column for k, column in enumerate(request.varied.values())}
    return packed({"request": letters(notes), "times": request.times, **columns})


def read(arrays: Mapping[str, Array]) -> tuple[Request, Share, Sizes]:
    """A part's request, which part it is, and the sizes of its answers.

    Raises:
        ValueError: it is none.
    """
    notes = RequestNotes.read(json.loads(arrays["request"].tobytes()))
    share = Share(*notes.share)
    if not (1 <= share.number <= share.count and 0 <= share.first < share.last <= share.runs):
        raise ValueError("it is not a part of anything")
    times = arrays["times"]
    if times.dtype != np.float64 or times.ndim != 1:
        raise ValueError("its output times are damaged")
    if sum(notes.counts) > len(notes.entries):
        raise ValueError("it has too many speeds")
    varied = {}
    for k, name in enumerate(notes.varied):
        column = arrays[f"varied {k}"]
        if column.dtype != np.float64 or column.ndim not in (1, 2) or len(column) != len(share):
            raise ValueError(f"what is varied of '{name}' is damaged")
        varied[name] = column
    by_name = reread_all(notes.reductions)
    sizes = Sizes(len(share), len(notes.entries), len(times), by_name)
    request = Request(
        model=notes.model,
        entries=tuple(notes.entries),
        counts=(notes.counts[0], notes.counts[1]),
        start=float(notes.start),
        end=float(notes.end),
        times=times,
        names=tuple(notes.names),
        method=notes.method,
        settings=notes.settings,
        reason=notes.reason,
        lanes=1,
        varied=varied,
        axes={name: one.axes for name, one in by_name.items()},
        share=share,
    )
    return request, share, sizes
