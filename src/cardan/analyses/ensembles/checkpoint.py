"""Finished blocks of runs in a file that only grows: what was computed survives a killed process.

The file is a line that says what it is, then records: length (8 bytes), SHA-256 of the content,
content. The first record tells whose runs these are; every other one is a block, written at once
and on the disk before the next begins. A record that was cut off is thrown away when the file is
opened again. Nothing in it is ever executed.
"""

from __future__ import annotations

import fcntl
import hashlib
import io
import json
import os
import struct
import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from ...errors import ModelError, SolveError
from .job import Piece

MAGIC = b"cardan ensemble 1\n"
LENGTH = struct.Struct("<Q")
DIGEST = 32
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
        try:
            self._file = os.open(path, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o666)
        except OSError as error:
            raise ModelError(f"checkpoint {path} cannot be opened: {error.strerror}") from error
        try:
            try:
                fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                raise ModelError(f"checkpoint {path} is in use by another process") from None
            self._begin(whose)
        except BaseException:
            self.close()
            raise

    def close(self) -> None:
        """Let others have the file."""
        if self._file >= 0:
            os.close(self._file)
            self._file = -1

    def _begin(self, whose: dict[str, str]) -> None:
        head = os.pread(self._file, len(MAGIC), 0)
        if head != MAGIC[: len(head)]:
            raise ModelError(f"checkpoint {self.path} is no file of an ensemble: name another one")
        self._end = len(MAGIC)
        records = self._records()
        first = next(records, None) if len(head) == len(MAGIC) else None
        if first is None:
            # new, or cut off before anything was computed
            os.ftruncate(self._file, 0)
            self._end = 0
            self._write(MAGIC)
            self._append(json.dumps(whose).encode())
            return
        stated = json.loads(first)
        wrong = [CURES[name] for name, value in whose.items() if stated.get(name) != value]
        if wrong:
            raise ModelError(
                f"checkpoint {self.path} belongs to another ensemble: {'; '.join(wrong)}. Name "
                "another file, or remove it to begin anew"
            )

    def pieces(self) -> Iterator[Piece]:
        """The blocks that are in the file; what was cut off behind them is removed."""
        for content in self._records():
            piece = _unpacked(content)
            self.runs += len(piece.x)
            yield piece
        os.ftruncate(self._file, self._end)

    def _records(self) -> Iterator[bytes]:
        """Contents from ``_end`` on, which moves along; the first broken one ends them."""
        while True:
            start = self._end + LENGTH.size + DIGEST
            head = os.pread(self._file, LENGTH.size + DIGEST, self._end)
            if len(head) < LENGTH.size + DIGEST:
                return
            (length,) = LENGTH.unpack(head[: LENGTH.size])
            if start + length > os.fstat(self._file).st_size:
                return
            content = os.pread(self._file, length, start)
            if hashlib.sha256(content).digest() != head[LENGTH.size :]:
                return
            self._end = start + length
            yield content

    def add(self, piece: Piece) -> None:
        """Put a finished block on the disk.

        Raises:
            SolveError: there is no room for it.
        """
        self._append(_packed(piece))
        self.runs += len(piece.x)

    def _append(self, content: bytes) -> None:
        head = LENGTH.pack(len(content)) + hashlib.sha256(content).digest()
        self._write(head + content)

    def _write(self, content: bytes) -> None:
        try:
            done = 0
            while done < len(content):
                done += os.pwrite(self._file, content[done:], self._end + done)
            os.fsync(self._file)
        except OSError as error:
            raise SolveError(
                f"checkpoint {self.path} cannot be written to: {error.strerror}. The blocks in it "
                "are whole: make room and call again to go on from there"
            ) from error
        self._end += len(content)


def _packed(piece: Piece) -> bytes:
    """A block as bytes: an npz file without objects."""
    arrays: dict[str, Any] = {
        "first": np.array(piece.first),
        "x": piece.x,
        "status": piece.status,
        "numbers": piece.numbers,
        "messages": np.frombuffer(json.dumps(piece.messages).encode(), dtype=np.uint8),
        "names": np.frombuffer(json.dumps(list(piece.parts)).encode(), dtype=np.uint8),
    }
    for k, parts in enumerate(piece.parts.values()):
        arrays |= {f"part {k} {name}": value for name, value in parts.items()}
    stream = io.BytesIO()
    np.savez(stream, **arrays)
    return stream.getvalue()


def _unpacked(content: bytes) -> Piece:
    try:
        with np.load(io.BytesIO(content), allow_pickle=False) as found:
            arrays = dict(found)
    except (ValueError, OSError, zipfile.BadZipFile) as error:
        raise ModelError(f"a block of the checkpoint cannot be read: {error}") from error
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
        {int(k): text for k, text in messages.items()},
        parts,
    )
