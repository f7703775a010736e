"""Named arrays and texts in netCDF files: written through SciPy, read and judged here.

What is read may come from anybody: no length in a file is believed before the file is seen to have
so many bytes, and a hash of everything that counts tells whether it is what was written.

Source: Unidata, The NetCDF Classic Format Specification (CDF-1, CDF-2).
"""

from __future__ import annotations

import hashlib
import json
import struct
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from math import prod
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import ModelError
from ..regular_file import content
from ..version import VERSION, Format
from ..whole_file import replaced

LIMIT = 2**31 - 4  # bytes of one variable that every netCDF-3 reader takes
ENDINGS = ("", ".nc", ".nc3", ".cdf")
HASH = "sha256"
SOURCE, WRITER = "source", "cardan "  # the text that names the writer, and what is before it
KINDS = ("run", "ensemble")  # what files hold
# number of a type in a file -> NumPy's name
TYPES = {1: "i1", 2: "S1", 3: ">i2", 4: ">i4", 5: ">f4", 6: ">f8"}
MAGIC = {b"CDF\x01": ">I", b"CDF\x02": ">Q"}  # -> how the place of data is written
DIMENSIONS, VARIABLES, ATTRIBUTES, ABSENT = 10, 11, 12, 0
AXES = 8  # of one variable
MOST = 1 << 40  # bytes of a file

Array = NDArray[Any]


@dataclass(frozen=True, eq=False)
class Variable:
    """One array of a file.

    Attributes:
        dimensions: Names of the axes.
        values: Numbers, or single bytes of texts.
        attributes: Texts.
    """

    dimensions: tuple[str, ...]
    values: Array
    attributes: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True, eq=False)
class Contents:
    """What a file holds: arrays, and texts about all of them, by name."""

    variables: Mapping[str, Variable]
    notes: Mapping[str, str]

    def digest(self) -> str:
        """Hash of all of it."""
        found = hashlib.sha256()
        for name, one in sorted(self.variables.items()):
            told = (name, one.dimensions, one.values.shape, sorted(one.attributes.items()))
            found.update(json.dumps(told).encode())
            found.update(np.ascontiguousarray(one.values).tobytes())
        found.update(json.dumps(sorted(self.notes.items())).encode())
        return found.hexdigest()


def letters(texts: Iterable[str], dimension: str, name: str = "") -> Variable:
    """Texts as an array of bytes, as other programs read them.

    Args:
        texts: One for every place along the dimension.
        dimension: Its name.
        name: Of the variable, where it is not that of the dimension.
    """
    coded = [text.encode() for text in texts]
    width = max([1, *map(len, coded)])
    joined = b"".join(text.ljust(width, b"\0") for text in coded)
    values = np.frombuffer(joined, dtype="S1").reshape(len(coded), width)
    return Variable((dimension, f"{name or dimension}_letters"), values, {"_Encoding": "utf-8"})


def save(path: Path, form: Format, made: Contents, cure: str) -> Path:
    """Write a file; one with its name is replaced in one step.

    Args:
        path: The file.
        form: Of a run or an ensemble.
        made: What it shall hold; arrays without numbers are left out.
        cure: What to do where a variable is too large.

    Raises:
        ModelError: the ending of another format, a variable too large for the format, or a file
            that cannot be written.
    """
    from scipy.io import netcdf_file

    if path.suffix not in ENDINGS:
        raise ModelError(
            f"{path}: {form.kind}s are written as netCDF, whose files end in .nc; to_xarray() "
            "gives the numbers to writers of other formats"
        )
    kept = {name: one for name, one in made.variables.items() if one.values.size}
    for name, one in kept.items():
        if one.values.nbytes > LIMIT:
            raise ModelError(
                f"{path}: '{name}' takes {one.values.nbytes / 1e9:.1f} GB, netCDF-3 holds 2 GB in "
                f"one variable. {cure}"
            )
    made = Contents(kept, made.notes)
    notes = {SOURCE: f"{WRITER}{VERSION}", HASH: made.digest(), **made.notes}
    with replaced(path) as new, netcdf_file(new, "w", version=2) as file:
        setattr(file, f"cardan_{form.word}", form.version)
        for name, text in notes.items():
            setattr(file, name, text.encode("ascii"))
        for name, one in kept.items():
            _write(file, name, one)
    return path


def _write(file: Any, name: str, one: Variable) -> None:
    for dimension, size in zip(one.dimensions, one.values.shape, strict=True):
        if dimension not in file.dimensions:
            file.createDimension(dimension, size)
    kind = "c" if one.values.dtype.kind == "S" else "f8"
    variable = file.createVariable(name, kind, one.dimensions)
    variable[:] = one.values
    for key, text in one.attributes.items():
        setattr(variable, key, text.encode("ascii"))


def load(path: Path, form: Format, notes: Collection[str]) -> Contents:
    """Read a file that :func:`save` wrote.

    Args:
        path: The file.
        form: As of :func:`save`; files of its oldest version have no hash.
        notes: Names of the texts that count.

    Raises:
        ModelError: no such file, one of another kind or version, or a damaged one.
    """
    what = form.word
    try:
        attributes, variables = _parsed(content(path, MOST))
    except FileNotFoundError:
        raise ModelError(f"{path}: there is no such file") from None
    except OSError as error:
        raise ModelError(f"{path} cannot be read: {error.strerror}") from None
    except (ValueError, MemoryError) as error:
        raise ModelError(
            f"{path} is no {what} of cardan, or is damaged: {error or 'it is too large'}. Save the "
            f"{what} again"
        ) from None
    version = attributes.get(f"cardan_{what}", 0)
    if not form.reads(version):
        if f"cardan_{what}" not in attributes:
            raise ModelError(f"{path} is no {what} of cardan")
        writer = str(attributes.get(SOURCE, "")).removeprefix(WRITER)
        raise ModelError(form.refusal(path, version, writer))
    today = {name: form.today((name,), version) for name in attributes}
    counting = {name for name, now in today.items() if now in notes}
    texts = {name: attributes[name] for name in counting if isinstance(attributes[name], str)}
    found = Contents(variables, texts)
    # damage may have made a file of an early version out of this one
    if (version > form.oldest or HASH in attributes) and attributes.get(HASH) != found.digest():
        others = [k for k in KINDS if k != what and f"cardan_{k}" in attributes]
        if others and f"cardan_{what}" not in attributes:
            raise ModelError(f"{path} is no {what} that cardan can read: it holds a {others[0]}")
        raise ModelError(
            f"{path} is not what was saved: its hash differs. Copy it or save the {what} again"
        )
    return _today(found, form, version)


def _today(contents: Contents, form: Format, version: int) -> Contents:
    """What an older file holds, under the names of today."""
    if not any(older >= version for older in form.renamed):
        return contents

    def translated(name: str, text: str) -> str:
        try:
            return json.dumps(form.translated(json.loads(text), (name,), version))
        except ValueError:
            # a title, which holds no names
            return text

    notes = {name: translated(name, text) for name, text in contents.notes.items()}
    return Contents(
        {form.today((name,), version): one for name, one in contents.variables.items()},
        {form.today((name,), version): text for name, text in notes.items()},
    )


class _Bytes:
    """The header of a file, read from its start.

    Raises:
        ValueError: it ends before it should, or says what no header can.
    """

    def __init__(self, data: bytes) -> None:
        self.data, self.place = data, 0

    def take(self, count: int) -> bytes:
        """So many bytes, and what fills them up to a multiple of four."""
        end = self.place + count
        if count < 0 or end > len(self.data):
            raise ValueError("it is cut off")
        found = self.data[self.place : end]
        self.place = end + -count % 4
        return found

    def integer(self) -> int:
        """A number that is not negative."""
        found: int = struct.unpack(">i", self.take(4))[0]
        if found < 0:
            raise ValueError("a length is negative")
        return found

    def text(self) -> str:
        """A name or a text."""
        return self.take(self.integer()).decode()

    def many(self, kind: int) -> Iterator[int]:
        """Numbers of the entries of a list, each of which must be read before the next."""
        said, count = self.integer(), self.integer()
        if said != kind and (said != ABSENT or count):
            raise ValueError("its header is out of order")
        yield from range(count)

    def attributes(self) -> dict[str, Any]:
        """Texts by name; of single numbers the number; None of others."""
        found: dict[str, Any] = {}
        for _ in self.many(ATTRIBUTES):
            name, kind, count = self.text(), self.kind(), self.integer()
            raw = self.take(np.dtype(kind).itemsize * count)
            if name in found:
                raise ValueError(f"it has two of '{name}'")
            if kind == "S1":
                found[name] = raw.decode()
            else:
                found[name] = np.frombuffer(raw, kind)[0].item() if count == 1 else None
        return found

    def kind(self) -> str:
        """A type, as NumPy has it."""
        number = self.integer()
        if number not in TYPES:
            raise ValueError(f"there is no type {number}")
        return TYPES[number]


def _parsed(data: bytes) -> tuple[dict[str, Any], dict[str, Variable]]:
    """Attributes and variables.

    Raises:
        ValueError: the header is damaged, or speaks of more data than there are.
    """
    if data[:4] not in MAGIC:
        raise ValueError("it is not a netCDF-3 file")
    wide, head = MAGIC[data[:4]], _Bytes(data)
    head.take(4)
    head.take(4)  # records, of which there are none
    dimensions = [(head.text(), head.integer()) for _ in head.many(DIMENSIONS)]
    if not all(size for _, size in dimensions):
        raise ValueError("it has a dimension that grows")
    notes = head.attributes()
    variables: dict[str, Variable] = {}
    total = 0
    for _ in head.many(VARIABLES):
        name, axes = head.text(), head.integer()
        if axes > AXES or name in variables:
            raise ValueError(f"'{name}' has {axes} axes, or is there twice")
        which = [head.integer() for _ in range(axes)]
        attributes, kind = head.attributes(), head.kind()
        head.take(4)  # its length, which follows from the dimensions
        (start,) = struct.unpack(wide, head.take(struct.calcsize(wide)))
        if any(k >= len(dimensions) for k in which):
            raise ValueError(f"'{name}' has dimensions that do not exist")
        shape = tuple(dimensions[k][1] for k in which)
        size = prod(shape) * np.dtype(kind).itemsize
        total += size
        # variables that share their bytes would take more memory than the file
        if start + size > len(data) or total > len(data):
            raise ValueError(f"'{name}' is cut off")
        values: Array = np.frombuffer(data, kind, prod(shape), start).reshape(shape)
        if kind != "S1":
            values = values.astype(np.float64)
        texts = {key: text for key, text in attributes.items() if isinstance(text, str)}
        variables[name] = Variable(tuple(dimensions[k][0] for k in which), values, texts)
    return notes, variables
