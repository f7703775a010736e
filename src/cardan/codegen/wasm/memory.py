"""The data of an exported model as they lie in a memory of 32 bits."""

from __future__ import annotations

import re
import struct
from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from ...schema import records
from ..export.constants import Array, Name, Value
from .module import Module

# letters of ``struct`` by types in C, all little-endian
FORMATS = dict.fromkeys(("*", "cardan_function", "ptrdiff_t", "int32_t"), "i")
FORMATS |= dict.fromkeys(("double", "real"), "d")
_DECLARED = re.compile(r"(\w+) (\w+)(?:\[.*\])?$")


def places(record: str) -> dict[str, tuple[int, str]]:
    """Offsets of the fields of a record, and the letters of their formats."""
    at, result = 0, {}
    for name, kind in records.kinds(record).items():
        letter = FORMATS[kind]
        at += -at % struct.calcsize(letter)
        result[name] = at, letter
        at += struct.calcsize(letter)
    return result


def size(record: str) -> int:
    """Bytes of a record, a multiple of what its largest field is aligned to."""
    fields = places(record).values()
    end = max(at + struct.calcsize(letter) for at, letter in fields)
    return end + -end % max(struct.calcsize(letter) for _, letter in fields)


class Memory:
    """Declarations as constants of a module; see ``export.constants``.

    Attributes:
        module: Whose they are.
        addresses: Of what was declared, by name.
        values: Numbers that stand for names, such as sizes.
    """

    def __init__(
        self, module: Module, addresses: Mapping[str, int], values: Mapping[str, int]
    ) -> None:
        self.module = module
        self.addresses = dict(addresses)
        self.values = {**records.constants("run.h"), **values}

    def say(self, about: str) -> None:
        """Nothing: nobody reads it."""

    def external(self, declared: str) -> None:
        """Nothing: the address is known."""

    def numbers(self, name: str, values: Array | Sequence[float], kind: str = "") -> Name | None:
        """Put an array of numbers; integers have 32 bits."""
        array = np.asarray(values)
        if not array.size:
            return None
        content = array.astype("<f8" if array.dtype.kind == "f" else "<i4")
        self.addresses[name] = self.module.constant(content.tobytes())
        return Name(name)

    def records(self, kind: str, name: str, rows: Sequence[Value]) -> Name | None:
        """Put an array of records, or of other values."""
        if not rows:
            return None
        self.addresses[name] = self.module.constant(b"".join(self._encoded(kind, r) for r in rows))
        return Name(name)

    def record(self, declared: str, fields: Mapping[str, Value]) -> None:
        """Put one record."""
        kind, name = self._declared(declared)
        self.addresses[name] = self.module.constant(self._encoded(kind, fields))

    def named(self, declared: str, values: Iterable[float], names: Iterable[str]) -> None:
        """Put numbers, one at least."""
        listed = list(values) or [0.0]
        self.addresses[self._declared(declared)[1]] = self.module.doubles(listed)

    def _declared(self, declared: str) -> tuple[str, str]:
        """Type and name of a declaration."""
        match = _DECLARED.search(declared)
        assert match is not None, declared
        return match[1], match[2]

    def _encoded(self, kind: str, value: Value) -> bytes:
        """Bytes of a value."""
        if not isinstance(value, Mapping):
            return struct.pack(f"<{FORMATS[kind]}", self._number(kind, value))
        content = bytearray(size(kind))
        fields = places(kind)
        for name, each in value.items():
            at, letter = fields[name]
            struct.pack_into(
                f"<{letter}", content, at, self._number(records.kinds(kind)[name], each)
            )
        return bytes(content)

    def _number(self, kind: str, value: Value) -> float:
        """A field as a number."""
        if value is None:
            return 0
        if isinstance(value, Name):
            name = value.removeprefix("&")
            if name in self.values:
                return self.values[name]
            if name not in self.addresses:
                self.addresses[name] = self.module.listed(name)
            return self.addresses[name]
        if isinstance(value, str):
            return self.module.constant(value.encode() + b"\0")
        assert not isinstance(value, Mapping)
        return float(value) if FORMATS[kind] == "d" else int(value)
