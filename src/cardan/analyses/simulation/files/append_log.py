"""Files that only grow: what was written survives a killed process.

A file is a line that says what it is, then records: length (8 bytes), SHA-256 of the content,
content. The first record tells whose the others are; every other one is written at once and on the
disk before the next begins. A record that was cut off is thrown away when the file is opened again.
Nothing in it is ever executed.
"""

from __future__ import annotations

import hashlib
import json
import os
import re
import struct
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from .... import number_file, processes, regular_file
from ....errors import ModelError, SolveError
from ....runtime.models.loaded_model import LoadedModel
from ....version import VERSION, Format, written_by

packed = number_file.packed

LENGTH = struct.Struct("<Q")
DIGEST = 32
LONGEST = 1 << 31  # bytes of a record
HEAD = re.compile(rb"cardan ([a-z]+) (\d+)\n")
DIGITS = 8  # that a version may have more than ours


def magic(form: Format) -> bytes:
    """The first line of a file."""
    return f"cardan {form.word} {form.version}\n".encode()


class AppendLog:
    """An open file of records; one process at a time."""

    def __init__(
        self, path: Path, form: Format, whose: Mapping[str, str], cures: Mapping[str, str]
    ) -> None:
        """Open or begin a file.

        Args:
            path: The file.
            form: Its format; the first line is such as ``b"cardan ensemble 1\\n"``.
            whose: Hashes of what decides about its content, by name.
            cures: What it means that one of them differs, in words.

        Raises:
            ModelError: it belongs to something else or another process, or is no such file.
        """
        self.path, self._form, self._cures = path, form, cures
        self._whose = {"cardan": VERSION, **whose}
        self._magic = magic(form)
        self.writer: object = VERSION
        try:
            self._file = regular_file.grown(path)
        except OSError as error:
            raise ModelError(f"checkpoint {path} cannot be opened: {error.strerror}") from error
        try:
            try:
                processes.lock(self._file, wait=False)
            except BlockingIOError:
                raise ModelError(f"checkpoint {path} is in use by another process") from None
            self._open()
        except BaseException:
            self.close()
            raise

    def close(self) -> None:
        """Let others have the file."""
        if self._file >= 0:
            os.close(self._file)
            self._file = -1

    def _open(self) -> None:
        head = self._read(len(self._magic), 0)
        if head != self._magic[: len(head)]:
            raise self._foreign()
        self._end = len(self._magic)
        first = next(self._records(), None) if len(head) == len(self._magic) else None
        if first is None:
            # new, or cut off before anything was computed
            self.begin()
            return
        try:
            stated = number_file.plain(first)
        except ValueError:
            stated = None
        if not isinstance(stated, dict):
            raise ModelError(f"checkpoint {self.path} is damaged: name another file, or remove it")
        self.writer = stated.get("cardan")
        wrong = [why for k, why in self._cures.items() if stated.get(k) != self._whose[k]]
        if wrong:
            raise ModelError(
                f"checkpoint {self.path} belongs to another {self._form.word}: {'; '.join(wrong)}; "
                f"{written_by(self.writer)} wrote it. Name another file, or remove it to begin anew"
            )

    def _foreign(self) -> ModelError:
        """Why a file that begins otherwise is not read."""
        line = HEAD.match(self._read(len(self._magic) + DIGITS, 0))
        if line is None or line[1].decode() != self._form.word:
            word = self._form.word
            return ModelError(f"checkpoint {self.path} is not a file of an {word}: name another")
        self._end = line.end()
        try:
            writer = number_file.plain(next(self._records(), b"")).get("cardan")
        except (ValueError, AttributeError):
            writer = ""
        return ModelError(self._form.refusal(f"checkpoint {self.path}", int(line[2]), writer))

    def _read(self, length: int, start: int) -> bytes:
        """Read up to a number of bytes; one call gives 2 GiB at most, less the last page."""
        parts, done = list[bytes](), 0
        try:
            while done < length:
                part = os.pread(self._file, length - done, start + done)
                if not part:
                    break
                parts, done = [*parts, part], done + len(part)
        except OSError as error:
            raise ModelError(f"checkpoint {self.path} cannot be read: {error.strerror}") from error
        return b"".join(parts)

    def begin(self) -> None:
        """Throw away all records."""
        os.ftruncate(self._file, 0)
        self._end = 0
        self._write(self._magic)
        self.add(json.dumps(self._whose).encode())

    def contents(self) -> Iterator[bytes]:
        """The records behind the first; what was cut off behind them is removed."""
        yield from self._records()
        os.ftruncate(self._file, self._end)

    def _records(self) -> Iterator[bytes]:
        """Contents from ``_end`` on, which moves along; the first broken one ends them."""
        while True:
            start = self._end + LENGTH.size + DIGEST
            head = self._read(LENGTH.size + DIGEST, self._end)
            if len(head) < LENGTH.size + DIGEST:
                return
            (length,) = LENGTH.unpack(head[: LENGTH.size])
            if length > LONGEST or start + length > os.fstat(self._file).st_size:
                return
            content = self._read(length, start)
            if hashlib.sha256(content).digest() != head[LENGTH.size :]:
                return
            self._end = start + length
            yield content

    def add(self, content: bytes) -> None:
        """Put a record on the disk.

        Raises:
            SolveError: there is no room for it.
        """
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


def unpacked(content: bytes) -> dict[str, Any]:
    """The arrays that :func:`packed` made bytes of.

    Raises:
        ModelError: others made them.
    """
    try:
        return number_file.unpacked(content)
    except ValueError as error:
        raise ModelError(f"a block of the checkpoint cannot be read: {error}") from error


def text(value: object) -> Any:
    """Plain data as an array of bytes."""
    return np.frombuffer(json.dumps(value).encode(), dtype=np.uint8)


def build_key(model: LoadedModel) -> str:
    """Key of everything that decides the last bit of a run:

    compiler, flags, processor and all texts.

    The names of the compiled ``rhs``, or of the functions of elements together; "Python" without a
    compiler; and of the integrators.
    """
    built = [code.built for code in model._source.codes(model)]
    names = ["Python" if each is None else each.path.stem for each in built]
    functions = names[0] if len(names) == 1 else digest(*names)
    return "-".join(name[:16] for name in (functions, Path(model._kernels()._name).stem))


def model_key(model: LoadedModel) -> str:
    """Hash of the equations and parameters of a model."""
    # a function is in the manifest once it is there to be called
    model._function("rhs")
    manifest = model.manifest
    if manifest.absolute:
        # every function of its elements, and the tables
        return digest(model.name, dict(manifest.sha256), model.parameters.vector)
    text = manifest.functions["rhs"].sha256
    return digest(model.name, text, model.parameters.vector)


def digest(*values: object) -> str:
    """Hash of arrays, and of what JSON or ``repr`` can tell."""
    total = hashlib.sha256()
    for value in values:
        if isinstance(value, np.ndarray):
            total.update(repr((value.shape, value.dtype.str)).encode())
            total.update(np.ascontiguousarray(value).tobytes())
        elif isinstance(value, dict):
            total.update(json.dumps(value, sort_keys=True).encode())
        else:
            total.update(repr(value).encode())
    return total.hexdigest()
