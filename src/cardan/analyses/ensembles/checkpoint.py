"""Finished blocks of runs in a file that only grows."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from ..growing import Growing, packed, text, unpacked
from .job import Piece

MAGIC = b"cardan ensemble 1\n"
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
        self._file = Growing(path, MAGIC, whose, CURES)

    def close(self) -> None:
        """Let others have the file."""
        self._file.close()

    def pieces(self) -> Iterator[Piece]:
        """The blocks that are in the file; what was cut off behind them is removed."""
        for content in self._file.contents():
            piece = _piece(unpacked(content))
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
    return Piece(
        int(arrays["first"]),
        arrays["x"],
        arrays["status"],
        arrays["numbers"],
        {int(k): told for k, told in messages.items()},
        parts,
    )
