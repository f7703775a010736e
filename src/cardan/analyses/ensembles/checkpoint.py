"""Finished blocks of runs in a file that only grows."""

from __future__ import annotations

import json
import re
from collections.abc import Collection, Iterator
from pathlib import Path
from typing import Any

import numpy as np

from ...errors import ModelError
from ...version import ENSEMBLE_FILE
from ..simulation.files.append_log import Growing, packed, text, unpacked
from .executors import Block
from .job import Job, Piece
from .lane_runner import NUMBERS
from .reductions import FREE

WORD = re.compile(r"[a-z_]{1,40}")  # of a status
CURES = {
    "model": "it was computed with another model",
    "build": "it was computed with another compiler, processor or version of the integrators",
    "plan": "its runs start elsewhere or have other parameters or inputs",
    "settings": "it has another time, method or tolerance",
    "reductions": "it keeps other reductions",
}


class Checkpoint:
    """An open file of finished blocks; one process at a time.

    Attributes:
        path: The file.
        runs: How many runs are known to be in it.
    """

    def __init__(self, path: Path, whose: dict[str, str]) -> None:
        """Open or begin a file.

        Args:
            path: The file.
            whose: Hashes of model, build, plan, settings and reductions.

        Raises:
            ModelError: it belongs to other runs or another process, or is no such file.
        """
        self.path, self.runs = path, 0
        self._file = Growing(path, ENSEMBLE_FILE, whose, CURES)

    def close(self) -> None:
        """Let others have the file."""
        self._file.close()

    def pieces(self, job: Job, left: Collection[Block]) -> Iterator[Piece]:
        """The blocks that are in the file; what was cut off behind them is removed.

        Args:
            job: What the blocks are of.
            left: Blocks that are not computed yet; it shrinks meanwhile.

        Raises:
            ModelError: a block is not one of this job's.
        """
        for content in self._file.contents():
            try:
                piece = _piece(unpacked(content))
                _check(piece, job, left)
            except (ValueError, KeyError, TypeError, IndexError, RecursionError) as error:
                raise ModelError(
                    f"checkpoint {self.path} holds a block that is none of these runs: {error}. "
                    "Name another file, or remove it to begin anew"
                ) from None
            self.runs += len(piece.x)
            yield piece

    def add(self, piece: Piece) -> None:
        """Put a finished block on the disk.

        Raises:
            SolveError: there is no room for it.
        """
        self._file.add(packed(_arrays(piece)))
        self.runs += len(piece.x)


def _arrays(piece: Piece) -> dict[str, Any]:
    """A block as arrays by name."""
    arrays: dict[str, Any] = {
        "first": np.array(piece.first),
        "x": piece.x,
        "status": piece.status,
        "numbers": piece.numbers,
        "messages": text(piece.messages),
        "names": text(list(piece.parts)),
    }
    for k, parts in enumerate(piece.parts.values()):
        arrays |= {f"part {k} {name}": value for name, value in parts.items()}
    return arrays


def _piece(arrays: dict[str, Any]) -> Piece:
    names = json.loads(arrays["names"].tobytes())
    parts: dict[str, dict[str, Any]] = {name: {} for name in names}
    for key, value in arrays.items():
        word, _, rest = key.partition(" ")
        if word == "part":
            k, _, name = rest.partition(" ")
            parts[names[int(k)]][name] = value
    messages = json.loads(arrays["messages"].tobytes())
    if not isinstance(messages, dict) or not isinstance(names, list):
        raise ValueError("it has no messages")
    first = arrays["first"]
    if first.dtype.kind != "i" or first.size != 1:
        raise ValueError("it has no place")
    return Piece(
        int(first),
        arrays["x"],
        arrays["status"],
        arrays["numbers"],
        {int(k): told for k, told in messages.items()},
        parts,
    )


def _check(piece: Piece, job: Job, left: Collection[Block]) -> None:
    """Refuse what no block of a job is.

    Raises:
        ValueError: it is elsewhere, or has arrays of another size or kind.
    """
    count, nx = len(piece.x), job.model.nx
    times = 0 if job.over.times is None else len(job.over.times)
    if (piece.first, piece.last) not in left:
        raise ValueError(f"it has runs {piece.first} to {piece.last - 1}")
    _array("x", piece.x, (count, nx))
    _array("numbers", piece.numbers, (count, len(NUMBERS)))
    status = piece.status
    words = status.tolist() if status.dtype.kind == "U" and status.shape == (count,) else [""]
    if not all(isinstance(word, str) and WORD.fullmatch(word) for word in words):
        raise ValueError("its status is none")
    for k, told in piece.messages.items():
        if not piece.first <= k < piece.last or not isinstance(told, str):
            raise ValueError("a message is of none of its runs")
        told.encode()
    if list(piece.parts) != list(job.kept):
        raise ValueError("it keeps other reductions")
    for name, reduction in job.kept.items():
        parts, shapes = piece.parts[name], reduction.shapes(count, times, nx)
        if set(parts) != set(shapes):
            raise ValueError(f"'{name}' has other parts")
        for part, shape in shapes.items():
            _array(f"'{name}'", parts[part], shape)


def _array(name: str, array: Any, shape: tuple[int, ...]) -> None:
    """Refuse what is not numbers of a shape, which may go on where it ends in ``FREE``."""
    found = array.shape
    whole = found[: len(shape) - 1] + shape[-1:] if shape[-1:] == (FREE,) else found
    if array.dtype != np.float64 or whole != shape:
        raise ValueError(f"{name} has shape {found}")
