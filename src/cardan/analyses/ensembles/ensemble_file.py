"""An ensemble as a file, read again, and as an xarray data set."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import astuple
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ... import arguments
from ...errors import ModelError
from ...runtime import formats
from ...runtime.formats.contents import Contents, Variable, letters, safe_name
from ...version import ENSEMBLE
from .file_schema import NOTES, Read, checked
from .lane_runner import NUMBERS
from .reductions import Bins
from .share import Share

if TYPE_CHECKING:
    from .result import EnsembleRecord, Request

FEWER = "Keep reductions instead of states"


def variables(ensemble: EnsembleRecord) -> dict[str, Variable]:
    """Name -> array. The attribute ``kind`` says what it is, ``name`` what it is called here."""
    request, variables = ensemble.request, dict[str, Variable]()

    def add(
        name: str, kind: str, label: str, axes: Sequence[str], values: Any, **more: str
    ) -> None:
        # netCDF allows fewer characters in names than cardan; the attribute keeps the name
        safe = safe_name(name, {*variables, "status", "entry", "run"})
        shape = np.shape(values)
        dimensions = [a if a in ("run", "time", "entry") else f"{safe}_{a}" for a in axes]
        dimensions += [f"{safe}_axis_{k}" for k in range(len(dimensions), len(shape))]
        attributes = {"kind": kind, "name": json.dumps(label), **more}
        array = np.asarray(values, dtype=np.float64)
        variables[safe] = Variable(tuple(dimensions), array, attributes)

    add("final", "final", "final", ("run", "entry"), ensemble.final)
    for name, values in ensemble.statistics.items():
        units = {"units": "s"} if name == "t" else {}
        add(name, "statistic", name, ("run",), values, **units)
    if len(request.times):
        add("time", "time", "time", ("time",), request.times, units="s")
    for name, values in ensemble.varied.items():
        add(f"varied {name}", "varied", name, ("run",), values)
    for name, value in ensemble.results.items():
        if isinstance(value, Bins):
            outside = json.dumps([value.below, value.above])
            add(name, "bins", name, ("bin",), value.counts, below_and_above=outside)
            add(f"edges of {name}", "edges", name, ("edge",), value.edges)
        else:
            add(name, "reduction", name, request.axes.get(name, ()), value)
    return variables


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
        attributes = {**one.attributes, "name": json.loads(one.attributes["name"])}
        parts[name] = (one.dimensions, one.values, attributes)
    times = {"time": parts.pop("time")} if "time" in parts else {}
    coordinates = {
        "run": np.arange(len(ensemble)),
        "entry": list(ensemble.request.entries),
        **times,
    }
    parts["status"] = (("run",), ensemble.status, {})
    return xarray.Dataset(parts, coordinates, {"model": ensemble.request.model})


@arguments.checked
def save(ensemble: EnsembleRecord, path: str | Path) -> Path:
    """Write everything but the model; :func:`cardan.load_ensemble` reads it.

    The ending says the format: .nc (netCDF), .npz (NumPy archive), .csv (a table with a row for
    every run) or .mat (MATLAB); the last two are not read again. The file appears complete or not
    at all.

    Returns:
        Its path.

    Raises:
        ModelError: a variable too large for the format, or a file that cannot be written.
    """
    content = variables(ensemble)
    content["entry"] = letters(ensemble.request.entries, "entry")
    content["status"] = letters(ensemble.status, "run", "status")
    notes = {
        "title": f"ensemble of {ensemble.request.model}".encode("ascii", "replace").decode(),
        "messages": json.dumps({str(k): text for k, text in ensemble.messages.items()}),
        "ensemble": json.dumps(_notes(ensemble)),
    }
    return formats.save(Path(path), ENSEMBLE, Contents(content, notes), FEWER)


def _notes(ensemble: EnsembleRecord) -> dict[str, Any]:
    """Description of the ensemble for its file."""
    request = ensemble.request
    return {
        "model": request.model,
        "entries": request.entries,
        "counts": request.counts,
        "start": request.start,
        "end": request.end,
        "names": request.names,
        "method": request.method,
        "settings": request.settings,
        "reason": request.reason,
        "lanes": request.lanes,
        "axes": dict(request.axes),
        "words": ensemble.status_names,
        "seconds": ensemble.seconds,
        "hands": ensemble.executor,
        "restored": ensemble.restored,
        "kept": ensemble.saved_message,
        **({} if request.share is None else {"share": list(astuple(request.share))}),
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
    contents = formats.load(path, ENSEMBLE, ("title", *NOTES))
    try:
        read = checked(contents)
        request = _request(read)
    except (ValueError, MemoryError, RecursionError) as error:
        raise ModelError(
            f"{path} is not an ensemble that cardan can read: {error or 'it is too large'}. Save "
            "the ensemble again"
        ) from None
    notes = read.notes
    return EnsembleRecord(
        request=request,
        final=read.final,
        results=read.results,
        codes=read.codes,
        status_names=tuple(notes.words),
        numbers=np.stack([read.statistics[name] for name in NUMBERS], axis=1),
        messages=read.messages,
        seconds=float(notes.seconds),
        executor=notes.hands,
        restored=notes.restored,
        saved_message=notes.kept,
    )


def _request(read: Read) -> Request:
    from .result import Request

    notes = read.notes
    return Request(
        model=notes.model,
        entries=tuple(notes.entries),
        counts=None if notes.counts is None else (notes.counts[0], notes.counts[1]),
        start=float(notes.start),
        end=float(notes.end),
        times=read.times,
        names=tuple(notes.names),
        method=notes.method,
        settings=notes.settings,
        reason=notes.reason,
        lanes=notes.lanes,
        varied=read.varied,
        axes={name: tuple(axes) for name, axes in notes.axes.items()},
        share=None if notes.share is None else Share(*notes.share),
    )
