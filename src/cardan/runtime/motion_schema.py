"""What a saved run must be before anything of it is used: names, sizes, places, numbers.

Everything that is later looked up, counted over or put in a page is checked here; a file that says
something else is refused as a whole.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from copy import copy
from dataclasses import fields
from typing import Any

import numpy as np

from ..ir.rows import Rows, opened
from .calling import Array
from .conduct import Conduct
from .formats.contents import Contents
from .motion_rows import CONDUCT, HAPPENING, ROWS, SIGNALS, SIZES, listed, number, text

# length of a number of the scene by joint or by frame
BY_JOINT = {
    **dict.fromkeys(("mass", "pitch", "ratio", "offset", "rotor"), 1),
    **dict.fromkeys(("first_moment", "position", "axis", "axis2"), 3),
    **dict.fromkeys(("inertia", "rotation"), 9),
    "sizes": 2,
}
BY_FRAME = {"frame_rotation": 9, "frame_position": 3}
# whose rows may be told by a pattern
PATTERNED = ("coordinates", "speeds", "joints")
# parts of the manifest that a file leaves out where they are empty
EMPTY: dict[str, Any] = {
    "absent": {},
    **{key: [] for key in ROWS if key not in ("coordinates", "speeds")},
}
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
    _manifest(notes["manifest"], values)
    _numbers(notes, values)
    notes["scene"] = _scene(notes["manifest"], notes["scene"])
    frames = {row["name"] for row in notes["manifest"]["frames"]}
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
    _require(isinstance(found["manifest"], dict), "its manifest is not a table")
    found["manifest"] = opened(found["manifest"])
    _require(CONDUCT(found["conduct"]), "it does not say how it went")
    _require(
        set(found["conduct"]) <= {one.name for one in fields(Conduct)},
        "it says more than a run has to say about how it went",
    )
    # what may be left out may be nothing too
    found["conduct"] = {k: v for k, v in found["conduct"].items() if v is not None}
    found["conduct"]["defaulted"] = tuple(found["conduct"]["defaulted"])
    _require(listed(HAPPENING)(found["happenings"]), "its events are not told")
    found["happenings"] = tuple(found["happenings"])
    sources = found["sources"]
    _require(sources is None or listed(text)(sources), "its sources have no names")
    found["sources"] = None if sources is None else tuple(sources)
    _require(found["signals"] is None or SIGNALS(found["signals"]), "its inputs are not told")
    return found


def _manifest(manifest: dict[str, Any], values: Mapping[str, Array]) -> None:
    """Rows of the manifest, and the names and places that they speak of."""
    for key, nothing in EMPTY.items():
        manifest.setdefault(key, copy(nothing))
    manifest.setdefault("method", "")
    for name in ("name", "method"):
        _require(text(manifest.get(name)), f"its manifest has no '{name}'")
    for key, row in ROWS.items():
        rows = manifest.get(key)
        kinds = list | Rows if key in PATTERNED else list
        _require(isinstance(rows, kinds), f"its manifest has no '{key}'")
        _require(all(map(row, _seen(rows or ()))), f"a row of '{key}' is damaged")
    absent = manifest["absent"]
    _require(isinstance(absent, dict) and all(map(text, absent.values())), "'absent' is damaged")
    for name, key in (("q", "coordinates"), ("u", "speeds")):
        shape = values[name].shape if name in values else (0, 0)
        # a pattern may speak of any number of rows
        _require(len(manifest[key]) == shape[-1], f"'{name}' has shape {shape}")
    _joints(manifest)
    _places(manifest)
    if manifest["method"] != "absolute":
        _tree(manifest.get("scene") or {}, manifest["joints"])


def _seen(rows: Sequence[Any]) -> list[Any]:
    """The rows that are judged: all but those between the first and the last of a kind."""
    if not isinstance(rows, Rows):
        return list(rows)
    ends = list(rows.listed)
    for run in rows.runs:
        kinds = len(run.pattern)
        ends += [run.row(k) for k in (*range(kinds), *range(len(run) - kinds, len(run)))]
    return ends


def _joints(manifest: dict[str, Any]) -> None:
    """Entries of joints in q and u, and joints that follow others."""
    joints, counts = manifest["joints"], {"q": "coordinates", "u": "speeds"}
    listed = joints.listed if isinstance(joints, Rows) else joints
    _require(
        len(joints) <= len(listed) + len(manifest["coordinates"]), "it has more joints than it can"
    )
    for block, key in counts.items():
        most = len(manifest[key])
        for row in _seen(joints):
            start, size = row.get(block) or (0, 0)
            _require(start + size <= most, f"joint '{row['name']}' is beyond {block}")
    for row in joints:
        row.setdefault("coupled", None)
        row.setdefault("prescribed", False)
    leaders = {row["name"]: row["coupled"]["leader"] for row in joints if row["coupled"]}
    names = {row["name"] for row in joints}
    for name in leaders:
        follow = name
        for _ in range(len(leaders) + 1):
            follow = leaders.get(follow, "")
            if not follow:
                break
            _require(follow in names, f"joint '{name}' follows none")
        _require(not follow, f"joint '{name}' follows itself")


def _places(manifest: dict[str, Any]) -> None:
    """Bodies, frames, beams, shapes and quaternions."""
    nq, nu = len(manifest["coordinates"]), len(manifest["speeds"])
    bodies = {row["name"] for row in manifest["bodies"]}
    frames = {row["name"] for row in manifest["frames"]}
    carrying = {row["body"] for row in manifest["frames"]}
    absolute = manifest["method"] == "absolute"
    _require(len(frames) == len(manifest["frames"]), "two frames have one name")
    for row in manifest["bodies"]:
        _require(row["parent"] in (*bodies, "ground"), f"body '{row['name']}' is nowhere")
        _require(
            not row["parts"] or ({*row["parts"]} <= frames and row["name"] in carrying),
            f"body '{row['name']}' has no frame",
        )
    keys = {"beams": ("plane",), "shapes": ("rotation", "color")}
    keys |= {"frames": ("node", "plane")} if absolute else {}
    for name, optional in keys.items():
        for row in manifest[name]:
            row.update({key: row.get(key) for key in optional})
    for row in manifest["frames"]:
        _require(row["body"] in (*bodies, "ground"), f"frame '{row['name']}' is nowhere")
        sizes = (3, 3) if row.get("plane") else (7, 6)
        node = row.get("node") or (0, 0)
        good = not absolute or (node[0] + sizes[0] <= nq and node[1] + sizes[1] <= nu)
        _require(good or row.get("node") is None, f"frame '{row['name']}' is beyond q")
    for row in manifest["beams"]:
        first, count = row["q"]
        size = 3 if row.get("plane") else 7
        _require({row["start"], row["end"]} <= frames, f"beam '{row['name']}' has no ends")
        _require(first + size * count <= nq, f"beam '{row['name']}' is beyond q")
    for row in manifest["shapes"]:
        needed = SIZES.get(row["kind"], ())
        _require(row["frame"] in frames, "a shape is nowhere")
        _require(all(row.get(size) is not None for size in needed), "a shape has no size")
    starts = manifest["quaternions"]
    _require(all(k + 4 <= nq for k in starts), "a quaternion is beyond q")
    _require(
        absolute or not manifest["bodies"] or len(bodies) == len(manifest["joints"]),
        "it has not a joint for every body",
    )


def _tree(scene: Any, joints: Sequence[Any]) -> None:
    """What poses follow from."""
    _require(isinstance(scene, dict), "its scene is not a table")
    if not scene:
        return
    count = len(joints)
    parents = scene.get("parents")
    _require(listed(number, count)(parents), "its tree is damaged")
    good = all(isinstance(p, int) and -1 <= p < i for i, p in enumerate(parents or ()))
    _require(good, "its tree is damaged")
    _require(listed(text, count)(scene.get("kinds")), "its tree has joints of no kind")
    known = listed(lambda value: value is None or text(value), count)
    _require(known(scene.get("rotations")), "its tree is damaged")
    curves = scene.get("curves", [])
    _require(isinstance(curves, list) and len(curves) in (0, count), "its curves are damaged")
    for row in curves:
        if row is not None:
            breaks, coefficients, period = row
            axes = np.asarray(coefficients, dtype=np.float64).shape
            good = len(axes) == 3 and axes[:2] == (3, len(breaks) - 1) and min(axes) > 0
            _require(good and listed(number)(breaks) and number(period), "its curves are damaged")


def _scene(manifest: Mapping[str, Any], scene: Any) -> dict[str, Array]:
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
            count = len(manifest[counts[name]])
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
    manifest, happenings = notes["manifest"], notes["happenings"]
    t = values.get("time", np.zeros(0))
    _require(t.ndim == 1 and len(t) > 0, "it has no times")
    _require(bool(np.isfinite(t).all()), "its times are damaged")
    way = np.diff(t)
    _require(bool((way >= 0).all() or (way <= 0).all()), "its times go back and forth")
    count, sources = len(t), len(notes["sources"] or ())
    widths = {"q": "coordinates", "u": "speeds", "r": "inputs", "z": "z", "s": "s"}
    for name, key in widths.items():
        _shaped(values, name, (count, len(manifest[key])))
    _shaped(values, "work", (count, sources))
    nx = sum(len(manifest[key]) for key in ("coordinates", "speeds", "z"))
    ns, rows = len(manifest["s"]), len(manifest["multipliers"])
    for row in happenings:
        place = (row.get("decides") or (-1,))[0]
        _require("decides" not in row or -ns <= int(place) <= -1, "an event decides nothing")
    happened = len(values["events"]) if "events" in values else 0
    _shaped(values, "events", (happened, 1 + len(happenings) + 2 * (nx + ns)))
    holding = sum(row["level"] == "position" for row in manifest["multipliers"])
    for name, shape in (
        ("kinetic", (count,)),
        ("potential", (count,)),
        ("losses", (happened,)),
        ("constraints", (count, holding)),
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
    _signals(notes["signals"], len(manifest["inputs"]), values)


def _signals(told: Any, nr: int, values: dict[str, Array]) -> None:
    """Inputs by pieces."""
    if told is None:
        return
    _require(len(told["constants"]) == nr, "its inputs are damaged")
    _require(all(k < nr for k in (*told["pieces"], *told["asked"])), "its inputs are damaged")
    for k in range(len(told["pieces"])):
        breaks = values.get(f"breaks_{k}", np.zeros(0))
        _require(breaks.ndim == 1 and len(breaks) > 1, "its inputs are damaged")
        _require(bool((np.diff(breaks) >= 0).all()), "its inputs are damaged")
        _shaped(values, f"coefficients_{k}", (len(breaks) - 1, 4))
