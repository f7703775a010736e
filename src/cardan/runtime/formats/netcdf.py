"""netCDF files: written through SciPy, read and judged here.

Source: Unidata, The NetCDF Classic Format Specification (CDF-1, CDF-2).
"""

from __future__ import annotations

import struct
from collections.abc import Iterator
from math import prod
from pathlib import Path
from typing import Any

import numpy as np

from .contents import Array, Attributes, FileFormat, Variable, Variables

# number of a type in a file -> NumPy's name
TYPES = {1: "i1", 2: "S1", 3: ">i2", 4: ">i4", 5: ">f4", 6: ">f8"}
MAGIC = {b"CDF\x01": ">I", b"CDF\x02": ">Q"}  # -> how the place of data is written
DIMENSIONS, VARIABLES, ATTRIBUTES, ABSENT = 10, 11, 12, 0
AXES = 8  # of one variable


def _written(path: Path, attributes: Attributes, variables: Variables) -> None:
    from scipy.io import netcdf_file

    with netcdf_file(path, "w", version=2) as file:
        for name, value in attributes.items():
            setattr(file, name, value.encode("ascii") if isinstance(value, str) else value)
        for name, one in variables.items():
            _write(file, name, one)


def _write(file: Any, name: str, one: Variable) -> None:
    for dimension, size in zip(one.dimensions, one.values.shape, strict=True):
        if dimension not in file.dimensions:
            file.createDimension(dimension, size)
    kind = "c" if one.values.dtype.kind == "S" else "f8"
    variable = file.createVariable(name, kind, one.dimensions)
    variable[:] = one.values
    for key, text in one.attributes.items():
        setattr(variable, key, text.encode("ascii"))


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
        part = self.data[self.place : end]
        self.place = end + -count % 4
        return part

    def integer(self) -> int:
        """A number that is not negative."""
        number: int = struct.unpack(">i", self.take(4))[0]
        if number < 0:
            raise ValueError("a length is negative")
        return number

    def text(self) -> str:
        """A name or a text."""
        return self.take(self.integer()).decode()

    def many(self, kind: int) -> Iterator[int]:
        """Numbers of the entries of a list, each of which must be read before the next."""
        said, count = self.integer(), self.integer()
        if said != kind and (said != ABSENT or count):
            raise ValueError("its header is out of order")
        yield from range(count)

    def attributes(self) -> Attributes:
        """Texts by name; of single numbers the number; None of others."""
        attributes: Attributes = {}
        for _ in self.many(ATTRIBUTES):
            name, kind, count = self.text(), self.kind(), self.integer()
            raw = self.take(np.dtype(kind).itemsize * count)
            if name in attributes:
                raise ValueError(f"it has two of '{name}'")
            if kind == "S1":
                attributes[name] = raw.decode()
            else:
                attributes[name] = np.frombuffer(raw, kind)[0].item() if count == 1 else None
        return attributes

    def kind(self) -> str:
        """A type, as NumPy has it."""
        number = self.integer()
        if number not in TYPES:
            raise ValueError(f"there is no type {number}")
        return TYPES[number]


def _parsed(data: bytes) -> tuple[Attributes, Variables]:
    """Attributes and variables.

    Raises:
        ValueError: the header is damaged, or speaks of more data than there are.
    """
    wide, head = MAGIC[data[:4]], _Bytes(data)
    head.take(4)
    head.take(4)  # records, of which there are none
    dimensions = [(head.text(), head.integer()) for _ in head.many(DIMENSIONS)]
    if not all(size for _, size in dimensions):
        raise ValueError("it has a dimension that grows")
    notes = head.attributes()
    variables: Variables = {}
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


# every reader of netCDF-3 takes so many bytes of one variable
NETCDF = FileFormat(
    "netCDF-3", (".nc", ".nc3", ".cdf", ""), _written, tuple(MAGIC), _parsed, 2**31 - 4
)
