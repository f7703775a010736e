"""Checks of a saved run before anything of it is used: names, sizes, places, numbers.

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
from ...superelements.moving_surface import entry
from ..formats.contents import Contents
from ..models.finite_elements.superelements import surface_of
from .solver_info import SolverInfo

COUNTED = ("steps", "rejections", "evaluations", "milliseconds")


class RunConduct(Record):
    """Solver info of a run in its file."""

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
        """Check that all counts are there."""
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
        "place of a mode, counted from the end, and the value from which it is not an event but "
        "the first decision about that mode",
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


def checked(contents: Contents) -> tuple[dict[str, Any], dict[str, Array], dict[str, Array]]:
    """Notes, numbers and poses of a file.

    Returns:
        The notes as data; arrays by name, those that a file leaves out with their sizes; poses
        (nt, 4, 4) by frame.

    Raises:
        ValueError: a part is missing, or does not fit the others.
    """
    notes = _notes(contents.notes)
    values = {
        name: one.values for name, one in contents.variables.items() if one.values.dtype.kind == "f"
    }
    manifest: Manifest = notes["manifest"]
    for name in "qu":
        shape = values[name].shape if name in values else (0, 0)
        # a pattern may speak of any number of rows
        _require(len(manifest.block(name)) == shape[-1], f"'{name}' has shape {shape}")
    _numbers(notes, values)
    notes["scene"] = _scene(manifest, notes["scene"]) | _surfaces(manifest, values)
    frames = {row.name for row in manifest.frames}
    poses = {}
    for name, one in contents.variables.items():
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
    notes: dict[str, Any] = {"happenings": [], "signals": None}
    for name in ("manifest", "conduct", "scene", "happenings", "sources", "signals"):
        _require(name in texts or name in notes, f"it has no '{name}'")
        if name in texts:
            notes[name] = json.loads(texts[name])
    notes["manifest"] = Manifest.read(notes["manifest"], run=True)
    RunConduct.read(notes["conduct"])
    _require(
        set(notes["conduct"]) <= {one.name for one in fields(SolverInfo)},
        "it says more than a run has to say about how it went",
    )
    # what may be left out may be nothing too
    notes["conduct"] = {k: v for k, v in notes["conduct"].items() if v is not None}
    notes["conduct"]["defaulted"] = tuple(notes["conduct"]["defaulted"])
    rows = listed(RunEvent).read(notes["happenings"], True)
    notes["happenings"] = tuple(vars(row) for row in rows)
    sources = maybe(listed(text)).read(notes["sources"], True)
    notes["sources"] = None if sources is None else tuple(sources)
    notes["signals"] = maybe(Signals).read(notes["signals"], True)
    return notes


def _scene(manifest: Manifest, scene: Any) -> dict[str, Array]:
    """Numbers of the scene, shaped."""
    _require(isinstance(scene, dict), "its scene is not a table")
    scene_arrays: dict[str, Array] = {}
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
        scene_arrays[name] = array
    _require(scene_arrays.get("gravity", np.zeros(3)).shape == (3,), "its gravity is not a vector")
    names = set(scene_arrays) & {*BY_JOINT, *BY_FRAME}
    _require(not names or set(BY_FRAME) <= names, "its scene says nothing of frames")
    needed = {"mass", "first_moment", "position", "rotation", "ratio", "offset", "axis", "pitch"}
    _require(not names & set(BY_JOINT) or needed <= names, "its scene is damaged")
    return scene_arrays


def _surfaces(manifest: Manifest, values: dict[str, Array]) -> dict[str, Array]:
    """Surfaces of superelements; earlier files have none."""
    arrays: dict[str, Array] = {}
    for k, row in enumerate(manifest.superelements):
        if entry("points", k) in values:
            surface = surface_of(values, k, row).arrays()
            arrays |= {entry(name, k): array for name, array in surface.items()}
    return arrays


def _shaped(values: dict[str, Array], name: str, shape: tuple[int, ...]) -> None:
    """An array of a shape; what has no numbers stands in no file."""
    if 0 in shape:
        values.setdefault(name, np.zeros(shape))
    actual = values[name].shape if name in values else "none"
    _require(actual == shape, f"'{name}' has shape {actual}, not {shape}")


def _numbers(notes: Mapping[str, Any], values: dict[str, Array]) -> None:
    """Arrays that fit each other and the manifest."""
    manifest: Manifest = notes["manifest"]
    event_rows = notes["happenings"]
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
    for row in event_rows:
        place = (row.get("decides") or (-1,))[0]
        _require("decides" not in row or -ns <= int(place) <= -1, "an event decides nothing")
    event_count = len(values["events"]) if "events" in values else 0
    _shaped(values, "events", (event_count, 1 + len(event_rows) + 2 * (nx + ns)))
    for name, shape in (
        ("kinetic", (count,)),
        ("potential", (count,)),
        ("losses", (event_count,)),
        ("constraints", (count, manifest.position_rows)),
        ("multipliers", (count, rows)),
        ("parameters", (len(manifest.parameters),)),
        ("outputs", (count, len(manifest.outputs))),
        ("element_forces", (count, len(manifest.element_forces))),
    ):
        if name in values:
            _shaped(values, name, shape)
    _require(("kinetic" in values) == ("potential" in values), "half of its energy is missing")
    if "ledger" in values:
        ledger_rows = len(values["ledger"])
        _require(rows <= ledger_rows <= 2 * rows, "its ledger has another number of rows")
        _shaped(values, "ledger", (ledger_rows, 4))
    for name in ("spreads", "increments"):
        if name in values:
            axes = values[name].shape
            good = len(axes) == 3 and count > 1 and axes[::2] == (count - 1, nx + sources)
            _require(good, f"'{name}' has shape {axes}")
    _signals(notes["signals"], len(manifest.inputs), values)


def _signals(recorded: Signals | None, nr: int, values: dict[str, Array]) -> None:
    """Inputs by pieces."""
    if recorded is None:
        return
    _require(len(recorded.constants) == nr, "its inputs are damaged")
    _require(all(k < nr for k in (*recorded.pieces, *recorded.asked)), "its inputs are damaged")
    for k in range(len(recorded.pieces)):
        breaks = values.get(f"breaks_{k}", np.zeros(0))
        _require(breaks.ndim == 1 and len(breaks) > 1, "its inputs are damaged")
        _require(bool((np.diff(breaks) >= 0).all()), "its inputs are damaged")
        _shaped(values, f"coefficients_{k}", (len(breaks) - 1, 4))
