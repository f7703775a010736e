"""Files that only grow: what was written survives a killed process.

A file is a line that says what it is, then records: length (8 bytes), SHA-256 of the content,
content. The first record tells whose the others are; every other one is written at once and on the
disk before the next begins. A record that was cut off is thrown away when the file is opened again.
Nothing in it is ever executed.
"""

from __future__ import annotations

import hashlib
import json
import math
import os
import re
import struct
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from .... import number_file, processes, regular_file
from ....errors import ModelError, SolveError
from ....runtime.build import prebuilt
from ....runtime.models.loaded_model import LoadedModel
from ....version import VERSION, Format, written_by

packed = number_file.packed

LENGTH = struct.Struct("<Q")
DIGEST = 32
LONGEST = 1 << 31  # bytes of a record
HEAD = re.compile(rb"cardan ([a-z]+) (\d+)\n")
DIGITS = 8  # that a version may have more than ours
# of the mathematical library: functions and numbers at which one tells it from another
PROBES = 400
FUNCTIONS_OF_C = (math.exp, math.tan, math.asin, math.acos, math.sinh, math.cosh, math.tanh)


def magic(form: Format) -> bytes:
    """The first line of a file."""
    return f"cardan {form.word} {form.version}\n".encode()


class LogReader:
    """Records of an open file, one after the other.

    Attributes:
        end: Where the last record that was read ends.
        writer: The cardan that wrote it, as the file says.
    """

    def __init__(self, file: int, path: Path, form: Format) -> None:
        """Take an open file.

        Args:
            file: Its descriptor.
            path: Its name, for messages.
            form: Its format; the first line is such as ``b"cardan ensemble 1\\n"``.
        """
        self.path, self.end = path, 0
        self.writer: object = VERSION
        self._file, self._form, self._magic = file, form, magic(form)

    def stated(self) -> dict[str, object] | None:
        """The first record: hashes of what decides about the others; None where it is cut off.

        Raises:
            ModelError: it is another kind of file, of another version, or damaged.
        """
        head = self._read(len(self._magic), 0)
        if head != self._magic[: len(head)]:
            raise self._foreign()
        self.end = len(self._magic)
        first = next(self.records(), None) if len(head) == len(self._magic) else None
        if first is None:
            return None
        try:
            stated = number_file.plain(first)
        except ValueError:
            stated = None
        if not isinstance(stated, dict):
            raise ModelError(f"checkpoint {self.path} is damaged: name another file, or remove it")
        self.writer = stated.get("cardan")
        return stated

    def records(self) -> Iterator[bytes]:
        """Contents from ``end`` on, which moves along; the first broken one ends them."""
        while True:
            start = self.end + LENGTH.size + DIGEST
            head = self._read(LENGTH.size + DIGEST, self.end)
            if len(head) < LENGTH.size + DIGEST:
                return
            (length,) = LENGTH.unpack(head[: LENGTH.size])
            if length > LONGEST or start + length > os.fstat(self._file).st_size:
                return
            content = self._read(length, start)
            if hashlib.sha256(content).digest() != head[LENGTH.size :]:
                return
            self.end = start + length
            yield content

    def _foreign(self) -> ModelError:
        """Why a file that begins otherwise is not read."""
        line = HEAD.match(self._read(len(self._magic) + DIGITS, 0))
        if line is None or line[1].decode() != self._form.word:
            word = self._form.word
            return ModelError(f"checkpoint {self.path} is not a file of an {word}: name another")
        self.end = line.end()
        try:
            writer = number_file.plain(next(self.records(), b"")).get("cardan")
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


class AppendLog:
    """An open file of records; one process at a time."""

    def __init__(
        self,
        path: Path,
        form: Format,
        whose: Mapping[str, str],
        cures: Mapping[str, str],
        locked: bool = True,
    ) -> None:
        """Open or begin a file.

        Args:
            path: The file.
            form: Its format.
            whose: Hashes of what decides about its content, by name.
            cures: What it means that one of them differs, in words.
            locked: Against other processes; False where the caller knows that there are none, as
                not every shared disk has locks.

        Raises:
            ModelError: it belongs to something else or another process, or is no such file.
        """
        self.path, self._form, self._cures = path, form, cures
        self._whose = {"cardan": VERSION, **whose}
        try:
            self._file = regular_file.grown(path)
        except OSError as error:
            raise ModelError(f"checkpoint {path} cannot be opened: {error.strerror}") from error
        self._reader = LogReader(self._file, path, form)
        try:
            if locked:
                self._lock()
            self._open()
        except BaseException:
            self.close()
            raise

    def close(self) -> None:
        """Let others have the file."""
        if self._file >= 0:
            os.close(self._file)
            self._file = -1

    @property
    def writer(self) -> object:
        """The cardan that wrote it, as the file says."""
        return self._reader.writer

    def _lock(self) -> None:
        try:
            processes.lock(self._file, wait=False)
        except BlockingIOError:
            raise ModelError(f"checkpoint {self.path} is in use by another process") from None
        except OSError as error:
            raise ModelError(
                f"checkpoint {self.path} cannot be locked: {error.strerror}. Name a file on a disk "
                "of this machine; a part of an ensemble, such as part=(1, 1), needs no lock"
            ) from error

    def _open(self) -> None:
        stated = self._reader.stated()
        if stated is None:
            # new, or cut off before anything was computed
            self.begin()
            return
        wrong = [why for k, why in self._cures.items() if stated.get(k) != self._whose[k]]
        if wrong:
            raise ModelError(
                f"checkpoint {self.path} belongs to another {self._form.word}: {'; '.join(wrong)}; "
                f"{written_by(self.writer)} wrote it. Name another file, or remove it to begin anew"
            )

    def begin(self) -> None:
        """Throw away all records."""
        os.ftruncate(self._file, 0)
        self._reader.end = 0
        self._write(magic(self._form))
        self.add(json.dumps(self._whose).encode())

    def contents(self) -> Iterator[bytes]:
        """The records behind the first; what was cut off behind them is removed."""
        yield from self._reader.records()
        os.ftruncate(self._file, self._reader.end)

    def add(self, content: bytes) -> None:
        """Put a record on the disk.

        Raises:
            SolveError: there is no room for it.
        """
        head = LENGTH.pack(len(content)) + hashlib.sha256(content).digest()
        self._write(head + content)

    def _write(self, content: bytes) -> None:
        end = self._reader.end
        try:
            done = 0
            while done < len(content):
                done += os.pwrite(self._file, content[done:], end + done)
            os.fsync(self._file)
        except OSError as error:
            raise SolveError(
                f"checkpoint {self.path} cannot be written to: {error.strerror}. The blocks in it "
                "are whole: make room and call again to go on from there"
            ) from error
        self._reader.end += len(content)


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

    compiler, flags, processor and all texts; of a reproducible model texts alone, and the
    mathematical library of the system.

    The names of the compiled ``rhs``, or of the functions of elements together; "Python" without a
    compiler; and of the integrators.
    """
    built = [code.built for code in model._source.codes(model)]
    if model._objects.reproducible and None not in built:
        return f"exact-{digest(VERSION, prebuilt.digest())[:16]}-{_library_key()[:16]}"
    names = ["Python" if each is None else each.path.stem for each in built]
    functions = names[0] if len(names) == 1 else digest(*names)
    return "-".join(name[:16] for name in (functions, Path(model._kernels()._name).stem))


@cache
def _library_key() -> str:
    """Hash of values of the mathematical library: its versions differ in last digits."""
    points = [1.1**k for k in range(-PROBES, PROBES)]
    small = [1 - 0.99**k for k in range(1, PROBES)]
    values = [[f(x) for x in points] for f in (math.log, math.atan, math.cbrt, math.asinh)]
    values += [[f(x) for x in small] for f in FUNCTIONS_OF_C]
    values += [[math.pow(x, 0.3) for x in points], [math.atan2(x, 1.7) for x in points]]
    return digest(np.array([x for row in values for x in row]))


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
