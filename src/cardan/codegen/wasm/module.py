"""A WebAssembly module as bytes.

Source: WebAssembly Core Specification 2.0, W3C, chapter 5 (binary format).
"""

from __future__ import annotations

import struct
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field
from typing import TypeAlias

from ...records import dataclass

I32, F64 = 0x7F, 0x7C
TYPES = {"i": I32, "d": F64}
# sections in their order
TYPE, IMPORT, FUNCTION, EXPORT, ELEMENT, CODE, DATA = 1, 2, 3, 7, 9, 10, 11
FUNCREF, MEMORY, TABLE = 0x70, 2, 1
ALIGNED = 8  # where constants begin: as doubles
MAGIC = b"\0asm\x01\0\0\0"
PAGE = 65536
# instructions; a text calls the function of that name
Code: TypeAlias = "list[bytes | str]"


def unsigned(value: int) -> bytes:
    """A natural number in LEB128."""
    encoded = bytearray()
    while value > 0x7F:
        encoded.append(value & 0x7F | 0x80)
        value >>= 7
    encoded.append(value)
    return bytes(encoded)


def signed(value: int) -> bytes:
    """An integer in LEB128."""
    encoded = bytearray()
    while not -64 <= value < 64:
        encoded.append(value & 0x7F | 0x80)
        value >>= 7
    encoded.append(value & 0x7F)
    return bytes(encoded)


def vector(items: Sequence[bytes]) -> bytes:
    """Items with their number before them."""
    return unsigned(len(items)) + b"".join(items)


def text(name: str) -> bytes:
    """A name."""
    encoded = name.encode()
    return unsigned(len(encoded)) + encoded


@dataclass(frozen=True)
class Signature:
    """Types of a function: a letter each, ``i`` of 32 bits and ``d`` of doubles."""

    takes: str
    gives: str = ""

    @property
    def encoded(self) -> bytes:
        """As the section of types has it."""
        sides = (vector([bytes([TYPES[c]]) for c in side]) for side in (self.takes, self.gives))
        return b"\x60" + b"".join(sides)


@dataclass
class Module:
    """A module that works on the memory and, if it asks for it, on the table of another one.

    Attributes:
        base: Address of its first constant.
        source: Name of the module that its imports come from.
        table_base: Place of its first function in the table of that module; None: it asks for
            no table.
    """

    base: int
    source: str = "kernels"
    table_base: int | None = None
    _types: dict[Signature, int] = field(default_factory=dict)
    _imports: dict[str, Signature] = field(default_factory=dict)
    _functions: dict[str, tuple[Signature, Code]] = field(default_factory=dict)
    _exported: list[str] = field(default_factory=list)
    _listed: list[str] = field(default_factory=list)
    _data: bytearray = field(default_factory=bytearray)

    def imported(self, name: str, signature: Signature) -> None:
        """Let functions call one of the other module."""
        self._imports[name] = signature

    def add(self, name: str, signature: Signature, code: Code, exported: bool = False) -> None:
        """Add a function: its locals and instructions."""
        assert name not in self._functions, f"{name} is there already"
        self._functions[name] = signature, code
        if exported:
            self._exported.append(name)

    def listed(self, name: str) -> int:
        """What stands for a pointer to a function: its place in the table."""
        assert self.table_base is not None
        if name not in self._listed:
            self._listed.append(name)
        return self.table_base + self._listed.index(name)

    @property
    def table_end(self) -> int:
        """Length of the table with its functions."""
        return (self.table_base or 0) + len(self._listed)

    def constant(self, content: bytes) -> int:
        """Address of constant bytes."""
        self._data += b"\0" * (-len(self._data) % ALIGNED)
        address = self.base + len(self._data)
        self._data += content
        return address

    def integers(self, values: Iterable[float]) -> int:
        """Address of an array of ints."""
        listed = [int(value) for value in values]
        return self.constant(struct.pack(f"<{len(listed)}i", *listed))

    def doubles(self, values: Iterable[float]) -> int:
        """Address of an array of doubles."""
        listed = list(values)
        return self.constant(struct.pack(f"<{len(listed)}d", *listed))

    @property
    def end(self) -> int:
        """First address behind the constants, for what is written while it runs."""
        return self.base + len(self._data) + -len(self._data) % ALIGNED

    def encoded(self) -> bytes:
        """The module."""
        signatures = [*self._imports.values(), *(s for s, _ in self._functions.values())]
        types = {signature: k for k, signature in enumerate(dict.fromkeys(signatures))}
        numbers = {name: k for k, name in enumerate((*self._imports, *self._functions))}
        shared = [self._from("memory", bytes([MEMORY, 0]) + unsigned(1))]
        if self.table_base is not None:
            shared.append(self._from("table", bytes([TABLE, FUNCREF, 0]) + unsigned(1)))
        imports = [self._from(n, b"\0" + unsigned(types[s])) for n, s in self._imports.items()]
        sections = [
            (TYPE, [signature.encoded for signature in types]),
            (IMPORT, [*shared, *imports]),
            (FUNCTION, [unsigned(types[s]) for s, _ in self._functions.values()]),
            (EXPORT, [text(n) + b"\0" + unsigned(numbers[n]) for n in self._exported]),
            (ELEMENT, self._elements(numbers)),
            (CODE, [sized(_linked(code, numbers)) for _, code in self._functions.values()]),
            (DATA, [b"\0" + _at(self.base) + sized(self._data)] if self._data else []),
        ]
        parts = [bytes([number]) + sized(vector(items)) for number, items in sections if items]
        return MAGIC + b"".join(parts)

    def _from(self, name: str, description: bytes) -> bytes:
        """An import."""
        return text(self.source) + text(name) + description

    def _elements(self, numbers: Mapping[str, int]) -> list[bytes]:
        """What it puts into the table."""
        if not self._listed or self.table_base is None:
            return []
        listed = [unsigned(numbers[name]) for name in self._listed]
        return [b"\0" + _at(self.table_base) + vector(listed)]


def sized(content: bytes | bytearray) -> bytes:
    """Bytes with their number before them."""
    return unsigned(len(content)) + bytes(content)


def _linked(code: Code, numbers: Mapping[str, int]) -> bytes:
    """Code with the numbers of the functions that it calls."""
    return b"".join(
        b"\x10" + unsigned(numbers[part]) if isinstance(part, str) else part for part in code
    )


def _at(address: int) -> bytes:
    """The constant expression of an address."""
    return b"\x41" + signed(address) + b"\x0b"
