"""What a manifest must be before anything in it is used: the shape of it, sizes, names.

The full description is ``docs/manifest.schema.json``; here stands what memory and files depend on.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from math import prod
from pathlib import Path
from typing import Any

from ..errors import ModelError
from ..ir.rows import Rows
from .slots import ORDER

ABI = 1
SCHEMA = 1
LARGEST = 1 << 40  # numbers of a block, a result or work memory
NAMED = ("coordinates", "speeds", "inputs", "parameters", "frames", "joints", "outputs")
ROWS = (*NAMED, "bodies", "multipliers", "quaternions")
TABLES = ("functions", "sha256")
SIZES = ("output_size", "work_size", "prepared_size")
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
    for name, known in (("abi", ABI), ("schema", SCHEMA)):
        if manifest.get(name) != known:
            raise ModelError(
                f"{where}: {name} version {manifest.get(name)!r} cannot be read, this cardan "
                f"reads {known}. Compile the model again"
            )
    for key, kind in (*((k, list) for k in ROWS), *((k, dict) for k in TABLES), ("name", str)):
        right = isinstance(manifest.get(key), (kind, Rows) if kind is list else kind)
        _require(right, where, f"'{key}' is no {kind.__name__}")
    for key in NAMED:
        rows = manifest[key]
        rows = rows.kinds if isinstance(rows, Rows) else rows
        named = all(isinstance(r, dict) and isinstance(r.get("name"), str) for r in rows)
        _require(named, where, f"a row of '{key}' has no name")
    for name, stated in manifest["sha256"].items():
        good = Path(name).name == name and isinstance(stated, str) and HASH.match(stated)
        _require(bool(good), where, f"{name!r} is no file with its hash")
    for symbol, entry in manifest["functions"].items():
        _function(symbol, entry, f"{where}: function {symbol!r}")


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
    _require(isinstance(inputs, list) and set(inputs) <= set(ORDER), where, "its inputs")
    _require(isinstance(outputs, list) and all(map(_output, outputs)), where, "its outputs")
    total = sum(prod(output["shape"]) for output in outputs or ())
    _require(total == entry["output_size"], where, f"its outputs hold {total} numbers")
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
    )


def _require(good: bool, where: str, what: str) -> None:
    if not good:
        raise ModelError(f"{where}: {what}. Compile the model again")
