"""Constants of C, from numbers, names and arrays: the one writer of the data of an export."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any, Protocol, TypeAlias

import numpy as np
from numpy.typing import NDArray

PER_LINE = 12
KINDS = {"f": "double", "i": "ptrdiff_t"}


class Name(str):
    """Literal C text: a name, or an expression of names."""

    __slots__ = ()


Array: TypeAlias = NDArray[Any]
Value: TypeAlias = "Name | str | float | Mapping[str, Value] | None"


def literal(value: Value) -> str:
    """A value in C: NULL, a number, a string, or a record by the names of its fields."""
    if value is None:
        return "NULL"
    if isinstance(value, Name):
        return str(value)
    if isinstance(value, str):
        return _quoted(value)
    if isinstance(value, Mapping):
        fields = (f".{name} = {literal(each)}" for name, each in value.items())
        return f"{{{', '.join(fields)}}}"
    return repr(float(value)) if isinstance(value, float) else str(int(value))


def _quoted(text: str) -> str:
    plain = "".join(c if c.isascii() and c.isprintable() else "?" for c in text)
    return '"' + plain.replace("\\", "\\\\").replace('"', '\\"').replace("?", "\\?") + '"'


class Declarations(Protocol):
    """What takes the data of an export: a C file, or the memory of a program."""

    def say(self, about: str) -> None:
        """Comment on what follows."""

    def external(self, declared: str) -> None:
        """Declare a constant that stands elsewhere."""

    def numbers(self, name: str, values: Array | Sequence[float], kind: str = "") -> Name | None:
        """Declare an array of numbers, or of records of them by rows; NULL where it is empty.

        Args:
            name: In C.
            values: The numbers; of two axes in one row after the other.
            kind: Type in C; else as the array has it.
        """

    def records(self, kind: str, name: str, rows: Sequence[Value]) -> Name | None:
        """Declare an array of records, or of other values; NULL without any."""

    def record(self, declared: str, fields: Mapping[str, Value]) -> None:
        """Declare one record."""

    def named(self, declared: str, values: Iterable[float], names: Iterable[str]) -> None:
        """Declare numbers with a comment each; C wants at least one."""


class Constants:
    """Lines of a C file that declare constants, one after the other.

    Args:
        lines: What stands before them.
    """

    def __init__(self, *lines: str) -> None:
        self.lines = list(lines)

    @property
    def text(self) -> str:
        """The file."""
        return "\n".join(self.lines) + "\n"

    def say(self, about: str) -> None:
        """Put a comment above what follows."""
        self.lines += ["", f"/* {about} */"]

    def external(self, declared: str) -> None:
        """Declare a constant that stands in another file."""
        self.lines.append(f"extern {declared};")

    def numbers(self, name: str, values: Array | Sequence[float], kind: str = "") -> Name | None:
        """Declare an array; see :class:`Declarations`."""
        array = np.asarray(values)
        if not array.size:
            return None
        flat = array.tolist() if kind and array.ndim > 1 else array.ravel().tolist()
        c_type = kind or ("int32_t" if array.dtype == np.int32 else KINDS[array.dtype.kind])
        self._array(f"static const {c_type} {name}[]", _wrapped(map(_entry, flat)))
        return Name(name)

    def records(self, kind: str, name: str, rows: Sequence[Value]) -> Name | None:
        """Declare an array of records, or of other values, one to a line; NULL without any."""
        if not rows:
            return None
        self._array(f"static const {kind} {name}[]", (f"    {literal(row)}," for row in rows))
        return Name(name)

    def record(self, declared: str, fields: Mapping[str, Value]) -> None:
        """Declare one record, a field to a line."""
        self._array(declared, (f"    .{name} = {literal(v)}," for name, v in fields.items()))

    def named(self, declared: str, values: Iterable[float], names: Iterable[str]) -> None:
        """Declare numbers one to a line, each with a comment; C wants at least one."""
        pairs = list(zip(values, names, strict=True)) or [(0.0, "nothing")]
        self._array(declared, (f"    {float(x)!r}, /* {about} */" for x, about in pairs))

    def _array(self, declared: str, lines: Iterable[str]) -> None:
        self.lines += [f"{declared} = {{", *lines, "};"]


def _entry(value: object) -> str:
    return f"{{{', '.join(map(str, value))}}}" if isinstance(value, list) else repr(value)


def _wrapped(numbers: Iterable[str]) -> Iterator[str]:
    """Numbers of a table, some to a line."""
    listed = list(numbers)
    for k in range(0, len(listed), PER_LINE):
        yield "    " + ", ".join(listed[k : k + PER_LINE]) + ","
