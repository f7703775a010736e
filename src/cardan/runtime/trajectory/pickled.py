"""Motions in pickles: what they are made of, checked before it is used."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import fields
from typing import Any

import numpy as np

from ...errors import ModelError
from ...schema.fields import dumped
from ...schema.manifest import Manifest, checked_manifest
from ...version import PICKLE, VERSION
from .closure_errors import Ledger, Worst
from .dense_output import Dense, LaterDense
from .event_log import EventLog
from .input_history import PiecewiseInput, Recorded
from .solver_info import SolverInfo
from .trajectory import TrajectoryRecord

ARRAYS = ("t", "x", "r", "work_done")
RECORDS: dict[str, type[Any]] = {
    kind.__name__: kind
    for kind in (SolverInfo, Dense, EventLog, Ledger, PiecewiseInput, Recorded, Worst)
}
RECORD = ""  # the key of the name of a record


def parts(motion: TrajectoryRecord) -> tuple[dict[str, Any], str]:
    """The fields of a motion, and their hash; its model takes along what draws the motion."""
    model = motion.model
    drawn = model is not None and "pose" in model.manifest.available
    # elements in tables take theirs along as they are
    if model is not None and drawn and not model.manifest.absolute:
        for body in model.bodies:
            model._objects.symbol("pose", body)
    values = {field.name: getattr(motion, field.name) for field in fields(motion)}
    if isinstance(motion.dense, LaterDense):
        values["dense"] = motion.dense.as_data()
    # histories are computed again; those of a file, and what the method found, cannot be
    stored = {name: x for name, x in motion.stored.items() if name == "multipliers"}
    values["stored"] = stored if motion.model is not None else dict(motion.stored)
    stated = digest(values)
    # data only: a pickle names no class that may move
    values["manifest"] = dumped(values["manifest"])
    return {name: plain(value) for name, value in values.items()}, stated


def plain(value: object) -> object:
    """Records as dictionaries that say what they are."""
    name = type(value).__name__
    if RECORDS.get(name) is type(value):
        entries = {one.name: plain(getattr(value, one.name)) for one in fields(RECORDS[name])}
        return {RECORD: name, **entries}
    if isinstance(value, Mapping):
        return {key: plain(one) for key, one in value.items()}
    return tuple(map(plain, value)) if isinstance(value, tuple) else value


def read(values: Mapping[str, object]) -> dict[str, Any]:
    """The fields of a motion that :func:`parts` made data of."""
    entries = {name: x if name == "model" else records(x) for name, x in values.items()}
    manifest = json.loads(str(entries["manifest"]))
    if entries["model"] is None:
        return {**entries, "manifest": Manifest.read(manifest, run=True)}
    return {**entries, "manifest": checked_manifest(manifest, "a pickled motion")}


def records(value: object) -> object:
    """The inverse of :func:`plain`."""
    if isinstance(value, dict):
        entries = {key: records(one) for key, one in value.items() if key != RECORD}
        return RECORDS[value[RECORD]](**entries) if RECORD in value else entries
    return tuple(map(records, value)) if isinstance(value, tuple) else value


def digest(values: Mapping[str, Any]) -> str:
    """Hash of the numbers and names of a motion."""
    total = hashlib.sha256(dumped(values["manifest"], sort_keys=True).encode())
    total.update(repr((values["sources"], values["solver_info"], values["ledger"])).encode())
    event_log = values["event_log"]
    total.update(repr([sorted(row.items()) for row in event_log.rows]).encode())
    arrays = [
        *(values[name] for name in ARRAYS),
        *_sorted(values["stored"]),
        event_log.s,
        event_log.log,
    ]
    if values["dense"] is not None:
        arrays += [values["dense"].t, values["dense"].y, values["dense"].spreads]
        total.update(repr(values["dense"].charted).encode())
    # motions without any have the hash of those that could not have any
    arrays += _sorted(values.get("sensitivity", {}))
    for array in (*arrays, *_sorted(values["numbers"])):
        total.update(repr(np.shape(array)).encode())
        total.update(np.ascontiguousarray(array, dtype=np.float64).tobytes())
    return total.hexdigest()


def _sorted(values: Mapping[str, object]) -> list[Any]:
    return [values[name] for name in sorted(values)]


def reduced(motion: TrajectoryRecord) -> tuple[object, ...]:
    """Return value of ``__reduce__`` of a motion."""
    return unpickled, (PICKLE.version, VERSION, *parts(motion))


def unpickled(version: int, writer: str, values: dict[str, Any], stated: str) -> TrajectoryRecord:
    """The motion of a pickle.

    Raises:
        ModelError: it is of another version, was damaged or changed.
    """
    if not PICKLE.reads(version):
        raise ModelError(PICKLE.refusal("this pickle of a motion", version, writer))
    return restore(values, stated)


def restore(values: dict[str, Any], stated: str) -> TrajectoryRecord:
    """The motion of a pickle.

    Raises:
        ModelError: it was damaged or changed.
    """
    try:
        values = read(values)
        names = {field.name for field in fields(TrajectoryRecord)}
        # pickles of earlier versions have none
        values.setdefault("sensitivity", {})
        intact = digest(values) == stated and set(values) == names
    except ModelError:
        raise
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise _damaged(f"a part is missing or of another kind ({error})") from None
    if not intact:
        raise _damaged("its content is not what it was made of")
    _check(values)
    return TrajectoryRecord(**values)


def _check(values: Mapping[str, Any]) -> None:
    """Shapes that fit each other and the manifest."""
    manifest, count = values["manifest"], len(values["t"])
    width = sum(len(manifest.block(letter)) for letter in "quz")
    source_count = len(values["sources"] or ())
    for name, size in (("x", width), ("r", len(manifest.inputs)), ("work_done", source_count)):
        if np.shape(values[name]) != (count, size):
            raise _damaged(f"{name} has shape {np.shape(values[name])}, not ({count}, {size})")
    event_log, modes = values["event_log"], len(manifest.s)
    columns = 1 + len(event_log.rows) + 2 * (width + modes)
    if (modes and np.shape(event_log.s) != (count, modes)) or (
        len(event_log.log) and np.shape(event_log.log)[1] != columns
    ):
        raise _damaged("its events do not fit its states")
    for name, one in values["sensitivity"].items():
        if np.shape(one)[:2] != (count, width):
            raise _damaged(f"its sensitivity by {name!r} does not fit its states")
    dense = values["dense"]
    said = isinstance(values["solver_info"], SolverInfo) and isinstance(
        values["ledger"], Ledger | None
    )
    if not said or not isinstance(dense, Dense | None):
        raise _damaged("it does not say how it went")
    if dense is not None and (
        np.shape(dense.y) != (len(dense.t), width + source_count)
        or np.shape(dense.spreads)[::2] != (len(dense.t) - 1, width + source_count)
    ):
        raise _damaged("what lies between its times does not fit them")


def _damaged(why: str) -> ModelError:
    return ModelError(f"this pickle holds no motion of cardan: {why}. Pickle the motion again")
