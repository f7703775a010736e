"""Contents of a saved run or ensemble, and the interface of the file formats."""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Callable, Container, Iterable, Mapping
from dataclasses import field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...records import dataclass

Array = NDArray[Any]
# texts and single numbers about a whole file
Attributes = dict[str, Any]
# what a name in a file may have beside letters of ASCII and digits
OTHER = re.compile(r"[^A-Za-z0-9_.]")


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
    """Contents of a file: arrays, and texts about all of them, by name."""

    variables: Mapping[str, Variable]
    notes: Mapping[str, str]

    def digest(self) -> str:
        """Hash of all of it."""
        total = hashlib.sha256()
        for name, one in sorted(self.variables.items()):
            description = (name, one.dimensions, one.values.shape, sorted(one.attributes.items()))
            total.update(json.dumps(description).encode())
            total.update(np.ascontiguousarray(one.values).tobytes())
        total.update(json.dumps(sorted(self.notes.items())).encode())
        return total.hexdigest()


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


def texts(one: Variable) -> list[str]:
    """Texts out of an array of :func:`letters`."""
    return [b"".join(row).rstrip(b"\0").decode() for row in one.values]


def for_json(values: Array) -> Array:
    """Numbers with None in place of what is not finite, which JSON does not have."""
    finite = np.isfinite(values)
    if finite.all():
        return values
    entries: Array = values.astype(object)
    entries[~finite] = None
    return entries


def safe_name(name: str, taken: Container[str]) -> str:
    """A name that readers of all formats take, and no other variable has."""
    safe = OTHER.sub("_", name)
    safe = safe if safe[:1].isalpha() else f"_{safe}"
    candidate, k = safe, 1
    while candidate in taken:
        k += 1
        candidate = f"{safe}_{k}"
    return candidate


Variables = dict[str, Variable]


@dataclass(frozen=True)
class Ending:
    """A format by what the names of its files end in.

    Attributes:
        name: As messages call it.
        endings: Of its files; what has none is of the first format.
        packages: Modules that its writer imports, beyond those of cardan.
        extra: Of cardan, which installs these.
    """

    name: str
    endings: tuple[str, ...]
    packages: tuple[str, ...] = field(default=(), kw_only=True)
    extra: str = field(default="", kw_only=True)


@dataclass(frozen=True)
class FileFormat(Ending):
    """One way to write contents to a file.

    Attributes:
        write: To a path.
        magic: First bytes of its files, where all begin with the same.
        parse: Attributes and variables of such bytes, a ValueError where they are damaged; None
            where files are not read again.
        limit: Bytes of one variable, 0 without such a limit.
        empty: Whether arrays without numbers are written too.
    """

    write: Callable[[Path, Attributes, Variables], None]
    magic: tuple[bytes, ...] = ()
    parse: Callable[[bytes], tuple[Attributes, Variables]] | None = None
    limit: int = 0
    empty: bool = False
