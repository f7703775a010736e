"""Rows of the manifest: C functions and their results."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import prod
from pathlib import Path

from .blocks import ORDER
from .fields import Misfit, Record, count, field, kind, listed, matching, one_of, size, table, text

IDENTIFIER = matching("^[A-Za-z_][A-Za-z0-9_]*$", "a name in C")
HASH = matching("^[0-9a-f]{64}$", "a hash")
FILE = kind(
    "the name of a file",
    lambda value: isinstance(value, str) and Path(value).name == value,
    type="string",
    pattern="^[^/]+$",
)


class ResultRow(Record):
    """One result of a function."""

    name: str = field(text)
    shape: Sequence[int] = field(listed(size))
    entries: Sequence[str] = field(listed(text), default=())
    units: Sequence[str] = field(listed(text), default=())
    sparsity: Sequence[int] | None = field(
        listed(count),
        "of results with two axes or more: entries, row by row, that are not 0 at every state",
        default=None,
    )

    def fit(self, run: bool) -> None:
        """A result has few axes."""
        if len(self.shape) > 8:
            raise Misfit(f"has {len(self.shape)} axes").within(".shape")


class FunctionRow(Record):
    """A C function."""

    file: str = field(FILE)
    symbol: str = field(IDENTIFIER)
    of: str | None = field(text, "frame or joint", default=None)
    about: str = field(text, default="")
    inputs: Sequence[str] = field(
        listed(one_of(*ORDER)), "blocks that are read; p by prepare_ only"
    )
    vector: Sequence[str] = field(listed(text), "entries of the block v", default=())
    outputs: Sequence[ResultRow] = field(listed(ResultRow))
    output_size: int = field(size)
    work_size: int = field(size)
    prepared_size: int = field(size, "length of w")
    lanes: Sequence[int] = field(listed(count))
    operations: Mapping[str, int] = field(table(count))
    headers: Sequence[str] = field(listed(text), default=())
    sha256: str = field(HASH)

    @property
    def total_operations(self) -> int:
        """Number of its operations."""
        return sum(self.operations.values())

    def fit(self, run: bool) -> None:
        """Results are as long as they are said to be, and states can be taken one by one."""
        total = sum(prod(output.shape) for output in self.outputs)
        if total != self.output_size:
            raise Misfit(f"hold {total} numbers, not {self.output_size}").within(".outputs")
        if not self.lanes:
            raise Misfit("is empty").within(".lanes")
