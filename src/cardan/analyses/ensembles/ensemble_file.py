"""An ensemble as a file, read again, and as an xarray data set."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ... import arguments
from ...errors import ModelError
from ...runtime import formats
from ...runtime.formats.contents import Contents, Variable, letters
from ...version import ENSEMBLE
from .file_schema import NOTES, Read, checked
from .lane_runner import NUMBERS
from .reductions import Bins

if TYPE_CHECKING:
    from .result import Asked, EnsembleRecord

FEWER = "Keep reductions instead of states"
# what a name in a file may have beside letters of ASCII and digits
OTHER = re.compile(r"[^A-Za-z0-9_.]")


def variables(ensemble: EnsembleRecord) -> dict[str, Variable]:
    """Name -> array. The attribute ``kind`` says what it is, ``name`` what it is called here."""
    asked, found = ensemble.asked, dict[str, Variable]()

    def add(name: str, kind: str, own: str, axes: Sequence[str], values: Any, **more: str) -> None:
        safe = _safe(name, found)
        shape = np.shape(values)
        known = [a if a in ("run", "time", "entry") else f"{safe}_{a}" for a in axes]
        known += [f"{safe}_axis_{k}" for k in range(len(known), len(shape))]
        told = {"kind": kind, "name": json.dumps(own), **more}
        array = np.asarray(values, dtype=np.float64)
        found[safe] = Variable(tuple(known), array, told)

    add("final", "final", "final", ("run", "entry"), ensemble.final)
    for name, values in ensemble.statistics.items():
        units = {"units": "s"} if name == "t" else {}
        add(name, "statistic", name, ("run",), values, **units)
    if len(asked.times):
        add("time", "time", "time", ("time",), asked.times, units="s")
    for name, values in ensemble.varied.items():
        add(f"varied {name}", "varied", name, ("run",), values)
    for name, value in ensemble.results.items():
        if isinstance(value, Bins):
            outside = json.dumps([value.below, value.above])
            add(name, "bins", name, ("bin",), value.counts, below_and_above=outside)
            add(f"edges of {name}", "edges", name, ("edge",), value.edges)
        else:
            add(name, "reduction", name, asked.axes.get(name, ()), value)
    return found


def _safe(name: str, taken: Mapping[str, Any]) -> str:
    """A name that every reader takes, and no other variable has."""
    safe = OTHER.sub("_", name)
    safe = safe if safe[:1].isalpha() else f"_{safe}"
    found, k = safe, 1
    while found in (*taken, "status", "entry", "run"):
        k += 1
        found = f"{safe}_{k}"
    return found


def to_xarray(ensemble: EnsembleRecord) -> Any:
    """Data set with the dimensions run, entry, time; names have _ for blanks.

    Entries of states are labeled by name, ``status`` is text; the attribute ``name`` of a variable
    is its name here.

    Raises:
        ModuleNotFoundError: xarray is missing.
    """
    try:
        import xarray
    except ModuleNotFoundError as error:
        raise ModuleNotFoundError(
            "to_xarray needs xarray, which is not installed: pip install 'cardan[data]'"
        ) from error
    parts = {}
    for name, one in variables(ensemble).items():
        told = {**one.attributes, "name": json.loads(one.attributes["name"])}
        parts[name] = (one.dimensions, one.values, told)
    times = {"time": parts.pop("time")} if "time" in parts else {}
    coordinates = {"run": np.arange(len(ensemble)), "entry": list(ensemble.asked.entries), **times}
    parts["status"] = (("run",), ensemble.status, {})
    return xarray.Dataset(parts, coordinates, {"model": ensemble.asked.model})


@arguments.checked
def save(ensemble: EnsembleRecord, path: str | Path) -> Path:
    """Write everything but the model; :func:`cardan.load_ensemble` reads it.

    The ending says the format: .nc (netCDF), .npz (NumPy archive) or .csv (a table with a row for
    every run, which is not read again). The file appears complete or not at all.

    Returns:
        Its path.

    Raises:
        ModelError: a variable too large for the format, or a file that cannot be written.
    """
    found = variables(ensemble)
    found["entry"] = letters(ensemble.asked.entries, "entry")
    found["status"] = letters(ensemble.status, "run", "status")
    notes = {
        "title": f"ensemble of {ensemble.asked.model}".encode("ascii", "replace").decode(),
        "messages": json.dumps({str(k): text for k, text in ensemble.messages.items()}),
        "ensemble": json.dumps(_told(ensemble)),
    }
    return formats.save(Path(path), ENSEMBLE, Contents(found, notes), FEWER)


def _told(ensemble: EnsembleRecord) -> dict[str, Any]:
    """What the ensemble says about itself."""
    asked = ensemble.asked
    return {
        "model": asked.model,
        "entries": asked.entries,
        "counts": asked.counts,
        "start": asked.start,
        "end": asked.end,
        "names": asked.names,
        "method": asked.method,
        "settings": asked.settings,
        "reason": asked.reason,
        "lanes": asked.lanes,
        "axes": dict(asked.axes),
        "words": ensemble.words,
        "seconds": ensemble.seconds,
        "hands": ensemble.hands,
        "restored": ensemble.restored,
        "kept": ensemble.kept,
    }


def load(path: str | Path) -> EnsembleRecord:
    """Read an ensemble that :meth:`.Ensemble.save` wrote.

    Everything in the file is checked before it is used: nothing in it is ever executed. A file
    holds no model: ``run(i)`` needs the ensemble that was computed.

    Args:
        path: The file.

    Returns:
        What was saved: last states, status, statistics, what was varied and all reductions.

    Raises:
        ModelError: not an ensemble of cardan, a damaged one, or a newer format.
    """
    from .result import EnsembleRecord

    path = Path(path)
    held = formats.load(path, ENSEMBLE, ("title", *NOTES))
    try:
        read = checked(held)
        asked = _asked(read)
    except (ValueError, MemoryError, RecursionError) as error:
        raise ModelError(
            f"{path} is no ensemble that cardan can read: {error or 'it is too large'}. Save the "
            "ensemble again"
        ) from None
    told = read.told
    return EnsembleRecord(
        asked=asked,
        final=read.final,
        results=read.results,
        codes=read.codes,
        words=tuple(told.words),
        numbers=np.stack([read.statistics[name] for name in NUMBERS], axis=1),
        messages=read.messages,
        seconds=float(told.seconds),
        hands=told.hands,
        restored=told.restored,
        kept=told.kept,
    )


def _asked(read: Read) -> Asked:
    from .result import Asked

    told = read.told
    return Asked(
        model=told.model,
        entries=tuple(told.entries),
        counts=None if told.counts is None else (told.counts[0], told.counts[1]),
        start=float(told.start),
        end=float(told.end),
        times=read.times,
        names=tuple(told.names),
        method=told.method,
        settings=told.settings,
        reason=told.reason,
        lanes=told.lanes,
        varied=read.varied,
        axes={name: tuple(axes) for name, axes in told.axes.items()},
    )
