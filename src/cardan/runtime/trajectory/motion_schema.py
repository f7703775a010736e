"""What a saved run must be before anything of it is used: names, sizes, places, numbers.

Everything that is later looked up, counted over or put in a page is checked here; a file that says
something else is refused as a whole.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import fields
from typing import Any

import numpy as np

from ...arrays import Array
from ...schema.entries import EVENTS
from ...schema.fields import (
    Misfit,
    Record,
    count,
    field,
    flag,
    listed,
    maybe,
    number,
    one_of,
    table,
    text,
)
from ...schema.manifest import Manifest
from ..formats.contents import Contents
from .solver_info import Conduct

COUNTED = ("steps", "rejections", "evaluations", "milliseconds")


class RunConduct(Record):
    """How a run went, as its file says it."""

    method: str = field(text)
    settings: str = field(text)
    status: str = field(text)
    message: str = field(text)
    reason: str | None = field(text, default=None)
    warning: str | None = field(text, default=None)
    initial: Mapping[str, float] = field(table(number))
    defaulted: Sequence[str] = field(listed(text))
    statistics: Mapping[str, float] = field(table(number))

    def fit(self, run: bool) -> None:
        """What is counted is there."""
        for name in COUNTED:
            if name not in self.statistics:
                raise Misfit("is missing").within(f".statistics.{name}")


class RunEvent(Record):
    """An event that could happen in a run."""

    name: str = field(text)
    element: str = field(text)
    kind: str = field(one_of(*EVENTS))
    decides: Sequence[float] | None = field(
        listed(number, 2),
        "place of a mode, counted from the end, and the value from which it is no event but the "
        "first decision about that mode",
        default=None,
    )


class Signals(Record):
    """Inputs by pieces."""

    constants: Sequence[float] = field(listed(number))
    pieces: Sequence[int] = field(listed(count))
    asked: Sequence[int] = field(listed(count))
    held: bool = field(flag)


# length of a number of the scene by joint or by frame
BY_JOINT = {
    **dict.fromkeys(("mass", "pitch", "ratio", "offset", "rotor"), 1),
    **dict.fromkeys(("first_moment", "position", "axis", "axis2"), 3),
    **dict.fromkeys(("inertia", "rotation"), 9),
    "sizes": 2,
}
BY_FRAME = {"frame_rotation": 9, "frame_position": 3}
SHAPES = {3: (-1, 3), 9: (-1, 3, 3), 2: (-1, 2)}


def checked(held: Contents) -> tuple[dict[str, Any], dict[str, Array], dict[str, Array]]:
    """Notes, numbers and poses of a file.

    Returns:
        The notes as data; arrays by name, those that a file leaves out with their sizes; poses
        (nt, 4, 4) by frame.

    Raises:
        ValueError: a part is missing, or does not fit the others.
    """
    notes = _notes(held.notes)
    values = {
        name: one.values for name, one in held.variables.items() if one.values.dtype.kind == "f"
    }
    manifest: Manifest = notes["manifest"]
    for name in "qu":
        shape = values[name].shape if name in values else (0, 0)
        # a pattern may speak of any number of rows
        _require(len(manifest.block(name)) == shape[-1], f"'{name}' has shape {shape}")
    _numbers(notes, values)
    notes["scene"] = _scene(manifest, notes["scene"])
    frames = {row.name for row in manifest.frames}
    poses = {}
    for name, one in held.variables.items():
        if not name.startswith("pose_"):
            continue
        said = one.attributes.get("frame", "")
        frame = json.loads(said) if said.startswith('"') else said
        _require(frame in frames, f"'{name}' is of no frame")
        _shaped(values, name, (len(values["time"]), 3, 4))
        last = np.broadcast_to([0.0, 0.0, 0.0, 1.0], (len(one.values), 1, 4))
        poses[f"pose {frame}"] = np.concatenate([one.values, last], axis=1)
    return notes, values, poses


def _require(good: bool, what: str) -> None:
    if not good:
        raise ValueError(what)


def _notes(texts: Mapping[str, str]) -> dict[str, Any]:
    """Everything that is not numbers, each part by itself."""
    found: dict[str, Any] = {"happenings": [], "signals": None}
    for name in ("manifest", "conduct", "scene", "happenings", "sources", "signals"):
        _require(name in texts or name in found, f"it has no '{name}'")
        if name in texts:
            found[name] = json.loads(texts[name])
    found["manifest"] = Manifest.read(found["manifest"], run=True)
    RunConduct.read(found["conduct"])
    _require(
        set(found["conduct"]) <= {one.name for one in fields(Conduct)},
        "it says more than a run has to say about how it went",
    )
    # what may be left out may be nothing too
    found["conduct"] = {k: v for k, v in found["conduct"].items() if v is not None}
    found["conduct"]["defaulted"] = tuple(found["conduct"]["defaulted"])
    rows = listed(RunEvent).read(found["happenings"], True)
    found["happenings"] = tuple(vars(row) for row in rows)
    sources = maybe(listed(text)).read(found["sources"], True)
    found["sources"] = None if sources is None else tuple(sources)
    found["signals"] = maybe(Signals).read(found["signals"], True)
    return found


def _scene(manifest: Manifest, scene: Any) -> dict[str, Array]:
    """Numbers of the scene, shaped."""
    _require(isinstance(scene, dict), "its scene is not a table")
    found: dict[str, Array] = {}
    counts = {**dict.fromkeys(BY_JOINT, "joints"), **dict.fromkeys(BY_FRAME, "frames")}
    for name, value in scene.items():
        try:
            array = np.array(value, dtype=np.float64)
        except (TypeError, OverflowError):
            raise ValueError(f"'{name}' of its scene is not a number") from None
        size = {**BY_JOINT, **BY_FRAME}.get(name)
        if size is not None:
            count = len(getattr(manifest, counts[name]))
            _require(array.size == size * count, f"'{name}' of its scene has another size")
            array = array.reshape(SHAPES.get(size, (-1,)))
        found[name] = array
    _require(found.get("gravity", np.zeros(3)).shape == (3,), "its gravity is not a vector")
    told = set(found) & {*BY_JOINT, *BY_FRAME}
    _require(not told or set(BY_FRAME) <= told, "its scene says nothing of frames")
    needed = {"mass", "first_moment", "position", "rotation", "ratio", "offset", "axis", "pitch"}
    _require(not told & set(BY_JOINT) or needed <= told, "its scene is damaged")
    return found


def _shaped(values: dict[str, Array], name: str, shape: tuple[int, ...]) -> None:
    """An array of a shape; what has no numbers stands in no file."""
    if 0 in shape:
        values.setdefault(name, np.zeros(shape))
    found = values[name].shape if name in values else "none"
    _require(found == shape, f"'{name}' has shape {found}, not {shape}")


def _numbers(notes: Mapping[str, Any], values: dict[str, Array]) -> None:
    """Arrays that fit each other and the manifest."""
    manifest: Manifest = notes["manifest"]
    happenings = notes["happenings"]
    t = values.get("time", np.zeros(0))
    _require(t.ndim == 1 and len(t) > 0, "it has no times")
    _require(bool(np.isfinite(t).all()), "its times are damaged")
    way = np.diff(t)
    _require(bool((way >= 0).all() or (way <= 0).all()), "its times go back and forth")
    count, sources = len(t), len(notes["sources"] or ())
    for name in "qurzs":
        _shaped(values, name, (count, len(manifest.block(name))))
    _shaped(values, "work", (count, sources))
    nx = sum(len(manifest.block(letter)) for letter in "quz")
    ns, rows = len(manifest.s), len(manifest.multipliers)
    for row in happenings:
        place = (row.get("decides") or (-1,))[0]
        _require("decides" not in row or -ns <= int(place) <= -1, "an event decides nothing")
    happened = len(values["events"]) if "events" in values else 0
    _shaped(values, "events", (happened, 1 + len(happenings) + 2 * (nx + ns)))
    for name, shape in (
        ("kinetic", (count,)),
        ("potential", (count,)),
        ("losses", (happened,)),
        ("constraints", (count, manifest.held)),
        ("multipliers", (count, rows)),
    ):
        if name in values:
            _shaped(values, name, shape)
    _require(("kinetic" in values) == ("potential" in values), "half of its energy is missing")
    if "ledger" in values:
        own = len(values["ledger"])
        _require(rows <= own <= 2 * rows, "its ledger has another number of rows")
        _shaped(values, "ledger", (own, 4))
    for name in ("spreads", "increments"):
        if name in values:
            axes = values[name].shape
            good = len(axes) == 3 and count > 1 and axes[::2] == (count - 1, nx + sources)
            _require(good, f"'{name}' has shape {axes}")
    _signals(notes["signals"], len(manifest.inputs), values)


def _signals(told: Signals | None, nr: int, values: dict[str, Array]) -> None:
    """Inputs by pieces."""
    if told is None:
        return
    _require(len(told.constants) == nr, "its inputs are damaged")
    _require(all(k < nr for k in (*told.pieces, *told.asked)), "its inputs are damaged")
    for k in range(len(told.pieces)):
        breaks = values.get(f"breaks_{k}", np.zeros(0))
        _require(breaks.ndim == 1 and len(breaks) > 1, "its inputs are damaged")
        _require(bool((np.diff(breaks) >= 0).all()), "its inputs are damaged")
        _shaped(values, f"coefficients_{k}", (len(breaks) - 1, 4))
