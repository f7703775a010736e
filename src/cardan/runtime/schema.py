"""What a manifest must be before anything in it is used: the shape of it, sizes, names.

The full description is ``docs/manifest.schema.json``; here stands what memory and files depend on.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from math import prod
from pathlib import Path
from typing import Any

from ..errors import ModelError
from ..ir.rows import Rows
from ..schema.blocks import ORDER
from ..version import ABI, MANIFEST
from . import motion_rows
from .motion_rows import HAPPENING, Check, count, listed, named_numbers, number, row_of, text

LARGEST = 1 << 40  # numbers of a block, a result or work memory
NAMED = ("coordinates", "speeds", "inputs", "parameters", "frames", "joints", "outputs")
TEXTS = ("name", "cardan", "method")
ROWS = (
    *(*NAMED, "bodies", "multipliers", "quaternions", "z", "s", "available"),
    *("fixed", "shapes", "notes", "snaps"),
)
TABLES = ("structural", "scene", "functions", "sha256")
SIZES = ("output_size", "work_size", "prepared_size")


def _starts(joint: Mapping[str, Any]) -> Callable[[str], bool]:
    """Whether a joint starts, if it says so, with one number for each of its coordinates.

    A joint that its circuit solves keeps its start and has no coordinates of its own.
    """

    def good(letter: str) -> bool:
        own, start = joint.get(letter), joint.get(f"{letter}0")
        return start is None or listed(number, None if own is None else own[1])(start)

    return good


def _event(row: Any) -> bool:
    """Whether a row is an event; what it decides stands by the name of the mode."""
    decides = row.get("decides", {}) if isinstance(row, Mapping) else None
    return named_numbers(decides) and HAPPENING({**row, "decides": None})


# what saved runs do not hold, or hold otherwise
NUMBERED = row_of(name=text, unit=text, maybe_default=number, maybe_joint=text)
OWN: dict[str, Check] = {
    **dict.fromkeys(("coordinates", "speeds", "inputs", "z"), NUMBERED),
    "s": row_of(name=text, maybe_default=number),
    "cuts": row_of(name=text, kind=text, parent_frame=text, child_frame=text),
    **dict.fromkeys(("fixed", "notes", "snaps"), text),
    "parameters": row_of(name=text, default=number, kind=text, maybe_unit=text),
    "joints": lambda row: (
        motion_rows.ROWS["joints"](row)
        and row_of(maybe_domain=text, maybe_rotation=text)(row)
        and all(map(_starts(row), "qu"))
        and isinstance(row.get("limits"), dict)
    ),
    "events": _event,
    "ticks": row_of(event=count, period=lambda x: number(x) and x > 0, phase=number),
}
IDENTIFIER = re.compile(r"[A-Za-z_][A-Za-z0-9_]*\Z", re.ASCII)
HASH = re.compile(r"[0-9a-f]{64}\Z")


def check(manifest: Any, where: str) -> None:
    """Look at a manifest that came from outside.

    Args:
        manifest: What JSON held.
        where: What to call it in errors.

    Raises:
        ModelError: it is none, of another version, or a part has the wrong shape.
    """
    if not isinstance(manifest, dict):
        raise ModelError(f"{where} is not a manifest")
    for form in (ABI, MANIFEST):
        version = manifest.get(form.word)
        if not form.reads(version):
            raise ModelError(form.refusal(where, version, manifest.get("cardan")))
    for kind, keys in ((list, ROWS), (dict, TABLES), (str, TEXTS)):
        for key in keys:
            right = isinstance(manifest.get(key), (kind, Rows) if kind is list else kind)
            _require(right, where, f"'{key}' is no {kind.__name__}")
    for key in NAMED:
        rows = manifest[key]
        rows = rows.kinds if isinstance(rows, Rows) else rows
        named = all(isinstance(r, dict) and isinstance(r.get("name"), str) for r in rows)
        _require(named, where, f"a row of '{key}' has no name")
    _rows(manifest, where)
    _places(manifest, where)
    for name, stated in manifest["sha256"].items():
        good = Path(name).name == name and isinstance(stated, str) and HASH.match(stated)
        _require(bool(good), where, f"{name!r} is no file with its hash")
    for symbol, entry in manifest["functions"].items():
        _function(symbol, entry, f"{where}: function {symbol!r}")
    if "constraints" in manifest["functions"]:
        size = manifest["functions"]["constraints"]["output_size"]
        rows = sum(row["level"] == "position" for row in manifest["multipliers"])
        _require(size == rows, where, f"{rows} rows tell of {size} constraints of positions")


def _rows(manifest: Mapping[str, Any], where: str) -> None:
    """Every row has what is read of it."""
    checks = {**motion_rows.ROWS, **OWN}
    for key in checks.keys() & manifest.keys():
        rows = manifest[key]
        # of rows that repeat one of a kind
        some = rows.kinds if isinstance(rows, Rows) else rows
        good = isinstance(some, list) and all(map(checks[key], some))
        _require(good, where, f"a row of '{key}' is not one")


def _places(manifest: Mapping[str, Any], where: str) -> None:
    """Places that the kernels take from rows exist."""
    nq = len(manifest["coordinates"])
    inside = all(k + 4 <= nq for k in manifest["quaternions"])
    _require(inside, where, "a quaternion is of no coordinates")
    events = len(manifest.get("events", ()))
    due = all(tick["event"] < events for tick in manifest.get("ticks", ()))
    _require(due, where, "a sample is of no event")
    _require("mesh" not in manifest or "beams" in manifest, where, "it has no beams")


def _function(symbol: str, entry: Any, where: str) -> None:
    """One function: a name that C knows, a file beside the manifest, sizes that agree."""
    _require(bool(IDENTIFIER.match(symbol)), where, "this is no name in C")
    _require(isinstance(entry, Mapping), where, "it has no entry")
    file = entry.get("file")
    _require(isinstance(file, str) and Path(file).name == file, where, "its file is elsewhere")
    for key in SIZES:
        size = entry.get(key)
        _require(type(size) is int and 0 <= size < LARGEST, where, f"{key} is {size!r}")
    inputs, outputs = entry.get("inputs"), entry.get("outputs")
    _require(isinstance(inputs, list) and all(x in ORDER for x in inputs), where, "its inputs")
    _require(isinstance(outputs, list) and all(map(_output, outputs)), where, "its outputs")
    total = sum(prod(output["shape"]) for output in outputs or ())
    _require(total == entry["output_size"], where, f"its outputs hold {total} numbers")
    lanes = entry.get("lanes")
    _require(isinstance(lanes, list) and bool(lanes) and all(map(count, lanes)), where, "its lanes")
    counts = entry.get("operations")
    whole = isinstance(counts, dict) and all(type(n) is int and n >= 0 for n in counts.values())
    _require(whole, where, "its operations are not counted")


def _output(output: Any) -> bool:
    """Whether a result has a name and a shape."""
    shape = output.get("shape") if isinstance(output, dict) else None
    return (
        isinstance(shape, list)
        and len(shape) <= 8
        and all(type(n) is int and 0 <= n < LARGEST for n in shape)
        and isinstance(output.get("name"), str)
        and isinstance(output.get("entries", 0), list | None)
        and all(isinstance(name, str) for name in output["entries"] or ())
    )


def _require(good: bool, where: str, what: str) -> None:
    if not good:
        raise ModelError(f"{where}: {what}. Compile the model again")
