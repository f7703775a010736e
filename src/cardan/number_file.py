"""Arrays and plain data of files that others may have made: whole and sane, or a ValueError."""

from __future__ import annotations

import io
import json
import math
import zipfile
from collections.abc import Mapping
from typing import Any

import numpy as np

# what parsers raise where bytes are not what they expect
DAMAGE = (
    *(ValueError, KeyError, IndexError, TypeError, AttributeError, OverflowError, SyntaxError),
    *(EOFError, MemoryError, RuntimeError, zipfile.BadZipFile),
)
KINDS = "fiubU"  # numbers and texts, no objects
SWOLLEN = 1 << 30  # bytes of all entries of a file that is smaller than half of that


def packed(arrays: Mapping[str, object]) -> bytes:
    """Arrays as bytes: an npz file without objects."""
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w") as file:
        for name, array in arrays.items():
            entry = io.BytesIO()
            np.lib.format.write_array(entry, np.asanyarray(array), allow_pickle=False)
            # an entry without a date: the same bytes at any time
            file.writestr(zipfile.ZipInfo(f"{name}.npy"), entry.getbuffer())
    return stream.getvalue()


def unpacked(content: bytes) -> dict[str, Any]:
    """The arrays of an npz file of numbers and texts.

    Sizes that a file speaks of cost no memory: an array is as large as the bytes of its entry.

    Raises:
        ValueError: it is none, or damaged.
    """
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as file:
            entries = file.infolist()
            if sum(entry.file_size for entry in entries) > max(SWOLLEN, 2 * len(content)):
                raise ValueError("its content is larger than any that is written")
            return dict(_array(file, entry) for entry in entries)
    except DAMAGE as error:
        raise ValueError(f"it holds no arrays: {error}") from error


def plain(content: bytes) -> Any:
    """Value of a JSON text.

    Raises:
        ValueError: it is none, or nested too deeply.
    """
    try:
        return json.loads(content)
    except RecursionError as error:
        raise ValueError("it is nested too deeply") from error


def _array(file: zipfile.ZipFile, entry: zipfile.ZipInfo) -> tuple[str, Any]:
    """Name and array of an entry."""
    stream = io.BytesIO(file.read(entry))
    if np.lib.format.read_magic(stream) != (1, 0):
        raise ValueError(f"'{entry.filename}' is of another version")
    shape, by_columns, kind = np.lib.format.read_array_header_1_0(stream)
    data = stream.getbuffer()[stream.tell() :]
    integral = all(type(size) is int and size >= 0 for size in shape)
    if kind.kind not in KINDS or not integral or math.prod(shape) * kind.itemsize != len(data):
        raise ValueError(f"'{entry.filename}' does not hold what it speaks of")
    array = np.frombuffer(data, dtype=kind).reshape(shape, order="F" if by_columns else "C")
    return entry.filename.removesuffix(".npy"), array.copy()
